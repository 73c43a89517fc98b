// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit trials: how good the diagnosis of missing physics is, on recordings with planted
// effects.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/commands.h"
#include "apps/interrupt.h"
#include "apps/progress_display.h"
#include "autodiff_sim/error.h"
#include "fitting/diagnosis/diagnosis_folder.h"
#include "fitting/diagnosis/trial_effect_table.h"
#include "fitting/diagnosis/trial_plan.h"
#include "fitting/diagnosis/trial_run.h"
#include "fitting/diagnosis/trial_summary.h"
#include "fitting/whole_file.h"
#include "tracking/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct TrialsOptions {
  std::string plan, output;
  TrialPlanOptions size;
  int num_threads = 1;
  bool no_projection = false, table_null = false, no_proof = false, no_true_model = false;
  bool keep_recordings = false, keep_diagnoses = false, resume = false, force = false;
  bool list = false, effects = false;
};

// What decides the scores.
std::string Conditions(const TrialsOptions& options) {
  std::string only;
  for (const std::string& name : options.size.only) only += (only.empty() ? "" : ", ") + name;
  const auto flag = [](bool value) { return value ? "true" : "false"; };
  return fmt::format(
      "plan: {}\nmatch: '{}'\nfirst_seed: {}\nseeds: {}\nonly: [{}]\nframes: {}\nresolution: {}\n"
      "same_generator: {}\nfinite_elements: {}\nproject: {}\nsimulate_null: {}\nprove: "
      "{}\ntrue_model: {}\n",
      options.plan, options.size.match, options.size.first_seed, options.size.num_seeds, only,
      options.size.frame_count, options.size.resolution, flag(options.size.same_generator),
      flag(options.size.finite_elements), flag(!options.no_projection), flag(!options.table_null),
      flag(!options.no_proof), flag(!options.no_true_model));
}

// The scores to go on from; makes the folder and writes down what is to be found in it.
std::vector<TrialScore> Prepare(const TrialsOptions& options, const std::vector<Trial>& trials) {
  const fs::path folder = options.output;
  const std::string conditions = Conditions(options), commitments = CommitmentsAsCsv(trials);
  std::vector<TrialScore> before;
  if (options.resume) {
    const bool same = ReadTextFile(folder / "conditions.yaml") == conditions &&
                      ReadTextFile(folder / "commitments.csv") == commitments;
    if (!same) {
      throw InputError("--resume", "the options or the plan differ from those in " +
                                       folder.string() + "/conditions.yaml and commitments.csv");
    }
    if (fs::exists(folder / "trials.csv")) before = ReadScores(folder / "trials.csv");
    return before;
  }
  if (fs::exists(folder / "conditions.yaml") && !options.force) {
    throw InputError(options.output,
                     "already holds trials; --force replaces them, --resume goes on with them");
  }
  fs::create_directories(folder);
  fs::remove(folder / "trials.csv");
  fs::remove(folder / "trials.md");
  WriteWholeFile(folder / "conditions.yaml", conditions);
  WriteWholeFile(folder / "commitments.csv", commitments);
  return before;
}

int RunAll(const TrialsOptions& options, const std::vector<Trial>& trials) {
  if (options.output.empty()) throw InputError("--output", "is missing: expected a folder");
  const std::vector<TrialScore> before = Prepare(options, trials);
  const fs::path folder = options.output;
  ProgressDisplay display;
  TrialRunOptions run;
  run.diagnosis.project = !options.no_projection;
  run.diagnosis.simulate_null = !options.table_null;
  run.diagnosis.prove = !options.no_proof;
  run.folder = folder / "recordings";
  run.keep_recordings = options.keep_recordings;
  if (options.keep_diagnoses) {
    run.diagnosed = [&](const Trial& trial, const Diagnosis& diagnosis,
                        const std::vector<std::string>& log) {
      const DiagnosisFolder kept(folder / "diagnoses" / trial.name, true);
      for (const std::string& line : log) kept.AppendLog(line);
      kept.Write(diagnosis);
    };
  }
  run.refit_truth = !options.no_true_model;
  run.num_threads = options.num_threads;
  run.stop = StopOnInterrupt();
  const auto write = [&](const std::vector<TrialScore>& scores) {
    WriteWholeFile(folder / "trials.csv", ScoresAsCsv(scores));
    WriteWholeFile(folder / "trials.md", ScoresAsMarkdown(scores));
  };
  run.done = [&](const std::vector<TrialScore>& scores) {
    write(scores);
    display.Show("trials", fmt::format("{} of {}", scores.size(), trials.size()),
                 static_cast<double>(scores.size()) / static_cast<double>(trials.size()));
  };
  const std::vector<TrialScore> scores = RunTrials(trials, Diagnose, run, before);
  display.Finish();
  write(scores);
  fmt::print("{}\n{}\n", ScoresAsMarkdown(scores), folder.string());
  std::fflush(stdout);
  if (!*run.stop) return kExitSuccess;
  fmt::print(stderr, "clothfit: interrupted; the same command with --resume goes on\n");
  return kExitInterrupted;
}

int PrintEffects(const TrialsOptions& options, const std::vector<Trial>& trials) {
  ProgressDisplay display;
  const std::atomic<bool>* const stop = StopOnInterrupt();
  const std::vector<MeasuredEffect> effects = MeasureEffects(
      trials, options.num_threads,
      [&](double share) { display.Show("effects", fmt::format("{:.0f} %", 100.0 * share), share); },
      stop);
  display.Finish();
  fmt::print("{}", EffectsAsMarkdown(effects));
  return *stop ? kExitInterrupted : kExitSuccess;
}

int RunTrialsCommand(const TrialsOptions& options) {
  if (options.num_threads < 1)
    throw InputError("--threads", fmt::format("{}: expected 1 or more", options.num_threads));
  const std::vector<Trial> trials = MakeTrialPlan("PLAN", options.plan, options.size);
  if (options.list) {
    fmt::print("{}", DescribePlan(trials));
    return kExitSuccess;
  }
  return options.effects ? PrintEffects(options, trials) : RunAll(options, trials);
}

void AddPlanOptions(CLI::App* command, TrialsOptions* options) {
  command->add_option("plan", options->plan, "one of " + JoinNames(TrialPlanNames()))
      ->type_name("PLAN")
      ->required();
  command->add_option("--seeds", options->size.num_seeds, "how often the whole plan is drawn")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--first-seed", options->size.first_seed, "seed of the first")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--only", options->size.only, "effects and faults; all others are left out")
      ->type_name("EFFECT");
  command
      ->add_option("--match", options->size.match,
                   "only trials with this in their name, see --list")
      ->type_name("TEXT");
  command->add_option("--frames", options->size.frame_count, "of each recording")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--resolution", options->size.resolution,
                   "particles a side that a recording tells a fit to use")
      ->type_name("N")
      ->capture_default_str();
  CLI::Option* const same =
      command->add_flag("--same-generator", options->size.same_generator,
                        "simulate the recordings with the fit's mesh and step");
  command
      ->add_flag("--finite-elements", options->size.finite_elements,
                 "simulate them by finite elements, which share no code with a fit")
      ->excludes(same);
}

void AddRunOptions(CLI::App* command, TrialsOptions* options) {
  command->add_option("-o,--output", options->output, "folder of the tables")->type_name("FOLDER");
  command->add_flag("--no-projection", options->no_projection,
                    "candidates do not compete with the baseline and the faults");
  command->add_flag("--table-null", options->table_null,
                    "chi-squared tables instead of a re-simulated null");
  command->add_flag("--no-proof", options->no_proof, "keep effects without a held-out proof");
  command->add_flag("--no-true-model", options->no_true_model,
                    "do not find what the true model would predict, which costs a fit a trial");
  command
      ->add_option("--threads", options->num_threads,
                   "trials at the same time; no influence on the scores")
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--keep-recordings", options->keep_recordings,
                    "write every recording and leave it in FOLDER/recordings");
  command->add_flag("--keep-diagnoses", options->keep_diagnoses,
                    "leave every diagnosis in FOLDER/diagnoses");
  command->add_flag("--force", options->force, "replace the trials that are there");
  command->add_flag("--resume", options->resume, "go on with interrupted trials")
      ->excludes("--force");
  CLI::Option* const list = command->add_flag("--list", options->list, "print the plan only");
  command
      ->add_flag("--effects", options->effects,
                 "print only how far each effect of the plan moves the cloth")
      ->excludes(list);
}

}  // namespace

void AddTrialsCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand(
      "trials", "recordings with planted effects; does the diagnosis find them?");
  const auto options = std::make_shared<TrialsOptions>();
  AddPlanOptions(command, options.get());
  AddRunOptions(command, options.get());
  command->footer(
      "Examples:\n"
      "  clothfit trials --list listed\n"
      "  clothfit trials --effects listed --only wind gust\n"
      "  clothfit trials all --seeds 2 -o trials");
  command->callback(
      [options, action] { *action = [options] { return RunTrialsCommand(*options); }; });
}

}  // namespace clothfit
