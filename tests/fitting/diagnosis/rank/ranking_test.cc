// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the ranking looks at, and how it tells sources of an observation apart.
#include "fitting/diagnosis/rank/ranking.h"

#include <algorithm>
#include <atomic>
#include <random>
#include <string_view>

#include <gtest/gtest.h>

#include "fitting/diagnosis/model/fault_estimate.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "tests/support/small_recording.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

FittedScene Fitted(const Recording& recording, bool buckling = true) {
  FitConfig config = DefaultConfig(recording);
  config.buckling = buckling;
  config.use_silhouettes = false;
  for (auto& [name, setting] : config.parameters) setting.free = false;
  for (const char* name : {"stretch.stiffness", "bending.stiffness", "air_drag.normal"})
    config.parameters.at(name).free = true;
  std::optional<FittedScene> fitted =
      FitAfresh({recording, config}, Start::kPlain, 10, FitRunner());
  EXPECT_TRUE(fitted);
  return std::move(*fitted);
}

const RankedCandidate& Named(const Ranking& ranking, std::string_view name) {
  const auto found = std::find_if(ranking.candidates.begin(), ranking.candidates.end(),
                                  [&](const auto& c) { return c.summary.name == name; });
  EXPECT_NE(found, ranking.candidates.end()) << name;
  return *found;
}

// Discretisation errors: noise of so many sigmas.
std::shared_ptr<const DiscretisationErrors> ErrorsOf(const FittedScene& fitted, double sigmas) {
  const ObservationResiduals observations(fitted.scene, fitted.config);
  const Eigen::Index rows = RowFrames(fitted.scene, observations, kMostRows).num_rows();
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  DiscretisationErrors errors;
  errors.num_rows = rows;
  for (int k = 0; k < 3; ++k)
    errors.at_draws.push_back(
        Eigen::VectorXd::NullaryExpr(rows, [&]() { return sigmas * normal(random); }));
  return std::make_shared<const DiscretisationErrors>(std::move(errors));
}

Ranking Rank(const FittedScene& fitted, double sigmas_of_errors,
             const DiagnosisOptions& options = {}) {
  RankingStart start;
  start.errors = ErrorsOf(fitted, sigmas_of_errors);
  return RankCandidates(fitted, options, start);
}

TEST(Ranking, WhatStandsOutByItsPatternIsLookedAtWhateverMeshAndStepLeave) {
  const FittedScene fitted =
      Fitted(MakeSmallRecording({5, 30, 0.002, {{"added_mass.normal", 0.01}}}));
  const Ranking ranking = Rank(fitted, 4.0);
  EXPECT_GT(ranking.discretisation_rms, ranking.residual_rms);
  EXPECT_GT(ranking.gate_p_value, 0.05);  // no more is left than the null leaves
  const Candidate& mass = Named(ranking, "added_mass").summary;
  EXPECT_LT(mass.p_value, 1e-3);
  EXPECT_TRUE(mass.is_short_listed) << mass.why_not;
}

TEST(Ranking, NothingStandsOutOfNoise) {
  const FittedScene fitted = Fitted(MakeSmallRecording({5, 30, 0.002, {}}));
  for (const RankedCandidate& candidate : Rank(fitted, 0.5).candidates)
    EXPECT_FALSE(candidate.summary.is_short_listed) << candidate.summary.name;
}

TEST(Ranking, EndsWhereItIsStoppedBeforeAnyTrial) {
  const FittedScene fitted = Fitted(MakeSmallRecording({5, 10, 0.002, {}}));
  const std::atomic<bool> stop = true;
  DiagnosisOptions options;
  options.stop = &stop;
  const Ranking ranking = Rank(fitted, 0.5, options);
  for (const RankedCandidate& candidate : ranking.candidates)
    EXPECT_EQ(candidate.summary.kind, CandidateKind::kObservation) << candidate.summary.name;
}

Recording SeenByThree(double track_sigma = 0.5) {
  SyntheticOptions options;
  options.resolution = {6, 6};
  options.frame_count = 24;
  options.frame_rate = 60.0;
  options.num_cameras = 3;
  options.markers = {5, 5};
  options.track_sigma = track_sigma;
  options.buckling = false;  // cameras are tested
  return MakeSyntheticRecording(options).recording;
}

// Its tracks alone, with the second camera's focal length told so many times too long.
Recording WithLongFocalLength(Recording recording, double times) {
  recording.markers.clear();
  recording.cameras[1].fx *= times;
  recording.cameras[1].fy *= times;
  return recording;
}

TEST(Ranking, AFaultIsOfOneCameraAndNotAllOfThem) {
  const Recording recording = WithLongFocalLength(SeenByThree(), 1.01);
  const FittedScene fitted = Fitted(recording, false);
  const Ranking ranking = Rank(fitted, 0.5);
  const std::vector<Camera>& cameras = recording.cameras;
  const RankedCandidate& guilty = Named(ranking, "camera " + cameras[1].name + ": scale");
  EXPECT_TRUE(guilty.summary.is_short_listed) << guilty.summary.why_not;
  EXPECT_NEAR(guilty.amounts[0], -0.01, 0.002);  // its focal length is shorter than told
  for (const int other : {0, 2}) {
    const RankedCandidate& innocent =
        Named(ranking, "camera " + cameras[static_cast<std::size_t>(other)].name + ": scale");
    EXPECT_LT(innocent.summary.score, 0.2 * guilty.summary.score);
  }
}

TEST(Ranking, WhatWellMadeRecordingsHaveIsNoFault) {
  const Recording recording = WithLongFocalLength(SeenByThree(0.05), 1.0006);
  const FittedScene fitted = Fitted(recording, false);
  DiagnosisOptions options;
  options.false_discovery = 1.0;  // whatever stands out
  const Ranking ranking = Rank(fitted, 0.0, options);
  const Candidate scale = Named(ranking, "camera " + recording.cameras[1].name + ": scale").summary;
  EXPECT_NEAR(scale.parameters[0].value, -6e-4, 2e-4);
  EXPECT_FALSE(scale.is_short_listed);
}

// However little of it the ranking has found.
TEST(Ranking, AFaultIsEstimatedAgainInItsModel) {
  const Recording recording = WithLongFocalLength(SeenByThree(), 1.01);
  const FittedScene fitted = Fitted(recording, false);
  const Ranking ranking = Rank(fitted, 0.5);
  FittedModel model{Named(ranking, "camera " + recording.cameras[1].name + ": scale"), fitted};
  model.candidate.amounts[0] = -0.004;
  const ModelStart put_right = SwitchOn(fitted, model.candidate, ranking.faults);
  model.scene = *FitModel(fitted, put_right, kModelIterations, FitRunner());
  EstimateFaultAgain(ranking.faults, FitRunner(), &model);
  EXPECT_NEAR(model.candidate.amounts[0], -0.0099, 0.0003);
  const EffectParameter& given = model.candidate.summary.parameters[0];
  EXPECT_EQ(given.value, model.candidate.amounts[0]);
  EXPECT_LT(given.lower90, -0.0099);
  EXPECT_GT(given.upper90, -0.0099);
  const Camera& camera = model.scene.scene.recording.cameras[1];
  const double true_focal_length = recording.cameras[1].fx / 1.01;
  EXPECT_NEAR(camera.fx, true_focal_length, 3e-4 * true_focal_length);
}

TEST(Ranking, MarkersThatAreAllBesideTheirPlacesAreOneFault) {
  Recording recording = SeenByThree();
  recording.tracks.clear();
  for (Marker& marker : recording.markers) marker.uv += Eigen::Vector2d(0.006, -0.004);
  const FittedScene fitted = Fitted(recording, false);
  const RankedCandidate layout = Named(Rank(fitted, 0.5), "markers: layout");
  EXPECT_TRUE(layout.summary.is_short_listed) << layout.summary.why_not;
  EXPECT_NEAR(layout.amounts[0], -0.006, 0.003);
  EXPECT_NEAR(layout.amounts[1], 0.004, 0.003);
}

}  // namespace
}  // namespace clothfit
