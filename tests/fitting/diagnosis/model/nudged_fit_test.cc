// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits that what was observed guides past the local minima of a lively cloth's cost.
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/model/switch_on.h"
#include "fitting/rollout/window_simulator.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

// Shaken, with next to no damping, in air that moves along.
SyntheticOptions Lively(int num_frames = 36) {
  SyntheticOptions options;
  options.scenario = SyntheticScenario::kTwoCornerShake;
  options.size = {0.5, 0.5};
  options.resolution = {5, 5};
  options.refinement = 2;
  options.markers = {7, 7};
  options.marker_sigma = 0.0015;
  options.frame_rate = 24.0;
  options.frame_count = num_frames;
  options.steps_per_frame = 5;
  options.parameters = {{"stretch.stiffness", 370.0}, {"stretch.damping", 0.8},
                        {"shear.stiffness", 6.2},     {"shear.damping", 0.18},
                        {"bending.stiffness", 4e-5},  {"bending.damping", 6e-6},
                        {"added_mass.normal", 0.26}};
  return options;
}

Recording LivelyCloth(int num_frames = 36) {
  return MakeSyntheticRecording(Lively(num_frames)).recording;
}

ModelStart WithAddedMass(const Recording& recording) {
  ModelStart start{recording, DefaultConfig(recording)};
  start.config.initial_order = 1;
  start.config.parameters.at("added_mass.normal").free = true;
  return start;
}

// m, root mean square over all markers and frames, of a cloth whose air was forgotten.
double Distance(const Scene& scene, const FitConfig& config) {
  const FreeParameters free(config, scene, MakeParameterTable());
  WindowSimulator simulator(scene, config, free, config.attract, nullptr);
  double sum = 0.0;
  int count = 0;
  const auto observe = [&](int frame, const State& state, const Sensitivity*) {
    for (const MarkerObservation& marker : scene.markers) {
      if (marker.frame != frame) continue;
      sum += (marker.on_cloth.At(state.x) - marker.position).squaredNorm();
      ++count;
    }
  };
  const Eigen::VectorXd theta = free.start();
  EXPECT_EQ(
      simulator.Run(simulator.FirstStart(theta), theta, scene.last_fitted_frame, false, observe),
      WindowSimulator::Outcome::kComplete);
  return std::sqrt(sum / count);
}

TEST(NudgedConfig, FollowsWhatWasSeenWithoutRinging) {
  SyntheticOptions options = Lively();
  options.refinement = 1;
  options.marker_sigma = 1e-5;
  const Recording recording = MakeSyntheticRecording(options).recording;
  FitConfig config = DefaultConfig(recording);
  for (const auto& [name, value] : options.parameters) config.parameters.at(name).value = value;
  config.parameters.at("added_mass.normal").value = 0.0;
  const Scene scene = MakeScene(recording, config);
  const auto nudged = [&](double share) { return *NudgedConfig(config, scene, share); };
  const double free = Distance(scene, config), held = Distance(scene, nudged(1.0));
  FitConfig ringing = nudged(1.0);
  for (const char* name : {"attraction_point.damping", "attraction_ray.damping"})
    ringing.parameters.at(name).value = 0.0;
  EXPECT_LT(held, 0.1 * free);
  EXPECT_LT(held, 0.9 * Distance(scene, ringing));
  // Weaker and weaker, it comes nearer to what the model does by itself.
  double nearer = held;
  for (const double share : {0.3, 0.1, 0.03}) {
    const double weaker = Distance(scene, nudged(share));
    EXPECT_GT(weaker, nearer) << share;
    nearer = weaker;
  }
  EXPECT_LT(nearer, free);
}

TEST(WindowsOfModel, FindWhatAPlainFitDoesNot) {
  SyntheticOptions rugged = Lively();
  rugged.buckling = false;
  ModelStart start = WithAddedMass(MakeSyntheticRecording(rugged).recording);
  start.config.buckling = false;
  const auto plain = FitAfresh(start, Start::kPlain, 21, FitRunner());  // as many iterations
  const auto windows = FitAfresh(start, Start::kWindows, 12, FitRunner());
  ASSERT_TRUE(plain && windows);
  // A plain one finds a minimum that costs less, far from the truth.
  const auto amount = [](const FittedScene& fitted) {
    return fitted.values.parameters.at("added_mass.normal").value;
  };
  EXPECT_NEAR(amount(*windows), 0.26, 0.026);
  EXPECT_GT(std::abs(amount(*plain) - 0.26), 2.0 * std::abs(amount(*windows) - 0.26));
}

TEST(WindowsOfModel, AreLaidOnTheMeshThatItIsToldAndStayWithIt) {
  ModelStart start = WithAddedMass(LivelyCloth(8));
  start.config.resolution = {9, 9};
  start.config.window = 0.1;
  const auto fitted = FitAfresh(start, Start::kWindows, 1, FitRunner());
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->scene.mesh.grid, (std::array<int, 2>{9, 9}));
  EXPECT_FALSE(fitted->config.attract);
  EXPECT_EQ(fitted->config.window, 0.1);
  EXPECT_EQ(fitted->config.parameters.at("stretch.stiffness").value,
            start.config.parameters.at("stretch.stiffness").value);
}

// A linear estimate may be any times too large.
TEST(AtBestShare, BeginsWhereTheRecordingIsNearest) {
  SyntheticOptions calm;
  calm.resolution = {5, 5};
  calm.frame_count = 12;
  calm.frame_rate = 24.0;
  calm.parameters = {{"added_mass.normal", 0.1}};
  const Recording recording = MakeSyntheticRecording(calm).recording;
  ModelStart without{recording, DefaultConfig(recording)};
  const auto fitted = FitAfresh(without, Start::kPlain, 0, FitRunner());
  ASSERT_TRUE(fitted);
  RankedCandidate mass;
  mass.summary.name = mass.term.term = "added_mass";
  mass.names = {"added_mass.normal"};
  for (const double times : {1.0, 3.0, 10.0}) {
    mass.amounts = Eigen::VectorXd::Constant(1, 0.1 * times);
    const ModelStart start = AtBestShare(*fitted, SwitchOn(*fitted, mass, {}), mass, FitRunner());
    EXPECT_NEAR(start.config.parameters.at("added_mass.normal").value, 0.1, 0.011) << times;
    EXPECT_TRUE(start.config.parameters.at("added_mass.normal").free);
  }
}

TEST(WithOnly, KeepsOneOfTwoEffects) {
  const Recording recording = LivelyCloth(8);
  const ModelStart plain{recording, DefaultConfig(recording)};
  const auto before = FitAfresh(plain, Start::kPlain, 0, FitRunner());
  ASSERT_TRUE(before);
  RankedCandidate crease, mass;
  crease.summary.name = crease.term.term = "crease";
  crease.names = {"crease.curvature"};
  crease.amounts = Eigen::VectorXd::Constant(1, 2.0);
  crease.probe = {{"crease.angle", 0.5}};
  mass.summary.name = mass.term.term = "added_mass";
  mass.names = {"added_mass.normal"};
  mass.amounts = Eigen::VectorXd::Constant(1, 0.1);
  const auto first = FitModel(*before, SwitchOn(*before, crease, {}), 0, FitRunner());
  ASSERT_TRUE(first);
  ModelStart both = SwitchOn(*first, mass, {});
  both.config.parameters.at("bending.stiffness").value *= 1.5;
  const auto model = FitModel(*first, both, 0, FitRunner());
  ASSERT_TRUE(model);
  const ModelStart one = WithOnly(*before, *model, mass);
  EXPECT_EQ(one.config.parameters.at("crease.curvature").value, 0.0);
  EXPECT_FALSE(one.config.parameters.at("crease.curvature").free);
  EXPECT_FALSE(one.config.parameters.at("crease.angle").free);
  EXPECT_NEAR(one.config.parameters.at("added_mass.normal").value, 0.1, 1e-12);
  EXPECT_TRUE(one.config.parameters.at("added_mass.normal").free);
  EXPECT_EQ(one.config.parameters.at("bending.stiffness").value,
            model->values.parameters.at("bending.stiffness").value);
  EXPECT_NE(one.config.parameters.at("bending.stiffness").value,
            before->values.parameters.at("bending.stiffness").value);
}

TEST(FittedScene, KeepsValuesAtTheirBoundsInside) {
  const Recording recording = LivelyCloth();
  FitConfig config = DefaultConfig(recording);
  config.parameters.at("bending.stiffness").free = true;
  Scene scene = MakeScene(recording, config);
  const FreeParameters free(config, scene, MakeParameterTable());
  FitResult fit;
  fit.theta = free.start();
  fit.parameters = free.Values(fit.theta);
  const int index = RequireParameter(MakeParameterTable(), "bending.stiffness");
  const double lower = config.parameters.at("bending.stiffness").lower;
  fit.parameters[index] = lower * (1.0 - 1e-15);
  const FittedScene fitted = MakeFittedScene(std::move(scene), config, fit);
  EXPECT_EQ(fitted.values.parameters.at("bending.stiffness").value, lower);
  EXPECT_NO_THROW(fitted.values.Check("values"));
}

TEST(NudgedFit, NeedsSomethingToPullAt) {
  ModelStart start = WithAddedMass(LivelyCloth());
  start.recording.markers.clear();
  start.recording.tracks.clear();
  EXPECT_FALSE(FitAfresh(start, Start::kWindows, 1, FitRunner()));
  EXPECT_FALSE(FitNudged(start, kScoringDamping, FitRunner()));
}

}  // namespace
}  // namespace clothfit
