// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit fit: from a recording to a run, or from several of one cloth.
#include <cstdio>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/commands/fits/fit_options.h"
#include "apps/commands/fits/fit_result_text.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "fitting/optimise/optimiser.h"
#include "fitting/report/records/run_record.h"
#include "fitting/report/verdict/facts.h"
#include "fitting/runs/fit_run.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

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
    callbacks.note = [&display](const std::string& line) { display.Note(line); };
  }
  FitResult result = FitIntoRun(scene, config, run, callbacks, options.resume).result;
  display.Finish();
  return result;
}

int Report(const FitResult& result, const RunFolder& run, bool quiet) {
  if (!quiet) {
    Print("{}\n{}\nrun: {}\n", DescribeFitResult(result),
          DescribeVerdict(JudgeFit(FactsOf(ReadRunRecord(run)))), run.path().string());
  }
  return EndOfFit(result, run, quiet);
}

RunFolder MakeRunFolder(const FitOptions& options, const Recording& recording) {
  return RunFolder(options.run.empty() ? DefaultRun(recording) : fs::path(options.run),
                   ExistingIf(options.force, options.resume));
}

int RunFitCommand(FitOptions options) {
  if (IsOfSeveral(options)) return RunFitOfSeveral(options);
  if (!options.recordings.empty()) options.config.recording = options.recordings.front();
  if (options.resume) TakeOptionsOfRun(&options);
  Recording recording = ReadRecordingOf(options.config);
  FitConfig config = ReadConfigOf(options.config, recording);
  ApplyOptions(options, &config);
  LeaveOutOutliers(config, &recording, options.quiet);
  Scene scene = MakeScene(recording, config);
  const bool track = HasPicturesOnly(recording);
  if (!track) CheckFittable(scene, config);
  CheckContact(scene, config);
  const RunFolder run = MakeRunFolder(options, recording);
  if (track) {
    const std::optional<Recording> tracked = TrackIntoRun(recording, run, options);
    if (!tracked) return kExitInterrupted;
    recording = *tracked;
    config = ReadConfigOf(options.config, recording);
    config.recording = fs::absolute(recording.path).lexically_normal().string();
    ApplyOptions(options, &config);
    LeaveOutOutliers(config, &recording, options.quiet);
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

void AddMeshOption(CLI::App* command, FitOptions* options) {
  DefaultIsKey("cloth.finest",
               command->add_option("--finest", options->finest,
                                   "without --resolution: particles along the longer side of the "
                                   "finest mesh that the fit may choose; 0: it keeps the "
                                   "recording's"))
      ->type_name("N");
}

void AddObservationOptions(CLI::App* command, FitOptions* options) {
  const std::map<std::string, LossKind> losses = {
      {"none", LossKind::kNone}, {"huber", LossKind::kHuber}, {"cauchy", LossKind::kCauchy}};
  BeginGroup(command, "What is fitted");
  AddFramesOptions(command, &options->frames);
  DefaultIsKey("observations.loss",
               command->add_option("--loss", options->loss, "how outliers count"),
               "; huber with tracks, masks or clouds")
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
  DefaultIsKey(
      "initial_state.order",
      command->add_option("--initial-order", options->initial_order,
                          "polynomial offsets of the state at frame 0: -1 none, 0 constant, 1 "
                          "bilinear, 2 biquadratic"),
      "; 0 where measured points place the cloth")
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
  DefaultIsKey("strategy.max_iterations",
               command->add_option("--max-iterations", options->max_iterations,
                                   "of the fit of all frames; windows take fewer"),
               fmt::format("; {} of outlines alone", kIterationsOfOutlines))
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
  AddThreadLimit(command);
  command
      ->add_option("--hold-out", options->hold_out,
                   "a recording to predict and not to fit, of those named or another; may be "
                   "repeated")
      ->type_name("RECORDING")
      ->allow_extra_args(false);
  AddConfigOptions(command, &options->config, &options->recordings);
  AddMeshOption(command, options);
  AddFreeOptions(command, &options->config);
  AddObservationOptions(command, options);
  AddSearchOptions(command, options);
}

}  // namespace

void AddFitCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("fit", "fit a cloth to a recording, or to several, and write a run");
  const auto options = std::make_shared<FitOptions>();
  AddFitOptions(command, options.get());
  command->footer(
      "Ctrl-C stops and keeps the best so far (exit status 130); --resume goes on from there. A "
      "fit\n"
      "that uses up its iterations ends with a warning and status 0. Several recordings are of "
      "one\n"
      "cloth: its material is fitted to all of them, and all else to each.\n\n"
      "Examples:\n"
      "  clothfit fit data/demo\n"
      "  clothfit fit takes/1 takes/2 takes/3 --hold-out takes/4 -o runs/silk\n"
      "  clothfit fit data/demo -o runs/b --set bending.stiffness=1e-4 --fix bending --window 0.5\n"
      "  clothfit fit --config runs/b/config.yaml -o runs/c --without air_drag\n"
      "  clothfit fit --resume -o runs/b");
  command->callback([options, action] { *action = [options] { return RunFitCommand(*options); }; });
}

}  // namespace clothfit
