// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/finite_elements/cloth.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

// dz = (ds - z |ds|) / onset, Dahl 1968, for a small slide.
double Slid(double z, double slide, double onset) {
  return z + (slide - z * std::abs(slide)) / onset;
}

// N per area, of air that a surface with this unit normal moves through.
Vector3d Drag(const FemLaws& laws, const Vector3d& normal, const Vector3d& velocity) {
  const double across = velocity.dot(normal);
  const double quadratic =
      laws.drag_normal * std::abs(across) * across / (1.0 + laws.drag_saturation * across * across);
  return -quadratic * normal - laws.drag_tangential * (velocity - across * normal);
}

}  // namespace

FemCloth::FemCloth(FemMesh mesh, FemLaws laws, std::vector<FemHandle> handles,
                   std::optional<FemGround> ground, VectorXd positions)
    : mesh_(std::move(mesh)),
      laws_(std::move(laws)),
      handles_(std::move(handles)),
      ground_(ground),
      areas_(VertexAreas(mesh_)),
      laplacians_(LaplaciansOf(mesh_)),
      x_(std::move(positions)),
      v_(VectorXd::Zero(x_.size())),
      a_(VectorXd::Zero(x_.size())) {
  for (const std::array<int, 3>& nodes : mesh_.triangles) {
    const double area = TriangleArea(mesh_, nodes);
    Triangle triangle{nodes, {}, {}, area, Vector2d::Zero()};
    for (int i = 0; i < 3; ++i) {
      const Vector2d& next = mesh_.uv[nodes[(i + 1) % 3]];
      const Vector2d& last = mesh_.uv[nodes[(i + 2) % 3]];
      triangle.du[i] = (next.y() - last.y()) / (2.0 * area);
      triangle.dv[i] = (last.x() - next.x()) / (2.0 * area);
      triangle.uv += mesh_.uv[nodes[i]] / 3.0;
    }
    triangles_.push_back(triangle);
  }
  // Points of a thread along the diagonal.
  Vector2d corner = Vector2d::Zero();
  for (const Vector2d& uv : mesh_.uv) corner = corner.cwiseMax(uv);
  for (int k = 0; k <= kThreadPieces; ++k) {
    const Vector2d at = corner * (static_cast<double>(k) / kThreadPieces);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Triangle& triangle = triangles_[t];
      std::array<double, 3> weights{};
      for (int i = 0; i < 3; ++i) {
        const Vector2d from = at - triangle.uv;
        weights[i] = 1.0 / 3.0 + triangle.du[i] * from.x() + triangle.dv[i] * from.y();
      }
      if (*std::min_element(weights.begin(), weights.end()) < -1e-9) continue;
      thread_.emplace_back(static_cast<int>(t), weights);
      break;
    }
  }
  for (const Triangle& triangle : triangles_) {
    const Strain s = StrainOf(triangle);
    memory_.push_back({0.0, 0.0, 0.0, 0.0, s.warp, s.weft, s.shear});
  }
  stable_step_ = LargestStableStep();
}

FemCloth::Tangents FemCloth::TangentsOf(const Triangle& triangle, const VectorXd& x) {
  Tangents tangents;
  for (int i = 0; i < 3; ++i) {
    tangents.x_u += triangle.du[i] * x.segment<3>(3 * triangle.nodes[i]);
    tangents.x_v += triangle.dv[i] * x.segment<3>(3 * triangle.nodes[i]);
  }
  return tangents;
}

FemCloth::Strain FemCloth::StrainOf(const Triangle& triangle) const {
  const Tangents tangents = TangentsOf(triangle, x_);
  const double u = tangents.x_u.norm(), v = tangents.x_v.norm();
  return {tangents, u - 1.0, v - 1.0, tangents.x_u.dot(tangents.x_v) / (u * v)};
}

Vector3d FemCloth::AreaNormal(const Triangle& triangle) const {
  const Vector3d origin = x_.segment<3>(3 * triangle.nodes[0]);
  return (x_.segment<3>(3 * triangle.nodes[1]) - origin)
      .cross(x_.segment<3>(3 * triangle.nodes[2]) - origin);
}

void FemCloth::AddMembranes(const FemLaws& laws, VectorXd* force) const {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& triangle = triangles_[t];
    const FemLaws::Membrane& law = laws.membranes[t];
    const Memory& memory = memory_[t];
    const Strain s = StrainOf(triangle);
    const Tangents rate = TangentsOf(triangle, v_);
    const double u = 1.0 + s.warp, v = 1.0 + s.weft;
    const Vector3d along_u = s.tangents.x_u / u, along_v = s.tangents.x_v / v;
    const Vector3d shear_u = (along_v - s.shear * along_u) / u;
    const Vector3d shear_v = (along_u - s.shear * along_v) / v;
    const auto cubic = [&](double strain) {
      const double beyond = std::max(0.0, strain - laws.cubic_onset);
      return laws.cubic * beyond * beyond * beyond;
    };
    const double warp = law.warp * s.warp + cubic(s.warp) +
                        laws.stretch_viscosity * along_u.dot(rate.x_u) +
                        laws.stretch_share * law.warp * memory.relaxing_warp;
    const double weft = law.weft * s.weft + cubic(s.weft) +
                        laws.stretch_viscosity * along_v.dot(rate.x_v) +
                        laws.stretch_share * law.weft * memory.relaxing_weft;
    const double turning = shear_u.dot(rate.x_u) + shear_v.dot(rate.x_v);
    const double shear = law.shear * s.shear + laws.shear_viscosity * turning +
                         laws.shear_share * law.shear * memory.relaxing_shear +
                         laws.shear_friction * memory.friction;
    const Vector3d pull_u = triangle.area * (warp * along_u + shear * shear_u);
    const Vector3d pull_v = triangle.area * (weft * along_v + shear * shear_v);
    for (int i = 0; i < 3; ++i) {
      force->segment<3>(3 * triangle.nodes[i]) -= triangle.du[i] * pull_u + triangle.dv[i] * pull_v;
    }
  }
}

// Damping acts on the rate of the curvature's size: a bent cloth that turns as a whole is not held
// back. Where the cloth is nearly flat the curvature is that along the normal.
void FemCloth::AddPlates(const FemLaws& laws, VectorXd* force) const {
  constexpr double kFlat = 1.0;  // 1/m
  const Eigen::Matrix3Xd normals = VertexNormals();
  for (std::size_t p = 0; p < laplacians_.size(); ++p) {
    const FemLaplacian& laplacian = laplacians_[p];
    Vector3d bent = Vector3d::Zero(), rate = Vector3d::Zero();
    for (const auto& [vertex, weight] : laplacian.weights) {
      bent += weight * x_.segment<3>(3 * vertex);
      rate += weight * v_.segment<3>(3 * vertex);
    }
    const Vector3d normal = normals.col(laplacian.vertex);
    const double flat = kFlat * laplacian.area;
    const Vector3d along = (bent + (bent.dot(normal) < 0.0 ? -flat : flat) * normal).normalized();
    const Vector3d resisted =
        laws.plates[p] / laplacian.area * (bent + laws.bending_delay * rate.dot(along) * along);
    for (const auto& [vertex, weight] : laplacian.weights)
      force->segment<3>(3 * vertex) -= weight * resisted;
  }
}

void FemCloth::AddAir(const FemLaws& laws, VectorXd* force) const {
  for (const Triangle& triangle : triangles_) {
    const auto mean = [&](const VectorXd& of) -> Vector3d {
      return (of.segment<3>(3 * triangle.nodes[0]) + of.segment<3>(3 * triangle.nodes[1]) +
              of.segment<3>(3 * triangle.nodes[2])) /
             3.0;
    };
    const Vector3d place = mean(x_);
    Vector3d velocity = mean(v_);
    for (const FemLaws::Air& air : laws.air) velocity -= air(place, triangle.uv, time_);
    const Vector3d across = AreaNormal(triangle);
    const double twice_area = across.norm();
    const Vector3d push = twice_area / 6.0 * Drag(laws, across / twice_area, velocity);
    for (const int node : triangle.nodes) force->segment<3>(3 * node) += push;
  }
}

void FemCloth::AddOutside(const FemLaws& laws, VectorXd* force) const {
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    const Vector3d place = x_.segment<3>(3 * i), velocity = v_.segment<3>(3 * i);
    Vector3d pressure = Vector3d::Zero();
    for (const FemLaws::Outside& law : laws.outside) pressure += law(place, velocity);
    const double depth = ground_ ? ground_->distance - (place.z() - ground_->height) : 0.0;
    if (depth > 0.0) {
      const double push = ground_->stiffness * depth * depth / ground_->distance;
      const double drag =
          ground_->friction * push / std::hypot(velocity.head<2>().norm(), ground_->slip_speed);
      pressure += Vector3d(-drag * velocity.x(), -drag * velocity.y(), push);
    }
    force->segment<3>(3 * i) +=
        areas_[i] * pressure + (laws.mass[i] + laws.extra_mass[i]) * laws.gravity;
  }
}

void FemCloth::AddDiagonalThread(const FemLaws& laws, VectorXd* force) const {
  constexpr double kRounding = 0.01;  // strain over which it becomes taut
  std::vector<Vector3d> points;
  for (const auto& [t, weights] : thread_) {
    Vector3d point = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) point += weights[i] * x_.segment<3>(3 * triangles_[t].nodes[i]);
    points.push_back(point);
  }
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const Vector3d along = points[k + 1] - points[k];
    const double strain = along.norm() / ((1.0 - laws.thread_gather) * laws.thread_piece) - 1.0;
    const double taut = 0.5 * (strain + std::hypot(strain, kRounding));
    const Vector3d pull = laws.thread_stiffness * taut / along.norm() * along;
    for (int i = 0; i < 3; ++i) {
      const auto& [t0, w0] = thread_[k];
      const auto& [t1, w1] = thread_[k + 1];
      force->segment<3>(3 * triangles_[t0].nodes[i]) += w0[i] * pull;
      force->segment<3>(3 * triangles_[t1].nodes[i]) -= w1[i] * pull;
    }
  }
}

VectorXd FemCloth::ForcesOf(const FemLaws& laws) const {
  VectorXd force = VectorXd::Zero(x_.size());
  AddMembranes(laws, &force);
  AddPlates(laws, &force);
  AddAir(laws, &force);
  AddOutside(laws, &force);
  if (laws.thread_stiffness > 0.0) AddDiagonalThread(laws, &force);
  return force;
}

Eigen::Matrix3Xd FemCloth::VertexNormals() const {
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, x_.size() / 3);
  for (const Triangle& triangle : triangles_) {
    const Vector3d across = AreaNormal(triangle);
    for (const int node : triangle.nodes) normals.col(node) += across;
  }
  normals.colwise().normalize();
  return normals;
}

VectorXd FemCloth::ForceBeyond(const FemLaws& others) const {
  VectorXd force = ForcesOf(laws_) - ForcesOf(others);
  const Eigen::Matrix3Xd normals = VertexNormals();
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    const Vector3d a = a_.segment<3>(3 * i), n = normals.col(static_cast<Eigen::Index>(i));
    force.segment<3>(3 * i) -= (laws_.extra_mass[i] - others.extra_mass[i]) * a +
                               (laws_.added_mass - others.added_mass) * areas_[i] * a.dot(n) * n;
  }
  return force;
}

double FemCloth::ElasticEnergy() const {
  double energy = 0.0;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Strain s = StrainOf(triangles_[t]);
    const FemLaws::Membrane& law = laws_.membranes[t];
    energy +=
        0.5 * triangles_[t].area *
        (law.warp * s.warp * s.warp + law.weft * s.weft * s.weft + law.shear * s.shear * s.shear);
  }
  for (std::size_t p = 0; p < laplacians_.size(); ++p) {
    Vector3d bent = Vector3d::Zero();
    for (const auto& [vertex, weight] : laplacians_[p].weights)
      bent += weight * x_.segment<3>(3 * vertex);
    energy += 0.5 * laws_.plates[p] / laplacians_[p].area * bent.squaredNorm();
  }
  return energy;
}

double FemCloth::KineticEnergy() const {
  double energy = 0.0;
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    energy += 0.5 * (laws_.mass[i] + laws_.extra_mass[i]) * v_.segment<3>(3 * i).squaredNorm();
  }
  return energy;
}

void FemCloth::Remember(double step) {
  if (!laws_.HasMemory()) return;
  // dq/dt = de/dt - q / time
  const double stretch = std::exp(-step / laws_.stretch_time);
  const double shear = std::exp(-step / laws_.shear_time);
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Strain s = StrainOf(triangles_[t]);
    Memory& memory = memory_[t];
    memory.relaxing_warp = stretch * memory.relaxing_warp + s.warp - memory.warp;
    memory.relaxing_weft = stretch * memory.relaxing_weft + s.weft - memory.weft;
    memory.relaxing_shear = shear * memory.relaxing_shear + s.shear - memory.shear;
    memory.friction = Slid(memory.friction, s.shear - memory.shear, laws_.shear_onset);
    memory.warp = s.warp;
    memory.weft = s.weft;
    memory.shear = s.shear;
  }
}

// 1/s^2 or 1/s: the largest eigenvalue of what `response` makes of a small displacement or velocity
// (3N), over the masses, by power iteration.
double FemCloth::LargestRate(const std::function<VectorXd(const VectorXd&)>& response) const {
  constexpr int kIterations = 60;
  VectorXd direction(x_.size());
  for (Eigen::Index i = 0; i < direction.size(); ++i)
    direction[i] = std::sin(1.0 + 2.3 * static_cast<double>(i * i % 97));
  double largest = 0.0;
  for (int k = 0; k < kIterations; ++k) {
    direction.normalize();
    VectorXd answer = response(direction);
    for (std::size_t i = 0; i < areas_.size(); ++i) answer.segment<3>(3 * i) /= laws_.mass[i];
    largest = answer.norm();
    if (largest == 0.0) break;
    direction = answer;
  }
  return largest;
}

// s. For vibrations w and decays r, symplectic Euler with what damps explicit needs w^2 h^2 + 2 r h
// below 4; half of that is left in hand.
double FemCloth::LargestStableStep() {
  constexpr double kSmall = 1e-7, kLimit = 2.0;
  const VectorXd x = x_, rest = Forces();
  const double squared = LargestRate([&](const VectorXd& direction) {
    x_ = x + kSmall * direction;
    const VectorXd response = (Forces() - rest) / kSmall;
    x_ = x;
    return response;
  });
  const double decay = LargestRate([&](const VectorXd& direction) {
    v_ = kSmall * direction;
    const VectorXd response = (Forces() - rest) / kSmall;
    v_.setZero();
    return response;
  });
  // Friction's memory is a stiffness at first that Forces does not see.
  const double friction = laws_.shear_friction / laws_.shear_onset;
  const double stiffest = laws_.membranes.front().shear + laws_.membranes.front().warp;
  const double all = squared * (1.0 + friction / stiffest);
  return (std::sqrt(decay * decay + kLimit * all) - decay) / all;
}

void FemCloth::Step(double step) {
  const VectorXd force = Forces();
  const Eigen::Matrix3Xd normals =
      laws_.added_mass > 0.0 ? VertexNormals() : Eigen::Matrix3Xd(3, 0);
  for (std::size_t i = 0; i < areas_.size(); ++i) {
    const double mass = laws_.mass[i] + laws_.extra_mass[i];
    Vector3d a = force.segment<3>(3 * i) / mass;
    if (laws_.added_mass > 0.0) {
      const Vector3d n = normals.col(static_cast<Eigen::Index>(i));
      const double more = laws_.added_mass * areas_[i];
      a -= more / (mass + more) * a.dot(n) * n;
    }
    a_.segment<3>(3 * i) = a;
  }
  v_ += step * a_;
  for (const FemHandle& handle : handles_) {
    const auto i = 3 * handle.vertex;
    const Vector3d before = v_.segment<3>(i) - step * a_.segment<3>(i);
    v_.segment<3>(i) = (handle.path(time_ + step) - x_.segment<3>(i)) / step;
    a_.segment<3>(i) = (v_.segment<3>(i) - before) / step;
  }
  x_ += step * v_;
  time_ += step;
  if (!x_.allFinite()) throw std::runtime_error("the finite elements diverge");
  Remember(step);
}

}  // namespace clothfit
