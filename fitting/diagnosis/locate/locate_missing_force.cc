// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/locate_missing_force.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "autodiff_sim/base/normal_numbers.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/scene/grid_side.h"

namespace clothfit {
namespace {

constexpr int kLongestSide = 11;      // particles: a force that is even over patches needs no more
constexpr int kMostKnots = 24;        // in time
constexpr double kKnotSpacing = 0.1;  // s, at least
constexpr int kLinearisations = 2;    // at most
constexpr int kNulls = 99;            // so that a p-value of 0.01 can be seen
constexpr int kErrorDraws = 2;        // of parameters, at which the numerical error is measured

FittedScene Coarse(const FittedScene& fitted) {
  const std::array<int, 2>& grid = fitted.scene.mesh.grid;
  if (!fitted.scene.mesh.is_grid() || LongerSide(grid) <= kLongestSide) return fitted;
  return WithOtherSteps(fitted, GridWithSide(grid, kLongestSide), fitted.config.max_step);
}

// Markers (-1) and cameras with rows.
int CountSources(const Scene& scene, const std::vector<int>& frames) {
  std::set<int> sources;
  for (const int frame : frames) {
    for (const ResidualSource& s : SourcesOfFrame(scene, frame))
      sources.insert(s.kind == ResidualSource::Kind::kMarker ? -1 : s.source);
  }
  return static_cast<int>(sources.size());
}

// All that an estimate of the missing force of a fit is made of.
class MissingForceLocator {
 public:
  MissingForceLocator(const FittedScene& fitted, const DiagnosisOptions& options,
                      const DiscretisationErrors* known, LocatedForce* result)
      : options_(options),
        known_(known),
        result_(*result),
        fitted_(result->fitted),
        observations_(fitted.scene, fitted.config),
        frames_(fitted.scene, observations_, kMostRows),
        faults_(ListFaults(fitted.scene, fitted.config)) {}

  bool Run() {
    if (frames_.frames().empty() || frames_.frames().back() < 1) return false;
    if (!MeasureErrors() || !Estimate()) return false;
    result_.location = Locate(fitted_.scene, result_.missing);
    result_.sources =
        WhoseDiscrepancy(fitted_.scene.recording, result_.missing, result_.location.patch);
    if (const SourceShift* blamed = result_.Blamed()) {
      result_.location.discrepancy.words += fmt::format(
          " Without {} only {:.0f} % of it is left: that is what is off, rather than the physics.",
          blamed->name, 100.0 * std::max(0.0, blamed->kept));
    }
    return true;
  }

 private:
  bool MeasureErrors() {
    const std::optional<Rows> baseline =
        EvaluateRows(fitted_, BaselinePass(fitted_), frames_, faults_);
    if (!baseline) return false;
    if (known_ != nullptr && known_->num_rows == frames_.num_rows()) {
      errors_ = *known_;
    } else {
      errors_ = MeasureDiscretisationErrors(fitted_, frames_, *baseline,
                                            options_.simulate_null ? kErrorDraws : 0, options_.seed,
                                            options_.stop);
    }
    typical_.resize(static_cast<Eigen::Index>(faults_.size()));
    for (std::size_t i = 0; i < faults_.size(); ++i)
      typical_[static_cast<Eigen::Index>(i)] = options_.simulate_null ? faults_[i].typical : 0.0;
    nulls_ = DrawNullResiduals(errors_.at_draws, baseline->faults, typical_, frames_.num_rows(),
                               kNulls, options_.seed);
    return true;
  }

  // The faults' columns, then the discretisation errors.
  RowMajorMatrix NuisanceColumns(int frame, const State& state) const {
    const RowMajorMatrix of_faults =
        FaultColumns(fitted_.scene, fitted_.config, observations_, faults_, frame, state);
    const int row = frames_.FirstRow(frame);
    RowMajorMatrix columns(of_faults.rows(), of_faults.cols() + NumErrors());
    columns.leftCols(of_faults.cols()) = of_faults;
    for (Eigen::Index k = 0; k < NumErrors(); ++k) {
      columns.col(of_faults.cols() + k) =
          errors_.at_draws[static_cast<std::size_t>(k)].segment(row, of_faults.rows());
    }
    return columns;
  }

  Eigen::Index NumErrors() const { return static_cast<Eigen::Index>(errors_.at_draws.size()); }

  bool Estimate() {
    ResidualForceOptions force;
    force.frames = frames_.frames();
    force.iterations = kLinearisations;
    force.by_source = CountSources(fitted_.scene, force.frames) > 1;
    force.knot_spacing =
        std::max(kKnotSpacing, fitted_.scene.FrameTime(force.frames.back()) / (kMostKnots - 1));
    force.correlation_time = std::max(force.correlation_time, 1.5 * force.knot_spacing);
    force.nulls = nulls_;
    force.stop = options_.stop;
    if (options_.project) {
      force.faults = [this](int frame, const State& state) {
        return NuisanceColumns(frame, state);
      };
      force.fault_sigmas.setConstant(static_cast<Eigen::Index>(faults_.size()) + NumErrors(),
                                     kDiscretisationSigma);
      for (std::size_t i = 0; i < faults_.size(); ++i)
        force.fault_sigmas[static_cast<Eigen::Index>(i)] = faults_[i].tolerated;
    }
    const FreeParameters free(fitted_.config, fitted_.scene, MakeParameterTable());
    std::optional<MissingForce> missing =
        EstimateMissingForce(fitted_.scene, fitted_.config, free, fitted_.fit.theta, force);
    if (missing) result_.missing = std::move(*missing);
    return missing.has_value();
  }

  const DiagnosisOptions& options_;
  const DiscretisationErrors* known_;
  LocatedForce& result_;
  const FittedScene& fitted_;
  ObservationResiduals observations_;
  RowFrames frames_;
  std::vector<Fault> faults_;
  DiscretisationErrors errors_;
  Eigen::VectorXd typical_;
  Eigen::MatrixXd nulls_;
};

}  // namespace

const SourceShift* LocatedForce::Blamed() const {
  const auto found = std::find_if(sources.begin(), sources.end(),
                                  [](const SourceShift& s) { return s.is_to_blame; });
  return found == sources.end() ? nullptr : &*found;
}

Eigen::MatrixXd DrawNullResiduals(const std::vector<Eigen::VectorXd>& numerical,
                                  const Eigen::MatrixXd& fault_columns,
                                  const Eigen::VectorXd& typical_faults, Eigen::Index num_rows,
                                  int count, std::uint64_t seed) {
  constexpr std::uint64_t kStream = 104;
  NormalNumbers normal(seed, kStream);
  Eigen::MatrixXd nulls(num_rows, count);
  for (auto null : nulls.colwise()) {
    for (double& value : null) value = normal.Next();
    if (!numerical.empty()) {
      const double amount = 1.0 + 0.3 * normal.Next();
      null += amount * numerical[normal.Index(numerical.size())];
    }
    Eigen::VectorXd amounts = typical_faults;
    for (double& amount : amounts) amount *= normal.Next();
    null += fault_columns * amounts;
  }
  return nulls;
}

std::optional<LocatedForce> LocateMissingForce(const FittedScene& fitted,
                                               const DiagnosisOptions& options,
                                               const DiscretisationErrors* errors) {
  LocatedForce result;
  result.fitted = Coarse(fitted);
  const bool is_same = result.fitted.scene.mesh.grid == fitted.scene.mesh.grid;
  if (!MissingForceLocator(result.fitted, options, is_same ? errors : nullptr, &result).Run())
    return {};
  return result;
}

}  // namespace clothfit
