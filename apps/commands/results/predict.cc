// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit predict: where any point of a fitted cloth is in any frame.
#include <filesystem>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "fitting/jobs/shell.h"
#include "fitting/runs/prediction.h"

namespace clothfit {
namespace {

struct PredictOptions {
  std::string run, points, output;
  bool force = false;
};

int RunPredictCommand(const PredictOptions& options) {
  const Overwrite overwrite = OverwriteIf(options.force);
  CheckMayWrite(options.output, overwrite);
  const RunFolder run = RunFolder::Open(options.run);
  const FittedRun fitted = ReadFittedRun(run);
  const std::vector<PredictionQuery> queries = ReadQueries(options.points, fitted.scene);
  WritePredictions(options.output, queries, Predict(fitted, run, queries), overwrite);
  Print("{} points: {}\n", queries.size(), options.output);
  PrintNext("clothfit draw " + ShellWord(options.run) + " -o cloth.png");
  return kExitSuccess;
}

}  // namespace

void AddPredictCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("predict", "where points of a fitted cloth are, in any frame");
  const auto options = std::make_shared<PredictOptions>();
  command->add_option("RUN", options->run, "folder of the run")->required();
  command->add_option("--at", options->points, "CSV file with the columns frame,u,v (u, v in m)")
      ->type_name("FILE")
      ->required();
  command->add_option("-o,--output", options->output, "CSV file to write: frame,u,v,x,y,z (m)")
      ->type_name("FILE")
      ->required();
  command->add_flag("--force", options->force, "replace the file that is there");
  command->footer(
      "Frames beyond the fitted ones are simulated on along the known paths of the handles.\n\n"
      "Example:\n"
      "  clothfit predict runs/demo --at points.csv -o predicted.csv");
  command->callback(
      [options, action] { *action = [options] { return RunPredictCommand(*options); }; });
}

}  // namespace clothfit
