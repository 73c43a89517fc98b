// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How the fits of a diagnosis are run: each only once. Those that came to their end are kept in a
// folder, where one is given, so that a diagnosis that was interrupted goes on without running them
// again, to the same numbers as if it had never been.
#pragma once

#include <atomic>
#include <filesystem>
#include <utility>

#include "fitting/diagnosis/fitted/options.h"
#include "fitting/fit/fit.h"

namespace clothfit {

class FitRunner {
 public:
  // `stop` may be null, and the folder empty: then nothing is kept.
  explicit FitRunner(const std::atomic<bool>* stop = nullptr, std::filesystem::path folder = {})
      : stop_(stop), folder_(std::move(folder)) {}
  explicit FitRunner(const DiagnosisOptions& options)
      : FitRunner(options.stop, options.kept_fits) {}

  bool IsStopped() const { return stop_ != nullptr && *stop_; }

  // RunFit, or what the same fit of the same scene came to before. A kept file that is damaged is
  // as good as none. Throws InputError where the folder cannot be written. Can be called from many
  // threads.
  FitResult Run(const Scene& scene, const FitConfig& config, const FitCheckpoint* from = nullptr,
                FitCallbacks callbacks = {}) const;

 private:
  const std::atomic<bool>* stop_;
  std::filesystem::path folder_;
};

// A digest of all that a fit depends on: observations, start, config, and where it goes on from.
std::string FitKey(const Scene& scene, const FitConfig& config, const FitCheckpoint* from);

// How many fits such a folder keeps; 0 where there is none.
int NumKeptFits(const std::filesystem::path& folder);

}  // namespace clothfit
