// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/discrepancy_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace clothfit {

std::string DirectionText(const Eigen::Vector3d& direction) {
  constexpr double kNear = 0.94;  // cosine of 20 degrees
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  if (std::abs(direction[axis]) >= kNear)
    return std::string(direction[axis] > 0.0 ? "+" : "-") + "xyz"[axis];
  return fmt::format("({:.2f}, {:.2f}, {:.2f})", direction.x(), direction.y(), direction.z());
}

std::string RegionText(const Eigen::Vector2d& cloth_low, const Eigen::Vector2d& cloth_high,
                       const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  const Eigen::Vector2d size = cloth_high - cloth_low;
  std::array<std::string, 2> side;  // empty: all along this axis
  int parts = 0, middles = 0;
  for (int axis = 0; axis < 2; ++axis) {
    const double a = (low[axis] - cloth_low[axis]) / size[axis];
    const double b = (high[axis] - cloth_low[axis]) / size[axis];
    if (b - a > 0.8) continue;
    const double middle = 0.5 * (a + b);
    const bool is_middle = std::abs(middle - 0.5) < 0.15;
    const std::string name = axis == 0 ? "u" : "v";
    side[axis] = is_middle ? "" : (middle < 0.5 ? "low " : "high ") + name;
    ++parts;
    middles += is_middle ? 1 : 0;
  }
  if (parts == 0) return "the whole cloth";
  const std::string numbers = fmt::format(" (u {:.2f} to {:.2f} m, v {:.2f} to {:.2f} m)", low.x(),
                                          high.x(), low.y(), high.y());
  if (middles == parts) return "the cloth's middle" + numbers;
  const std::string both = side[0].empty() || side[1].empty() ? "" : " and ";
  return "the part at " + side[0] + both + side[1] + numbers;
}

std::string DiscrepancyText(const Scene& scene, const ForceLayout& layout, int last_frame,
                            const Discrepancy& discrepancy) {
  if (!discrepancy.is_significant) {
    return fmt::format(
        "No force is missing that shows: what the map has at its strongest, {:.2g} N/m^2, is seen "
        "in {:.0f} of 100 recordings without any.",
        discrepancy.peak, 100.0 * discrepancy.p_value);
  }
  const int margin = layout.frames_per_knot;
  const bool is_always =
      discrepancy.first_frame <= margin && discrepancy.last_frame >= last_frame - margin;
  const std::string when = is_always ? "all the time"
                                     : fmt::format("between {:.2f} s and {:.2f} s",
                                                   scene.FrameTime(discrepancy.first_frame),
                                                   scene.FrameTime(discrepancy.last_frame));
  const std::string where =
      RegionText(layout.low, layout.high, discrepancy.low_uv, discrepancy.high_uv);
  const bool has_peak = discrepancy.peak > discrepancy.peak_sigma;
  if (!has_peak && !(discrepancy.even > 2.0 * discrepancy.even_sigma)) {
    return fmt::format(
        "By the map of the missing force, {} something acts on {} that the baseline does not have; "
        "by how much, and which way, this recording cannot tell.",
        when, where);
  }
  const std::string along =
      discrepancy.direction.norm() > 0.0 ? " along " + DirectionText(discrepancy.direction) : "";
  if (has_peak) {
    return fmt::format(
        "By the map of the missing force, {} {} is pushed{} with up to {:.2g} N/m^2 (+- {:.1g}) "
        "more than the baseline has.",
        when, where, along, discrepancy.peak, discrepancy.peak_sigma);
  }
  return fmt::format(
      "By the map of the missing force, {} {} is pushed{} with {:.2g} N/m^2 (+- {:.1g}) more than "
      "the baseline has, if evenly; where most this recording cannot tell.",
      when, where, along, discrepancy.even, discrepancy.even_sigma);
}

}  // namespace clothfit
