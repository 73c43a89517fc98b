// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/commands/fits/fit_options.h"

#include <cstdio>
#include <stdexcept>

#include "apps/process/exit_status.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "fitting/fit/rugged_cost.h"
#include "fitting/jobs/shell.h"

namespace clothfit {

void ApplyOptions(const FitOptions& options, FitConfig* config) {
  if (options.window) config->window = *options.window;
  if (options.initial_order) config->initial_order = *options.initial_order;
  if (options.max_iterations) config->max_iterations = *options.max_iterations;
  ForgetChosenMesh(config);
  if (options.finest) config->finest = *options.finest;
  TakeFrames(options.frames, config);
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

int EndOfFit(const FitResult& result, const RunFolder& run, bool quiet) {
  std::fflush(stdout);
  const std::string folder = ShellWord(run.path().string());
  const std::string rugged_cost = RuggedCostAmong(result.statements);
  switch (result.status) {
    case FitStatus::kConverged:
      if (!quiet) PrintNext("clothfit report " + folder);
      return kExitSuccess;
    case FitStatus::kNotConverged:
      if (rugged_cost.empty()) {
        Print(Terminal(),
              "clothfit: warning: not converged; 'clothfit fit --resume -o {} "
              "--max-iterations N' goes on\n",
              folder);
      } else {
        Print(Terminal(), "clothfit: warning: not converged: {}\n", rugged_cost);
      }
      if (!quiet) PrintNext("clothfit report " + folder);
      return kExitSuccess;
    case FitStatus::kInterrupted:
      Print(Terminal(), "clothfit: interrupted; 'clothfit fit --resume -o {}' goes on\n",
            run.path().string());
      return kExitInterrupted;
    case FitStatus::kFailed:
      break;
  }
  throw std::runtime_error("the fit failed: the simulation diverges, see " +
                           (run.path() / "log.txt").string());
}

bool HasPicturesOnly(const Recording& recording) {
  return recording.markers.empty() && recording.tracks.empty() && !HasClouds(recording) &&
         HasPictures(recording);
}

std::optional<Recording> TrackIntoRun(const Recording& recording, const RunFolder& run,
                                      const FitOptions& options) {
  const std::filesystem::path folder = run.path() / "observations";
  if (options.resume && std::filesystem::exists(folder / "recording.yaml"))
    return ReadRecording(folder);
  run.Add({"observations/"});
  const TrackingResult found =
      TrackWithDisplay(recording, options.tracking, folder, Overwrite::kAllow, options.quiet);
  if (!options.quiet) Print("{}\n\n", DescribeTracking(recording, found));
  std::fflush(stdout);
  if (found.num_frames == recording.frame_count) return ReadRecording(folder);
  std::error_code ignored;  // half of the observations would be taken for all
  std::filesystem::remove(folder / "recording.yaml", ignored);
  Print(Terminal(),
        "clothfit: interrupted before the fit began; 'clothfit fit --force' "
        "begins again\n");
  return std::nullopt;
}

}  // namespace clothfit
