// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/locate.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fitting/diagnosis/locate/discrepancy_text.h"
#include "fitting/optimise/checked_factor.h"

namespace clothfit {
namespace {

// Upper tail of the chi-squared distribution with three degrees of freedom.
double ChiSquared3Tail(double x) {
  return std::erfc(std::sqrt(0.5 * x)) + std::sqrt(2.0 * x / M_PI) * std::exp(-0.5 * x);
}

}  // namespace

Eigen::MatrixXd MapStatistics(const MissingForce& missing, const Eigen::MatrixXd& forces) {
  const Eigen::MatrixXd blocks = missing.posterior.NoiseBlocks();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < blocks.cols(); ++i) largest = std::max(largest, blocks(i % 3, i));
  Eigen::MatrixXd statistics(forces.rows() / 3, forces.cols());
  for (Eigen::Index part = 0; part < statistics.rows(); ++part) {
    // Where the data say nothing both vanish; the statistic does too.
    constexpr double kNothing = 1e-6;
    const Eigen::Matrix3d covariance =
        blocks.middleCols<3>(3 * part) + kNothing * largest * Eigen::Matrix3d::Identity();
    const auto factor = TryCholesky(covariance);
    if (!factor) {
      statistics.row(part).setZero();
      continue;
    }
    const Eigen::MatrixXd white = factor->matrixL().solve(forces.middleRows<3>(3 * part));
    statistics.row(part) = white.colwise().norm();
  }
  return statistics;
}

double MapPValue(const MissingForce& missing) {
  const Eigen::Index nulls = missing.null_forces.cols();
  Eigen::MatrixXd forces(missing.force.size(), 1 + nulls);
  // The linear estimate, as those of the null are: a simulation that cannot follow it all the way
  // would hold a large force for a small one.
  forces << missing.posterior.Mean(missing.system.data.leftCols(1)), missing.null_forces;
  const Eigen::MatrixXd all = MapStatistics(missing, forces);
  if (nulls == 0) {
    const double each = ChiSquared3Tail(std::pow(all.maxCoeff(), 2));
    return -std::expm1(static_cast<double>(all.size()) * std::log1p(-std::min(each, 1.0 - 1e-15)));
  }
  constexpr double kOfNoise = 10.0;  // recordings that noise alone counts for; squares are about 3
  const Eigen::VectorXd squares = all.rowwise().squaredNorm() / 3.0;
  const Eigen::VectorXd scale =
      ((squares.array() + kOfNoise) / (kOfNoise + static_cast<double>(all.cols())))
          .sqrt()
          .inverse();
  const Eigen::VectorXd largest = (scale.asDiagonal() * all).colwise().maxCoeff().transpose();
  return static_cast<double>((largest.array() >= largest[0]).count()) /
         static_cast<double>(largest.size());
}

namespace {

// The largest force of any (node, knot) in the region, and its sigma along itself.
void FindPeak(const MissingForce& missing, Discrepancy* discrepancy) {
  const ForceLayout& layout = missing.layout;
  const Eigen::MatrixXd blocks = missing.posterior.Blocks();
  const Eigen::Vector2d reach(0.5 * (layout.high.x() - layout.low.x()) / (layout.nodes[0] - 1),
                              0.5 * (layout.high.y() - layout.low.y()) / (layout.nodes[1] - 1));
  for (int k = 0; k < layout.num_knots; ++k) {
    const double frame = k * layout.frames_per_knot, half = 0.5 * layout.frames_per_knot;
    if (frame < discrepancy->first_frame - half || frame > discrepancy->last_frame + half) continue;
    for (int node = 0; node < layout.num_nodes(); ++node) {
      const Eigen::Vector2d uv = layout.NodePlace(node);
      if ((uv - discrepancy->low_uv + reach).minCoeff() < 0.0 ||
          (discrepancy->high_uv + reach - uv).minCoeff() < 0.0)
        continue;
      const int i = layout.Index(k, node, 0);
      const Eigen::Vector3d f = missing.force.segment<3>(i);
      if (f.norm() <= discrepancy->peak) continue;
      discrepancy->peak = f.norm();
      const Eigen::Vector3d along = f.normalized();
      discrepancy->peak_sigma = std::sqrt(along.dot(blocks.middleCols<3>(i) * along));
    }
  }
}

// The even force on the patch that a system finds, and its covariance.
struct Amplitude {
  Eigen::Vector3d value;
  Eigen::Matrix3d covariance;
};

Amplitude EstimateAmplitude(const LinearSystem& system, const ForcePatch& patch, double noise) {
  Eigen::MatrixXd pattern = Eigen::MatrixXd::Zero(system.information.rows(), 3);
  for (Eigen::Index i = 0; i < patch.weights.size(); ++i) {
    for (int c = 0; c < 3; ++c) pattern(3 * i + c, c) = patch.weights[i];
  }
  const Eigen::MatrixXd moved = system.information.selfadjointView<Eigen::Lower>() * pattern;
  Eigen::Matrix3d information = pattern.transpose() * moved;
  constexpr double kRidge = 1e-12;
  information.diagonal().array() += kRidge + kRidge * information.trace();
  const Eigen::Matrix3d inverse = information.inverse();
  return {inverse * (pattern.transpose() * system.data.col(0)), noise * noise * inverse};
}

// Neighbouring places err against each other, so that this is known better than any of them.
void FindEven(const MissingForce& missing, const ForcePatch& patch, Discrepancy* discrepancy) {
  const Amplitude even = EstimateAmplitude(missing.system, patch, missing.noise_factor);
  discrepancy->even = even.value.norm();
  if (!(discrepancy->even > 0.0)) return;
  const Eigen::Vector3d along = even.value / discrepancy->even;
  discrepancy->even_sigma = std::sqrt(along.dot(even.covariance * along));
}

// Mean over the region and its time, of the force with the force found there for a weight.
Eigen::Vector3d MeanDirection(const Scene& scene, const MissingForce& missing,
                              const Discrepancy& discrepancy) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int frame = discrepancy.first_frame; frame <= discrepancy.last_frame; ++frame) {
    const Eigen::Matrix3Xd forces = TriangleForces(scene.mesh, missing.layout, missing.force,
                                                   scene.FrameTime(frame), missing.x[frame]);
    for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
      const std::array<int, 3>& nodes = scene.mesh.triangles[t];
      const std::vector<Eigen::Vector2d>& uv = scene.mesh.uv;
      const Eigen::Vector2d middle = (uv[nodes[0]] + uv[nodes[1]] + uv[nodes[2]]) / 3.0;
      if ((middle - discrepancy.low_uv).minCoeff() >= 0.0 &&
          (discrepancy.high_uv - middle).minCoeff() >= 0.0)
        sum += forces.col(static_cast<Eigen::Index>(t));
    }
  }
  return sum.stableNormalized();
}

}  // namespace

Location Locate(const Scene& scene, const MissingForce& missing, const LocateOptions& options) {
  Location location;
  location.patch = FindPatch(missing);
  Discrepancy& discrepancy = location.discrepancy;
  discrepancy.p_value = MapPValue(missing);
  discrepancy.is_significant = discrepancy.p_value <= options.significance;
  discrepancy.first_frame = location.patch.first_frame;
  discrepancy.last_frame = location.patch.last_frame;
  discrepancy.low_uv = location.patch.low_uv;
  discrepancy.high_uv = location.patch.high_uv;
  FindPeak(missing, &discrepancy);
  FindEven(missing, location.patch, &discrepancy);
  discrepancy.direction = MeanDirection(scene, missing, discrepancy);
  discrepancy.words = DiscrepancyText(scene, missing.layout, missing.last_frame, discrepancy);
  return location;
}

namespace {

SourceShift ShiftWithout(const SourceSystem& source, const ForcePatch& patch,
                         const Amplitude& with_all, double noise) {
  const Amplitude without = EstimateAmplitude(source.force, patch, noise);
  SourceShift shift;
  shift.camera = source.camera;
  shift.kept = without.value.dot(with_all.value) / with_all.value.squaredNorm();
  // Along the amplitude, of which the others are to tell whether it is there.
  const Eigen::Vector3d along = with_all.value.normalized();
  const double difference = along.dot(without.value - with_all.value);
  const double variance = std::max(along.dot((without.covariance - with_all.covariance) * along),
                                   1e-12 * along.dot(with_all.covariance * along));
  shift.p_value = std::erfc(std::abs(difference) / std::sqrt(2.0 * variance));
  return shift;
}

}  // namespace

std::vector<SourceShift> WhoseDiscrepancy(const Recording& recording, const MissingForce& missing,
                                          const ForcePatch& patch) {
  std::vector<SourceShift> shifts;
  if (missing.without.size() < 2) return shifts;
  const Amplitude with_all = EstimateAmplitude(missing.system, patch, missing.noise_factor);
  std::size_t least = 0;
  for (const SourceSystem& source : missing.without) {
    shifts.push_back(ShiftWithout(source, patch, with_all, missing.noise_factor));
    SourceShift& shift = shifts.back();
    shift.name = source.camera < 0 ? "markers" : "camera " + recording.cameras[source.camera].name;
    if (shift.kept < shifts[least].kept) least = shifts.size() - 1;
  }
  constexpr double kMost = 0.5, kByChance = 1e-3;
  shifts[least].is_to_blame = shifts[least].kept < kMost && shifts[least].p_value < kByChance;
  return shifts;
}

}  // namespace clothfit
