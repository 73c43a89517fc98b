// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit study: measures clothfit itself.
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/options/tracking.h"
#include "apps/options/value_checks.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "fitting/studies/chaos_study.h"
#include "fitting/studies/mesh_study.h"
#include "fitting/studies/recovery_study.h"
#include "fitting/trials/finite_elements/generator.h"
#include "tracking/features/tracking_evaluation.h"
#include "tracking/files/output_folder.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct RecoveryStudyOptions {
  RecoveryOptions recovery;
  std::string output;
  int elements = 4;  // along a spacing of the recording's particles
  bool force = false, finite_elements = false;
};

int RunRecoveryCommand(RecoveryStudyOptions options) {
  if (options.finite_elements) {
    options.recovery.generator = FiniteElementGenerator({}, {}, nullptr);
    options.recovery.recording.refinement = options.elements;
  }
  if (options.recovery.num_seeds < 1) {
    throw InputError("--seeds", fmt::format("{}; expected 1 or more", options.recovery.num_seeds));
  }
  if (options.recovery.num_threads < 1) {
    throw InputError("--threads",
                     fmt::format("{}; expected 1 or more", options.recovery.num_threads));
  }
  OutputFolder output(options.output, FolderKind::kStudyTables, "study recovery",
                      ExistingIf(options.force));
  output.Begin({"recovery.csv", "recovery.md"});
  const std::vector<RecoveredSeed> seeds =
      RunRecoveryStudy(options.recovery, [](const RecoveredSeed& seed) {
        const Coverage coverage = CountCoverage({seed});
        Print(Terminal(), "seed {}: {} in {:.0f} s, {} of {} determined parameters covered\n",
              seed.seed, ToString(seed.status), seed.seconds, coverage.covered, coverage.total);
      });
  output.WriteAll(
      {{"recovery.csv", RecoveryAsCsv(seeds)}, {"recovery.md", RecoveryAsMarkdown(seeds)}});
  Print("{}", RecoveryAsMarkdown(seeds));
  PrintNext("clothfit report " + ShellWord(options.output));
  return kExitSuccess;
}

void AddRecoveryStudy(CLI::App* study, Action* action) {
  CLI::App* const recovery =
      study->add_subcommand("recovery", "fit recordings of known truth; do the intervals hold it?");
  const auto options = std::make_shared<RecoveryStudyOptions>();
  options->recovery.recording = DemoRecording();
  recovery->add_option("-o,--output", options->output, "folder of the tables")
      ->type_name("FOLDER")
      ->required();
  recovery->add_option("--seeds", options->recovery.num_seeds, "recordings to make and fit")
      ->type_name("N")
      ->capture_default_str();
  recovery->add_option("--first-seed", options->recovery.first_seed, "seed of the first")
      ->type_name("N")
      ->capture_default_str();
  recovery
      ->add_option("--threads", options->recovery.num_threads,
                   "recordings fitted at the same time; no influence on the result")
      ->type_name("N")
      ->capture_default_str();
  recovery
      ->add_option("--finest", options->recovery.finest,
                   "particles along the longer side of the finest mesh that a fit may choose; 0: "
                   "it keeps the recording's")
      ->type_name("N")
      ->check(WholeNumber(0, kMostResolution))
      ->capture_default_str();
  recovery
      ->add_option("--layout-noise", options->recovery.recording.layout_sigma,
                   "sigma of what is told of markers' places on the cloth, m")
      ->type_name("M")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  CLI::Option* const finite_elements = recovery->add_flag(
      "--finite-elements", options->finite_elements,
      "make them with triangular finite elements on a finer mesh, which share no code with a fit");
  recovery
      ->add_option("--elements", options->elements,
                   "of these along a spacing of the recording's particles; twice as many take 8 "
                   "times the time")
      ->type_name("N")
      ->check(WholeNumber(1, 10))
      ->needs(finite_elements)
      ->capture_default_str();
  recovery->add_flag("--force", options->force, "replace the tables that are there");
  recovery->footer("Example:\n  clothfit study recovery --seeds 20 -o studies/recovery");
  recovery->callback(
      [options, action] { *action = [options] { return RunRecoveryCommand(*options); }; });
}

struct TrackingStudyOptions {
  std::vector<std::string> recordings;
  TrackingOptions tracking;
  std::string output;
  bool force = false;
};

int RunTrackingStudy(const TrackingStudyOptions& options) {
  OutputFolder output(options.output, FolderKind::kStudyTables, "study tracking",
                      ExistingIf(options.force));
  output.Begin({"tracking.md", "tracking.csv"});
  std::string table = TrackingTableHeader(), course = "recording,frame,tracks,markers\n", filters;
  for (const std::string& path : options.recordings) {
    const Recording recording = ReadRecording(path);
    const TruthSurface truth = TruthSurface::Read(recording.path);
    const std::string name = AsFolderName(recording.name);
    const std::filesystem::path out = output.path() / name;
    output.Add({name + "/"});
    const auto start = std::chrono::steady_clock::now();
    const TrackingResult found =
        TrackWithDisplay(recording, options.tracking, out, Overwrite::kAllow, false);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const TrackingEvaluation evaluation =
        EvaluateTracking(recording, truth, found.tracks, found.markers, out / "masks");
    table += TrackingTableRow(recording.name, evaluation);
    for (std::size_t f = 0; f < evaluation.tracks_in_frame.size(); ++f) {
      course += fmt::format("{},{},{},{}\n", recording.name, f, evaluation.tracks_in_frame[f],
                            evaluation.markers_in_frame[f]);
    }
    filters += fmt::format("\n{}: {}\n{:.1f} s, {:.1f} frames a second and camera\n",
                           recording.name, DescribeTracking(recording, found), seconds,
                           static_cast<double>(found.pictures.size()) / seconds);
    // What there is, should it end early.
    output.WriteAll({{"tracking.md", table + filters}, {"tracking.csv", course}});
    if (found.num_frames < recording.frame_count) return kExitInterrupted;
  }
  Print("{}{}", table, filters);
  PrintNext("clothfit report " + ShellWord(options.output));
  return kExitSuccess;
}

void AddTrackingStudy(CLI::App* study, Action* action) {
  CLI::App* const tracking = study->add_subcommand(
      "tracking", "track in synthetic recordings; how far from the truth is what is found?");
  const auto options = std::make_shared<TrackingStudyOptions>();
  tracking->add_option("RECORDING", options->recordings, "recordings with truth/")->required();
  tracking->add_option("-o,--output", options->output, "folder of the tables and of what is found")
      ->type_name("FOLDER")
      ->required();
  AddTrackingOptions(tracking, &options->tracking);
  tracking->add_flag("--force", options->force, "replace the tables that are there");
  tracking->footer("Example:\n  clothfit study tracking lift1 lift2 lift3 -o studies/tracking");
  tracking->callback(
      [options, action] { *action = [options] { return RunTrackingStudy(*options); }; });
}

struct ChaosStudyOptions {
  ChaosOptions chaos;
  std::string output;
  bool no_contact = false, force = false;
};

int RunChaosCommand(ChaosStudyOptions options) {
  if (options.chaos.particles < 4 || options.chaos.particles > 200) {
    throw InputError("--particles", fmt::format("{}; expected 4 to 200", options.chaos.particles));
  }
  if (!(options.chaos.duration > 0.0)) {
    throw InputError("--duration",
                     fmt::format("{}; expected a number above 0", options.chaos.duration));
  }
  options.chaos.self_contact = !options.no_contact;
  OutputFolder output(options.output, FolderKind::kStudyTables, "study chaos",
                      ExistingIf(options.force));
  output.Begin({"chaos.csv", "chaos.md", "chaos.svg", "chaos.png"});
  const ChaosResult result =
      RunChaosStudy(options.chaos, [](int frame) { Print(Terminal(), "frame {}\n", frame); });
  output.WriteAll({{"chaos.csv", ChaosAsCsv(result)},
                   {"chaos.md", ChaosAsMarkdown(options.chaos, result)},
                   {"chaos.svg", ChaosAsSvg(result)}});
  DrawChaos(options.chaos, result, (output.path() / "chaos.png").string());
  Print("{}", ChaosAsMarkdown(options.chaos, result));
  if (result.complete) {
    PrintNext("clothfit report " + ShellWord(options.output));
    return kExitSuccess;
  }
  throw std::runtime_error(
      fmt::format("the simulation fails after frame {}", result.frames.size() - 1));
}

void AddChaosStudy(CLI::App* study, Action* action) {
  CLI::App* const chaos = study->add_subcommand(
      "chaos", "move one particle of a cloth that drops; how far do the two runs part?");
  const auto options = std::make_shared<ChaosStudyOptions>();
  chaos->add_option("-o,--output", options->output, "folder of tables and pictures")
      ->type_name("FOLDER")
      ->required();
  chaos->add_option("--particles", options->chaos.particles, "particles a side")
      ->type_name("N")
      ->capture_default_str();
  chaos->add_option("--offset", options->chaos.offset, "m, of the particle")
      ->type_name("M")
      ->capture_default_str();
  chaos->add_option("--duration", options->chaos.duration, "s")
      ->type_name("S")
      ->capture_default_str();
  chaos->add_flag("--no-contact", options->no_contact, "let the cloth pass through itself");
  chaos->add_flag("--force", options->force, "replace what is there");
  chaos->footer("Example:\n  clothfit study chaos -o studies/chaos");
  chaos->callback([options, action] { *action = [options] { return RunChaosCommand(*options); }; });
}

struct MeshCommandOptions {
  MeshStudyOptions study;
  std::string output;
  bool no_fit = false, force = false;
};

int RunMeshCommand(MeshCommandOptions options) {
  for (const int particles : options.study.particles) {
    if (particles < 4 || particles > 200)
      throw InputError("--particles", fmt::format("{}; expected 4 to 200", particles));
  }
  if (options.study.num_threads < 1) {
    throw InputError("--threads", fmt::format("{}; expected 1 or more", options.study.num_threads));
  }
  options.study.fit = !options.no_fit;
  options.study.generator = FiniteElementGenerator({}, {}, nullptr);
  OutputFolder output(options.output, FolderKind::kStudyTables, "study mesh",
                      ExistingIf(options.force));
  output.Begin({"mesh.csv", "mesh.md", "mesh.svg"});
  const std::vector<MeshCase> cases = RunMeshStudy(options.study, [](const MeshCase& one) {
    Print(Terminal(), "{}, {} springs, {} particles: {:.1f} mm\n", one.motion,
          one.buckles ? "buckling" : "plain", one.particles, 1e3 * one.at_truth.fitted);
  });
  const std::string table = MeshStudyAsMarkdown(cases);
  output.WriteAll({{"mesh.csv", MeshStudyAsCsv(cases)},
                   {"mesh.md", table},
                   {"mesh.svg", MeshStudyAsSvg(cases)}});
  Print("{}", table);
  PrintNext("clothfit report " + ShellWord(options.output));
  return kExitSuccess;
}

void AddMeshStudy(CLI::App* study, Action* action) {
  CLI::App* const mesh = study->add_subcommand(
      "mesh", "how far is cloth on coarse meshes from finite elements on a fine one?");
  const auto options = std::make_shared<MeshCommandOptions>();
  mesh->add_option("-o,--output", options->output, "folder of tables and charts")
      ->type_name("FOLDER")
      ->required();
  mesh->add_option("--particles", options->study.particles, "particles a side of the meshes")
      ->type_name("N")
      ->capture_default_str();
  mesh->add_option("--threads", options->study.num_threads,
                   "cases at the same time; no influence on the result")
      ->type_name("N")
      ->capture_default_str();
  mesh->add_flag("--no-fit", options->no_fit, "at the true parameters alone");
  mesh->add_flag("--force", options->force, "replace what is there");
  mesh->footer("Example:\n  clothfit study mesh -o studies/mesh");
  mesh->callback([options, action] { *action = [options] { return RunMeshCommand(*options); }; });
}

}  // namespace

void AddStudyCommand(CLI::App* app, Action* action) {
  CLI::App* const study = app->add_subcommand("study", "measure clothfit itself");
  study->require_subcommand(1);
  study->footer("Example:\n  clothfit study recovery --seeds 20 -o studies/recovery");
  AddRecoveryStudy(study, action);
  AddTrackingStudy(study, action);
  AddChaosStudy(study, action);
  AddMeshStudy(study, action);
  AddJobStudies(study, action);
}

}  // namespace clothfit
