// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The free vector: what its entries are and what they move.
#include "fitting/rollout/free_parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/QR>

#include "autodiff_sim/base/error.h"
#include "fitting/optimise/checked_factor.h"
#include "fitting/scene/path_guess.h"

namespace clothfit {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr char kAxes[] = "xyz";

}  // namespace

FreeParameters::FreeParameters(const FitConfig& config, const Scene& scene,
                               const std::vector<NamedParameter>& table)
    : values_(InitialValues(table)), initial_(scene.initial) {
  AddParameters(config, table);
  AddHandles(config, scene);
  AddInitialState(config, scene);
  start_.resize(size());
  for (int i = 0; i < size(); ++i) start_[i] = starts_[i];
  BuildPrior(config, scene);
  GuessHandlePaths(scene);
}

void FreeParameters::AddParameters(const FitConfig& config,
                                   const std::vector<NamedParameter>& table) {
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto found = config.parameters.find(table[i].name);
    if (found == config.parameters.end()) continue;
    const ParameterSetting& setting = found->second;
    values_[static_cast<Eigen::Index>(i)] = setting.value;
    if (!setting.free) continue;
    FreeEntry entry;
    entry.kind = FreeEntry::Kind::kParameter;
    entry.name = table[i].name;
    entry.unit = table[i].parameter.unit;
    entry.is_log = setting.scale.value_or(table[i].parameter.scale) == Scale::kLog;
    if (entry.is_log && !(setting.lower > 0.0 && setting.value > 0.0)) {
      throw InputError("parameters." + entry.name,
                       "on a logarithmic scale a free value and its bounds are above 0");
    }
    entry.index = static_cast<int>(i);
    const auto scaled = [&entry](double value) { return entry.is_log ? std::log(value) : value; };
    entry.least = setting.lower;
    entry.most = setting.upper;
    entry.lower = scaled(setting.lower);
    entry.upper = scaled(setting.upper);
    entry.prior = scaled(setting.prior);
    entry.prior_sigma = scaled(setting.prior_sigma);
    entries_.push_back(entry);
    starts_.push_back(scaled(setting.value));
  }
}

void FreeParameters::AddHandles(const FitConfig&, const Scene& scene) {
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const SceneHandle& handle = scene.handles[h];
    for (int c = 0; c < handle.path.num_controls(); ++c) {
      for (int axis = 0; axis < 3; ++axis) {
        FreeEntry entry;
        entry.kind = FreeEntry::Kind::kHandle;
        entry.name = "handle." + handle.name + "." + kAxes[axis] + "[" + std::to_string(c) + "]";
        entry.unit = "m";
        entry.index = static_cast<int>(h);
        entry.control = c;
        entry.axis = axis;
        entry.lower = -kUnbounded;
        entry.upper = kUnbounded;
        entry.prior = handle.path.controls()[c][axis];  // where the cloth lies at frame 0
        entry.prior_sigma = 1.0;                        // m; its neighbours say more
        entries_.push_back(entry);
        starts_.push_back(entry.prior);
      }
    }
  }
}

void FreeParameters::AddInitialState(const FitConfig& config, const Scene& scene) {
  const int order = config.initial_order;
  const Eigen::Vector2d size = scene.recording.cloth.size;
  std::vector<std::array<int, 2>> powers;
  for (int a = 0; a <= order; ++a) {
    for (int b = 0; b <= order; ++b) powers.push_back({a, b});
  }
  modes_.resize(scene.mesh.num_particles(), static_cast<Eigen::Index>(powers.size()));
  const double width2 = 0.0625 * size.squaredNorm();  // a quarter of the diagonal
  std::vector<Eigen::Vector2d> held;
  for (const HandleDescription& handle : scene.recording.handles) held.push_back(handle.uv);
  for (int i = 0; i < scene.mesh.num_particles(); ++i) {
    const Eigen::Vector2d& uv = scene.mesh.uv[i];
    const Eigen::Vector2d s = 2.0 * uv.cwiseQuotient(size) - Eigen::Vector2d::Ones();
    double window = 1.0;  // no offset at the handles
    for (const Eigen::Vector2d& h : held)
      window *= 1.0 - std::exp(-0.5 * (uv - h).squaredNorm() / width2);
    for (std::size_t k = 0; k < powers.size(); ++k) {
      modes_(i, static_cast<Eigen::Index>(k)) =
          window * std::pow(s.x(), powers[k][0]) * std::pow(s.y(), powers[k][1]);
    }
  }
  for (const bool is_velocity : {false, true}) {
    for (std::size_t k = 0; k < powers.size(); ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        FreeEntry entry;
        entry.kind =
            is_velocity ? FreeEntry::Kind::kInitialVelocity : FreeEntry::Kind::kInitialPosition;
        entry.name = std::string("initial.") + (is_velocity ? "velocity." : "position.") +
                     kAxes[axis] + "[" + std::to_string(k) + "]";
        entry.unit = is_velocity ? "m/s" : "m";
        entry.index = static_cast<int>(k);
        entry.axis = axis;
        entry.lower = -kUnbounded;
        entry.upper = kUnbounded;
        entry.prior = 0.0;
        entry.prior_sigma =
            is_velocity ? config.initial_velocity_sigma : config.initial_position_sigma;
        entries_.push_back(entry);
        starts_.push_back(0.0);
      }
    }
  }
}

// Rows of the prior, each `row . theta - target` in units of its sigma.
void FreeParameters::BuildPrior(const FitConfig& config, const Scene& scene) {
  std::vector<Eigen::VectorXd> rows;
  std::vector<double> targets;
  const auto add = [&](const std::vector<std::pair<int, double>>& terms, double target,
                       double sigma) {
    Eigen::VectorXd row = Eigen::VectorXd::Zero(size());
    for (const auto& [index, factor] : terms) row[index] += factor / sigma;
    rows.push_back(row);
    targets.push_back(target / sigma);
  };
  for (int i = 0; i < size(); ++i) {
    if (entries_[i].kind != FreeEntry::Kind::kHandle) {
      add({{i, 1.0}}, entries_[i].prior, entries_[i].prior_sigma);
    }
  }
  // An unknown path begins where the cloth lies, has about the speed of a hand and changes it only
  // so fast.
  for (int i = 0; i < size(); ++i) {
    const FreeEntry& entry = entries_[i];
    if (entry.kind != FreeEntry::Kind::kHandle) continue;
    const SceneHandle& handle = scene.handles[entry.index];
    const double sigma =
        scene.recording.handles[entry.index].path_sigma.value_or(kDefaultPathSigma);
    const double spacing = handle.path.spacing();
    if (entry.control == 0) {
      add({{i, 1.0 / 6.0}, {i + 3, 4.0 / 6.0}, {i + 6, 1.0 / 6.0}}, entry.prior, sigma);
    }
    // Without this an unseen path would go on at its last speed for ever.
    if (entry.control + 1 < handle.path.num_controls()) {
      add({{i, -1.0}, {i + 3, 1.0}}, 0.0, config.spline_speed * spacing);
    }
    if (entry.control + 2 < handle.path.num_controls()) {
      add({{i, 1.0}, {i + 3, -2.0}, {i + 6, 1.0}}, 0.0,
          config.spline_acceleration * spacing * spacing);
    }
  }
  prior_jacobian_.resize(static_cast<Eigen::Index>(rows.size()), size());
  prior_target_.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    prior_jacobian_.row(static_cast<Eigen::Index>(r)) = rows[r].transpose();
    prior_target_[static_cast<Eigen::Index>(r)] = targets[r];
  }
}

// Starts each unknown path near where the markers say that it went: far from its path a fit would
// have to unfold the cloth first. Least squares over the guessed points and the path's own prior.
void FreeParameters::GuessHandlePaths(const Scene& scene) {
  std::vector<std::vector<PathPoint>> paths(scene.handles.size());
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    const SceneHandle& handle = scene.handles[h];
    if (!handle.path.is_known()) paths[h] = GuessPath(scene, handle.on_cloth.At(scene.mesh.uv));
  }
  constexpr double kGuessSigma = 0.01;  // m, of a guessed point
  start_ = WithHandlePaths(start_, scene, paths, kGuessSigma);
}

Eigen::VectorXd FreeParameters::WithHandlePaths(Eigen::VectorXd theta, const Scene& scene,
                                                const std::vector<std::vector<PathPoint>>& paths,
                                                double sigma) const {
  for (std::size_t h = 0; h < scene.handles.size(); ++h) {
    if (scene.handles[h].path.is_known()) continue;
    Eigen::MatrixXd information = prior_jacobian_.transpose() * prior_jacobian_;
    Eigen::VectorXd right = prior_jacobian_.transpose() * prior_target_;
    for (const PathPoint& point : paths[h]) {
      const Eigen::MatrixXd directions =
          HandleDirections(scene.handles, static_cast<int>(h), point.time) / sigma;
      information += directions.transpose() * directions;
      right += directions.transpose() * point.position / sigma;
    }
    const Eigen::VectorXd controls =
        Cholesky(information, "the path of handle " + scene.handles[h].name).solve(right);
    for (int i = 0; i < size(); ++i) {
      const bool own =
          entries_[i].kind == FreeEntry::Kind::kHandle && entries_[i].index == static_cast<int>(h);
      if (own) theta[i] = controls[i];
    }
  }
  return theta;
}

Eigen::VectorXd FreeParameters::Values(const Eigen::VectorXd& theta) const {
  Eigen::VectorXd values = values_;
  for (int i = 0; i < size(); ++i) {
    if (entries_[i].kind == FreeEntry::Kind::kParameter)
      values[entries_[i].index] = UnitValue(i, theta[i]);
  }
  return values;
}

Eigen::MatrixXd FreeParameters::ValueDirections(const Eigen::VectorXd& theta) const {
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(values_.size(), size());
  for (int i = 0; i < size(); ++i) {
    if (entries_[i].kind != FreeEntry::Kind::kParameter) continue;
    directions(entries_[i].index, i) = entries_[i].is_log ? std::exp(theta[i]) : 1.0;
  }
  return directions;
}

void FreeParameters::ApplyToHandles(const Eigen::VectorXd& theta,
                                    std::vector<SceneHandle>* handles) const {
  for (int i = 0; i < size(); ++i) {
    const FreeEntry& entry = entries_[i];
    if (entry.kind != FreeEntry::Kind::kHandle) continue;
    HandlePath& path = (*handles)[entry.index].path;
    Eigen::Vector3d control = path.controls()[entry.control];
    control[entry.axis] = theta[i];
    path.SetControl(entry.control, control);
  }
}

Eigen::MatrixXd FreeParameters::HandleDirections(const std::vector<SceneHandle>& handles, int h,
                                                 double time) const {
  Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(3, size());
  if (handles[h].path.is_known()) return directions;
  int first = 0;
  std::array<double, 4> weights;
  handles[h].path.Weights(time, &first, &weights);
  for (int i = 0; i < size(); ++i) {
    const FreeEntry& entry = entries_[i];
    if (entry.kind != FreeEntry::Kind::kHandle || entry.index != h) continue;
    const int k = entry.control - first;
    if (k >= 0 && k < 4) directions(entry.axis, i) = weights[k];
  }
  return directions;
}

void FreeParameters::InitialState(const Eigen::VectorXd& theta, Eigen::VectorXd* x,
                                  Eigen::VectorXd* v) const {
  Eigen::MatrixXd dx, dv;
  InitialDirections(&dx, &dv);
  *x = initial_ + dx * theta;
  *v = dv * theta;
}

void FreeParameters::InitialDirections(Eigen::MatrixXd* dx, Eigen::MatrixXd* dv) const {
  dx->setZero(initial_.size(), size());
  dv->setZero(initial_.size(), size());
  for (int i = 0; i < size(); ++i) {
    const FreeEntry& entry = entries_[i];
    Eigen::MatrixXd* part = entry.kind == FreeEntry::Kind::kInitialPosition   ? dx
                            : entry.kind == FreeEntry::Kind::kInitialVelocity ? dv
                                                                              : nullptr;
    if (part == nullptr) continue;
    for (Eigen::Index n = 0; n < modes_.rows(); ++n)
      (*part)(3 * n + entry.axis, i) = modes_(n, entry.index);
  }
}

}  // namespace clothfit
