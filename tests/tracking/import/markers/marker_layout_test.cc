// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/marker_layout.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/motive_file.h"

namespace clothfit {
namespace {

using Points = std::vector<Eigen::Vector2d>;

// On no grid, spread over 0.30 x 0.24 m about the middle.
const Points kScattered = {{-0.15, -0.12}, {0.15, -0.11}, {0.01, -0.07},
                           {-0.14, 0.02},  {0.13, 0.00},  {0.03, 0.05},
                           {-0.12, 0.115}, {0.02, 0.12},  {0.15, 0.10}};

Points Grid(int columns, int rows, double spacing_u, double spacing_v) {
  Points uv;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      uv.emplace_back(column * spacing_u, row * spacing_v);
    }
  }
  return uv;
}

Points Turned(const Points& uv, double angle) {
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  Points turned;
  for (const Eigen::Vector2d& point : uv) turned.emplace_back(turn * point);
  return turned;
}

std::vector<Eigen::Vector3d> Lying(const Points& uv) {
  std::vector<Eigen::Vector3d> positions;
  for (const Eigen::Vector2d& point : uv) positions.emplace_back(point.x(), point.y(), 0.0);
  return positions;
}

Eigen::MatrixXd DistancesOf(const MarkerTake& take) {
  std::vector<HandleDescription::Path> paths;
  for (const MarkerPath& marker : take.markers) paths.push_back(marker.positions);
  return LargestDistances(paths);
}

std::vector<size_t> All(const Points& uv) {
  std::vector<size_t> all;
  for (size_t i = 0; i < uv.size(); ++i) all.push_back(i);
  return all;
}

TEST(LargestDistances, AreNoneWherePairsAreNeverSeenTogether) {
  using Path = HandleDescription::Path;
  const Path a = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0, 0, 0), std::nullopt};
  const Path b = {Eigen::Vector3d(0, 3, 4), Eigen::Vector3d(0, 1, 0), std::nullopt};
  const Path c = {std::nullopt, std::nullopt, Eigen::Vector3d(0, 0, 0)};
  const Eigen::MatrixXd distances = LargestDistances({a, b, c});
  EXPECT_DOUBLE_EQ(distances(0, 1), 5.0);
  EXPECT_DOUBLE_EQ(distances(1, 0), 5.0);
  EXPECT_LT(distances(0, 2), 0.0);
}

TEST(FindFlatLayout, FlattensASheetThatIsNeverFlat) {
  const Eigen::MatrixXd distances = DistancesOf(BentSheetTake(kScattered));
  const Points uv = FindFlatLayout(distances);
  // The axis of the bend comes in steps of 3 degrees: of no pair is the largest distance short by
  // more than a micrometre.
  const double difference =
      std::min(LayoutDifference(uv, kScattered), LayoutDifference(uv, kScattered, true));
  EXPECT_LT(difference, 2e-6);
  EXPECT_LT(CompareLayout(uv, distances).rms, 2e-6);
  EXPECT_LT(CompareLayout(uv, distances).largest_stretch, 1e-4);
}

TEST(FindFlatLayout, DoesWithoutPairsThatWereNeverSeenTogether) {
  Eigen::MatrixXd distances = DistancesOf(BentSheetTake(kScattered));
  for (const auto& [i, j] : {std::pair(0, 8), std::pair(1, 6), std::pair(2, 7)}) {
    distances(i, j) = distances(j, i) = -1.0;
  }
  const Points uv = FindFlatLayout(distances);
  EXPECT_LT(std::min(LayoutDifference(uv, kScattered), LayoutDifference(uv, kScattered, true)),
            2e-4);
}

TEST(FindFlatLayout, DoesNotFollowOneDistanceThatIsTooShort) {
  Eigen::MatrixXd distances = DistancesOf(BentSheetTake(kScattered));
  distances(0, 8) = distances(8, 0) = 0.6 * distances(0, 8);  // the cloth was never taut there
  const Points uv = FindFlatLayout(distances);
  // Of the 150 mm that are missing, all but a few have to be refused.
  EXPECT_LT(std::min(LayoutDifference(uv, kScattered), LayoutDifference(uv, kScattered, true)),
            5e-3);
}

TEST(SnapToGrid, FindsTheGridInATurnedAndNoisyLayout) {
  const Points exact = Turned(Grid(4, 3, 0.1, 0.08), 0.7);
  Points noisy = exact;
  for (size_t i = 0; i < noisy.size(); ++i) {
    noisy[i] += 0.001 * Eigen::Vector2d(std::sin(3.0 * double(i)), std::cos(5.0 * double(i)));
  }
  const std::optional<MarkerGrid> grid = SnapToGrid(All(noisy), &noisy);
  ASSERT_TRUE(grid);
  EXPECT_EQ(grid->count.prod(), 12);
  EXPECT_EQ(grid->count.maxCoeff(), 4);
  EXPECT_NEAR(grid->spacing.maxCoeff(), 0.1, 5e-4);  // a millimetre over some markers
  EXPECT_NEAR(grid->spacing.minCoeff(), 0.08, 5e-4);
  EXPECT_LT(grid->rms, 1.5e-3);
  EXPECT_LT(LayoutDifference(noisy, exact), 1e-3);
}

TEST(SnapToGrid, LeavesOtherLayoutsAlone) {
  Points uv = kScattered;
  EXPECT_FALSE(SnapToGrid(All(uv), &uv));
  EXPECT_EQ(uv, kScattered);
}

TEST(SnapToGrid, MovesNoneButItsMembers) {
  Points uv = Grid(3, 2, 0.1, 0.1);
  uv.insert(uv.begin(), {-0.017, -0.031});
  const std::optional<MarkerGrid> grid = SnapToGrid({1, 2, 3, 4, 5, 6}, &uv);
  ASSERT_TRUE(grid);
  EXPECT_LT(grid->rms, 1e-12);
  EXPECT_EQ(uv[0], Eigen::Vector2d(-0.017, -0.031));
}

// However a layout comes, the same comes out of it.
TEST(OrientLayout, DoesNotDependOnTheOrientationBefore) {
  const Points exact = Grid(4, 3, 0.1, 0.08);
  const std::vector<Eigen::Vector3d> positions = Lying(exact);
  int checked = 0;
  for (const bool mirror : {false, true}) {
    for (int step = 0; step < 12; ++step) {
      Points uv = Turned(exact, 0.1 + step * M_PI / 6.0);
      for (Eigen::Vector2d& point : uv) point.y() *= mirror ? -1.0 : 1.0;
      OrientLayout({}, positions, nullptr, &uv);
      for (size_t i = 0; i < uv.size(); ++i) EXPECT_LT((uv[i] - exact[i]).norm(), 1e-9);
      ++checked;
    }
  }
  EXPECT_EQ(checked, 24);
}

TEST(OrientLayout, TellsTheGridInTheOrderOfUAndV) {
  const Points exact = Grid(4, 3, 0.1, 0.08);
  int checked = 0;
  for (const double angle : {0.2, 0.2 + 0.5 * M_PI}) {
    Points uv = Turned(exact, angle);
    std::optional<MarkerGrid> grid = SnapToGrid(All(uv), &uv);
    ASSERT_TRUE(grid);
    OrientLayout({}, Lying(exact), &*grid, &uv);
    EXPECT_EQ(grid->count, Eigen::Vector2i(4, 3));
    EXPECT_LT((grid->spacing - Eigen::Vector2d(0.1, 0.08)).norm(), 1e-12);
    for (size_t i = 0; i < uv.size(); ++i) EXPECT_LT((uv[i] - exact[i]).norm(), 1e-9);
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

TEST(OrientLayout, FrontOfALyingClothLooksUp) {
  const Points below = Grid(4, 3, 0.1, 0.08);
  std::vector<Eigen::Vector3d> positions = Lying(below);
  for (Eigen::Vector3d& position : positions) position.y() *= -1.0;  // seen from below
  Points uv = below;
  OrientLayout({}, positions, nullptr, &uv);
  EXPECT_LT((uv[0] - Eigen::Vector2d(0.0, 0.16)).norm(), 1e-9);
  EXPECT_GT(LayoutDifference(uv, below), 0.05);
  EXPECT_LT(LayoutDifference(uv, below, true), 1e-9);
}

TEST(OrientLayout, TwoHandlesGiveTheDirections) {
  const Points exact = Grid(3, 4, 0.1, 0.09);
  const std::vector<Eigen::Vector3d> positions = Lying(exact);
  Points uv = Turned(exact, 1.0);
  OrientLayout({0, 2}, positions, nullptr, &uv);
  for (size_t i = 0; i < uv.size(); ++i) EXPECT_LT((uv[i] - exact[i]).norm(), 1e-9);
  uv = Turned(exact, 1.0);
  OrientLayout({2, 0}, positions, nullptr, &uv);  // the cloth stays at v > 0 all the same
  EXPECT_LT((uv[2] - Eigen::Vector2d(0.0, 0.0)).norm(), 1e-9);
  EXPECT_LT((uv[0] - Eigen::Vector2d(0.2, 0.0)).norm(), 1e-9);
  EXPECT_LT((uv[11] - Eigen::Vector2d(0.0, 0.27)).norm(), 1e-9);
}

TEST(OrientLayout, HandlesAtOppositeCornersDoNotTurnTheSides) {
  const Points exact = Grid(3, 3, 0.1, 0.09);
  Points uv = Turned(exact, 0.3);
  OrientLayout({0, 8}, Lying(exact), nullptr, &uv);
  for (size_t i = 0; i < uv.size(); ++i) EXPECT_LT((uv[i] - exact[i]).norm(), 1e-9);
}

}  // namespace
}  // namespace clothfit
