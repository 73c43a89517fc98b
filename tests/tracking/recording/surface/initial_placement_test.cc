// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/initial_placement.h"

#include <stdexcept>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

TEST(InitialPositions, OfAFlatPlacementLieOnItsPlane) {
  Recording recording;
  recording.cloth.initial = FlatPlacement{{1, 2, 3}, {0, 1, 0}, {0, 0, -1}};
  const std::vector<Eigen::Vector3d> positions =
      InitialPositions(recording, {{0, 0}, {0.5, 0}, {0.5, 0.25}});
  ASSERT_EQ(positions.size(), 3u);
  EXPECT_EQ(positions[0], Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(positions[1], Eigen::Vector3d(1, 2.5, 3));
  EXPECT_EQ(positions[2], Eigen::Vector3d(1, 2.5, 2.75));
}

TEST(InitialPositions, OfPointsGoThroughThem) {
  Recording recording;
  PointPlacement placement;
  placement.points = {{{0, 0}, {0, 0, 1}},
                      {{1, 0}, {0.9, 0, 1}},
                      {{0, 1}, {0, 0.1, 0}},
                      {{1, 1}, {0.9, -0.1, 0}},
                      {{0.5, 0.6}, {0.45, 0.2, 0.4}}};
  recording.cloth.initial = placement;
  std::vector<Eigen::Vector2d> uv;
  for (const PlacedPoint& point : placement.points) uv.push_back(point.uv);
  const std::vector<Eigen::Vector3d> positions = InitialPositions(recording, uv);
  ASSERT_EQ(positions.size(), 5u);
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_LT((positions[i] - placement.points[i].position).norm(), 1e-13);
  }
}

TEST(InitialPositions, RefusesAMesh) {
  Recording recording;
  recording.cloth.initial = MeshPlacement{"cloth.obj"};
  EXPECT_THROW(InitialPositions(recording, {{0, 0}}), std::logic_error);
}

}  // namespace
}  // namespace clothfit
