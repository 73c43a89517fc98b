// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/misfit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

namespace clothfit {
namespace {

// Sums of products of pairs at the distances 1, 2, ...
struct Correlogram {
  std::vector<double> products, pairs;
  void Add(int distance, double product) {
    const auto k = static_cast<std::size_t>(distance);
    if (products.size() <= k) {
      products.resize(k + 1, 0.0);
      pairs.resize(k + 1, 0.0);
    }
    products[k] += product;
    pairs[k] += 1.0;
  }
};

// Sums of the correlations, and of their squares, of one residual with the others: each distance
// counts with twice its pairs a residual.
struct Sums {
  double of_correlations = 0.0, of_squares = 0.0;
};

Sums SumUp(const Correlogram& correlogram, double variance, std::size_t count) {
  constexpr double kStandardErrors = 2.0;
  Sums sums;
  for (std::size_t k = 1; k < correlogram.pairs.size(); ++k) {
    const double pairs = correlogram.pairs[k];
    if (pairs == 0.0) continue;
    const double correlation = correlogram.products[k] / (pairs * variance);
    if (correlation < kStandardErrors / std::sqrt(pairs)) break;
    const double others = 2.0 * pairs / static_cast<double>(count);
    sums.of_correlations += others * correlation;
    sums.of_squares += others * correlation * correlation;
  }
  return sums;
}

Correlogram InTime(const std::vector<SeenResidual>& seen) {
  std::map<int, std::vector<const SeenResidual*>> series;  // by frame, as they were seen
  for (const SeenResidual& s : seen) series[s.series].push_back(&s);
  Correlogram correlogram;
  for (const auto& [id, of_series] : series) {
    for (std::size_t i = 0; i < of_series.size(); ++i) {
      for (std::size_t k = i + 1; k < of_series.size(); ++k)
        correlogram.Add(of_series[k]->frame - of_series[i]->frame,
                        of_series[i]->value * of_series[k]->value);
    }
  }
  return correlogram;
}

// The distance (m) of most points from their nearest neighbour, the median; 0 where there is none.
double Spacing(const std::vector<const SeenResidual*>& points) {
  std::vector<double> nearest;
  for (const SeenResidual* a : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const SeenResidual* b : points)
      if (a != b) least = std::min(least, (a->uv - b->uv).norm());
    if (std::isfinite(least)) nearest.push_back(least);
  }
  if (nearest.empty()) return 0.0;
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

Correlogram OverTheCloth(const std::vector<SeenResidual>& seen) {
  std::map<std::pair<int, int>, std::vector<const SeenResidual*>> groups;
  for (const SeenResidual& s : seen) groups[{s.frame, s.kind}].push_back(&s);
  Correlogram correlogram;
  std::map<int, double> spacings;  // by kind, of the first frame that it is seen in
  for (const auto& [key, points] : groups) {
    const auto [spacing, is_new] = spacings.try_emplace(key.second, 0.0);
    if (is_new) spacing->second = Spacing(points);
    if (spacing->second <= 0.0) continue;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = i + 1; k < points.size(); ++k) {
        const double distance = (points[i]->uv - points[k]->uv).norm() / spacing->second;
        correlogram.Add(std::max(1, static_cast<int>(std::lround(distance))),
                        points[i]->value * points[k]->value);
      }
    }
  }
  return correlogram;
}

}  // namespace

double ChiSquareLimit(double independent) {
  constexpr double kSigmas = 3.0;
  return 1.0 + kSigmas * std::sqrt(2.0 / std::max(1.0, independent));
}

std::vector<SeenResidual> SeenResiduals(const Scene& scene, const Eigen::VectorXd& residuals) {
  std::vector<SeenResidual> seen;
  seen.reserve(static_cast<std::size_t>(residuals.size()));
  std::map<std::tuple<int, int, int>, int> series;  // by camera (-1: of markers), id and coordinate
  const auto add = [&](int frame, int camera, int id, int coordinates, const SurfacePoint& point) {
    const Eigen::Vector2d uv = point.At(scene.mesh.uv);
    for (int c = 0; c < coordinates; ++c) {
      const auto next = static_cast<int>(series.size());
      const int of_series = series.try_emplace({camera, id, c}, next).first->second;
      const auto row = static_cast<Eigen::Index>(seen.size());
      seen.push_back({frame, of_series, 3 * (camera + 1) + c, uv, residuals[row]});
    }
  };
  auto marker = scene.markers.begin();
  auto track = scene.tracks.begin();
  for (int frame = 0; frame <= scene.last_fitted_frame; ++frame) {
    for (; marker != scene.markers.end() && marker->frame == frame; ++marker)
      if (scene.is_fitted[frame]) add(frame, -1, marker->id, 3, marker->on_cloth);
    for (; track != scene.tracks.end() && track->frame == frame; ++track)
      if (scene.IsFitted(*track)) add(frame, track->camera, track->id, 2, track->on_cloth);
  }
  return seen;
}

std::vector<SeenResidual> SeenResiduals(const JointScenes& scenes,
                                        const Eigen::VectorXd& residuals) {
  std::vector<SeenResidual> all;
  Eigen::Index row = 0;
  int next_series = 0, next_kind = 0;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const auto& [scene, config, free, observations] = scenes[i];
    const Eigen::Index count = observations.Count(0, scene.last_fitted_frame);
    const int first_series = next_series, first_kind = next_kind;
    for (SeenResidual seen : SeenResiduals(scene, residuals.segment(row, count))) {
      seen.series += first_series;
      seen.kind += first_kind;
      next_series = std::max(next_series, seen.series + 1);
      next_kind = std::max(next_kind, seen.kind + 1);
      all.push_back(seen);
    }
    row += count;
  }
  return all;
}

Misfit MeasureMisfit(const std::vector<SeenResidual>& seen, int num_free) {
  Misfit misfit;
  misfit.observed = static_cast<int>(seen.size());
  double sum = 0.0;
  for (const SeenResidual& s : seen) sum += s.value * s.value;
  misfit.chi_square = sum / std::max(1, misfit.observed - num_free);
  if (!(sum > 0.0)) {
    misfit.limit = ChiSquareLimit(misfit.observed);
    return misfit;
  }
  const double variance = sum / misfit.observed;
  const Sums in_time = SumUp(InTime(seen), variance, seen.size());
  const Sums over_the_cloth = SumUp(OverTheCloth(seen), variance, seen.size());
  misfit.correlation = (1.0 + in_time.of_correlations) * (1.0 + over_the_cloth.of_correlations);
  misfit.limit = ChiSquareLimit(misfit.observed /
                                ((1.0 + in_time.of_squares) * (1.0 + over_the_cloth.of_squares)));
  return misfit;
}

}  // namespace clothfit
