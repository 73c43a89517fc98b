// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit evaluate: how far a run's surface is from the truth.
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/commands/commands.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "fitting/jobs/shell.h"
#include "fitting/report/records/run_record.h"
#include "fitting/runs/surface_evaluation.h"
#include "tracking/recording/surface/truth.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct EvaluateOptions {
  std::string run, truth, output;
  bool force = false;
};

// "9 of 10 intervals hold the truth; not: bending.damping (2e-05 .. 6e-05, truth 1e-04)" of the
// free parameters that the data determine; empty where the truth of none is known.
std::string IntervalsAgainstTruth(const RunFolder& run, const std::filesystem::path& recording) {
  const std::filesystem::path file = run.path() / "summary.json";
  if (!HasTruthParameters(recording) || !std::filesystem::exists(file)) return "";
  const std::map<std::string, double> truth = ReadTruthParameters(recording);
  int known = 0, held = 0;
  std::vector<std::string> missed;
  const nlohmann::ordered_json summary = ReadRunRecord(run).summary;
  for (const auto& [name, estimate] : summary.at("parameters").items()) {
    const auto value = truth.find(name);
    if (value == truth.end() || estimate.at("determined") != true) continue;
    const auto& ends = estimate.at("interval");
    if (!ends.at(0).is_number() || !ends.at(1).is_number()) continue;
    const double lower = ends.at(0), upper = ends.at(1);
    ++known;
    if (value->second >= lower && value->second <= upper) {
      ++held;
    } else {
      missed.push_back(
          fmt::format("{} ({:.4g} .. {:.4g}, truth {:.4g})", name, lower, upper, value->second));
    }
  }
  if (known == 0) return "";
  return fmt::format("\n{} of {} intervals (95 %) of determined parameters hold the truth{}{}\n",
                     held, known, missed.empty() ? "" : "; not: ", JoinNames(missed));
}

int RunEvaluateCommand(const EvaluateOptions& options) {
  const Overwrite overwrite = OverwriteIf(options.force);
  if (!options.output.empty()) CheckMayWrite(options.output, overwrite);
  const RunFolder run = RunFolder::Open(options.run);
  const SurfaceEvaluation evaluation = EvaluateSurface(run, options.truth);
  if (!options.output.empty()) WriteOutputFile(options.output, SurfaceAsCsv(evaluation), overwrite);
  Print("{}{}", SurfaceAsMarkdown(evaluation), IntervalsAgainstTruth(run, options.truth));
  PrintNext("clothfit report " + ShellWord(options.run));
  return kExitSuccess;
}

}  // namespace

void AddEvaluateCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("evaluate", "compare a run's surface with a recording's truth");
  const auto options = std::make_shared<EvaluateOptions>();
  command->add_option("RUN", options->run, "folder of the run")->required();
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
