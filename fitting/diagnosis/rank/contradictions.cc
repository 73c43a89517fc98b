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

// Of the frames that are looked at, each with its state.
MotionlessProducts ProductsOfAll(const Scene& scene, const FitConfig& config,
                                 const std::map<int, State>& states,
                                 const std::vector<Fault>& faults) {
  const ObservationResiduals observations(scene, config);
  const auto count = static_cast<Eigen::Index>(1 + faults.size());
  std::vector<const std::pair<const int, State>*> frames;
  for (const auto& frame : states) frames.push_back(&frame);
  std::vector<MotionlessProducts> of_frames(frames.size());
  ParallelFor(static_cast<int>(frames.size()), NumThreads(0), [&](int i, int) {
    const auto& [frame, state] = *frames[static_cast<std::size_t>(i)];
    MotionlessProducts& products = of_frames[static_cast<std::size_t>(i)];
    products.gram.setZero(count, count);
    std::vector<PointResidual> all, points;
    if (!observations.EvaluateAtPoints(frame, state, &all)) return;
    const RowMajorMatrix by_faults =
        FaultColumns(scene, config, observations, faults, frame, state);
    const std::vector<ResidualSource> sources = SourcesOfFrame(scene, frame);
    Eigen::MatrixXd columns(by_faults.rows(), count);
    for (std::size_t r = 0; r < sources.size(); ++r) {
      using Kind = ResidualSource::Kind;
      if (sources[r].kind != Kind::kMarker && sources[r].kind != Kind::kTrack) continue;
      columns.row(static_cast<Eigen::Index>(points.size())) << all[r].value,
          by_faults.row(static_cast<Eigen::Index>(r));
      points.push_back(all[r]);
    }
    if (points.empty()) return;
    products = WithoutMotion(points, columns.topRows(static_cast<Eigen::Index>(points.size())));
  });
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
  std::map<int, Eigen::Index> place;  // of a particle's coordinates among those that are seen
  for (const PointResidual& point : points)
    for (const int node : point.point.nodes) place.emplace(node, 0);
  Eigen::Index size = 0;
  for (auto& [node, first] : place) {
    first = size;
    size += 3;
  }
  const double precision = 1.0 / (kAnywhere * kAnywhere);
  Eigen::MatrixXd information = precision * Eigen::MatrixXd::Identity(size, size);
  Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(size, columns.cols());
  for (std::size_t r = 0; r < points.size(); ++r) {
    const SurfacePoint& at = points[r].point;
    const Eigen::Vector3d slope = points[r].slope.transpose();
    const Eigen::Matrix3d squares = slope * slope.transpose();
    for (std::size_t a = 0; a < at.nodes.size(); ++a) {
      const Eigen::Index row = place.at(at.nodes[a]);
      cross.middleRows<3>(row) += at.weights[a] * slope * columns.row(static_cast<Eigen::Index>(r));
      for (std::size_t b = 0; b < at.nodes.size(); ++b) {
        information.block<3, 3>(row, place.at(at.nodes[b])) +=
            at.weights[a] * at.weights[b] * squares;
      }
    }
  }
  const auto factor = Cholesky(information, "the cloth's motion");
  const Eigen::MatrixXd half = factor.matrixL().solve(cross);
  const Eigen::MatrixXd inverse = factor.matrixL().solve(Eigen::MatrixXd::Identity(size, size));
  const double followed = static_cast<double>(size) - precision * inverse.squaredNorm();
  return {columns.transpose() * columns - half.transpose() * half,
          static_cast<double>(points.size()) - followed};
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
  MotionlessProducts products = ProductsOfAll(scene, fitted.config, states, ranking.faults);
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
