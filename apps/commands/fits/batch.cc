// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit batch: many recordings, one table.
#include "fitting/batch/batch.h"

#include <memory>
#include <utility>

#include "apps/commands/commands.h"
#include "apps/commands/jobs/job_options.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct BatchOptions {
  JobOptions jobs;
  std::string list;
};

// What decides the results: the list, and the files of settings that it names.
std::string Description(const std::string& list, const std::vector<BatchFit>& fits) {
  std::string text = ReadTextFile(list);
  for (const BatchFit& fit : fits) {
    text += "\n# " + fit.name + ": " + fit.recording.string() + "\n";
    for (const std::filesystem::path& config : fit.configs) text += ReadTextFile(config);
  }
  return text;
}

int RunBatchCommand(const BatchOptions& options) {
  CheckJobOptions(options.jobs);
  const std::vector<BatchFit> fits = ReadBatchList(options.list);
  FolderLock lock =
      PrepareJobFolder(options.jobs.output, BatchContents(fits, Description(options.list, fits)),
                       ExistingIf(options.jobs.force, options.jobs.resume));
  return RunPreparedJobs(std::move(lock), options.jobs);
}

}  // namespace

void AddBatchCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand("batch", "fit many recordings, into one table");
  const auto options = std::make_shared<BatchOptions>();
  command->add_option("LIST", options->list, "YAML file of recordings and what differs")
      ->type_name("FILE")
      ->required();
  AddJobOptions(command, &options->jobs);
  command->footer(
      "LIST has under `fits` a list of maps with the keys recording, name, config, set, free and\n"
      "fix, and may name a config for all; docs/file-formats.md has an example. Runs go to\n"
      "FOLDER/runs/NAME.\n\n"
      "Examples:\n"
      "  clothfit batch takes.yaml -o batches/takes\n"
      "  clothfit batch takes.yaml --slurm --sbatch=--time=2:00:00 -o batches/takes");
  command->callback(
      [options, action] { *action = [options] { return RunBatchCommand(*options); }; });
}

}  // namespace clothfit
