// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/two_starts.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/nudging.h"

namespace clothfit {
namespace {

std::vector<std::string> DampingsOfTheCloth() {
  std::vector<std::string> names;
  for (const TermInfo& term : AllTerms()) {
    for (const Parameter& parameter : term.parameters)
      if (term.internal && parameter.name == std::string("damping"))
        names.push_back(term.name + "." + parameter.name);
  }
  return names;
}

// One cloth's recordings, with a tenth of each free damping.
class LessDamped {
 public:
  explicit LessDamped(const std::vector<NamedScene>& scenes) {
    configs_.reserve(scenes.size());
    for (const auto& [name, scene, config] : scenes) {
      configs_.push_back(*config);
      scenes_.push_back({name, scene, &configs_.back()});
      is_another_ = LessenDamping(&configs_.back()) || is_another_;
      has_points_ = has_points_ || HasPoints(*scene);
    }
  }
  LessDamped(const LessDamped&) = delete;
  LessDamped& operator=(const LessDamped&) = delete;

  // False where there is nothing else to begin from.
  bool IsOfUse() const { return is_another_ && has_points_ && configs_.front().polish; }
  const std::vector<NamedScene>& scenes() const { return scenes_; }

 private:
  // Whether anything was lessened.
  static bool LessenDamping(FitConfig* config) {
    constexpr double kLess = 0.1;
    bool is_less = false;
    for (const std::string& name : DampingsOfTheCloth()) {
      const auto found = config->parameters.find(name);
      if (found == config->parameters.end() || !found->second.free) continue;
      ParameterSetting& setting = found->second;
      const double less = std::max(setting.lower, kLess * setting.value);
      is_less = is_less || less < setting.value;
      setting.value = less;
    }
    return is_less;
  }

  bool is_another_ = false, has_points_ = false;
  std::vector<FitConfig> configs_;
  std::vector<NamedScene> scenes_;
};

bool AsksForAnother(const FitResult& fit) {
  return fit.status != FitStatus::kInterrupted && fit.misfit && !fit.misfit->IsNoise();
}

// A core to spare, and seconds to gain by it.
bool HasRoomBeside(const std::vector<NamedScene>& scenes) {
  constexpr double kWorthIt = 20000.0;  // positions of particles in fitted frames
  double positions = 0.0;
  for (const NamedScene& one : scenes)
    positions += one.scene->mesh.num_particles() * (one.scene->last_fitted_frame + 1.0);
  return NumThreads(0) > 1 && positions > kWorthIt;
}

// A fit that is ended where nothing waits for it.
class Beside {
 public:
  explicit Beside(const std::vector<NamedScene>& scenes)
      : callbacks_{{}, {}, {}, &end_, nullptr, {}, {}},
        fit_(std::async(std::launch::async, [&scenes, this] {
          const InsideParallelWork inside;
          return RunJointFit(scenes, callbacks_, nullptr, true);
        })) {}
  ~Beside() { end_ = true; }
  Beside(const Beside&) = delete;
  Beside& operator=(const Beside&) = delete;

  FitResult Get(const std::atomic<bool>* stop) {
    constexpr auto kLook = std::chrono::milliseconds(50);
    while (fit_.wait_for(kLook) != std::future_status::ready)
      if (stop != nullptr && *stop) end_ = true;
    return fit_.get();
  }

 private:
  std::atomic<bool> end_ = false;
  FitCallbacks callbacks_;
  std::future<FitResult> fit_;  // the last member, whose destructor waits
};

std::string SaySecondStart(double kept, double other, bool agree) {
  if (agree) return "begun again with a tenth of the damping, the fit ends at the same cost";
  return fmt::format(
      "begun again with a tenth of the damping, the fit ends elsewhere: of the costs {:.6g} and "
      "{:.6g} the lower is kept",
      kept, other);
}

// As if `other` had begun where `first` did.
void TellStartOf(const FitResult& first, FitResult* other) {
  other->before = first.before;
  other->cost_before = first.cost_before;
  for (std::size_t i = 0; i < other->estimates.size() && i < first.estimates.size(); ++i)
    other->estimates[i].start = first.estimates[i].start;
  for (std::size_t i = 0; i < other->recordings.size() && i < first.recordings.size(); ++i)
    TellStartOf(first.recordings[i], &other->recordings[i]);
}

// Of two fits from different starts, told as if both had begun at the first one's.
FitResult LowerOf(FitResult first, FitResult second) {
  constexpr double kAlike = 1e-3;  // of the cost
  const bool was_interrupted = second.status == FitStatus::kInterrupted;
  const double apart = std::abs(second.cost_after - first.cost_after);
  const bool agree = apart <= kAlike * std::min(first.cost_after, second.cost_after);
  if (second.cost_after < first.cost_after) {
    TellStartOf(first, &second);
    std::swap(first, second);
  }
  AddWork(second, &first);
  if (was_interrupted)
    first.status = FitStatus::kInterrupted;
  else if (std::isfinite(second.cost_after))
    first.statements.push_back(SaySecondStart(first.cost_after, second.cost_after, agree));
  return first;
}

}  // namespace

FitResult FitFromTwoStarts(const std::vector<NamedScene>& scenes, const FitCallbacks& callbacks) {
  const auto begin = std::chrono::steady_clock::now();
  const LessDamped other(scenes);
  if (!other.IsOfUse()) return RunJointFit(scenes, callbacks, nullptr, true);
  std::optional<Beside> beside;
  const bool has_room = HasRoomBeside(scenes);
  if (has_room) beside.emplace(other.scenes());
  FitCallbacks of_first = callbacks;
  if (!has_room) of_first.progress = OfPart(callbacks, "", 0.0, 0.5).progress;
  FitResult first = RunJointFit(scenes, of_first, nullptr, true);
  if (!AsksForAnother(first)) return first;
  if (callbacks.stands) callbacks.stands(*scenes[0].scene, *scenes[0].config, first);
  if (callbacks.log)
    callbacks.log("more than noise is left: begun again with a tenth of the damping");
  FitCallbacks of_second = OfPart(callbacks, "with less damping, ", 0.5, 0.5);
  of_second.journal = nullptr;
  of_second.checkpoint = {};
  FitResult second = has_room ? beside->Get(callbacks.stop)
                              : RunJointFit(other.scenes(), of_second, nullptr, true);
  FitResult result = LowerOf(std::move(first), std::move(second));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace clothfit
