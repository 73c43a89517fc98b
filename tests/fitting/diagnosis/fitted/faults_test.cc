// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Columns of faults against recordings that have them.
#include "fitting/diagnosis/fitted/faults.h"

#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

SyntheticOptions SmallSwing() {
  SyntheticOptions options;
  options.resolution = {6, 6};
  options.frame_count = 24;
  options.frame_rate = 60.0;
  options.marker_sigma = 0.0005;
  options.markers = {4, 3};  // none on an edge of the mesh, where an offset has two derivatives
  options.held_out_share = 0.0;
  return options;
}

Recording WithCameras() {
  SyntheticOptions options = SmallSwing();
  options.num_cameras = 2;
  options.marker_sigma = 1e-6;  // so that observed and simulated courses are one
  options.track_sigma = 0.01;
  return MakeSyntheticRecording(options).recording;
}

// The states of one simulation of a recording's scene.
std::vector<State> Simulate(const Scene& scene, const FitConfig& config) {
  const FreeParameters free(config, scene, MakeParameterTable());
  std::vector<State> states;
  SimulateFrames(scene, config, free, free.start(), scene.last_fitted_frame,
                 [&](int, const State& state) { states.push_back(state); });
  return states;
}

FitConfig PlainConfig(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  config.loss = LossKind::kNone;
  config.use_silhouettes = false;
  return config;
}

Eigen::VectorXd Residuals(const Recording& recording, const FitConfig& config, int frame,
                          const State& state) {
  const Scene scene = MakeScene(recording, config);
  const ObservationResiduals observations(scene, config);
  Eigen::VectorXd residuals(observations.Count(frame));
  EXPECT_TRUE(observations.Evaluate(frame, state, nullptr, 0, &residuals, nullptr));
  return residuals;
}

TEST(Faults, ColumnsAreWhatThePutRightRecordingsShow) {
  const Recording recording = WithCameras();
  const FitConfig config = PlainConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const ObservationResiduals observations(scene, config);
  const std::vector<State> states = Simulate(scene, config);
  constexpr int kFrame = 12;
  const std::vector<Fault> faults = ListFaults(scene, config);
  const RowMajorMatrix columns =
      FaultColumns(scene, config, observations, faults, kFrame, states[kFrame]);
  int checked = 0;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Fault& fault = faults[i];
    const bool is_clock =
        fault.kind == Fault::Kind::kCameraClock || fault.kind == Fault::Kind::kMarkerClock;
    const double amount = 1e-5;
    Eigen::VectorXd amounts = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(faults.size()));
    const auto at = [&](double a) {
      amounts[static_cast<Eigen::Index>(i)] = a;
      return Residuals(WithoutFaults(recording, faults, amounts), config, kFrame, states[kFrame]);
    };
    const Eigen::VectorXd numeric = (at(amount) - at(-amount)) / (2.0 * amount);
    const Eigen::VectorXd column = columns.col(static_cast<Eigen::Index>(i));
    ASSERT_GT(numeric.norm(), 0.0) << fault.name;
    if (is_clock) {
      // The clock is put right by differences between frames.
      EXPECT_LT((numeric - column).norm(), 0.1 * column.norm()) << fault.name;
    } else {
      EXPECT_LT((numeric - column).norm(), 2e-3 * column.norm()) << fault.name;
    }
    ++checked;
  }
  EXPECT_GE(checked, 2 * 8 + 5);
}

TEST(Faults, OnlyTheOwnObservationsMove) {
  const Recording recording = WithCameras();
  const FitConfig config = PlainConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const ObservationResiduals observations(scene, config);
  const State state = Simulate(scene, config)[10];
  const std::vector<Fault> faults = ListFaults(scene, config);
  const RowMajorMatrix columns = FaultColumns(scene, config, observations, faults, 10, state);
  const std::vector<ResidualSource> sources = SourcesOfFrame(scene, 10);
  ASSERT_EQ(static_cast<Eigen::Index>(sources.size()), columns.rows());
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const bool is_marker_fault = faults[i].group.rfind("marker", 0) == 0;
    for (std::size_t r = 0; r < sources.size(); ++r) {
      const bool is_marker_row = sources[r].kind == ResidualSource::Kind::kMarker;
      if (is_marker_fault == is_marker_row &&
          (is_marker_row || sources[r].source == faults[i].source))
        continue;
      EXPECT_EQ(columns(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(i)), 0.0);
    }
  }
}

TEST(Faults, OfMasksArePutRightWhereTheyAreLoaded) {
  Recording recording = WithCameras();  // 60 Hz
  recording.files.resize(2);
  const std::vector<Fault> faults = {
      {Fault::Kind::kCameraClock, "camera 1: clock", "camera 1: clock", "s", 1},
      {Fault::Kind::kMaskBias, "camera 0: fat mask", "camera 0: fat mask", "px", 0}};
  const Eigen::Vector2d amounts(0.005, -1.5);
  const Recording once = WithoutFaults(recording, faults, amounts);
  EXPECT_EQ(once.files[0].mask_faults, (MaskFaults{0.0, -1.5}));
  EXPECT_DOUBLE_EQ(once.files[1].mask_faults.later, 0.3);
  // What is found later adds to it.
  const Recording twice = WithoutFaults(once, faults, amounts);
  EXPECT_DOUBLE_EQ(twice.files[1].mask_faults.later, 0.6);
  EXPECT_DOUBLE_EQ(twice.files[0].mask_faults.fat, -3.0);
}

}  // namespace
}  // namespace clothfit
