// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit track: from pictures to masks, tracks and markers.
#include <chrono>
#include <cstdio>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/options/tracking.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "fitting/jobs/shell.h"
#include "tracking/features/tracking_folder.h"

namespace clothfit {
namespace {

struct TrackOptions {
  TrackingOptions tracking;
  std::string recording, output;
  bool force = false, quiet = false;
};

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int RunTrackCommand(const TrackOptions& options) {
  const Recording recording = ReadRecording(options.recording);
  const auto start = std::chrono::steady_clock::now();
  const TrackingResult result = TrackWithDisplay(recording, options.tracking, options.output,
                                                 OverwriteIf(options.force), options.quiet);
  const double seconds = SecondsSince(start);
  if (!options.quiet) {
    Print("{}\n", DescribeTracking(recording, result));
    Print("{:.1f} s, {:.1f} pictures a second\nrecording: {}\n", seconds,
          static_cast<double>(result.pictures.size()) / seconds, options.output);
    if (result.num_frames == recording.frame_count)
      PrintNext("clothfit fit " + ShellWord(options.output));
    std::fflush(stdout);
  }
  if (result.num_frames == recording.frame_count) return kExitSuccess;
  Print(Terminal(), "clothfit: interrupted after frame {}; what was found is in {}\n",
        result.num_frames - 1, options.output);
  return kExitInterrupted;
}

}  // namespace

void AddTrackCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("track", "find masks, tracks and markers in a recording's pictures");
  const auto options = std::make_shared<TrackOptions>();
  command->add_option("RECORDING", options->recording, "folder of the recording")->required();
  BeginGroup(command, "The result");
  command
      ->add_option("-o,--output", options->output,
                   "folder of what is found, a recording without pictures")
      ->type_name("OUT")
      ->required();
  AddTrackingOptions(command, &options->tracking);
  command->add_flag("--force", options->force,
                    "replace what clothfit wrote there; other files stay");
  command->add_flag("--quiet", options->quiet, "print errors only");
  command->footer(
      "Writes masks/, tracks.csv and markers.csv, what each picture gave (pictures.csv) and what\n"
      "each filter threw out (filters.csv). 'clothfit fit OUT' fits it; 'clothfit fit RECORDING'\n"
      "does both where a recording has pictures only.\n\n"
      "Example:\n"
      "  clothfit track lift -o lift-tracked --reidentify tracking");
  command->callback(
      [options, action] { *action = [options] { return RunTrackCommand(*options); }; });
}

}  // namespace clothfit
