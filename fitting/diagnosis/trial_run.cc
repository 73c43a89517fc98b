// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/trial_run.h"

#include <chrono>
#include <exception>
#include <mutex>

#include "autodiff_sim/parallel.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool IsStopped(const TrialRunOptions& options) { return options.stop != nullptr && *options.stop; }

// Where the recording goes; nowhere, if it can stay in memory.
fs::path FolderOf(const Trial& trial, const TrialRunOptions& options) {
  const bool needs_files = trial.observation == TrialObservation::kSilhouettes;
  if (!needs_files && !options.keep_recordings) return {};
  return (options.folder.empty() ? fs::temp_directory_path() : options.folder) / trial.name;
}

TrialScore DiagnoseAndScore(const Trial& trial, const TrialRecording& made,
                            const Diagnoser& diagnose, const TrialRunOptions& options) {
  DiagnosisOptions of_trial = options.diagnosis;
  of_trial.seed = trial.seed;
  of_trial.stop = options.stop;
  std::vector<std::string> log;
  if (options.diagnosed) of_trial.log = [&log](const std::string& line) { log.push_back(line); };
  const FitConfig baseline = DefaultConfig(made.recording);
  const auto start = std::chrono::steady_clock::now();
  const Diagnosis diagnosis = diagnose(made.recording, baseline, of_trial);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (options.diagnosed) options.diagnosed(trial, diagnosis, log);
  std::optional<double> held_out_true;
  const bool has_gap = !trial.effects.empty() && options.refit_truth && !IsStopped(options);
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

TrialScore RunTrial(const Trial& trial, const Diagnoser& diagnose, const TrialRunOptions& options) {
  const TrialTruth truth = PlantedTruth(trial);
  const Commitment commitment = Commit(trial, truth);
  const fs::path folder = FolderOf(trial, options);
  TrialScore score;
  try {
    score = DiagnoseAndScore(trial, MakeTrialRecording(trial, folder), diagnose, options);
  } catch (const std::exception& error) {
    score = TrialScore();
    score.problem = error.what();
    Describe(trial, truth, &score);
  }
  if (!folder.empty() && !options.keep_recordings) fs::remove_all(folder);
  score.nonce = commitment.nonce;
  score.digest = commitment.digest;
  return score;
}

std::vector<TrialScore> RunTrials(const std::vector<Trial>& trials, const Diagnoser& diagnose,
                                  const TrialRunOptions& options,
                                  const std::vector<TrialScore>& done_before) {
  std::vector<std::optional<TrialScore>> scores(trials.size());
  std::vector<int> open;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    for (const TrialScore& known : done_before) {
      if (known.name == trials[i].name) scores[i] = known;
    }
    if (!scores[i]) open.push_back(static_cast<int>(i));
  }
  const auto so_far = [&] {
    std::vector<TrialScore> done;
    for (const std::optional<TrialScore>& score : scores) {
      if (score) done.push_back(*score);
    }
    return done;
  };
  std::mutex mutex;
  ParallelFor(static_cast<int>(open.size()), options.num_threads, [&](int i, int) {
    if (IsStopped(options)) return;
    const int which = open[static_cast<std::size_t>(i)];
    TrialScore score = RunTrial(trials[which], diagnose, options);
    if (IsStopped(options)) return;  // the diagnosis was cut short
    const std::lock_guard<std::mutex> lock(mutex);
    scores[which] = std::move(score);
    if (options.done) options.done(so_far());
  });
  return so_far();
}

std::string CommitmentsAsCsv(const std::vector<Trial>& trials) {
  std::string text = "trial,sha256\n";
  for (const Trial& trial : trials)
    text += trial.name + "," + Commit(trial, PlantedTruth(trial)).digest + "\n";
  return text;
}

}  // namespace clothfit
