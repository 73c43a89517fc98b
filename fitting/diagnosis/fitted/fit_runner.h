// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How the fits of a diagnosis are run: each only once. Those that came to their end are kept in a
// folder, where one is given, so that a diagnosis that was interrupted goes on without running them
// again, to the same numbers as if it had never been.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "fitting/diagnosis/fitted/options.h"
#include "fitting/fit/fit.h"
#include "fitting/fit/forecast_fit.h"

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
  // threads: the same fit is then run by the first of them, and the others wait for it.
  FitResult Run(const Scene& scene, const FitConfig& config, const FitCheckpoint* from = nullptr,
                FitCallbacks callbacks = {}) const;
  // The same of FitForecasts.
  FitResult RunForecasts(const Scene& scene, const FitConfig& config,
                         const FitCheckpoint* from = nullptr, int most_lengths = kAllLengths) const;

 private:
  FitResult RunOnce(const std::string& key, const std::function<FitResult()>& run) const;
  // The fits that are being run, by key.
  class UnderWay {
   public:
    FitResult Once(const std::string& key, const std::function<FitResult()>& run);

   private:
    std::mutex mutex_;
    std::map<std::string, std::shared_future<FitResult>> fits_;
  };

  const std::atomic<bool>* stop_;
  std::filesystem::path folder_;
  std::shared_ptr<UnderWay> under_way_ = std::make_shared<UnderWay>();
};

// A digest of all that a fit depends on: see fitting/fit/fit_inputs.h.
std::string FitKey(const Scene& scene, const FitConfig& config, const FitCheckpoint* from);

// How many fits such a folder keeps; 0 where there is none.
int NumKeptFits(const std::filesystem::path& folder);

}  // namespace clothfit
