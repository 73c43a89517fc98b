// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/window_cost.h"

#include <limits>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "tests/support/silhouette_scene.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

// Compressed rows have the sums of all rows: what Levenberg-Marquardt goes by is the same.
void ExpectTheSameSums(const Scene& scene, const FitConfig& config, int last) {
  const FreeParameters free(config, scene, MakeParameterTable());
  const ObservationResiduals observations(scene, config);
  WindowSimulator simulator(scene, config, free, false, nullptr);
  const Eigen::VectorXd theta = free.start();
  const WindowStart start = simulator.FirstStart(theta);
  Eigen::VectorXd all, compressed, value;
  RowMajorMatrix jacobian, compressed_jacobian;
  EvaluateWindow(&simulator, observations, start, theta, 0, last, WindowRows::kAll, &all,
                 &jacobian);
  EvaluateWindow(&simulator, observations, start, theta, 0, last, WindowRows::kCompressed,
                 &compressed, &compressed_jacobian);
  ASSERT_EQ(all.size(), observations.Count(0, last));
  ASSERT_EQ(compressed.size(), free.size() + 1);
  ASSERT_GT(all.squaredNorm(), 0.0);
  EXPECT_NEAR(compressed.squaredNorm(), all.squaredNorm(), 1e-10 * all.squaredNorm());
  const Eigen::VectorXd gradient = jacobian.transpose() * all;
  EXPECT_LT((compressed_jacobian.transpose() * compressed - gradient).norm(),
            1e-9 * gradient.norm());
  const Eigen::MatrixXd information = jacobian.transpose() * jacobian;
  EXPECT_LT((compressed_jacobian.transpose() * compressed_jacobian - information).norm(),
            1e-9 * information.norm());
  // Without derivatives, which leave the simulation's last digits otherwise.
  EvaluateWindow(&simulator, observations, start, theta, 0, last, WindowRows::kAll, &all, nullptr);
  EvaluateWindow(&simulator, observations, start, theta, 0, last, WindowRows::kCompressed, &value,
                 nullptr);
  EXPECT_EQ(value.size(), compressed.size());
  EXPECT_NEAR(value.squaredNorm(), all.squaredNorm(), 1e-10 * all.squaredNorm());
}

TEST(EvaluateWindow, CompressesRowsOfMarkersWithoutLoss) {
  const Recording recording = MakeSmallRecording();
  FitConfig config = DefaultConfig(recording);
  ExpectTheSameSums(MakeScene(recording, config), config, 20);
  config.loss = LossKind::kCauchy;  // which ties the three coordinates of a marker
  config.loss_scale = 0.5;
  ExpectTheSameSums(MakeScene(recording, config), config, 20);
}

TEST(EvaluateWindow, IsOfNoUseWhereARowIsNoNumber) {
  Recording recording = MakeSmallRecording();
  recording.markers[20].position.x() = std::numeric_limits<double>::quiet_NaN();
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const FreeParameters free(config, scene, MakeParameterTable());
  WindowSimulator simulator(scene, config, free, false, nullptr);
  Eigen::VectorXd residuals;
  RowMajorMatrix jacobian;
  for (const WindowRows rows : {WindowRows::kAll, WindowRows::kCompressed}) {
    EXPECT_EQ(EvaluateWindow(&simulator, ObservationResiduals(scene, config),
                             simulator.FirstStart(free.start()), free.start(), 0, 5, rows,
                             &residuals, &jacobian),
              WindowSimulator::Outcome::kDiverged);
  }
}

TEST(EvaluateWindow, CompressesRowsOfSilhouettesWithoutLoss) {
  SilhouetteScene known = MakeSilhouetteScene(), hidden = MakeSilhouetteScene(true);
  known.config.loss = LossKind::kHuber;
  known.config.loss_scale = 0.5;
  ExpectTheSameSums(known.scene, known.config, 8);
  ExpectTheSameSums(hidden.scene, hidden.config, 8);
}

}  // namespace
}  // namespace clothfit
