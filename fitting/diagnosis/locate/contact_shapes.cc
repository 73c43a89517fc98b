// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/contact_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "autodiff_sim/term/tilted_down.h"

namespace clothfit {
namespace {

constexpr double kOfLargest = 1.0 / 3.0;
constexpr double kParallel = 1e-3;  // of the spread of directions, beside the largest

double MeanDistance(const std::vector<Push>& pushes, const Eigen::Matrix3d& across,
                    const Eigen::Vector3d& middle) {
  double sum = 0.0, weights = 0.0;
  for (const Push& push : pushes) {
    sum += push.force.norm() * (across * (push.at - middle)).norm();
    weights += push.force.norm();
  }
  return sum / weights;
}

// Least squares of the distances from the lines along the forces, in the space that `across`
// projects onto.
std::optional<Eigen::Vector3d> NearestToLines(const std::vector<Push>& pushes,
                                              const Eigen::Matrix3d& across) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Push& push : pushes) {
    const Eigen::Vector3d projected = across * push.force;
    const double weight = projected.norm();
    if (!(weight > 0.0)) continue;
    const Eigen::Vector3d along = projected / weight;
    const Eigen::Matrix3d off_line = across - along * along.transpose();
    matrix += weight * off_line;
    right += weight * off_line * push.at;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(matrix);
  const double largest = eigen.eigenvalues()[2];
  const int dimensions = static_cast<int>(std::lround(across.trace()));
  Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
  for (int k = 0; k < dimensions; ++k) {
    const double value = eigen.eigenvalues()[2 - k];
    if (!(value > kParallel * largest)) return {};
    const Eigen::Vector3d axis = eigen.eigenvectors().col(2 - k);
    nearest += axis * (axis.dot(right) / value);
  }
  return nearest;
}

// As TiltedDown has it.
Eigen::Vector2d TiltOf(const DownFrame& frame, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d cross = frame.down.cross(direction);
  const double sine = cross.norm(), angle = std::atan2(sine, frame.down.dot(direction));
  const Eigen::Vector3d axis = sine > 1e-9 ? Eigen::Vector3d(cross / sine) : frame.axis_1;
  return angle * Eigen::Vector2d(axis.dot(frame.axis_1), axis.dot(frame.axis_2));
}

}  // namespace

std::vector<Push> StrongestPushes(const ClothMesh& mesh, const MissingForce& missing) {
  std::vector<Push> all;
  double largest = 0.0;
  for (int frame = 0; frame <= missing.last_frame; ++frame) {
    const Eigen::VectorXd& x = missing.x[static_cast<std::size_t>(frame)];
    const double time = frame / missing.layout.frame_rate;
    for (const std::array<int, 3>& nodes : mesh.triangles) {
      Eigen::Vector2d uv = Eigen::Vector2d::Zero();
      Eigen::Vector3d at = Eigen::Vector3d::Zero();
      for (const int node : nodes) {
        uv += mesh.uv[static_cast<std::size_t>(node)] / 3.0;
        at += x.segment<3>(3 * node) / 3.0;
      }
      all.push_back(
          {at, TriangleFrame(mesh, nodes, x) * missing.layout.At(missing.force, time, uv)});
      largest = std::max(largest, all.back().force.norm());
    }
  }
  all.erase(
      std::remove_if(all.begin(), all.end(),
                     [&](const Push& push) { return push.force.norm() < kOfLargest * largest; }),
      all.end());
  return all;
}

PlaneFit FitPlane(const std::vector<Push>& pushes) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Push& push : pushes) sum += push.force;
  const Eigen::Vector3d normal = sum.normalized();
  double height = 0.0, weights = 0.0;
  for (const Push& push : pushes) {
    height += push.force.norm() * normal.dot(push.at);
    weights += push.force.norm();
  }
  return {normal, height / weights};
}

std::optional<SphereFit> FitSphere(const std::vector<Push>& pushes) {
  const Eigen::Matrix3d all = Eigen::Matrix3d::Identity();
  const std::optional<Eigen::Vector3d> middle = NearestToLines(pushes, all);
  if (!middle) return {};
  return SphereFit{*middle, MeanDistance(pushes, all, *middle)};
}

std::optional<CapsuleFit> FitCapsule(const std::vector<Push>& pushes) {
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  for (const Push& push : pushes) directions += push.force * push.force.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(directions);
  const Eigen::Vector3d axis = eigen.eigenvectors().col(0);
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis * axis.transpose();
  const std::optional<Eigen::Vector3d> nearest = NearestToLines(pushes, across);
  if (!nearest) return {};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Push& push : pushes) {
    low = std::min(low, axis.dot(push.at));
    high = std::max(high, axis.dot(push.at));
  }
  const double beyond = 0.5 * (high - low);
  return CapsuleFit{*nearest + (low - beyond) * axis, *nearest + (high + beyond) * axis,
                    MeanDistance(pushes, across, *nearest)};
}

std::vector<ContactStart> ContactStarts(const std::vector<Push>& pushes,
                                        const Eigen::Vector3d& gravity) {
  std::vector<ContactStart> starts;
  if (pushes.empty()) return starts;
  const PlaneFit plane = FitPlane(pushes);
  if (!plane.normal.allFinite()) return starts;
  const Eigen::Vector2d tilt = TiltOf(MakeDownFrame(gravity), -plane.normal);
  starts.push_back({"obstacle_plane",
                    {{"obstacle_plane.height", plane.height},
                     {"obstacle_plane.angle_1", tilt[0]},
                     {"obstacle_plane.angle_2", tilt[1]}}});
  if (const std::optional<SphereFit> ball = FitSphere(pushes)) {
    starts.push_back({"obstacle_sphere",
                      {{"obstacle_sphere.x", ball->middle.x()},
                       {"obstacle_sphere.y", ball->middle.y()},
                       {"obstacle_sphere.z", ball->middle.z()},
                       {"obstacle_sphere.radius", ball->radius}}});
  }
  if (const std::optional<CapsuleFit> bar = FitCapsule(pushes)) {
    starts.push_back({"obstacle_capsule",
                      {{"obstacle_capsule.x1", bar->end_1.x()},
                       {"obstacle_capsule.y1", bar->end_1.y()},
                       {"obstacle_capsule.z1", bar->end_1.z()},
                       {"obstacle_capsule.x2", bar->end_2.x()},
                       {"obstacle_capsule.y2", bar->end_2.y()},
                       {"obstacle_capsule.z2", bar->end_2.z()},
                       {"obstacle_capsule.radius", bar->radius}}});
  }
  return starts;
}

}  // namespace clothfit
