// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit compare: optimisers and strategies side by side on one recording.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "fitting/runs/fit_run.h"
#include "fitting/studies/comparison.h"
#include "tracking/files/output_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct CompareOptions {
  ConfigOptions config;
  std::vector<std::string> contenders = {"lm/joint", "pattern/two-loop"};
  ComparisonOptions comparison;
  std::string output;
  std::optional<double> alpha, beta;
  FramesOptions frames;
  bool force = false, resume = false, quiet = false;
};

void CheckOptions(CompareOptions* options) {
  for (const std::string& name : options->contenders)
    options->comparison.contenders.push_back(ParseContender("--contenders", name));
  const auto require = [](bool right, const char* option, const std::string& problem) {
    if (!right) throw InputError(option, problem);
  };
  const ComparisonOptions& comparison = options->comparison;
  require(comparison.num_starts >= 1, "--starts",
          fmt::format("{}: expected 1 or more", comparison.num_starts));
  require(comparison.num_threads >= 1, "--threads",
          fmt::format("{}: expected 1 or more", comparison.num_threads));
  require(comparison.spread >= 0.0, "--spread",
          fmt::format("{}: expected 0 or more", comparison.spread));
  require(comparison.budget.evaluations > 0.0, "--max-simulations",
          fmt::format("{}: expected a number above 0", comparison.budget.evaluations));
  require(comparison.budget.seconds > 0.0, "--max-seconds",
          fmt::format("{}: expected a number above 0", comparison.budget.seconds));
}

FitConfig ConfigOf(const CompareOptions& options, const Recording& recording) {
  FitConfig config = ReadConfigOf(options.config, recording);
  if (options.alpha) config.alpha = *options.alpha;
  if (options.beta) config.beta = *options.beta;
  TakeFrames(options.frames, &config);
  CheckConfig(config);
  return config;
}

// What decides the runs, beside the config.
std::string Conditions(const ComparisonOptions& options) {
  return fmt::format("spread: {}\nseed: {}\nmax_simulations: {}\nmax_seconds: {}\nthreads: {}\n",
                     FormatNumber(options.spread), options.seed,
                     FormatNumber(options.budget.evaluations), FormatNumber(options.budget.seconds),
                     options.num_threads);
}

OutputFolder OpenFolder(const CompareOptions& options) {
  return OutputFolder(options.output, FolderKind::kComparison, "compare",
                      ExistingIf(options.force, options.resume));
}

// The comparison to go on with.
std::optional<Comparison> Prepare(const CompareOptions& options, const FitConfig& config,
                                  OutputFolder* output) {
  const fs::path folder = output->path(), file = folder / "comparison.json";
  const std::string yaml = ConfigToYaml(config), conditions = Conditions(options.comparison);
  std::optional<Comparison> before;
  if (options.resume) {
    const bool same = ReadTextFile(folder / "config.yaml") == yaml &&
                      ReadTextFile(folder / "conditions.yaml") == conditions;
    if (!same) {
      throw InputError("--resume", "the options differ from those in " + folder.string() +
                                       "/config.yaml and conditions.yaml");
    }
    if (fs::exists(file)) before = ReadComparison(file);
  }
  output->Begin({"config.yaml", "conditions.yaml", "comparison.json", "comparison.md",
                 "comparison.svg", "runs.csv", "history.csv"});
  output->WriteAll({{"config.yaml", yaml}, {"conditions.yaml", conditions}});
  return before;
}

void WriteTables(const fs::path& folder, const Comparison& comparison) {
  WriteWholeFile(folder / "comparison.md", ComparisonAsMarkdown(comparison));
  WriteWholeFile(folder / "runs.csv", ComparisonRunsAsCsv(comparison));
  WriteWholeFile(folder / "history.csv", ComparisonHistoryAsCsv(comparison));
  WriteWholeFile(folder / "comparison.svg", ComparisonAsSvg(comparison));
}

int RunCompareCommand(CompareOptions options) {
  CheckOptions(&options);
  Recording recording = ReadRecordingOf(options.config);
  const FitConfig config = ConfigOf(options, recording);
  LeaveOutOutliers(config, &recording, options.quiet);
  const Scene scene = MakeScene(recording, config);
  CheckFittable(scene, config);
  CheckContact(scene, config);
  if (!options.quiet) {
    PrintWarnings(recording);
    PrintWarnings(scene);
  }
  OutputFolder output = OpenFolder(options);
  const std::optional<Comparison> before = Prepare(options, config, &output);
  const fs::path folder = options.output;
  ProgressDisplay display;
  ComparisonCallbacks callbacks;
  callbacks.stop = StopOnInterrupt();
  const double runs = static_cast<double>(options.contenders.size()) *
                      static_cast<double>(options.comparison.num_starts);
  std::size_t num_done = before ? before->runs.size() : 0;
  if (!options.quiet) {
    callbacks.progress = [&](const std::string& name, int start, const SearchPoint& point) {
      display.Show(fmt::format("start {}, {}", start, name),
                   fmt::format("{:.0f} simulations, error {:.6g}", point.simulations, point.error),
                   static_cast<double>(num_done) / runs);
    };
  }
  callbacks.done = [&](const Comparison& comparison) {
    num_done = comparison.runs.size();
    WriteComparison(folder / "comparison.json", comparison);
  };
  const Comparison comparison =
      Compare(scene, config, options.comparison, before ? &*before : nullptr, callbacks);
  display.Finish();
  WriteComparison(folder / "comparison.json", comparison);
  WriteTables(folder, comparison);
  if (!options.quiet) Print("{}\n{}\n", ComparisonAsMarkdown(comparison), folder.string());
  if (!options.quiet && !*callbacks.stop)
    PrintNext("clothfit report " + ShellWord(folder.string()));
  std::fflush(stdout);
  if (!*callbacks.stop) return kExitSuccess;
  Print(Terminal(), "clothfit: interrupted; the same command with --resume goes on\n");
  return kExitInterrupted;
}

void AddContenderOptions(CLI::App* command, ComparisonOptions* comparison,
                         CompareOptions* options) {
  BeginGroup(command, "Who is compared, and how long");
  command
      ->add_option("--contenders", options->contenders,
                   "OPTIMISER/STRATEGY, separated by commas; the last is the one that the others "
                   "are measured by")
      ->type_name("LIST")
      ->delimiter(',')
      ->capture_default_str();
  command->add_option("--starts", comparison->num_starts, "how many: the config's, and moved ones")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--spread", comparison->spread,
                   "of moved starts: logarithms, or sigmas of the prior")
      ->type_name("S")
      ->capture_default_str();
  command->add_option("--seed", comparison->seed, "of the starts and of what draws lots")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--max-simulations", comparison->budget.evaluations,
                   "of each run; else until it converges")
      ->type_name("N");
  command
      ->add_option("--max-seconds", comparison->budget.seconds,
                   "of each run; else until it converges")
      ->type_name("S");
  command
      ->add_option("--threads", comparison->num_threads,
                   "of pattern search; the others have no use for more than one")
      ->type_name("N")
      ->default_str("all cores");
}

void AddCompareOptions(CLI::App* command, CompareOptions* options) {
  ComparisonOptions& comparison = options->comparison;
  comparison.num_threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  BeginGroup(command, "The comparison");
  command->add_option("-o,--output", options->output, "folder of the tables, curves and picture")
      ->type_name("FOLDER")
      ->required();
  command->add_flag("--force", options->force,
                    "replace the comparison that is there; other files stay");
  command->add_flag("--resume", options->resume, "go on with an interrupted comparison")
      ->excludes("--force");
  command->add_flag("--quiet", options->quiet, "print errors only");
  AddConfigOptions(command, &options->config);
  AddFreeOptions(command, &options->config);
  AddContenderOptions(command, &comparison, options);
  BeginGroup(command, "What is fitted");
  AddFramesOptions(command, &options->frames);
  DefaultIsKey("observations.alpha",
               command->add_option("--alpha", options->alpha, "weight of the silhouettes"))
      ->type_name("W");
  DefaultIsKey("observations.beta",
               command->add_option("--beta", options->beta, "weight of markers and tracks"))
      ->type_name("W");
}

}  // namespace

void AddCompareCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand(
      "compare", "optimisers and strategies from the same starts, judged by the same error");
  const auto options = std::make_shared<CompareOptions>();
  AddCompareOptions(command, options.get());
  command->footer(
      "The error is that of hard silhouettes (alpha) and of markers and tracks (beta), summed "
      "over\n"
      "the frames. A simulation with derivatives counts as what it costs here.\n\n"
      "Example:\n"
      "  clothfit compare lift --beta 0 --contenders lm/joint,bobyqa/joint,pattern/two-loop \\\n"
      "    --starts 3 --max-seconds 600 -o comparison");
  command->callback(
      [options, action] { *action = [options] { return RunCompareCommand(*options); }; });
}

}  // namespace clothfit
