// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit gradcheck: are the derivatives of a fit right?
#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/fit/gradient_report.h"
#include "fitting/jobs/shell.h"
#include "fitting/runs/fit_run.h"

namespace clothfit {
namespace {

constexpr int kDefaultFrames = 10;

struct GradcheckOptions {
  ConfigOptions config;
  std::optional<int> frames;
  std::vector<std::string> parameters;  // empty: those that a fit would free
};

const char* VerdictText(GradientVerdict verdict) {
  switch (verdict) {
    case GradientVerdict::kAgrees:
      return "agrees";
    case GradientVerdict::kDisagrees:
      return "WRONG";
    case GradientVerdict::kUndecided:
      break;
  }
  return "undecided: too little signal";
}

void PrintReport(const GradientReport& report, int frames) {
  Print("{} residuals of {} frames, {} evaluations\n\n", report.num_residuals, frames,
        report.check.evaluations);
  Print("  {:<32}{:>16}{:>20}  {}\n", "derivative along", "relative error", "difference's own",
        "verdict");
  for (size_t i = 0; i < report.names.size(); ++i) {
    const ColumnCheck& column = report.check.columns[i];
    Print("  {:<32}{:>16.2e}{:>20.2e}  {}\n", report.names[i], column.relative_error,
          column.difference_error, VerdictText(column.verdict));
  }
}

FitConfig MakeGradcheckConfig(const GradcheckOptions& options, const Recording& recording) {
  FitConfig config = ReadConfigOf(options.config, recording);
  if (!options.parameters.empty()) {
    for (auto& [name, setting] : config.parameters) setting.free = false;
  }
  for (const std::string& name : options.parameters) {
    SetFree("--parameters", name, true, &config);
  }
  CheckConfig(config);
  return config;
}

int RunGradcheckCommand(const GradcheckOptions& options) {
  Recording recording = ReadRecordingOf(options.config);
  const int frames = options.frames.value_or(std::min(kDefaultFrames, recording.frame_count));
  if (frames < 1 || frames > recording.frame_count) {
    throw InputError("--frames", fmt::format("{}: expected 1 to {}, the recording's length", frames,
                                             recording.frame_count));
  }
  const FitConfig config = MakeGradcheckConfig(options, recording);
  LeaveOutOutliers(config, &recording);
  const Scene scene = MakeScene(recording, config);
  CheckSimulable(scene);
  CheckContact(scene, config);
  const GradientReport report = CheckFitGradient(scene, config, frames - 1);
  PrintReport(report, frames);
  if (report.Passes()) PrintNext("clothfit fit " + ShellWord(recording.path.string()));
  return report.Passes() ? kExitSuccess : kExitFailure;
}

}  // namespace

void AddGradcheckCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("gradcheck", "compare the exact derivatives of a fit with differences");
  const auto options = std::make_shared<GradcheckOptions>();
  BeginGroup(command, "The check");
  command->add_option("--frames", options->frames, "how many frames")
      ->type_name("N")
      ->default_str(std::to_string(kDefaultFrames));
  command
      ->add_option("--parameters", options->parameters,
                   "parameter or term to check in place of the free ones; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  AddConfigOptions(command, &options->config);
  command->footer(
      "Exit status 1 where a derivative is wrong, or where none can be decided.\n\n"
      "Example:\n"
      "  clothfit gradcheck data/demo --frames 5 --parameters air_drag.normal");
  command->callback(
      [options, action] { *action = [options] { return RunGradcheckCommand(*options); }; });
}

}  // namespace clothfit
