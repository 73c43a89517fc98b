// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The study of meshes on a small scale, and its order of convergence.
#include "fitting/studies/mesh_study.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::HasSubstr;

TEST(MeshStudy, OrderIsTheSlopeOfLogarithms) {
  std::vector<MeshCase> cases;
  for (const int n : {9, 17, 33}) {
    cases.push_back({"swung", n, false, {3.0 * std::pow(n - 1, -2.0), 0.0}, {NAN, NAN}, 0, 0.0});
    cases.push_back({"swung", n, true, {0.2 * std::pow(n - 1, -1.0), 0.0}, {NAN, NAN}, 0, 0.0});
  }
  cases.push_back({"swung", 65, true, {NAN, NAN}, {NAN, NAN}, 0, 0.0});  // did not get there
  EXPECT_NEAR(OrderOfConvergence(cases, "swung", false), 2.0, 1e-9);
  EXPECT_NEAR(OrderOfConvergence(cases, "swung", true), 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(OrderOfConvergence(cases, "lifted", true)));
}

// Truth by the simulation that is judged, on the finest of the meshes: it meets it there.
TEST(MeshStudy, CoarseMeshesAreFartherFromTheTruth) {
  MeshStudyOptions options;
  options.particles = {5, 9};
  options.truth_cells = 16;
  options.frame_count = 20;
  options.fit = false;
  int told = 0;
  const std::vector<MeshCase> cases = RunMeshStudy(options, [&](const MeshCase&) { ++told; });
  ASSERT_EQ(cases.size(), 16u);
  EXPECT_EQ(told, 16);
  for (std::size_t i = 0; i < cases.size(); i += 2) {
    EXPECT_EQ(cases[i].particles, 5);
    EXPECT_GT(cases[i].at_truth.fitted, cases[i + 1].at_truth.fitted) << cases[i].motion;
    EXPECT_LT(cases[i + 1].at_truth.fitted, 0.09) << cases[i].motion;  // a tenth of a side
    EXPECT_TRUE(std::isnan(cases[i].after_fit.fitted));
  }
  EXPECT_THAT(MeshStudyAsMarkdown(cases), HasSubstr("| one corner lifted | plain | 5 |"));
  EXPECT_THAT(MeshStudyAsCsv(cases), HasSubstr("shaken in wind,buckling,9,0.11250,"));
  EXPECT_THAT(MeshStudyAsSvg(cases), HasSubstr("spacing, mm"));
}

}  // namespace
}  // namespace clothfit
