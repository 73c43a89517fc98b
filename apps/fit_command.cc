// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit fit: from a recording to a run.
#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/config_options.h"
#include "apps/fit_result_text.h"
#include "apps/interrupt.h"
#include "apps/next_step.h"
#include "apps/progress_display.h"
#include "apps/terminal.h"
#include "apps/tracking_options.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "fitting/optimise/optimiser.h"
#include "fitting/report/run_record.h"
#include "fitting/runs/fit_run.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct Interrupted {};

struct FitOptions {
  ConfigOptions config;
  TrackingOptions tracking;  // where there are pictures only
  std::string run;           // empty: runs/NAME
  std::optional<double> window;
  std::optional<int> initial_order, max_iterations;
  std::optional<double> alpha, beta, max_simulations;
  std::optional<std::string> strategy, optimiser;
  std::optional<std::vector<int>> frames;
  std::optional<LossKind> loss;
  bool no_polish = false, attract = false, force = false, resume = false;
  bool quiet = false;
};

void ApplyOptions(const FitOptions& options, FitConfig* config) {
  if (options.window) config->window = *options.window;
  if (options.initial_order) config->initial_order = *options.initial_order;
  if (options.max_iterations) config->max_iterations = *options.max_iterations;
  if (options.frames) config->frames = {(*options.frames)[0], (*options.frames)[1]};
  if (options.loss) config->loss = *options.loss;
  if (options.alpha) config->alpha = *options.alpha;
  if (options.beta) config->beta = *options.beta;
  if (options.strategy) config->loops = ParseStrategy("--strategy", *options.strategy);
  if (options.optimiser) config->optimiser = *options.optimiser;
  if (options.max_simulations) config->max_simulations = *options.max_simulations;
  if (options.no_polish) config->polish = false;
  if (options.attract) Attract(config);
  CheckConfig(*config);
}

fs::path DefaultRun(const Recording& recording) {
  return fs::path("runs") / AsFolderName(recording.name);
}

// A resumed run goes on as it began: options that are not given are the run's own.
void TakeOptionsOfRun(FitOptions* options) {
  if (options->run.empty()) {
    if (options->config.recording.empty()) {
      throw InputError("--resume", "expected the run as -o RUN");
    }
    options->run = DefaultRun(ReadRecordingOf(options->config)).string();
  }
  const RunFolder run(options->run, RunFolder::Existing::kResume);
  if (options->config.config.empty()) options->config.config = run.ConfigFile().string();
}

FitResult FitWithDisplay(const Scene& scene, const FitConfig& config, const RunFolder& run,
                         const FitOptions& options) {
  ProgressDisplay display;
  FitCallbacks callbacks;
  callbacks.stop = StopOnInterrupt();
  if (!options.quiet) {
    callbacks.progress = [&display, &scene](const FitProgress& progress) {
      display.Show(progress, scene.recording.frame_count);
    };
  }
  FitResult result = FitIntoRun(scene, config, run, callbacks, options.resume);
  display.Finish();
  return result;
}

int Report(const FitResult& result, const RunFolder& run, bool quiet) {
  if (!quiet) {
    fmt::print("{}\n{}\nrun: {}\n", DescribeFitResult(result),
               DescribeVerdict(JudgeFit(FactsOf(ReadRunRecord(run)))), run.path().string());
  }
  std::fflush(stdout);
  const std::string hint =
      fmt::format("; 'clothfit fit --resume -o {}' goes on", run.path().string());
  switch (result.status) {
    case FitStatus::kConverged:
      if (!quiet) PrintNext("clothfit report " + ShellWord(run.path().string()));
      return kExitSuccess;
    case FitStatus::kNotConverged:
      fmt::print(Terminal(),
                 "clothfit: warning: not converged; 'clothfit fit --resume -o {} "
                 "--max-iterations N' goes on\n",
                 ShellWord(run.path().string()));
      if (!quiet) PrintNext("clothfit report " + ShellWord(run.path().string()));
      return kExitSuccess;
    case FitStatus::kInterrupted:
      fmt::print(Terminal(), "clothfit: interrupted{}\n", hint);
      return kExitInterrupted;
    case FitStatus::kFailed:
      break;
  }
  throw std::runtime_error("the fit failed: the simulation diverges, see " +
                           (run.path() / "log.txt").string());
}

RunFolder MakeRunFolder(const FitOptions& options, const Recording& recording) {
  return RunFolder(options.run.empty() ? DefaultRun(recording) : fs::path(options.run),
                   ExistingIf(options.force, options.resume));
}

bool HasPicturesOnly(const Recording& recording) {
  return recording.markers.empty() && recording.tracks.empty() && !HasClouds(recording) &&
         HasPictures(recording);
}

// What is seen in the pictures becomes a recording of its own, inside the run.
Recording TrackIntoRun(const Recording& recording, const RunFolder& run,
                       const FitOptions& options) {
  const fs::path folder = run.path() / "observations";
  if (options.resume && fs::exists(folder / "recording.yaml")) return ReadRecording(folder);
  run.Add({"observations/"});
  const TrackingResult found =
      TrackWithDisplay(recording, options.tracking, folder, Overwrite::kAllow, options.quiet);
  if (!options.quiet) fmt::print("{}\n\n", DescribeTracking(recording, found));
  std::fflush(stdout);
  if (found.num_frames == recording.frame_count) return ReadRecording(folder);
  std::error_code ignored;  // half of the observations would be taken for all
  fs::remove(folder / "recording.yaml", ignored);
  throw Interrupted();
}

int RunFitCommand(FitOptions options) {
  if (options.resume) TakeOptionsOfRun(&options);
  Recording recording = ReadRecordingOf(options.config);
  FitConfig config = ReadConfigOf(options.config, recording);
  ApplyOptions(options, &config);
  LeaveOutOutliers(config, &recording);
  Scene scene = MakeScene(recording, config);
  const bool track = HasPicturesOnly(recording);
  if (!track) CheckFittable(scene, config);
  CheckContact(scene, config);
  const RunFolder run = MakeRunFolder(options, recording);
  if (track) {
    try {
      recording = TrackIntoRun(recording, run, options);
    } catch (const Interrupted&) {
      fmt::print(Terminal(),
                 "clothfit: interrupted before the fit began; 'clothfit fit --force' "
                 "begins again\n");
      return kExitInterrupted;
    }
    config = ReadConfigOf(options.config, recording);
    config.recording = fs::absolute(recording.path).lexically_normal().string();
    ApplyOptions(options, &config);
    LeaveOutOutliers(config, &recording);
    scene = MakeScene(recording, config);
    CheckFittable(scene, config);
  }
  if (options.resume) RequireSameConfig(run, recording, config);
  if (!options.quiet) {
    PrintWarnings(recording);
    PrintWarnings(scene);
  }
  return Report(FitWithDisplay(scene, config, run, options), run, options.quiet);
}

void AddObservationOptions(CLI::App* command, FitOptions* options) {
  const std::map<std::string, LossKind> losses = {
      {"none", LossKind::kNone}, {"huber", LossKind::kHuber}, {"cauchy", LossKind::kCauchy}};
  BeginGroup(command, "What is fitted");
  command
      ->add_option("--frames", options->frames,
                   "first and last frame to fit; else all that are not held out")
      ->type_name("A B")
      ->expected(2);
  command
      ->add_option("--loss", options->loss,
                   "how outliers count (default: none; huber with tracks or masks)")
      ->transform(CLI::Transformer(losses))
      ->option_text("none|huber|cauchy");
  DefaultIsKey("observations.alpha",
               command->add_option("--alpha", options->alpha,
                                   "weight of the silhouettes; 0 leaves them out"))
      ->type_name("W");
  DefaultIsKey("observations.beta",
               command->add_option("--beta", options->beta,
                                   "weight of markers and tracks; 0 leaves them out"))
      ->type_name("W");
  command
      ->add_option("--initial-order", options->initial_order,
                   "polynomial offsets of the state at frame 0: -1 none, 0 constant, 1 bilinear, "
                   "2 biquadratic (default: -1; 0 where measured points place the cloth)")
      ->type_name("K");
}

void AddSearchOptions(CLI::App* command, FitOptions* options) {
  BeginGroup(command, "How it is searched");
  DefaultIsKey("strategy.window",
               command->add_option("--window", options->window,
                                   "seconds of the first windows, which grow; 0: all frames at "
                                   "once"))
      ->type_name("S");
  command->add_flag("--no-polish", options->no_polish,
                    "leave out the fit of all frames after the windows");
  command
      ->add_option("--max-iterations", options->max_iterations,
                   "of the fit of all frames; of windows at most 8 each (default: 60; 100 of "
                   "outlines alone)")
      ->type_name("N");
  DefaultIsKey("strategy.loops", command->add_option("--strategy", options->strategy,
                                                     "which unknowns are searched together"))
      ->option_text("joint|two-loop|one-loop");
  DefaultIsKey("strategy.optimiser",
               command->add_option(
                   "--optimiser", options->optimiser,
                   "lm (Levenberg-Marquardt) on the soft error; on the hard error " +
                       JoinNames({std::next(OptimiserNames().begin()), OptimiserNames().end()})))
      ->type_name("NAME");
  DefaultIsKey("strategy.max_simulations",
               command->add_option("--max-simulations", options->max_simulations,
                                   "of the recording, of all optimisers but lm; 0: until they "
                                   "converge"))
      ->type_name("N");
  command->add_flag("--attract", options->attract,
                    "let markers and rays pull at the cloth while fitting (attraction_point.*, "
                    "attraction_ray.*)");
}

void AddFitOptions(CLI::App* command, FitOptions* options) {
  BeginGroup(command, "The run");
  command->add_option("-o,--output", options->run, "folder of the run; runs/NAME if left out")
      ->type_name("RUN");
  command->add_flag("--force", options->force, "replace the run that is there; other files stay");
  command->add_flag("--resume", options->resume, "go on with an interrupted run")
      ->excludes("--force");
  command->add_flag("--quiet", options->quiet, "print errors only");
  AddConfigOptions(command, &options->config);
  AddFreeOptions(command, &options->config);
  AddObservationOptions(command, options);
  AddSearchOptions(command, options);
}

}  // namespace

void AddFitCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("fit", "fit a cloth to a recording and write a run");
  const auto options = std::make_shared<FitOptions>();
  AddFitOptions(command, options.get());
  command->footer(
      "Ctrl-C stops and keeps the best so far (exit status 130); --resume goes on from there. A "
      "fit\n"
      "that uses up its iterations ends with a warning and status 0.\n\n"
      "Examples:\n"
      "  clothfit fit data/demo\n"
      "  clothfit fit data/demo -o runs/b --set bending.stiffness=1e-4 --fix bending --window 0.5\n"
      "  clothfit fit --config runs/b/config.yaml -o runs/c --without air_drag\n"
      "  clothfit fit --resume -o runs/b");
  command->callback([options, action] { *action = [options] { return RunFitCommand(*options); }; });
}

}  // namespace clothfit
