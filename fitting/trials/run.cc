// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/run.h"

#include <chrono>
#include <exception>
#include <stdexcept>

#include "fitting/jobs/results.h"
#include "fitting/trials/summary.h"
#include "tracking/files/manifest.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool IsStopped(const JobContext& context) { return context.stop != nullptr && *context.stop; }

// Where the recording goes; nowhere, if it can stay in memory.
fs::path FolderOf(const Trial& trial, const TrialRunOptions& options) {
  const bool needs_files = trial.observation == TrialObservation::kSilhouettes;
  if (!needs_files && !options.keep_recordings) return {};
  return (options.folder.empty() ? fs::temp_directory_path() : options.folder) / trial.name;
}

TrialScore DiagnoseAndScore(const Trial& trial, const TrialRecording& made,
                            const DiagnoseFunction& diagnose, const TrialRunOptions& options,
                            const JobContext& context) {
  DiagnosisOptions of_trial = options.diagnosis;
  of_trial.seed = trial.seed;
  of_trial.stop = context.stop;
  std::vector<std::string> log;
  of_trial.log = [&](const std::string& line) { log.push_back(line); };
  const FitConfig baseline = DefaultConfig(made.recording);
  const auto start = std::chrono::steady_clock::now();
  const Diagnosis diagnosis = diagnose(made.recording, baseline, of_trial);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.diagnosed) options.diagnosed(trial, diagnosis, log);
  std::optional<double> held_out_true;
  const bool has_gap = !trial.effects.empty() && options.refit_truth && !IsStopped(context);
  if (has_gap) held_out_true = TrueModelError(trial, made, baseline);
  TrialScore score = ScoreDiagnosis(trial, made.truth, diagnosis, held_out_true);
  score.seconds = seconds;
  return score;
}

// What a row says whatever comes of the trial.
void Describe(const Trial& trial, const TrialTruth& truth, TrialScore* score) {
  const TrialScore blank = ScoreDiagnosis(trial, truth, Diagnosis(), std::nullopt);
  score->name = blank.name;
  score->kind = blank.kind;
  score->motion = blank.motion;
  score->observation = blank.observation;
  score->size = blank.size;
  score->truth = blank.truth;
}

}  // namespace

TrialScore RunTrial(const Trial& trial, const DiagnoseFunction& diagnose,
                    const TrialRunOptions& options, const JobContext& context) {
  const TrialTruth truth = PlantedTruth(trial);
  const Commitment commitment = Commit(trial, truth);
  const fs::path folder = FolderOf(trial, options);
  TrialScore score;
  try {
    score = DiagnoseAndScore(trial, MakeTrialRecording(trial, folder), diagnose, options, context);
  } catch (const std::exception& error) {
    score = TrialScore();
    score.problem = error.what();
    Describe(trial, truth, &score);
  }
  if (!folder.empty() && !options.keep_recordings) RemoveWrittenFolder(folder);
  score.nonce = commitment.nonce;
  score.digest = commitment.digest;
  return score;
}

std::vector<TrialScore> ScoresOf(const std::vector<JobResult>& results) {
  std::vector<TrialScore> scores;
  for (const JobResult& one : results)
    if (one.IsDone()) scores.push_back(ReadScores(one.name, one.output.get<std::string>()).front());
  return scores;
}

std::vector<Job> TrialJobs(const std::vector<Trial>& trials) {
  std::vector<Job> jobs;
  for (const Trial& trial : trials) jobs.push_back({trial.name, nullptr});
  return jobs;
}

JobWork TrialWork(const std::vector<Trial>& trials, const DiagnoseFunction& diagnose,
                  const TrialRunOptions& options) {
  return [trials, diagnose, options](const Job& job, const JobContext& context) -> nlohmann::json {
    for (const Trial& trial : trials) {
      if (trial.name == job.name) return ScoresAsCsv({RunTrial(trial, diagnose, options, context)});
    }
    throw std::logic_error("no such trial");
  };
}

std::string CommitmentsAsCsv(const std::vector<Trial>& trials) {
  std::string text = "trial,sha256\n";
  for (const Trial& trial : trials)
    text += trial.name + "," + Commit(trial, PlantedTruth(trial)).digest + "\n";
  return text;
}

}  // namespace clothfit
