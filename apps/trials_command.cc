// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit trials: how good the diagnosis of missing physics is, on recordings with planted
// effects.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/config_options.h"
#include "apps/interrupt.h"
#include "apps/progress_display.h"
#include "apps/study_commands.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/answer/folder.h"
#include "fitting/diagnosis/pipeline/diagnose.h"
#include "fitting/files/sha256.h"
#include "fitting/files/version.h"
#include "fitting/trials/effect_table.h"
#include "fitting/trials/plan.h"
#include "fitting/trials/run.h"
#include "fitting/trials/summary.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct TrialsOptions {
  std::string plan;
  TrialPlanOptions size;
  JobOptions jobs;
  int finest_side = DiagnosisOptions().finest_side;
  bool no_projection = false, table_null = false, no_guide = false;
  bool no_true_model = false;
  bool keep_recordings = false, keep_diagnoses = false;
  bool list = false, effects = false;
};

// What decides the scores. The digest of the labels' digests binds to them before any is scored.
std::string Conditions(const TrialsOptions& options, const std::string& commitments) {
  std::string only;
  for (const std::string& name : options.size.only) only += (only.empty() ? "" : ", ") + name;
  const auto flag = [](bool value) { return value ? "true" : "false"; };
  return fmt::format(
      "clothfit: {}\nplan: {}\nmatch: '{}'\nsample: {}\nfirst_seed: {}\nseeds: {}\nonly: "
      "[{}]\nframes: {}\n"
      "resolution: {}\nfinest: {}\nsame_generator: {}\nfinite_elements: {}\nproject: "
      "{}\nsimulate_null: {}\n"
      "guide: {}\ntrue_model: {}\ncommitments: {}\n",
      Version(), options.plan, options.size.match, options.size.sample, options.size.first_seed,
      options.size.num_seeds, only, options.size.frame_count, options.size.resolution,
      options.finest_side, flag(options.size.same_generator), flag(options.size.finite_elements),
      flag(!options.no_projection), flag(!options.table_null), flag(!options.no_guide),
      flag(!options.no_true_model), Sha256(commitments));
}

// Makes the folder and writes down what is to be found in it.
FolderLock Prepare(const TrialsOptions& options, const std::vector<Trial>& trials,
                   const JobFolderOptions& folder_options) {
  const fs::path folder = options.jobs.output;
  const std::string commitments = CommitmentsAsCsv(trials);
  JobFolderContents contents;
  contents.kind = FolderKind::kTrials;
  contents.command = "trials";
  contents.file = "conditions.yaml";
  contents.description = Conditions(options, commitments);
  contents.jobs = TrialJobs(trials);
  contents.files = {"commitments.csv", "trials.csv", "trials.md", "report.html"};
  for (const Trial& trial : trials) {
    contents.files.push_back("recordings/" + trial.name + "/");
    contents.files.push_back("diagnoses/" + trial.name + "/");
  }
  FolderLock lock = PrepareJobFolder(folder, contents, folder_options);
  if (folder_options.ranks.rank == 0) WriteWholeFile(folder / "commitments.csv", commitments);
  return lock;
}

TrialRunOptions HowToRun(const TrialsOptions& options) {
  const fs::path folder = options.jobs.output;
  TrialRunOptions run;
  run.diagnosis.finest_side = options.finest_side;
  run.diagnosis.project = !options.no_projection;
  run.diagnosis.simulate_null = !options.table_null;
  run.diagnosis.nudge = !options.no_guide;
  run.folder = folder / "recordings";
  run.keep_recordings = options.keep_recordings;
  if (options.keep_diagnoses) {
    run.diagnosed = [folder](const Trial& trial, const Diagnosis& diagnosis,
                             const std::vector<std::string>& log) {
      const DiagnosisFolder kept(folder / "diagnoses" / trial.name,
                                 DiagnosisFolder::Existing::kReplace);
      for (const std::string& line : log) kept.AppendLog(line);
      kept.Write(diagnosis);
    };
  }
  run.refit_truth = !options.no_true_model;
  return run;
}

// The tables of the trials that are done; returns the summary.
std::string WriteTables(const fs::path& folder, const std::vector<Trial>& trials) {
  const std::vector<TrialScore> scores = ScoresSoFar(trials, folder / "jobs");
  WriteWholeFile(folder / "trials.csv", ScoresAsCsv(scores));
  WriteWholeFile(folder / "trials.md", ScoresAsMarkdown(scores));
  return ScoresAsMarkdown(scores);
}

int RunAll(const TrialsOptions& options, const std::vector<Trial>& trials) {
  if (options.jobs.output.empty()) throw InputError("--output", "is missing: expected a folder");
  const fs::path folder = options.jobs.output;
  ProgressDisplay display;
  std::string stage = "trials";
  StudyRunOptions run = MakeRunOptions(options.jobs, &display, &stage);
  const FolderLock lock = Prepare(options, trials, run.folder);
  run.jobs.folder = folder / "jobs";
  const bool is_first = run.folder.ranks.rank == 0;
  JobRunOptions jobs = run.jobs;
  if (is_first) {
    jobs.progress = [&](int done, int total) {
      if (done > 0 && done < total) WriteTables(folder, trials);  // the last time by the report
      if (run.jobs.progress) run.jobs.progress(done, total);
    };
  }
  const JobRunResult done = RunTrials(trials, Diagnose, HowToRun(options), jobs);
  display.Finish();
  StudyRun result;
  result.Add(done);
  if (done.complete) {
    result.table = RunReportOnCommand([=] { return WriteTables(folder, trials); }, run.jobs);
  } else if (is_first) {
    result.table = WriteTables(folder, trials);
  }
  return FinishJobs(result, options.jobs, run);
}

int PrintEffects(const TrialsOptions& options, const std::vector<Trial>& trials) {
  ProgressDisplay display;
  const std::atomic<bool>* const stop = StopOnInterrupt();
  const std::vector<MeasuredEffect> effects = MeasureEffects(
      trials, NumThreads(options.jobs.threads),
      [&](double share) { display.Show("effects", fmt::format("{:.0f} %", 100.0 * share), share); },
      stop);
  display.Finish();
  fmt::print("{}", EffectsAsMarkdown(effects));
  return *stop ? kExitInterrupted : kExitSuccess;
}

int RunTrialsCommand(const TrialsOptions& options) {
  CheckJobOptions(options.jobs);
  const std::vector<Trial> trials = MakeTrialPlan("PLAN", options.plan, options.size);
  if (options.list) {
    fmt::print("{}", DescribePlan(trials));
    return kExitSuccess;
  }
  return options.effects ? PrintEffects(options, trials) : RunAll(options, trials);
}

void AddPlanOptions(CLI::App* command, TrialsOptions* options) {
  BeginGroup(command, "Which trials");
  command->add_option("PLAN", options->plan, "one of " + JoinNames(TrialPlanNames()))->required();
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
  command
      ->add_option("--sample", options->size.sample,
                   "only so many of them, drawn evenly over the list by the first seed")
      ->type_name("N");
  command->add_option("--frames", options->size.frame_count, "of each recording")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--resolution", options->size.resolution,
                   "particles a side that a recording tells a fit to use")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--finest", options->finest_side,
                   "particles a side that a fit may use, at most; 3 to 100")
      ->type_name("N")
      ->check(CLI::Range(3, 100))
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
  options->jobs.patience = 1800.0;  // a diagnosis says little while it fits
  AddJobOptions(command, &options->jobs);
  command->get_option("--output")->required(false);  // nothing is written by what only prints
  BeginGroup(command, "How they are done");
  command->add_flag("--no-projection", options->no_projection,
                    "candidates do not compete with the baseline and the faults");
  command->add_flag("--table-null", options->table_null,
                    "chi-squared tables instead of a re-simulated null");
  command->add_flag("--no-guide", options->no_guide, "score candidates along the free motion only");
  command->add_flag("--no-true-model", options->no_true_model,
                    "do not find what the true model would predict, which costs a fit a trial");
  command->add_flag("--keep-recordings", options->keep_recordings,
                    "write every recording and leave it in FOLDER/recordings");
  command->add_flag("--keep-diagnoses", options->keep_diagnoses,
                    "leave every diagnosis in FOLDER/diagnoses");
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
      "  clothfit trials all --seeds 2 -o trials\n"
      "  mpirun --enable-recovery -n 64 clothfit trials all --seeds 2 -o trials");
  command->callback(
      [options, action] { *action = [options] { return RunTrialsCommand(*options); }; });
}

}  // namespace clothfit
