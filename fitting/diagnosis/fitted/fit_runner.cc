// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/fit_runner.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "fitting/diagnosis/fitted/kept_fit.h"
#include "fitting/files/sha256.h"
#include "fitting/fit/fit_inputs.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEnding = ".cbor";

std::optional<FitResult> ReadKept(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    return FitFromBytes(ReadInputFile(file, kMostJsonBytes));
  } catch (const InputError&) {  // not readable: as good as none
    return std::nullopt;
  }
}

}  // namespace

std::string FitKey(const Scene& scene, const FitConfig& config, const FitCheckpoint* from) {
  return Sha256(FitInputsAsBytes(scene, config, from));
}

FitResult FitRunner::RunOnce(const std::string& key, const std::function<FitResult()>& run) const {
  return under_way_->Once(key, [&] {
    const fs::path file = folder_ / (key + kEnding);
    if (const std::optional<FitResult> kept = ReadKept(file)) return *kept;
    FitResult result = run();
    if (result.status != FitStatus::kInterrupted && !IsStopped())
      WriteWholeFile(file, FitAsBytes(result));
    return result;
  });
}

FitResult FitRunner::Run(const Scene& scene, const FitConfig& config, const FitCheckpoint* from,
                         FitCallbacks callbacks) const {
  callbacks.stop = stop_;
  const auto run = [&] { return RunFit(scene, config, callbacks, from); };
  return folder_.empty() ? run() : RunOnce(FitKey(scene, config, from), run);
}

FitResult FitRunner::RunForecasts(const Scene& scene, const FitConfig& config,
                                  const FitCheckpoint* from, int most_lengths) const {
  FitCallbacks callbacks;
  callbacks.stop = stop_;
  const auto run = [&] { return FitForecasts(scene, config, callbacks, from, most_lengths); };
  if (folder_.empty()) return run();
  const std::string kind =
      most_lengths == kAllLengths ? "forecasts-" : fmt::format("forecasts-{}-", most_lengths);
  return RunOnce(kind + FitKey(scene, config, from), run);
}

FitResult FitRunner::UnderWay::Once(const std::string& key, const std::function<FitResult()>& run) {
  std::promise<FitResult> promise;
  std::unique_lock<std::mutex> lock(mutex_);
  const auto [begun, is_first] = fits_.emplace(key, promise.get_future().share());
  const std::shared_future<FitResult> fit = begun->second;
  lock.unlock();
  if (!is_first) return fit.get();
  try {
    promise.set_value(run());
  } catch (...) {
    promise.set_exception(std::current_exception());
  }
  lock.lock();
  fits_.erase(key);
  lock.unlock();
  return fit.get();
}

int NumKeptFits(const fs::path& folder) {
  if (!fs::is_directory(folder)) return 0;
  const fs::directory_iterator files(folder);
  return static_cast<int>(std::count_if(begin(files), end(files), [](const fs::directory_entry& f) {
    return f.path().extension() == kEnding;
  }));
}

}  // namespace clothfit
