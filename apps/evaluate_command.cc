// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit evaluate: how far a run's surface is from the truth.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "apps/commands.h"
#include "fitting/runs/surface_evaluation.h"

namespace clothfit {
namespace {

struct EvaluateOptions {
  std::string run, truth, output;
  bool force = false;
};

int RunEvaluateCommand(const EvaluateOptions& options) {
  const Overwrite overwrite = OverwriteIf(options.force);
  if (!options.output.empty()) CheckMayWrite(options.output, overwrite);
  const SurfaceEvaluation evaluation = EvaluateSurface(RunFolder::Open(options.run), options.truth);
  if (!options.output.empty()) WriteOutputFile(options.output, SurfaceAsCsv(evaluation), overwrite);
  fmt::print("{}", SurfaceAsMarkdown(evaluation));
  return kExitSuccess;
}

}  // namespace

void AddEvaluateCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("evaluate", "compare a run's surface with a recording's truth");
  const auto options = std::make_shared<EvaluateOptions>();
  command->add_option("run", options->run, "folder of the run")->type_name("RUN")->required();
  command->add_option("--truth", options->truth, "recording with truth/")
      ->type_name("RECORDING")
      ->required();
  command->add_option("-o,--output", options->output, "also write the errors frame by frame")
      ->type_name("FILE.csv");
  command->add_flag("--force", options->force, "replace the file that is there");
  command->footer(
      "truth/ has points.csv (points of known (u, v)) or cloud_000000.csv ... (points of the\n"
      "surface), see docs/file-formats.md.\n\n"
      "Example:\n"
      "  clothfit evaluate runs/lift --truth lift -o lift.csv");
  command->callback(
      [options, action] { *action = [options] { return RunEvaluateCommand(*options); }; });
}

}  // namespace clothfit
