// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What cameras and markers say against each other.
#include "fitting/diagnosis/rank/contradictions.h"

#include <algorithm>
#include <random>
#include <string_view>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

constexpr double kSideWind = 3.0;  // m/s

// Pulled sideways by a wind, seen by three cameras and by markers.
Recording SeenInWind(double wind = kSideWind, int frames = 24) {
  SyntheticOptions options;
  options.resolution = {6, 6};
  options.frame_count = frames;
  options.num_cameras = 3;
  options.parameters = {{"wind.x", wind}};
  return MakeSyntheticRecording(options).recording;
}

// What a cloth that knows of no wind makes of it, as it is.
FittedScene InWind(const Recording& recording, double wind) {
  FitConfig config = DefaultConfig(recording);
  config.parameters.at("wind.x").value = wind;
  config.loss = LossKind::kHuber;
  for (auto& [name, setting] : config.parameters) setting.free = false;
  std::optional<FittedScene> fitted = FitAfresh({recording, config}, Start::kPlain, 0, FitRunner());
  EXPECT_TRUE(fitted);
  return std::move(*fitted);
}

FittedScene WithoutWind(const Recording& recording) { return InWind(recording, 0.0); }

const RankedCandidate& Named(const Ranking& ranking, std::string_view name) {
  const auto found = std::find_if(ranking.candidates.begin(), ranking.candidates.end(),
                                  [&](const auto& c) { return c.summary.name == name; });
  EXPECT_NE(found, ranking.candidates.end()) << name;
  return *found;
}

// The cloth is elsewhere, so far that a robust loss takes all for outliers, but no camera is wrong.
TEST(Contradictions, AreNoneWhereOnlyPhysicsIsMissing) {
  const FittedScene fitted = WithoutWind(SeenInWind(10.0, 40));
  const int observed = ObservationResiduals(fitted.scene, fitted.config)
                           .NumObserved(0, fitted.scene.last_fitted_frame);
  // Beyond what a track of two coordinates counts that is off by loss_scale, the least outlier.
  const double scale = fitted.config.loss_scale;
  ASSERT_GT(2.0 * fitted.fit.cost_after / observed, scale * scale / 2.0);
  const Ranking ranking = RankContradictions(fitted, {});
  EXPECT_NEAR(ranking.residual_rms, 1.0, 0.05);
  EXPECT_FALSE(ranking.candidates.empty());
  for (const RankedCandidate& candidate : ranking.candidates)
    EXPECT_FALSE(candidate.summary.is_short_listed) << candidate.summary.name;
}

TEST(Contradictions, TellWhichCameraIsWrongWhateverPhysicsIsMissing) {
  Recording recording = SeenInWind();
  recording.markers.clear();
  recording.cameras[1].fx *= 1.01;
  recording.cameras[1].fy *= 1.01;
  const std::string guilty = "camera " + recording.cameras[1].name;
  const Ranking ranking = RankContradictions(WithoutWind(recording), {});
  const RankedCandidate& scale = Named(ranking, guilty + ": scale");
  EXPECT_TRUE(scale.summary.is_short_listed) << scale.summary.why_not;
  EXPECT_LT(scale.summary.p_value, 1e-6);
  EXPECT_NEAR(scale.amounts[0], -0.01, 3.0 * scale.sigma[0]);  // it is shorter than told
  EXPECT_EQ(ranking.candidates.front().summary.name.rfind(guilty, 0), 0U);
  for (const int other : {0, 2}) {
    const std::string innocent = "camera " + recording.cameras[other].name + ": scale";
    EXPECT_LT(Named(ranking, innocent).summary.score, 0.5 * scale.summary.score);
  }
}

// Their scores are the same wherever the fit has the cloth.
TEST(Contradictions, DoNotDependOnTheFit) {
  Recording recording = SeenInWind();
  recording.cameras[1].fx *= 1.01;
  recording.cameras[1].fy *= 1.01;
  const Ranking far = RankContradictions(WithoutWind(recording), {});
  const Ranking near = RankContradictions(InWind(recording, kSideWind), {});
  EXPECT_NEAR(far.residual_rms, near.residual_rms, 0.01 * near.residual_rms);
  for (const RankedCandidate& one : near.candidates) {
    const double score = one.summary.score;
    EXPECT_NEAR(Named(far, one.summary.name).summary.score, score, 0.05 * score + 1.0)
        << one.summary.name;
  }
}

TEST(Contradictions, TellOfMarkersBesideWhereCamerasSeeThem) {
  Recording recording = SeenInWind();
  for (Marker& marker : recording.markers) marker.position.y() += 0.005;
  const Ranking ranking = RankContradictions(WithoutWind(recording), {});
  const RankedCandidate& place = ranking.candidates.front();
  EXPECT_EQ(place.summary.name, "markers: place");
  EXPECT_TRUE(place.summary.is_short_listed) << place.summary.why_not;
  EXPECT_NEAR(place.amounts[1], 0.005, 5e-4);
}

// What mesh and physics make of a camera is no fault where others see the cloth as it does.
TEST(Contradictions, TakeOutFaultsThatWouldShow) {
  const Ranking contradictions = RankContradictions(WithoutWind(SeenInWind()), {});
  const std::string clock = "camera " + SeenInWind().cameras[0].name + ": clock";
  const double limit = Named(contradictions, clock).summary.detection_limit;
  EXPECT_GT(limit, 0.0);
  EXPECT_LT(limit, 5e-3);  // s, as is tolerated
  Ranking ranking;
  for (const std::string& name : {clock, std::string("marker offsets"), std::string("wind")}) {
    ranking.candidates.emplace_back();
    ranking.candidates.back().summary.name = name;
    ranking.candidates.back().summary.is_short_listed = true;
  }
  TakeOutWhatAgrees(contradictions, &ranking);
  EXPECT_FALSE(ranking.candidates[0].summary.is_short_listed);
  EXPECT_NE(ranking.candidates[0].summary.why_not, "");
  EXPECT_TRUE(ranking.candidates[1].summary.is_short_listed);
  EXPECT_TRUE(ranking.candidates[2].summary.is_short_listed);
}

// A mask's fatness and where a single marker sits are no one else's business.
TEST(Contradictions, AreOfWholeSources) {
  for (const RankedCandidate& candidate :
       RankContradictions(WithoutWind(SeenInWind()), {}).candidates)
    EXPECT_NE(candidate.summary.name, "marker offsets");
}

TEST(Contradictions, NeedTwoSources) {
  const auto can = [](const Recording& recording) {
    return CanContradict(MakeScene(recording, DefaultConfig(recording)));
  };
  Recording recording = SeenInWind();
  EXPECT_TRUE(can(recording));
  Recording of_one = recording;
  of_one.tracks.erase(std::remove_if(of_one.tracks.begin(), of_one.tracks.end(),
                                     [](const Track& track) { return track.camera != 0; }),
                      of_one.tracks.end());
  EXPECT_TRUE(can(of_one));  // that camera and the markers
  of_one.markers.clear();
  EXPECT_FALSE(can(of_one));
  recording.tracks.clear();
  EXPECT_FALSE(can(recording));
}

// By the covariance of noise and motion: C' (I + s^2 H H')^-1 C.
TEST(WithoutMotion, IsLeastSquaresBesideAllMotions) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto draw = [&](double scale) { return scale * normal(random); };
  constexpr int kNodes = 5, kRows = 40, kColumns = 3;
  std::vector<PointResidual> points(kRows);
  Eigen::MatrixXd by_nodes = Eigen::MatrixXd::Zero(kRows, 3 * kNodes);
  for (int r = 0; r < kRows; ++r) {
    PointResidual& point = points[static_cast<std::size_t>(r)];
    point.point.nodes = {r % kNodes, (r + 1) % kNodes, (r + 3) % kNodes};
    point.point.weights = {0.5, 0.3, 0.2};
    for (double& slope : point.slope) slope = draw(10.0);
    for (std::size_t k = 0; k < 3; ++k)
      by_nodes.block<1, 3>(r, 3 * point.point.nodes[k]) += point.point.weights[k] * point.slope;
  }
  const Eigen::MatrixXd columns =
      Eigen::MatrixXd::NullaryExpr(kRows, kColumns, [&]() { return draw(1.0); });
  const Eigen::MatrixXd covariance =
      Eigen::MatrixXd::Identity(kRows, kRows) + by_nodes * by_nodes.transpose();
  const Eigen::MatrixXd weights = covariance.inverse();
  const MotionlessProducts products = WithoutMotion(points, columns);
  EXPECT_LT((products.gram - columns.transpose() * weights * columns).norm(), 1e-9);
  EXPECT_NEAR(products.freedom, weights.trace(), 1e-9);
}

}  // namespace
}  // namespace clothfit
