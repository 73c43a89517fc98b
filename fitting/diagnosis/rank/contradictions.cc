// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/rank/contradictions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/rank/fault_score.h"
#include "fitting/diagnosis/rank/short_list.h"
#include "fitting/optimise/checked_factor.h"
#include "fitting/residuals/observation_residuals.h"

namespace clothfit {
namespace {

constexpr double kAnywhere = 1.0;  // m, one sigma of where a coordinate of a particle may be

// Least squares of a frame's points over all motions of the cloth.
class MotionEquations {
 public:
  explicit MotionEquations(const std::vector<PointResidual>& points) : points_(points) {
    for (const PointResidual& point : points)
      for (const int node : point.point.nodes) place_.emplace(node, 0);
    for (auto& [node, first] : place_) {
      first = size_;
      size_ += 3;
    }
    Eigen::MatrixXd information = kPrecision * Eigen::MatrixXd::Identity(size_, size_);
    for (const PointResidual& point : points) {
      const SurfacePoint& at = point.point;
      const Eigen::Matrix3d squares = point.slope.transpose() * point.slope;
      for (std::size_t a = 0; a < at.nodes.size(); ++a) {
        for (std::size_t b = 0; b < at.nodes.size(); ++b) {
          information.block<3, 3>(place_.at(at.nodes[a]), place_.at(at.nodes[b])) +=
              at.weights[a] * at.weights[b] * squares;
        }
      }
    }
    factor_ = Cholesky(information, "the cloth's motion");
  }

  // Products of the particles' columns with others (rows x columns).
  Eigen::MatrixXd Cross(const Eigen::MatrixXd& columns) const {
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(size_, columns.cols());
    for (std::size_t r = 0; r < points_.size(); ++r) {
      const SurfacePoint& at = points_[r].point;
      for (std::size_t a = 0; a < at.nodes.size(); ++a) {
        cross.middleRows<3>(place_.at(at.nodes[a])) += at.weights[a] *
                                                       points_[r].slope.transpose() *
                                                       columns.row(static_cast<Eigen::Index>(r));
      }
    }
    return cross;
  }

  // Moves particles (3N, m) to where the points are seen.
  void Move(Eigen::VectorXd* x) const {
    Eigen::VectorXd residuals(points_.size());
    for (std::size_t r = 0; r < points_.size(); ++r)
      residuals[static_cast<Eigen::Index>(r)] = points_[r].value;
    const Eigen::VectorXd by = factor_.solve(Cross(residuals));
    for (const auto& [node, first] : place_) x->segment<3>(3 * node) -= by.segment<3>(first);
  }

  MotionlessProducts Of(const Eigen::MatrixXd& columns) const {
    const Eigen::MatrixXd half = factor_.matrixL().solve(Cross(columns));
    const Eigen::MatrixXd inverse =
        factor_.matrixL().solve(Eigen::MatrixXd::Identity(size_, size_));
    const double followed = static_cast<double>(size_) - kPrecision * inverse.squaredNorm();
    return {columns.transpose() * columns - half.transpose() * half,
            static_cast<double>(points_.size()) - followed};
  }

 private:
  static constexpr double kPrecision = 1.0 / (kAnywhere * kAnywhere);

  const std::vector<PointResidual>& points_;
  std::map<int, Eigen::Index> place_;  // of a particle's coordinates among those that are seen
  Eigen::Index size_ = 0;
  Eigen::LLT<Eigen::MatrixXd> factor_;
};

// Of markers and tracks alone, with the rows that they have among all; none where a point is behind
// its camera.
struct SeenPoints {
  std::vector<PointResidual> points;
  std::vector<Eigen::Index> rows;
};
SeenPoints PointsOf(const Scene& scene, const ObservationResiduals& observations, int frame,
                    const State& state) {
  std::vector<PointResidual> all;
  SeenPoints seen;
  if (!observations.EvaluateAtPoints(frame, state, &all)) return seen;
  const std::vector<ResidualSource> sources = SourcesOfFrame(scene, frame);
  for (std::size_t r = 0; r < sources.size(); ++r) {
    using Kind = ResidualSource::Kind;
    if (sources[r].kind != Kind::kMarker && sources[r].kind != Kind::kTrack) continue;
    seen.points.push_back(all[r]);
    seen.rows.push_back(static_cast<Eigen::Index>(r));
  }
  return seen;
}

// Of one frame, where its points are seen: a fit may be far from there, where a robust loss bends
// residuals that are linear in the cloth's motion. plain: the observations without such a loss.
MotionlessProducts ProductsOfFrame(const Scene& scene, const FitConfig& config,
                                   const ObservationResiduals& plain,
                                   const ObservationResiduals& observations,
                                   const std::vector<Fault>& faults, int frame, State state) {
  constexpr int kSteps = 2;  // of Gauss and Newton
  for (int k = 0; k < kSteps; ++k) {
    const SeenPoints seen = PointsOf(scene, plain, frame, state);
    if (!seen.points.empty()) MotionEquations(seen.points).Move(&state.x);
  }
  const auto count = static_cast<Eigen::Index>(1 + faults.size());
  const SeenPoints seen = PointsOf(scene, observations, frame, state);
  if (seen.points.empty()) return {Eigen::MatrixXd::Zero(count, count), 0.0};
  const RowMajorMatrix by_faults = FaultColumns(scene, config, observations, faults, frame, state);
  Eigen::MatrixXd columns(seen.points.size(), count);
  for (std::size_t r = 0; r < seen.points.size(); ++r) {
    columns.row(static_cast<Eigen::Index>(r)) << seen.points[r].value, by_faults.row(seen.rows[r]);
  }
  return WithoutMotion(seen.points, columns);
}

// Of the frames that are looked at, each with its state.
MotionlessProducts ProductsOfAll(const Scene& scene, const FitConfig& config,
                                 const std::map<int, State>& states,
                                 const std::vector<Fault>& faults) {
  FitConfig linear = config;
  linear.loss = LossKind::kNone;
  const ObservationResiduals plain(scene, linear), observations(scene, config);
  std::vector<const std::pair<const int, State>*> frames;
  for (const auto& frame : states) frames.push_back(&frame);
  std::vector<MotionlessProducts> of_frames(frames.size());
  ParallelFor(static_cast<int>(frames.size()), NumThreads(0), [&](int i, int) {
    const auto& [frame, state] = *frames[static_cast<std::size_t>(i)];
    of_frames[static_cast<std::size_t>(i)] =
        ProductsOfFrame(scene, config, plain, observations, faults, frame, state);
  });
  const auto count = static_cast<Eigen::Index>(1 + faults.size());
  MotionlessProducts sum{Eigen::MatrixXd::Zero(count, count), 0.0};
  for (const MotionlessProducts& products : of_frames) {
    sum.gram += products.gram;
    sum.freedom += products.freedom;
  }
  return sum;
}

// Is it of a source as a whole? Where a single marker sits, and how fat a mask is, others do not
// tell.
bool IsOfWholeSource(const Fault& fault) {
  return fault.kind != Fault::Kind::kMaskBias && fault.kind != Fault::Kind::kMarkerOffset;
}

}  // namespace

MotionlessProducts WithoutMotion(const std::vector<PointResidual>& points,
                                 const Eigen::MatrixXd& columns) {
  return MotionEquations(points).Of(columns);
}

bool CanContradict(const Scene& scene) {
  std::set<int> cameras;
  for (const TrackObservation& track : scene.tracks)
    if (scene.IsFitted(track)) cameras.insert(track.camera);
  return cameras.size() + (scene.markers.empty() ? 0U : 1U) >= 2U;
}

Ranking RankContradictions(const FittedScene& fitted, const DiagnosisOptions& options) {
  const Scene& scene = fitted.scene;
  const ObservationResiduals observations(scene, fitted.config);
  const RowFrames frames(scene, observations, kMostRows);
  Ranking ranking;
  ranking.faults = ListFaults(scene, fitted.config);
  std::map<int, State> states;
  const std::optional<Rows> rows =
      EvaluateRows(fitted, {fitted.values}, frames, {}, [&](int frame, const State& state) {
        if (frames.FirstRow(frame) >= 0) states.emplace(frame, state);
      });
  if (!rows) throw std::runtime_error("the fitted baseline cannot be simulated");
  const MotionlessProducts products = ProductsOfAll(scene, fitted.config, states, ranking.faults);
  ranking.num_rows = static_cast<int>(std::lround(products.freedom));
  ranking.residual_rms =
      std::sqrt(std::max(0.0, products.gram(0, 0)) / std::max(1.0, products.freedom));
  Eigen::VectorXd scale = products.gram.diagonal().cwiseMax(0.0).cwiseSqrt();
  for (double& s : scale) s = s > 0.0 ? 1.0 / s : 1.0;
  const Eigen::MatrixXd gram = scale.asDiagonal() * products.gram * scale.asDiagonal();
  std::vector<DrawnColumn> well_made;
  for (std::size_t i = 0; i < ranking.faults.size(); ++i) {
    const int column = 1 + static_cast<int>(i);
    well_made.push_back({column, ranking.faults[i].typical / scale[column]});
  }
  const std::vector<NullResidual> nulls =
      DrawNulls(gram, ranking.num_rows, {}, well_made, options.num_nulls, options.seed);
  const auto beside = [&](const std::string& group) {
    return OtherFaults(ranking.faults, group, 1, scale, true);
  };
  ranking.null_mean = Mean(LeftByNulls(Projection(gram, beside("")), nulls));
  std::set<std::string> groups;
  for (const Fault& fault : ranking.faults)
    if (IsOfWholeSource(fault)) groups.insert(fault.group);
  const FaultProducts of_faults = {ranking.faults, gram, scale, 0, 1, nulls, ranking.null_mean};
  for (const std::string& group : groups) {
    ranking.candidates.push_back(ScoreFaults(of_faults, group, beside(group)));
    ranking.candidates.back().sigma *= std::max(1.0, ranking.residual_rms);
  }
  std::stable_sort(ranking.candidates.begin(), ranking.candidates.end(),
                   [](const auto& a, const auto& b) { return a.summary.score > b.summary.score; });
  for (RankedCandidate& candidate : ranking.candidates)
    candidate.summary.share =
        ShareOf(candidate.summary.score, ranking.candidates.front().summary.score);
  ShortList(true, options, &ranking);
  return ranking;
}

void TakeOutWhatAgrees(const Ranking& contradictions, Ranking* ranking) {
  for (const RankedCandidate& agreed : contradictions.candidates) {
    const double limit = agreed.summary.detection_limit;
    const Fault& fault = contradictions.faults[static_cast<std::size_t>(agreed.faults.front())];
    if (agreed.summary.is_short_listed || limit <= 0.0 || limit > fault.tolerated) continue;
    for (RankedCandidate& candidate : ranking->candidates) {
      Candidate& summary = candidate.summary;
      if (summary.name != agreed.summary.name || !summary.is_short_listed) continue;
      summary.is_short_listed = false;
      summary.why_not = "all sources agree without it";
    }
  }
}

}  // namespace clothfit
