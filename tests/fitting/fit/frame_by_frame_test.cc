// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/fit/frame_by_frame.h"

#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/fit.h"
#include "tests/support/silhouette_scene.h"

namespace clothfit {
namespace {

// m, root mean square over handles and frames.
double PathError(const SilhouetteScene& known, const FrameByFrameResult& found) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t h = 0; h < known.true_paths.size(); ++h) {
    for (std::size_t f = 0; f < found.paths[h].size(); ++f, ++count) {
      sum += (found.paths[h][f].position - known.true_paths[h][f]).squaredNorm();
    }
  }
  return std::sqrt(sum / count);
}

// The truth's fabric is known, the handles' paths are not: derivatives find them from silhouettes,
// a search without derivatives does with more simulations.
TEST(FrameByFrame, FindsTheHandles) {
  SilhouetteScene known = MakeSilhouetteScene(true);
  for (const auto& [name, value] : known.truth) known.config.parameters.at(name).value = value;
  const FreeParameters free(known.config, known.scene, MakeParameterTable());
  FrameByFrameOptions options;
  options.optimiser = "lm";
  FrameByFrame by_derivatives(known.scene, known.config, free, options, nullptr);
  const FrameByFrameResult lm = by_derivatives.Run(free.start());
  ASSERT_TRUE(lm.complete);
  options.optimiser = "pattern";
  FrameByFrame by_search(known.scene, known.config, free, options, nullptr);
  const FrameByFrameResult pattern = by_search.Run(free.start());
  ASSERT_TRUE(pattern.complete);
  EXPECT_LT(PathError(known, lm), 0.002);  // a pixel is 4 mm
  EXPECT_LT(PathError(known, pattern), 0.01);
  EXPECT_LT(lm.error, pattern.error);
  EXPECT_GT(pattern.simulated_frames, 5.0 * lm.simulated_frames);
}

// One loop: each frame has a fabric of its own.
TEST(FrameByFrame, FitsTheFabricOfEachFrameToo) {
  const SilhouetteScene known = MakeSilhouetteScene(true);
  const FreeParameters free(known.config, known.scene, MakeParameterTable());
  FrameByFrameOptions options;
  options.optimiser = "lm";
  FrameByFrame handles_only(known.scene, known.config, free, options, nullptr);
  const FrameByFrameResult without = handles_only.Run(free.start());
  options.fabric = true;
  FrameByFrame all(known.scene, known.config, free, options, nullptr);
  const FrameByFrameResult with = all.Run(free.start());
  ASSERT_TRUE(without.complete && with.complete);
  EXPECT_LT(with.error, without.error);  // there is more to fit with
  EXPECT_EQ(without.theta, free.start());
  EXPECT_NE(with.theta, free.start());
  for (int i = 0; i < free.size(); ++i) {
    EXPECT_GE(with.theta[i], free.entries()[i].lower);
    EXPECT_LE(with.theta[i], free.entries()[i].upper);
  }
}

// It is the same whatever was tried before, and can be stopped.
TEST(FrameByFrame, CanBeRepeatedAndStopped) {
  const SilhouetteScene known = MakeSilhouetteScene(true);
  const FreeParameters free(known.config, known.scene, MakeParameterTable());
  FrameByFrameOptions options;
  options.optimiser = "lm";
  std::atomic<bool> stop = false;
  FrameByFrame search(known.scene, known.config, free, options, &stop);
  const FrameByFrameResult once = search.Run(free.start());
  Eigen::VectorXd other = free.start();
  other[0] += 0.5;
  search.Run(other);
  EXPECT_EQ(search.Run(free.start()).error, once.error);
  stop = true;
  EXPECT_FALSE(search.Run(free.start()).complete);
}

// From silhouettes alone, of a cloth whose fabric and whose handles' paths nobody knows.
TEST(FrameByFrame, IsWhereAFitOfHiddenHandlesBegins) {
  const SilhouetteScene known = MakeSilhouetteScene(true);
  FitConfig config = known.config;
  config.max_iterations = 15;
  const FreeParameters free(config, known.scene, MakeParameterTable());
  const FitResult fit = RunFit(known.scene, config);
  EXPECT_GT(known.SurfaceError(free.start()), 0.05);
  EXPECT_LT(known.SurfaceError(fit.theta), 0.004);  // a pixel
}

}  // namespace
}  // namespace clothfit
