// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/recording.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/scene/silhouettes.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

// Small enough to be simulated many times.
std::vector<Trial> SmallPlan(const std::string& plan, const std::vector<std::string>& only = {}) {
  TrialPlanOptions options;
  options.frame_count = 25;
  options.resolution = 5;
  options.same_generator = true;
  options.only = only;
  return MakeTrialPlan("PLAN", plan, options);
}

const Trial& Find(const std::vector<Trial>& trials, SyntheticScenario motion,
                  TrialObservation observation, EffectSize size = EffectSize::kLarge) {
  for (const Trial& trial : trials) {
    const bool is_size = trial.effects.empty() || trial.effects[0].size == size;
    if (trial.recording.scenario == motion && trial.observation == observation && is_size)
      return trial;
  }
  throw std::out_of_range("no such trial");
}

constexpr SyntheticScenario kSwing = SyntheticScenario::kTwoCornerSwing;

TEST(TrialRecording, ObservesWhatItsKindSays) {
  const std::vector<Trial> clean = SmallPlan("clean");
  const Recording markers =
      MakeTrialRecording(Find(clean, kSwing, TrialObservation::kMarkers)).recording;
  EXPECT_EQ(markers.markers.size(), 25U * 49U);
  EXPECT_TRUE(markers.tracks.empty());
  EXPECT_TRUE(markers.cameras.empty());
  const Recording tracks =
      MakeTrialRecording(Find(clean, kSwing, TrialObservation::kTracks)).recording;
  EXPECT_TRUE(tracks.markers.empty());
  EXPECT_FALSE(tracks.noise.marker);
  EXPECT_GT(tracks.tracks.size(), 25U * 3U * 40U);
  EXPECT_EQ(tracks.cameras.size(), 3U);
  const Recording mixture =
      MakeTrialRecording(Find(clean, kSwing, TrialObservation::kMixture)).recording;
  EXPECT_EQ(mixture.markers.size(), 25U * 16U);
  EXPECT_EQ(mixture.cameras.size(), 2U);
  EXPECT_FALSE(mixture.tracks.empty());
  EXPECT_TRUE(mixture.splits.held_out_frames);
}

TEST(TrialRecording, WritesMasksThatShowTheCloth) {
  const TestFolder folder;
  const std::vector<Trial> clean = SmallPlan("clean");
  const Trial& trial = Find(clean, kSwing, TrialObservation::kSilhouettes);
  const Recording recording = MakeTrialRecording(trial, folder.path() / "one").recording;
  EXPECT_TRUE(HasMasks(recording));
  EXPECT_TRUE(recording.markers.empty());
  EXPECT_TRUE(recording.tracks.empty());
  const Silhouettes silhouettes = LoadSilhouettes(recording, [](int, int) { return false; });
  EXPECT_TRUE(silhouettes.warnings.empty());
  ASSERT_EQ(silhouettes.observations.size(), 25U * 3U);
  for (const SilhouetteObservation& one : silhouettes.observations)
    EXPECT_GT(one.mask.Count(), 2000);  // px; edge on it is still that broad
  EXPECT_THROW(MakeTrialRecording(trial), std::invalid_argument);
}

TEST(TrialRecording, MovesFurtherForLargerEffects) {
  int compared = 0;
  for (const char* term : {"wind", "heavy_patch", "shear_friction", "obstacle_plane"}) {
    const std::vector<Trial> trials = SmallPlan("listed", {term});
    double before = 1e-5;  // m: rounding of the true points is a tenth of this
    for (const EffectSize size : kEffectSizes) {
      const SyntheticScenario motion = trials.front().recording.scenario;
      // Each size draws a fabric of its own.
      Trial trial = Find(trials, motion, trials.front().observation, size);
      for (const auto& [name, value] : TypicalParameters(trial.fabric))
        trial.recording.parameters[name] = value;
      const double moved = DistanceBetween(TruePoints(trial), TruePoints(WithoutEffects(trial)));
      EXPECT_GT(moved, before) << term << ", " << ToString(size);
      before = moved;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 12);
}

TEST(TrialRecording, WritesTheTruthBeside) {
  const std::vector<Trial> trials = SmallPlan("unlisted", {"vortex"});
  const Trial& trial = Find(trials, kSwing, TrialObservation::kMarkers);
  const TestFolder folder;
  const TrialRecording made = MakeTrialRecording(trial, folder.path() / "vortex");
  EXPECT_EQ(made.truth.effects, std::vector<std::string>{"vortex"});
  EXPECT_NE(made.fabric.at("vortex.speed"), 0.0);
  EXPECT_EQ(ReadTruthParameters(folder.path() / "vortex"), made.fabric);
  EXPECT_EQ(made.recording.name, trial.name);
}

TEST(TrueForce, OfAGustActsWhileItBlowsAndWhereItIs) {
  const std::vector<Trial> trials = SmallPlan("listed", {"gust"});
  const TrialRecording made = MakeTrialRecording(Find(trials, kSwing, TrialObservation::kTracks));
  const ActingForce& force = made.truth.force;
  ASSERT_TRUE(force.acts);
  const double rate = made.recording.frame_rate, onset = made.truth.parameters.at("gust.onset"),
               end = onset + made.truth.parameters.at("gust.duration");
  // The gust's speed is a tenth of its peak within a tenth of its duration of either end.
  EXPECT_GE(force.first_frame, std::floor(onset * rate));
  EXPECT_LE(force.first_frame, std::ceil((onset + 0.2 * (end - onset)) * rate));
  EXPECT_LE(force.last_frame, std::ceil(end * rate));
  EXPECT_GE(force.last_frame, std::floor((end - 0.2 * (end - onset)) * rate));
  EXPECT_LE(force.low_uv.y(), 0.35);
  EXPECT_GE(force.high_uv.y(), 0.35);
  EXPECT_GT(force.low_uv.y(), 0.0);  // far from the upper edge
}

TEST(TrueForce, OfFrictionTakesMoreEnergyThanItGives) {
  const std::vector<Trial> trials = SmallPlan("listed", {"shear_friction"});
  const ActingForce force =
      MakeTrialRecording(Find(trials, kSwing, TrialObservation::kMixture)).truth.force;
  ASSERT_TRUE(force.acts);
  EXPECT_GT(force.work_out, force.work_in);
}

TEST(TrueForce, OfNothingIsNone) {
  const std::vector<Trial> clean = SmallPlan("clean");
  EXPECT_FALSE(
      MakeTrialRecording(Find(clean, kSwing, TrialObservation::kMarkers)).truth.force.acts);
}

// Counts how many of a camera's tracks differ.
int Differences(const Recording& a, const Recording& b, int camera) {
  EXPECT_EQ(a.tracks.size(), b.tracks.size());
  int count = 0;
  for (std::size_t i = 0; i < std::min(a.tracks.size(), b.tracks.size()); ++i) {
    EXPECT_EQ(a.tracks[i].frame, b.tracks[i].frame);
    EXPECT_EQ(a.tracks[i].camera, b.tracks[i].camera);
    if (a.tracks[i].camera == camera && a.tracks[i].pixel != b.tracks[i].pixel) ++count;
  }
  return count;
}

TEST(TrialFault, OfACameraMovesThatCamerasTracksOnly) {
  int checked = 0;
  for (const char* fault : {"camera-pose", "camera-clock", "camera-scale"}) {
    const std::vector<Trial> trials = SmallPlan("fault", {fault});
    Trial trial = Find(trials, kSwing, TrialObservation::kTracks);
    const Recording faulty = MakeTrialRecording(trial).recording;
    const int camera = trial.fault->camera;
    trial.fault.reset();
    const Recording clean = MakeTrialRecording(trial).recording;
    for (int c = 0; c < 3; ++c) {
      SCOPED_TRACE(fault);
      const int count = Differences(faulty, clean, c);
      if (c == camera) {
        EXPECT_GT(count, 25 * 20);
      } else {
        EXPECT_EQ(count, 0);
      }
      // The recording tells what it always told.
      EXPECT_EQ(faulty.cameras[c].fx, clean.cameras[c].fx);
      EXPECT_EQ(faulty.cameras[c].camera_from_world_translation,
                clean.cameras[c].camera_from_world_translation);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 9);
}

TEST(TrialFault, SwapsTwoMarkersFromTheMiddleOn) {
  const std::vector<Trial> trials = SmallPlan("fault", {"marker-swap"});
  Trial trial = Find(trials, kSwing, TrialObservation::kMarkers);
  const Recording faulty = MakeTrialRecording(trial).recording;
  const PlantedFault fault = *trial.fault;
  trial.fault.reset();
  const Recording clean = MakeTrialRecording(trial).recording;
  int changed = 0;
  for (std::size_t i = 0; i < clean.markers.size(); ++i) {
    const Marker &a = clean.markers[i], &b = faulty.markers[i];
    if (a.position == b.position) continue;
    ++changed;
    EXPECT_GE(a.frame, 12);
    EXPECT_TRUE(a.id == fault.first_marker || a.id == fault.second_marker) << a.id;
    EXPECT_GT((a.position - b.position).norm(), 0.03);  // m; neighbours are 7 cm apart
  }
  EXPECT_EQ(changed, 2 * 13);
}

TEST(TrialFault, ShiftsAllMarkersAlongTheCloth) {
  const std::vector<Trial> trials = SmallPlan("fault", {"marker-shift"});
  Trial trial = Find(trials, kSwing, TrialObservation::kMarkers);
  const Recording faulty = MakeTrialRecording(trial).recording;
  const double shift = trial.fault->on_cloth.norm();
  trial.fault.reset();
  const Recording clean = MakeTrialRecording(trial).recording;
  for (std::size_t i = 0; i < clean.markers.size(); ++i) {
    EXPECT_EQ(clean.markers[i].uv, faulty.markers[i].uv);
    // The cloth hardly stretches; shear changes lengths along the bias by a few per cent, and so do
    // wrinkles that its mesh does not have.
    EXPECT_NEAR((clean.markers[i].position - faulty.markers[i].position).norm(), shift,
                0.2 * shift);
  }
}

TEST(TrialFault, TurnsAndScalesACamera) {
  Camera given;
  given.width = 640;
  given.height = 480;
  given.fx = given.fy = 500.0;
  given.camera_from_world_translation = {0.0, 0.0, 2.0};
  PlantedFault fault;
  fault.scale = 0.01;
  const Eigen::Vector3d point(0.2, 0.1, 0.0);
  EXPECT_NEAR(ProjectPoint(FaultyCamera(fault, given), point).x(),
              1.01 * ProjectPoint(given, point).x(), 1e-9);
  fault.scale = 0.0;
  fault.shift = {0.004, 0.0, 0.0};
  EXPECT_NEAR(ProjectPoint(FaultyCamera(fault, given), point).x(),
              ProjectPoint(given, point).x() + 500.0 * 0.004 / 2.0, 1e-9);
  fault.shift.setZero();
  fault.turn = {0.0, 0.003, 0.0};  // about the axis that points down: the view moves along x
  EXPECT_NEAR(ProjectPoint(FaultyCamera(fault, given), Eigen::Vector3d::Zero()).x(),
              500.0 * std::tan(0.003), 1e-9);
}

TEST(SurfaceAt, FollowsAParabolaBetweenFrames) {
  SyntheticSurface surface;
  surface.interval = 0.1;
  for (int k = 0; k < 6; ++k)
    surface.positions.push_back(Eigen::VectorXd::Constant(3, 2.0 * std::pow(0.1 * k, 2)));
  EXPECT_NEAR(SurfaceAt(surface, 0.234)[0], 2.0 * 0.234 * 0.234, 1e-12);
  EXPECT_NEAR(SurfaceAt(surface, 0.3)[0], 0.18, 1e-12);
  EXPECT_EQ(SurfaceAt(surface, -1.0)[0], 0.0);
  EXPECT_NEAR(SurfaceAt(surface, 9.0)[0], 0.5, 1e-12);
}

}  // namespace
}  // namespace clothfit
