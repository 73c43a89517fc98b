// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit trials: how good the diagnosis of missing physics is, on recordings with planted
// effects.
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/commands/jobs/job_options.h"
#include "apps/options/config.h"
#include "apps/options/value_checks.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "fitting/jobs/shell.h"
#include "fitting/trials/effect_table.h"
#include "fitting/trials/plan.h"
#include "fitting/trials/trial_jobs.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct TrialsOptions {
  TrialSettings settings;
  JobOptions jobs;
  bool list = false, effects = false;
};

int PrintEffects(const TrialsOptions& options, const std::vector<Trial>& trials) {
  ProgressDisplay display;
  const std::atomic<bool>* const stop = StopOnInterrupt();
  const std::vector<MeasuredEffect> effects = MeasureEffects(
      trials, NumThreads(options.jobs.threads),
      [&](double share) { display.Show("effects", fmt::format("{:.0f} %", 100.0 * share), share); },
      stop);
  display.Finish();
  Print("{}", EffectsAsMarkdown(effects));
  if (*stop) return kExitInterrupted;
  PrintNext("clothfit trials " + ShellWord(options.settings.plan) + " -o FOLDER");
  return kExitSuccess;
}

int RunTrialsCommand(const TrialsOptions& options) {
  CheckJobOptions(options.jobs);
  const TrialSettings& settings = options.settings;
  const std::vector<Trial> trials = MakeTrialPlan("PLAN", settings.plan, settings.size);
  if (options.list) {
    Print("{}", DescribePlan(trials));
    PrintNext("clothfit trials " + ShellWord(settings.plan) + " -o FOLDER");
    return kExitSuccess;
  }
  if (options.effects) return PrintEffects(options, trials);
  if (options.jobs.output.empty()) throw InputError("--output", "is missing: expected a folder");
  FolderLock lock = PrepareTrials(settings, trials, options.jobs.output,
                                  ExistingIf(options.jobs.force, options.jobs.resume));
  return RunPreparedJobs(std::move(lock), options.jobs);
}

void AddPlanOptions(CLI::App* command, TrialsOptions* options) {
  BeginGroup(command, "Which trials");
  command->add_option("PLAN", options->settings.plan, "one of " + JoinNames(TrialPlanNames()))
      ->required();
  command
      ->add_option("--seeds", options->settings.size.num_seeds, "how often the whole plan is drawn")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--first-seed", options->settings.size.first_seed, "seed of the first")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--only", options->settings.size.only,
                   "effects and faults; all others are left out")
      ->type_name("EFFECT");
  command
      ->add_option("--match", options->settings.size.match,
                   "only trials with this in their name, see --list; else all")
      ->type_name("TEXT");
  command
      ->add_option("--sample", options->settings.size.sample,
                   "only so many of them, drawn evenly over the list by the first seed; 0: all")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--frames", options->settings.size.frame_count, "of each recording")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--resolution", options->settings.size.resolution,
                   "particles a side that a recording tells a fit to use")
      ->type_name("N")
      ->capture_default_str();
  command
      ->add_option("--finest", options->settings.finest_side,
                   "particles a side that a fit may use, at most; 3 to 100")
      ->type_name("N")
      ->check(WholeNumber(3, 100))
      ->capture_default_str();
  CLI::Option* const same =
      command->add_flag("--same-generator", options->settings.size.same_generator,
                        "simulate the recordings with the fit's mesh and step");
  command
      ->add_flag("--finite-elements", options->settings.size.finite_elements,
                 "simulate them by finite elements, which share no code with a fit")
      ->excludes(same);
}

void AddRunOptions(CLI::App* command, TrialsOptions* options) {
  AddJobOptions(command, &options->jobs);
  command->get_option("--output")
      ->required(false)  // nothing is written by what only prints
      ->description("folder of results and tables; not needed by --list and --effects");
  BeginGroup(command, "How they are done");
  command->add_flag("--no-projection", options->settings.no_projection,
                    "candidates do not compete with the baseline and the faults");
  command->add_flag("--table-null", options->settings.table_null,
                    "chi-squared tables instead of a re-simulated null");
  command->add_flag("--no-nudge", options->settings.no_guide,
                    "locate missing forces along the free motion, never along a nudged one");
  command->add_flag("--no-guide", options->settings.no_guide)->group("");  // the same, not listed
  command->add_flag("--no-true-model", options->settings.no_true_model,
                    "do not find what the true model would predict, which costs a fit a trial");
  command->add_flag("--keep-recordings", options->settings.keep_recordings,
                    "write every recording and leave it in FOLDER/recordings");
  command->add_flag("--keep-diagnoses", options->settings.keep_diagnoses,
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
      "  clothfit trials all --seeds 2 --slurm --sbatch=--time=2:00:00 -o trials");
  command->callback(
      [options, action] { *action = [options] { return RunTrialsCommand(*options); }; });
}

}  // namespace clothfit
