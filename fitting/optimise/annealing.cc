// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/optimise/annealing.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "fitting/optimise/evaluation_counter.h"

namespace clothfit {
namespace {

constexpr double kCooling = 0.85;
constexpr int kSweepsBeforeAdapting = 5;
constexpr int kAdaptationsAtATemperature = 4;
constexpr std::size_t kQuietTemperatures = 4;
constexpr double kQuiet = 1e-6;  // of the value

class Chain {
 public:
  Chain(const Objective& objective, const OptimiserOptions& options)
      : objective_(objective),
        options_(options),
        counter_(objective, options),
        random_(options.seed),
        x_(objective.start),
        range_(objective.step) {
    value_ = counter_.Value(x_);
  }

  Minimum Run() {
    if (!FindFirstTemperature()) return counter_.Finish(false, counter_.Spent());
    std::deque<double> ends;  // of the chain at the last temperatures
    for (;;) {
      for (int i = 0; i < kAdaptationsAtATemperature; ++i) {
        if (!SweepAndAdapt()) return counter_.Finish(false, counter_.Spent());
      }
      if (range_.cwiseQuotient(objective_.step).maxCoeff() < options_.tolerance)
        return counter_.Finish(true, "all ranges are below the tolerance");
      ends.push_back(value_);
      if (ends.size() > kQuietTemperatures) ends.pop_front();
      const auto [least, most] = std::minmax_element(ends.begin(), ends.end());
      const double best = counter_.best().value;
      const bool is_quiet = *most - std::min(*least, best) <= kQuiet * std::abs(best);
      if (ends.size() == kQuietTemperatures && is_quiet)
        return counter_.Finish(true, "nothing changes any more");
      temperature_ *= kCooling;
      x_ = counter_.best().x;
      value_ = counter_.best().value;
    }
  }

 private:
  // Moves by one range along every coordinate show how the values differ.
  bool FindFirstTemperature() {
    double sum = 0.0;
    int count = 0;
    for (int axis = 0; axis < x_.size(); ++axis) {
      if (!counter_.Spent().empty()) return false;
      const double value = counter_.Value(Moved(axis));
      if (!std::isfinite(value) || !std::isfinite(value_)) continue;
      sum += std::abs(value - value_);
      ++count;
    }
    temperature_ = count > 0 && sum > 0.0 ? sum / count : 1.0;
    return true;
  }

  Eigen::VectorXd Moved(int axis) {
    std::uniform_real_distribution<double> chance(-1.0, 1.0);
    Eigen::VectorXd x = x_;
    x[axis] = std::clamp(x[axis] + chance(random_) * range_[axis], objective_.lower[axis],
                         objective_.upper[axis]);
    return x;
  }

  bool SweepAndAdapt() {
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    Eigen::VectorXi taken = Eigen::VectorXi::Zero(x_.size());
    for (int sweep = 0; sweep < kSweepsBeforeAdapting; ++sweep) {
      for (int axis = 0; axis < x_.size(); ++axis) {
        if (!counter_.Spent().empty()) return false;
        const Eigen::VectorXd x = Moved(axis);
        const double value = counter_.Value(x);
        const bool take =
            value <= value_ || chance(random_) < std::exp((value_ - value) / temperature_);
        if (!take) continue;
        x_ = x;
        value_ = value;
        ++taken[axis];
      }
    }
    // Corana's rule: wider where more than 60 % were taken, narrower where less than 40 %.
    for (int axis = 0; axis < x_.size(); ++axis) {
      const double share = static_cast<double>(taken[axis]) / kSweepsBeforeAdapting;
      if (share > 0.6) range_[axis] *= 1.0 + 2.0 * (share - 0.6) / 0.4;
      if (share < 0.4) range_[axis] /= 1.0 + 2.0 * (0.4 - share) / 0.4;
      const double width = objective_.upper[axis] - objective_.lower[axis];
      range_[axis] = std::min(range_[axis], width);
    }
    return true;
  }

  const Objective& objective_;
  const OptimiserOptions& options_;
  EvaluationCounter counter_;
  std::mt19937 random_;
  Eigen::VectorXd x_;
  double value_;
  Eigen::VectorXd range_;
  double temperature_ = 1.0;
};

}  // namespace

Minimum Anneal(const Objective& objective, const OptimiserOptions& options) {
  return Chain(objective, options).Run();
}

}  // namespace clothfit
