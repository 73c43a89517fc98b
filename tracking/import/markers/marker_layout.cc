// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/marker_layout.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <ceres/ceres.h>

namespace clothfit {
namespace {

// Of all frames that see a pair, the share whose distances are passed over.
constexpr double kOutlierShare = 0.01;

double LargestDistance(const HandleDescription::Path& a, const HandleDescription::Path& b) {
  std::vector<double> distances;
  for (size_t frame = 0; frame < a.size(); ++frame) {
    if (a[frame] && b[frame]) distances.push_back((*a[frame] - *b[frame]).norm());
  }
  if (distances.empty()) return -1.0;
  const auto passed_over =
      static_cast<std::ptrdiff_t>(kOutlierShare * static_cast<double>(distances.size()));
  const auto place = distances.end() - 1 - passed_over;
  std::nth_element(distances.begin(), place, distances.end());
  return *place;
}

// One pair of markers, in units of what is expected. A flat distance that is too short is a stretch
// of the cloth or noise; one that is too long only says that the cloth was never taut there, so
// that side counts by its amount rather than by its square.
struct PairDistance {
  double measured;  // m

  template <class T>
  bool operator()(const T* a, const T* b, T* residual) const {
    constexpr double kNoise = 5e-4;  // m
    // Of the distance. A cloth that is pulled taut while it moves stretches by a percent or two,
    // and half a percent here makes layouts of simulated takes 0.2 % larger still than they come
    // out.
    constexpr double kStretch = 1.5e-2;
    constexpr double kSlack = 1e-2;
    using std::sqrt;
    const T flat = sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + 1e-12);
    const T excess = flat - measured;
    if (excess < 0.0) {
      *residual = excess / (kNoise + kStretch * measured);
      return true;
    }
    // residual^2 = 2 (sqrt(1 + x^2) - 1), which is x^2 near zero and 2 x far from it
    const T x = excess / (kNoise + kSlack * measured);
    *residual = x * sqrt(2.0 / (sqrt(1.0 + x * x) + 1.0));
    return true;
  }
};

// Pairs that were never seen together get the length of the shortest way over others.
Eigen::MatrixXd Completed(const Eigen::MatrixXd& distances) {
  Eigen::MatrixXd complete = distances;
  const double far = 1e3 * std::max(distances.maxCoeff(), 1.0);
  complete = (complete.array() < 0.0).select(far, complete);
  complete.diagonal().setZero();
  for (Eigen::Index via = 0; via < complete.rows(); ++via) {
    for (Eigen::Index i = 0; i < complete.rows(); ++i) {
      for (Eigen::Index j = 0; j < complete.cols(); ++j) {
        if (distances(i, j) >= 0.0) continue;
        complete(i, j) = std::min(complete(i, j), complete(i, via) + complete(via, j));
      }
    }
  }
  return complete;
}

// Torgerson 1952: the two leading eigenvectors of the doubly centred squared distances.
std::vector<Eigen::Vector2d> ClassicalScaling(const Eigen::MatrixXd& distances) {
  const Eigen::Index n = distances.rows();
  const Eigen::MatrixXd centring =
      Eigen::MatrixXd::Identity(n, n) - Eigen::MatrixXd::Constant(n, n, 1.0 / double(n));
  const Eigen::MatrixXd squared = distances.cwiseProduct(distances);
  const Eigen::MatrixXd products = -0.5 * centring * squared * centring;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);  // ascending
  std::vector<Eigen::Vector2d> uv(static_cast<size_t>(n));
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Index column = n - 1 - axis;
    const double scale = std::sqrt(std::max(solver.eigenvalues()[column], 0.0));
    for (Eigen::Index i = 0; i < n; ++i) {
      uv[static_cast<size_t>(i)][axis] = scale * solver.eigenvectors()(i, column);
    }
  }
  return uv;
}

// Without one of the markers.
Eigen::MatrixXd DistancesWithout(size_t marker, const Eigen::MatrixXd& distances) {
  const auto left_out = static_cast<Eigen::Index>(marker);
  const auto old_index = [&](Eigen::Index i) { return i < left_out ? i : i + 1; };
  const Eigen::Index n = distances.rows() - 1;
  Eigen::MatrixXd others(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) others(i, j) = distances(old_index(i), old_index(j));
  }
  return others;
}

double RmsOfFlatLayout(const Eigen::MatrixXd& distances) {
  return CompareLayout(FindFlatLayout(distances), distances).rms;
}

}  // namespace

Eigen::MatrixXd LargestDistances(const std::vector<HandleDescription::Path>& paths) {
  const auto n = static_cast<Eigen::Index>(paths.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double largest =
          LargestDistance(paths[static_cast<size_t>(i)], paths[static_cast<size_t>(j)]);
      distances(i, j) = distances(j, i) = largest;
    }
  }
  return distances;
}

LayoutFit CompareLayout(const std::vector<Eigen::Vector2d>& uv, const Eigen::MatrixXd& distances) {
  LayoutFit fit;
  int count = 0;
  for (size_t i = 0; i < uv.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const double measured = distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (measured < 0.0) continue;
      const double flat = (uv[i] - uv[j]).norm();
      fit.rms += (flat - measured) * (flat - measured);
      if (flat > 0.0) fit.largest_stretch = std::max(fit.largest_stretch, measured / flat - 1.0);
      ++count;
    }
  }
  fit.rms = count == 0 ? 0.0 : std::sqrt(fit.rms / count);
  return fit;
}

std::vector<Eigen::Vector2d> FindFlatLayout(const Eigen::MatrixXd& distances) {
  std::vector<Eigen::Vector2d> uv = ClassicalScaling(Completed(distances));
  ceres::Problem problem;
  for (size_t i = 0; i < uv.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const double measured = distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      if (measured < 0.0) continue;
      problem.AddResidualBlock(
          new ceres::AutoDiffCostFunction<PairDistance, 1, 2, 2>(new PairDistance{measured}),
          nullptr, uv[i].data(), uv[j].data());
    }
  }
  ceres::Solver::Options options;
  options.linear_solver_type =
      ceres::DENSE_QR;  // three directions move nothing: no normal equations
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return uv;
}

std::optional<size_t> FindLooseMarker(const Eigen::MatrixXd& distances) {
  constexpr Eigen::Index kLeast = 6;
  if (distances.rows() < kLeast) return std::nullopt;
  const double rms = RmsOfFlatLayout(distances);
  if (rms < kLooseRms) return std::nullopt;
  double best = rms / kLooseGain;
  std::optional<size_t> loose;
  for (size_t i = 0; i < static_cast<size_t>(distances.rows()); ++i) {
    const double without = RmsOfFlatLayout(DistancesWithout(i, distances));
    if (without >= best) continue;
    best = without;
    loose = i;
  }
  return loose;
}

}  // namespace clothfit
