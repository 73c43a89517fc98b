// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit study NAME, of studies that are lists of jobs.
#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/commands/commands.h"
#include "apps/commands/jobs/job_options.h"
#include "apps/options/config.h"
#include "autodiff_sim/base/names.h"
#include "fitting/studies/study_plan.h"

namespace clothfit {
namespace {

struct JobStudyOptions {
  JobOptions jobs;
  std::string recordings;  // empty: FOLDER/recordings
  bool full = false;
  std::optional<std::vector<std::string>> experiments, fabric;
  std::optional<std::vector<double>> values;
  std::optional<int> under_way, frames, generator, picture, particles, points, starts;
  std::optional<double> simulations;
  std::optional<std::string> search;
  std::optional<unsigned> seed;
};

template <class Value>
void Take(const std::optional<Value>& given, Value* value) {
  if (given) *value = *given;
}

// The reduced or the full size, with what the command line changes.
StudyOptions SizeOf(const JobStudyOptions& given) {
  StudyOptions options = given.full ? FullSize() : StudyOptions();
  Take(given.experiments, &options.experiments);
  Take(given.fabric, &options.fabric);
  Take(given.values, &options.values);
  Take(given.under_way, &options.under_way);
  Take(given.frames, &options.frames);
  Take(given.generator, &options.generator);
  Take(given.picture, &options.picture);
  Take(given.particles, &options.particles);
  Take(given.points, &options.points);
  Take(given.starts, &options.starts);
  Take(given.simulations, &options.simulations);
  Take(given.search, &options.search);
  Take(given.seed, &options.seed);
  options.Check();
  return options;
}

int RunJobStudy(const Study& study, const JobStudyOptions& given) {
  CheckJobOptions(given.jobs);
  FolderLock lock = PrepareStudy(study, SizeOf(given), given.jobs.output, given.recordings,
                                 ExistingIf(given.jobs.force, given.jobs.resume));
  return RunPreparedJobs(std::move(lock), given.jobs);
}

std::string ValuesInWords(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return fmt::format("{:g}", value.get<double>());
  std::vector<std::string> words;
  for (const nlohmann::json& one : value) words.push_back(ValuesInWords(one));
  return JoinNames(words, ",");
}

// "30, with --full 300" in the help: the value of either size.
CLI::Option* DefaultIsOfSize(const nlohmann::json& reduced, const nlohmann::json& full,
                             CLI::Option* option) {
  const std::string text = ValuesInWords(reduced), of_full = ValuesInWords(full);
  return option->default_str(of_full == text ? text : text + ", with --full " + of_full);
}

// --under-way of the field under_way of StudyOptions.
template <class Value>
CLI::Option* AddField(CLI::App* command, const std::string& field, Value* value,
                      const std::string& doc) {
  std::string name = "--" + field;
  std::replace(name.begin(), name.end(), '_', '-');
  return DefaultIsOfSize(nlohmann::json(StudyOptions()).at(field),
                         nlohmann::json(FullSize()).at(field),
                         command->add_option(name, *value, doc));
}

void AddRecordingOptions(CLI::App* command, JobStudyOptions* options) {
  BeginGroup(command, "The recordings");
  command
      ->add_option("--recordings", options->recordings,
                   "folder of recordings, made where they are missing, which studies of the same "
                   "size can share; FOLDER/recordings if left out")
      ->type_name("FOLDER");
  AddField(command, "experiments", &options->experiments, "which of the three")
      ->type_name("NAME")
      ->delimiter(',');
  AddField(command, "frames", &options->frames, "of a recording")->type_name("N");
  AddField(command, "picture", &options->picture, "width of the pictures, px")->type_name("W");
  AddField(command, "generator", &options->generator,
           "particles a side of the simulation that makes the recordings, odd")
      ->type_name("N");
}

void AddFitOptions(CLI::App* command, const Study& study, JobStudyOptions* options) {
  BeginGroup(command, "The fits");
  if (study.values_of) {
    DefaultIsOfSize(study.values_of(StudyOptions()), study.values_of(FullSize()),
                    command->add_option("--values", options->values, study.values))
        ->type_name("V")
        ->delimiter(',');
  }
  AddField(command, "particles", &options->particles, "a side, of fits")->type_name("N");
  AddField(command, "fabric", &options->fabric, "parameters to find")
      ->type_name("TERM.PARAMETER")
      ->delimiter(',');
  AddField(command, "search", &options->search, "OPTIMISER/STRATEGY, where the study has no own")
      ->type_name("NAME");
  AddField(command, "simulations", &options->simulations,
           "of the whole recording; a fit ends with the pass that reaches as many")
      ->type_name("N");
  AddField(command, "points", &options->points,
           "markers a frame, and tracks a camera and frame, at most")
      ->type_name("N");
  AddField(
      command, "under_way", &options->under_way,
      "points of a fit's pattern search that are evaluated at a time, by as many threads; decides "
      "its course")
      ->type_name("N");
  AddField(command, "starts", &options->starts, "of each search that is compared")->type_name("N");
}

void AddJobStudy(CLI::App* parent, const Study& study, Action* action) {
  CLI::App* const command = parent->add_subcommand(study.name, study.doc);
  const auto options = std::make_shared<JobStudyOptions>();
  AddJobOptions(command, &options->jobs);
  BeginGroup(command, "The study");
  command->add_flag(
      "--full", options->full,
      "about the size of the paper's experiments, for a cluster; else minutes of two cores");
  AddField(command, "seed", &options->seed, "of recordings, starts and searches")->type_name("N");
  if (study.uses_recordings) {
    AddRecordingOptions(command, options.get());
    AddFitOptions(command, study, options.get());
  }
  command->footer("Examples:\n  clothfit study " + study.name + " -o studies/" + study.name +
                  "\n  clothfit study " + study.name +
                  " --full --slurm --sbatch=--time=12:00:00 -o studies/" + study.name);
  command->callback(
      [study, options, action] { *action = [=] { return RunJobStudy(study, *options); }; });
}

}  // namespace

void AddJobStudies(CLI::App* study, Action* action) {
  for (const Study& one : Studies()) AddJobStudy(study, one, action);
}

}  // namespace clothfit
