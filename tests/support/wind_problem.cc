// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/wind_problem.h"

#include <chrono>
#include <cmath>
#include <stdexcept>

#include <Eigen/Cholesky>
#include <ceres/ceres.h>
#include <fmt/format.h>

#include "autodiff_sim/step/known_motion.h"
#include "autodiff_sim/term/force_batch_impl.h"
#include "autodiff_sim/terms/terms.h"
#include "fitting/fit/uncertainty.h"
#include "fitting/optimise/simulation_cost.h"
#include "fitting/rollout/window_cost.h"
#include "tests/support/scenes.h"

namespace clothfit {

// f = A w (1 + sin(2 pi f t + phase)) / 2 along one direction, a third to each corner.
struct Wind : TermDefaults {
  static constexpr const char* kName = "wind";
  static constexpr const char* kDoc = "a push that comes and goes";
  static constexpr const char* kReference = "";
  static constexpr int kNodes = 3;
  static constexpr bool kInternal = false;
  static constexpr std::array<Parameter, 5> kParameters = {{
      {"strength", "N/m^2", "largest push", 1.0, 0.0, 1e-3, 1e3, Scale::kLog, M_E},
      {"azimuth", "rad", "direction about the vertical, from y to x", 0.0, 0.0, -M_PI, M_PI,
       Scale::kLinear, 1.0},
      {"elevation", "rad", "direction above the horizon", 0.0, 0.0, -M_PI_2, M_PI_2, Scale::kLinear,
       1.0},
      {"frequency", "Hz", "", 1.0, 0.0, 1e-2, 1e2, Scale::kLog, M_E},
      {"phase", "rad", "", 0.0, 0.0, -M_PI, M_PI, Scale::kLinear, 1.0},
  }};

  using Element = RestTriangle;
  static std::vector<Element> Elements(const TermContext& context) {
    return RestTriangles(context.mesh);
  }

  template <class T>
  static void AddForce(const Element& element, const ElementInput<Wind, T>& in,
                       ElementOutput<Wind, T>* out) {
    using std::cos;
    using std::sin;
    const T& azimuth = in.parameter[1];
    const T& elevation = in.parameter[2];
    const T swell = T(0.5) + sin(in.parameter[3] * (2.0 * M_PI * in.time) + in.parameter[4]) * 0.5;
    const T push = in.parameter[0] * swell * (element.area / 3.0);
    const Vector3<T> force(push * cos(elevation) * sin(azimuth),
                           push * cos(elevation) * cos(azimuth), push * sin(elevation));
    for (Vector3<T>& corner : out->force) corner += force;
  }
};

namespace {

using WindTerms = TypeList<Gravity, StretchSpring, Shear, Bending, Wind>;

constexpr double kSigma = 1e-3;  // m, of a position; the motion is free of noise

// One unknown number: the parameters that it scales, or the one that it is.
struct Unknown {
  std::vector<std::string> parameters;
  double start;  // over the truth where it is a scale, else off by this much
  bool is_log;
};

const std::vector<Unknown>& Unknowns() {
  static const std::vector<Unknown> unknowns = {
      {{"stretch.stiffness", "stretch.damping", "shear.stiffness", "shear.damping"}, 1.3, true},
      {{"bending.stiffness", "bending.damping"}, 0.75, true},
      {{"cloth.areal_density"}, 0.85, true},
      {{"wind.strength"}, 1.2, true},
      {{"wind.azimuth"}, 0.2, false},
      {{"wind.elevation"}, -0.15, false},
      {{"wind.frequency"}, 1.15, true},
      {{"wind.phase"}, 0.3, false}};
  return unknowns;
}

struct NamedValue {
  const char* name;
  double value;
};
constexpr NamedValue kTruth[] = {
    {"cloth.areal_density", 0.2}, {"gravity.scale", 1.0},    {"stretch.stiffness", 300.0},
    {"stretch.damping", 0.5},     {"shear.stiffness", 20.0}, {"shear.damping", 0.2},
    {"bending.stiffness", 5e-5},  {"bending.damping", 2e-5}, {"wind.strength", 1.5},
    {"wind.azimuth", 0.4},        {"wind.elevation", 0.3},   {"wind.frequency", 1.4},
    {"wind.phase", -0.8},
};

Simulation MakeSimulation(const WindProblem& problem) {
  const ClothMesh mesh = MakeGrid({1.0, 1.0}, {problem.particles, problem.particles});
  const std::vector<Eigen::Vector2d> corners = {{0.0, 0.0}, {1.0, 0.0}};
  return Simulation::WithTerms(WindTerms{}, mesh, World(), LocateOnCloth(mesh, corners));
}

class WindMotion {
 public:
  explicit WindMotion(const WindProblem& problem)
      : problem_(problem), simulation_(MakeSimulation(problem)), truth_(simulation_.parameters()) {
    const ClothMesh& mesh = simulation_.model().mesh();
    x_ =
        LayFlat(mesh, Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ());
    const std::vector<Eigen::Vector2d> corners = {{0.0, 0.0}, {1.0, 0.0}};
    for (const SurfacePoint& corner : LocateOnCloth(mesh, corners))
      held_.handles.push_back({corner, corner.At(x_)});
    for (const NamedValue& value : kTruth) truth_[Index(value.name)] = value.value;
  }

  int num_residuals() const { return problem_.steps * static_cast<int>(x_.size()); }
  const Eigen::VectorXd& truth() const { return truth_; }
  int Index(const std::string& name) const {
    return RequireParameter(simulation_.model().parameters(), name);
  }

  // All parameters at theta: logarithms of scales, and differences, from the truth.
  Eigen::VectorXd Parameters(const double* theta) const {
    Eigen::VectorXd parameters = truth_;
    for (std::size_t i = 0; i < Unknowns().size(); ++i) {
      for (const std::string& name : Unknowns()[i].parameters) {
        double& value = parameters[Index(name)];
        value = Unknowns()[i].is_log ? value * std::exp(theta[i]) : value + theta[i];
      }
    }
    return parameters;
  }

  // Positions after every step, m, and their derivatives with respect to theta. False where a step
  // does not converge.
  bool Simulate(const double* theta, Eigen::VectorXd* positions, RowMajorMatrix* jacobian) {
    const Eigen::VectorXd parameters = Parameters(theta);
    const auto count = static_cast<Eigen::Index>(Unknowns().size());
    Eigen::MatrixXd directions = Eigen::MatrixXd::Zero(parameters.size(), count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Unknown& unknown = Unknowns()[static_cast<std::size_t>(i)];
      for (const std::string& name : unknown.parameters) {
        const int index = Index(name);
        directions(index, i) = unknown.is_log ? parameters[index] : 1.0;
      }
    }
    simulation_.SetParameters(parameters);
    simulation_.Reset();
    State state = simulation_.MakeState(x_);
    Sensitivity sensitivity(state, directions);
    const Drive drive = [this](double, bool) { return held_; };
    positions->resize(num_residuals());
    if (jacobian != nullptr) jacobian->resize(num_residuals(), count);
    const bool is_known = jacobian != nullptr && motion_.IsOf(parameters);
    if (!is_known) motion_.Begin(parameters);
    for (int s = 0; s < problem_.steps; ++s) {
      const StepReport report = simulation_.Advance(
          problem_.step, drive, &state, jacobian != nullptr ? &sensitivity : nullptr,
          is_known ? motion_.After(static_cast<std::size_t>(s)) : nullptr);
      if (report.status != StepStatus::kConverged) return false;
      if (!is_known) motion_.Add(report, state);
      positions->segment(s * x_.size(), x_.size()) = state.x;
      if (jacobian != nullptr) jacobian->middleRows(s * x_.size(), x_.size()) = sensitivity.x();
    }
    return true;
  }

 private:
  WindProblem problem_;
  Simulation simulation_;
  Eigen::VectorXd x_, truth_;
  StepInputs held_;
  KnownMotion motion_;  // simulated last
};

// What the motion leaves open, from the Jacobian at the result; the priors have unit variance.
std::vector<std::string> Statements(WindMotion* motion, const Eigen::VectorXd& theta) {
  Eigen::VectorXd positions;
  RowMajorMatrix jacobian;
  if (!motion->Simulate(theta.data(), &positions, &jacobian)) return {"the result diverges"};
  jacobian /= kSigma;
  const Eigen::MatrixXd information =
      jacobian.transpose() * jacobian + Eigen::MatrixXd::Identity(theta.size(), theta.size());
  std::vector<FreeEntry> entries;
  for (const Unknown& unknown : Unknowns()) {
    FreeEntry entry;
    entry.name = unknown.parameters.front();
    entry.is_log = unknown.is_log;
    entry.prior_sigma = 1.0;
    entries.push_back(entry);
  }
  return DescribeUndetermined(
      entries, information.llt().solve(Eigen::MatrixXd::Identity(theta.size(), theta.size())));
}

}  // namespace

const WindUnknown& WindRecovery::Find(const std::string& name) const {
  for (const WindUnknown& unknown : unknowns) {
    if (unknown.name == name) return unknown;
  }
  throw std::logic_error("no unknown " + name);
}

WindRecovery RecoverWind(const WindProblem& problem) {
  WindRecovery result;
  WindMotion motion(problem);
  const auto count = static_cast<Eigen::Index>(Unknowns().size());
  Eigen::VectorXd measured, positions, theta(count);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(count);
  if (!motion.Simulate(none.data(), &measured, nullptr)) throw std::runtime_error("diverged");
  for (Eigen::Index i = 0; i < count; ++i) {
    const Unknown& unknown = Unknowns()[static_cast<std::size_t>(i)];
    theta[i] = unknown.is_log ? std::log(unknown.start) : unknown.start;
  }
  const Eigen::VectorXd start = theta;
  const auto rms = [&](const Eigen::VectorXd& at) {
    if (!motion.Simulate(at.data(), &positions, nullptr)) throw std::runtime_error("diverged");
    return std::sqrt(3.0 * (positions - measured).squaredNorm() /
                     static_cast<double>(positions.size()));
  };
  result.rms_before = rms(start);

  const auto begin = std::chrono::steady_clock::now();
  ceres::Problem ceres_problem;
  const auto evaluate = [&](const Eigen::VectorXd& at, Eigen::VectorXd* residuals,
                            RowMajorMatrix* jacobian) {
    ++(jacobian != nullptr ? result.differentiated : result.simulations);
    if (!motion.Simulate(at.data(), residuals, jacobian)) return false;
    *residuals = (*residuals - measured) / kSigma;
    if (jacobian != nullptr) *jacobian /= kSigma;
    return true;
  };
  ceres_problem.AddResidualBlock(
      new SimulationCost(motion.num_residuals(), static_cast<int>(count), evaluate), nullptr,
      theta.data());
  ceres_problem.AddResidualBlock(new LinearCost(Eigen::MatrixXd::Identity(count, count), start),
                                 nullptr, theta.data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.initial_trust_region_radius = 1e4;
  options.function_tolerance = 1e-4;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &ceres_problem, &summary);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  result.iterations = static_cast<int>(summary.iterations.size()) - 1;
  result.rms_after = rms(theta);
  const Eigen::VectorXd first = motion.Parameters(start.data());
  const Eigen::VectorXd last = motion.Parameters(theta.data());
  for (const Unknown& unknown : Unknowns()) {
    const std::string& name = unknown.parameters.front();
    const int index = motion.Index(name);
    result.unknowns.push_back({name, motion.truth()[index], first[index], last[index]});
  }
  result.statements = Statements(&motion, theta);
  return result;
}

std::string WindAsMarkdown(const WindProblem& problem, const WindRecovery& recovery) {
  std::string text = fmt::format(
      "{0} x {0} particles, {1} steps of 1/{2:.0f} s\n\n"
      "| unknown | truth | start | found | found / truth |\n|---|---:|---:|---:|---:|\n",
      problem.particles, problem.steps, 1.0 / problem.step);
  for (const WindUnknown& unknown : recovery.unknowns) {
    text += fmt::format("| {} | {:.4g} | {:.4g} | {:.4g} | {:.4f} |\n", unknown.name, unknown.truth,
                        unknown.start, unknown.found, unknown.found / unknown.truth);
  }
  text += fmt::format(
      "\n{} after {} iterations: {} simulations without and {} with derivatives, {:.1f} s; "
      "positions "
      "{:.3g} mm off at the start (rms), {:.2g} mm at the end.\n\n",
      recovery.converged ? "Converged" : "Not converged", recovery.iterations, recovery.simulations,
      recovery.differentiated, recovery.seconds, 1e3 * recovery.rms_before,
      1e3 * recovery.rms_after);
  for (const std::string& statement : recovery.statements) text += "- " + statement + "\n";
  return text;
}

}  // namespace clothfit
