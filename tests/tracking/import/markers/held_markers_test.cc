// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/held_markers.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace clothfit {
namespace {

// 3 x 3 markers of a sheet, 0.1 m apart, for a second at 120 Hz. The place of each is a function of
// (u, v) and of the time.
template <class Place>
MarkerTake TakeOf(Place place, double noise = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> gaussian;
  MarkerTake take;
  take.frame_rate = 120.0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      MarkerPath path{"m" + std::to_string(3 * row + column), {}};
      for (int frame = 0; frame < 120; ++frame) {
        Eigen::Vector3d position = place(0.1 * column, 0.1 * row, frame / 120.0);
        for (int axis = 0; axis < 3; ++axis) position[axis] += noise * gaussian(random);
        path.positions.emplace_back(position);
      }
      take.markers.push_back(path);
    }
  }
  return take;
}

std::vector<size_t> HeldIn(const MarkerTake& take) {
  return FindHeldMarkers(SupportAtStart(take), take);
}

const std::vector<size_t> kUpperCorners = {0, 2};

TEST(HeldMarkers, AreTheUpperCornersOfAClothThatHangsFromThem) {
  // The upper edge sags between the hands.
  const auto hanging = [](double u, double v, double) {
    return Eigen::Vector3d(u, 0.0, 1.0 - v - 0.2 * u * (0.2 - u));
  };
  EXPECT_EQ(HeldIn(TakeOf(hanging)), kUpperCorners);
  EXPECT_EQ(HeldIn(TakeOf(hanging, 5e-4)), kUpperCorners);
  const std::vector<double> support = SupportAtStart(TakeOf(hanging));
  for (size_t i = 0; i < support.size(); ++i) {
    if (i == 0 || i == 2) {
      EXPECT_GT(support[i], 0.9) << i;
    } else {
      EXPECT_LT(support[i], 0.2) << i;
    }
  }
}

TEST(HeldMarkers, MayMove) {
  const auto swinging = [](double u, double v, double time) {
    const double angle = 0.6 * std::sin(6.0 * time);  // about the line between the hands
    return Eigen::Vector3d(u + 0.2 * time, v * std::sin(angle), 1.0 - v * std::cos(angle));
  };
  EXPECT_EQ(HeldIn(TakeOf(swinging)), kUpperCorners);
}

TEST(HeldMarkers, AreNoneOfAClothThatLies) {
  const auto lying = [](double u, double v, double) { return Eigen::Vector3d(u, v, 0.0); };
  EXPECT_TRUE(HeldIn(TakeOf(lying)).empty());
}

TEST(HeldMarkers, IsTheCornerByWhichALyingClothIsLifted) {
  const auto lifted = [](double u, double v, double) {
    return Eigen::Vector3d(u, v, std::max(0.0, 0.15 - u - v));
  };
  EXPECT_EQ(HeldIn(TakeOf(lifted)), std::vector<size_t>{0});
}

TEST(HeldMarkers, AreNoneOfAClothThatFalls) {
  const auto falling = [](double u, double v, double time) {
    return Eigen::Vector3d(u, v, 2.0 - 0.5 * 9.81 * time * time);
  };
  for (const double support : SupportAtStart(TakeOf(falling))) EXPECT_LT(support, 1e-6);
}

TEST(HeldMarkers, AreNotThoseThatAreNotSeen) {
  MarkerTake take;
  take.frame_rate = 120.0;
  take.markers = {{"a", HandleDescription::Path(120)}, {"b", HandleDescription::Path(120)}};
  EXPECT_EQ(SupportAtStart(take), (std::vector<double>{0.0, 0.0}));
  for (MarkerPath& marker : take.markers) marker.positions.resize(1);
  EXPECT_EQ(SupportAtStart(take), (std::vector<double>{0.0, 0.0}));
}

}  // namespace
}  // namespace clothfit
