// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How many workers a pattern search of nine unknowns has use for, in simulated time: how much
// sooner than by one it ends, and which share of the workers' time is work. Evaluations take times
// that vary as those of fits do. Values are taken in order, as SearchPattern does, or as they
// arrive.
#include <algorithm>
#include <cmath>
#include <list>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "fitting/optimise/pattern_search.h"

namespace clothfit {
namespace {

constexpr int kUnknowns = 9, kSeeds = 20;

// A bent valley in each pair of unknowns and a bowl, the axes of unlike steepness.
double Valley(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (int i = 0; i < x.size(); ++i) {
    const double d = x[i] - 0.3 * (i + 1), bend = x[(i + 1) % x.size()] - x[i] * x[i] / 3.0;
    sum += std::pow(2.0, i % 4) * d * d + 0.2 * bend * bend;
  }
  return sum;
}

struct Schedule {
  int workers = 1, slots = 1;
  bool in_order = true;
  double spread = 0.5;  // of the logarithm of a time
};

struct Course {
  double time = 0.0, work = 0.0;
  int evaluations = 0;
};

struct UnderWay {
  PatternSearch::Trial trial;
  double end = -1.0;  // -1: waits for a worker
  bool has_value = false;
};

class Simulation {
 public:
  Simulation(const Schedule& schedule, unsigned seed)
      : schedule_(schedule), random_(seed), search_(Problem(), Valley(Problem().start), {}) {}

  Course Run() {
    Plan();
    while (true) {
      Begin();
      const auto first =
          std::min_element(under_way_.begin(), under_way_.end(),
                           [](const UnderWay& a, const UnderWay& b) { return Rank(a) < Rank(b); });
      if (first == under_way_.end()) break;
      course_.time = first->end;
      first->has_value = true;
      --busy_;
      Take(first);
    }
    return course_;
  }

 private:
  static Objective Problem() {
    Objective objective;
    objective.start = Eigen::VectorXd::Constant(kUnknowns, -1.0);
    objective.lower = Eigen::VectorXd::Constant(kUnknowns, -5.0);
    objective.upper = Eigen::VectorXd::Constant(kUnknowns, 5.0);
    objective.step = Eigen::VectorXd::Constant(kUnknowns, 0.5);
    return objective;
  }
  // Who ends next; those without a worker, or with a value, do not.
  static double Rank(const UnderWay& point) {
    return point.end < 0.0 || point.has_value ? 1e300 : point.end;
  }
  void Plan() {
    while (static_cast<int>(under_way_.size()) < schedule_.slots) {
      const auto trial = search_.Next();
      if (!trial) break;
      under_way_.push_back({*trial});
    }
  }
  void Begin() {
    for (UnderWay& point : under_way_) {
      if (busy_ == schedule_.workers) return;
      if (point.end >= 0.0) continue;
      const double seconds = std::exp(schedule_.spread * normal_(random_));
      point.end = course_.time + seconds;
      course_.work += seconds;
      ++course_.evaluations;
      ++busy_;
    }
  }
  void Take(std::list<UnderWay>::iterator point) {
    if (!schedule_.in_order) {
      search_.Report(point->trial.id, Valley(point->trial.x));
      under_way_.erase(point);
      Plan();
      return;
    }
    while (!under_way_.empty() && under_way_.front().has_value) {
      search_.Report(under_way_.front().trial.id, Valley(under_way_.front().trial.x));
      under_way_.pop_front();
      Plan();
    }
  }

  Schedule schedule_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  PatternSearch search_;
  std::list<UnderWay> under_way_;
  int busy_ = 0;
  Course course_;
};

Course Mean(const Schedule& schedule) {
  Course sum;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    const Course course = Simulation(schedule, seed).Run();
    sum.time += course.time / kSeeds;
    sum.work += course.work / kSeeds;
    sum.evaluations += course.evaluations / kSeeds;
  }
  return sum;
}

void PrintTable(double spread) {
  fmt::print("\n{} unknowns, log-normal times, spread {}\n\n", kUnknowns, spread);
  fmt::print(
      "| values | under way | workers | evaluations | sooner than one by | busy |\n"
      "|---|---:|---:|---:|---:|---:|\n");
  const Course alone = Mean({1, 1, true, spread});
  for (const bool in_order : {true, false}) {
    for (const int workers : {1, 2, 4, 8, 16, 32, 64}) {
      for (const int slots : {2, 4, 8, 16, 32}) {
        if (in_order ? workers > slots : slots != 2) continue;
        const int own = in_order ? slots : workers;
        const Course course = Mean({workers, own, in_order, spread});
        fmt::print("| {} | {} | {} | {} | {:.2f} | {:.2f} |\n",
                   in_order ? "in order" : "as they arrive", own, workers, course.evaluations,
                   alone.time / course.time, course.work / course.time / workers);
      }
    }
  }
}

}  // namespace
}  // namespace clothfit

int main() {
  for (const double spread : {0.2, 0.6}) clothfit::PrintTable(spread);
  return 0;
}
