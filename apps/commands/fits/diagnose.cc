// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit diagnose: what physics does a recording show that the simulation lacks?
#include "fitting/diagnosis/pipeline/diagnose.h"

#include <cstdio>
#include <filesystem>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/options/value_checks.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/answer/folder.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "fitting/diagnosis/fitted/held_out_errors.h"
#include "fitting/jobs/shell.h"
#include "fitting/runs/fit_run.h"

namespace clothfit {
namespace {

struct DiagnoseOptions {
  ConfigOptions config;
  DiagnosisOptions diagnosis;
  FramesOptions frames;
  std::string output;
  bool no_projection = false, table_null = false, no_nudge = false;
  bool force = false, resume = false, quiet = false;
};

// Scores and nulls know observations with names, and outlines.
void LeaveOutClouds(const Recording& recording, bool quiet, FitConfig* config) {
  if (!config->use_clouds) return;
  config->use_clouds = false;
  if (recording.markers.empty() && recording.tracks.empty() && !HasMasks(recording)) {
    throw InputError(recording.path.string(),
                     "has clouds alone, by which a diagnosis cannot go; expected markers, tracks "
                     "or masks, too");
  }
  if (!quiet) Print(Terminal(), "clothfit: warning: a diagnosis does not go by clouds: left out\n");
}

int RunDiagnoseCommand(DiagnoseOptions options) {
  Recording recording = ReadRecordingOf(options.config);
  FitConfig config = ReadConfigOf(options.config, recording);
  LeaveOutClouds(recording, options.quiet, &config);
  TakeFrames(options.frames, &config);
  CheckConfig(config);
  LeaveOutOutliers(config, &recording, options.quiet);
  const Recording with_held_out = WithHeldOutFrames(recording, options.diagnosis.held_out_share);
  CheckFittable(MakeScene(with_held_out, config), config);
  const DiagnosisFolder folder(options.output, ExistingIf(options.force, options.resume));
  if (!options.quiet) PrintWarnings(recording);
  options.diagnosis.project = !options.no_projection;
  options.diagnosis.simulate_null = !options.table_null;
  options.diagnosis.nudge = !options.no_nudge;
  options.diagnosis.stop = StopOnInterrupt();
  options.diagnosis.kept_fits = folder.KeptFits();
  options.diagnosis.log = [&folder](const std::string& line) { folder.AppendLog(line); };
  options.diagnosis.so_far = [&folder](const Diagnosis& so_far) { folder.Write(so_far); };
  ProgressDisplay display(ProgressDisplay::Lines::kNowAndThen);
  if (!options.quiet) {
    options.diagnosis.progress = [&display](const std::string& stage, double fraction) {
      display.Show(stage, "", fraction);
    };
  }
  const Diagnosis diagnosis = Diagnose(recording, config, options.diagnosis);
  display.Finish();
  folder.Write(diagnosis);
  if (!options.quiet) Print("{}{}\n", DiagnosisAsText(diagnosis), folder.path().string());
  if (diagnosis.verdict != Verdict::kInterrupted) {
    if (!options.quiet) PrintNext("clothfit report " + ShellWord(folder.path().string()));
    return kExitSuccess;
  }
  Print(Terminal(), "clothfit: interrupted; the same command with --resume goes on\n");
  return kExitInterrupted;
}

void AddLookOptions(CLI::App* command, DiagnoseOptions* options) {
  BeginGroup(command, "What is looked for");
  DiagnosisOptions& diagnosis = options->diagnosis;
  command
      ->add_option("--exclude", diagnosis.excluded,
                   "a term that is not looked for; may be repeated")
      ->type_name("TERM");
  command->add_option("--max-effects", diagnosis.max_effects, "effects to add at most, 1 to 10")
      ->type_name("N")
      ->check(WholeNumber(1, 10))
      ->capture_default_str();
  command
      ->add_option("--max-models", diagnosis.max_models,
                   "physical candidates to fit for each effect, 1 to 40")
      ->type_name("N")
      ->check(WholeNumber(1, 40))
      ->capture_default_str();
  command
      ->add_option("--finest", diagnosis.finest_side,
                   "particles a side of the mesh that decides, at most; more tell more and take "
                   "longer; 3 to 100")
      ->type_name("N")
      ->check(WholeNumber(3, 100))
      ->capture_default_str();
  command->add_option("--seed", diagnosis.seed, "of the null and of the bootstrap")
      ->type_name("N")
      ->capture_default_str();
}

void AddAblationOptions(CLI::App* command, DiagnoseOptions* options) {
  BeginGroup(command, "Parts left out, to measure what they are worth");
  command->add_flag("--no-projection", options->no_projection,
                    "score candidates without taking out what others can do");
  command->add_flag("--table-null", options->table_null,
                    "noise alone instead of the null that is simulated again");
  command->add_flag("--no-nudge", options->no_nudge,
                    "locate the missing force along the free motion, never along a nudged one");
  command->add_flag("--no-guide", options->no_nudge)->group("");  // the same, not listed
}

}  // namespace

void AddDiagnoseCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("diagnose", "find out what physics was left out: where, which, how sure");
  const auto options = std::make_shared<DiagnoseOptions>();
  BeginGroup(command, "The answer");
  command->add_option("-o,--output", options->output, "folder of the answer")
      ->type_name("OUT")
      ->required();
  CLI::Option* const force = command->add_flag(
      "--force", options->force, "replace an earlier diagnosis there; other files stay");
  command
      ->add_flag("--resume", options->resume,
                 "go on with an interrupted diagnosis there; begins where there is none")
      ->excludes(force);
  command->add_flag("--quiet", options->quiet, "print errors only");
  AddThreadLimit(command);
  AddConfigOptions(command, &options->config);
  AddFreeOptions(command, &options->config);
  BeginGroup(command, "What is fitted");
  AddFramesOptions(command, &options->frames);
  AddLookOptions(command, options.get());
  AddAblationOptions(command, options.get());
  command->footer(
      "The baseline is the config: what it switches off is looked for. Writes diagnosis.json,\n"
      "diagnosis.md and config.yaml, which fit and simulate take.\n"
      "Ctrl-C stops (exit status 130); the same command with --resume does not repeat fits that\n"
      "were finished by then.\n\n"
      "Example, with wind that the recording says nothing of:\n"
      "  clothfit synthesize -o windy --scenario two-corner-swing --resolution 9 9 --refinement 2 "
      "\\\n"
      "      --frames 60 --rate 24 --markers 7 7 --noise 0.0015 --held-out 0.33 --set wind.y=0.6\n"
      "  clothfit diagnose windy -o runs/windy");
  command->callback(
      [options, action] { *action = [options] { return RunDiagnoseCommand(*options); }; });
}

}  // namespace clothfit
