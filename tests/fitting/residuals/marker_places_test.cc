// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/residuals/marker_places.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "fitting/fit/search.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/runs/summary.h"
#include "fitting/studies/recovery_study.h"

namespace clothfit {
namespace {

constexpr double kLayout = 0.003;  // m

Recording WithLayout(int frames, double layout_sigma) {
  SyntheticOptions options = DemoRecording();
  options.resolution = {5, 5};
  options.frame_count = frames;
  options.layout_sigma = layout_sigma;
  return MakeSyntheticRecording(options).recording;
}

TEST(MarkerPlaces, TangentsAreHowThePointMoves) {
  const ClothMesh mesh = MakeGrid({0.4, 0.3}, {5, 4});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Eigen::VectorXd x(3 * mesh.num_particles());
  for (double& value : x) value = number(random);
  constexpr double kStep = 1e-4;  // m, within the triangle
  const Eigen::Vector2d place(0.17, 0.12);
  const Eigen::Matrix<double, 3, 2> tangents = TangentsAt(LocateOnCloth(mesh, {place})[0], mesh, x);
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(k);
    const auto at = LocateOnCloth(mesh, {place - step, place + step});
    const Eigen::Vector3d slope = (at[1].At(x) - at[0].At(x)) / (2.0 * kStep);
    EXPECT_LT((tangents.col(k) - slope).norm(), 1e-9 * slope.norm());
  }
}

// One simulation with its residuals and derivatives, and places as explicit unknowns.
class Eliminated : public testing::Test {
 protected:
  Eliminated()
      : recording_(WithLayout(8, kLayout)),
        config_(DefaultConfig(recording_)),
        plain_(MakeScene(recording_, config_)),
        placed_(plain_),
        free_(config_, plain_, MakeParameterTable()) {
    plain_.layout_sigma = 0.0;
  }

  // [J r]
  Eigen::MatrixXd RowsOf(const Scene& scene, WindowRows rows, bool differentiated = true) const {
    WindowSimulator simulator(scene, config_, free_, false, nullptr);
    const ObservationResiduals observations(scene, config_);
    Eigen::VectorXd residuals;
    RowMajorMatrix jacobian;
    EXPECT_EQ(EvaluateWindow(&simulator, observations, simulator.FirstStart(free_.start()),
                             free_.start(), 0, scene.last_fitted_frame, rows, &residuals,
                             differentiated ? &jacobian : nullptr),
              WindowSimulator::Outcome::kComplete);
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(residuals.size(), free_.size() + 1);
    if (differentiated) all.leftCols(free_.size()) = jacobian;
    all.rightCols(1) = residuals;
    return all;
  }

  // The tangents of all rows by all places, two columns a marker in the order of their ids.
  Eigen::MatrixXd Tangents() const {
    std::set<int> ids;
    for (const MarkerObservation& marker : plain_.markers) ids.insert(marker.id);
    const ObservationResiduals observations(plain_, config_);
    Eigen::MatrixXd tangents = Eigen::MatrixXd::Zero(
        observations.Count(0, plain_.last_fitted_frame), 2 * static_cast<int>(ids.size()));
    Eigen::Index row = 0;
    std::size_t next = 0;
    SimulateFrames(plain_, config_, free_, free_.start(), plain_.last_fitted_frame,
                   [&](int frame, const State& state) {
                     for (; next < plain_.markers.size() && plain_.markers[next].frame == frame;
                          ++next, row += 3) {
                       const MarkerObservation& marker = plain_.markers[next];
                       const auto which = std::distance(ids.begin(), ids.find(marker.id));
                       tangents.block<3, 2>(row, 2 * which) =
                           TangentsAt(marker.on_cloth, plain_.mesh, state.x) / plain_.marker_sigma;
                     }
                   });
    return tangents;
  }

  Recording recording_;
  FitConfig config_;
  Scene plain_, placed_;
  FreeParameters free_;
};

TEST_F(Eliminated, LeavesWhatTheBestPlacesLeave) {
  const Eigen::MatrixXd rows = RowsOf(plain_, WindowRows::kAll), tangents = Tangents();
  const Eigen::Index places = tangents.cols();
  // The normal equations of unknowns and places together, solved for the places.
  const Eigen::MatrixXd of_places = tangents.transpose() * tangents +
                                    Eigen::MatrixXd::Identity(places, places) / (kLayout * kLayout);
  const Eigen::MatrixXd with = tangents.transpose() * rows;
  const Eigen::MatrixXd expected =
      rows.transpose() * rows - with.transpose() * of_places.llt().solve(with);
  const Eigen::MatrixXd all = RowsOf(placed_, WindowRows::kAll);
  const Eigen::MatrixXd compressed = RowsOf(placed_, WindowRows::kCompressed);
  ASSERT_EQ(all.rows(), rows.rows());
  EXPECT_LT((all.transpose() * all - expected).norm(), 1e-10 * expected.norm());
  EXPECT_LT((compressed.transpose() * compressed - expected).norm(), 1e-10 * expected.norm());
  const Eigen::VectorXd without_derivatives =
      RowsOf(placed_, WindowRows::kCompressed, false).rightCols(1);
  const double left = expected(free_.size(), free_.size());
  EXPECT_NEAR(without_derivatives.squaredNorm(), left, 1e-10 * left);
  // Something was taken out.
  EXPECT_LT(all.rightCols(1).norm(), 0.9 * rows.rightCols(1).norm());
}

TEST_F(Eliminated, IsAllThereWherePlacesAreExact) {
  placed_.layout_sigma = 1e-9;
  const Eigen::MatrixXd rows = RowsOf(plain_, WindowRows::kAll);
  EXPECT_LT((RowsOf(placed_, WindowRows::kAll) - rows).norm(), 1e-9 * rows.norm());
}

FitResult FitWith(Recording recording, bool is_told) {
  if (!is_told) recording.noise.layout.reset();
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  return FitByStrategy(scene, config);
}

TEST(MarkerPlaces, AMisplacedLayoutDoesNoHarm) {
  const Recording recording = WithLayout(60, kLayout), exact = WithLayout(60, 0.0);
  const FitResult right = FitWith(exact, true), wrong = FitWith(recording, false);
  const FitResult known = FitWith(recording, true);
  ASSERT_TRUE(right.misfit && wrong.misfit && known.misfit);
  EXPECT_FALSE(wrong.misfit->IsNoise());
  EXPECT_TRUE(known.misfit->IsNoise());
  EXPECT_LT(known.misfit->correlation, 1.5);
  for (std::size_t i = 0; i < right.estimates.size(); ++i) {
    const ParameterEstimate &a = right.estimates[i], &b = known.estimates[i];
    if (!a.free || !a.determined) continue;
    EXPECT_TRUE(b.determined) << a.name;
    EXPECT_LT(b.lower95, a.value) << a.name;
    EXPECT_GT(b.upper95, a.value) << a.name;
  }
  // Places are found, and markers are compared there.
  double squares = 0.0;
  for (const Marker& marker : exact.markers) {
    if (marker.frame > 0) break;
    const auto told = std::find_if(recording.markers.begin(), recording.markers.end(),
                                   [&](const Marker& m) { return m.id == marker.id; });
    squares += (told->uv + known.after.marker_shifts.at(marker.id) - marker.uv).squaredNorm();
  }
  EXPECT_LT(std::sqrt(squares / (2.0 * 25.0)), 0.2 * kLayout);
  EXPECT_NEAR(*known.after.marker_rms, *right.after.marker_rms, 0.02 * *right.after.marker_rms);
  EXPECT_TRUE(right.after.marker_shifts.empty());
}

TEST(MarkerPlaces, AreToldInTheSummary) {
  const Recording recording = WithLayout(2, kLayout);
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  FitResult result;
  EXPECT_TRUE(SummaryAsJson(scene, config, result).at("marker_places").is_null());
  result.after.marker_shifts = {{1, {0.003, -0.004}}, {7, {0.0, 0.0}}};
  const auto places = SummaryAsJson(scene, config, result).at("marker_places");
  EXPECT_EQ(places.at("layout_m"), kLayout);
  EXPECT_NEAR(places.at("rms_m"), 0.005 / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(places.at("shifts_m").at("1"), (std::vector<double>{0.003, -0.004}));
  EXPECT_EQ(places.at("in_words"), "3.5 mm (root mean square), at most 5.0 mm (marker 1)");
}

}  // namespace
}  // namespace clothfit
