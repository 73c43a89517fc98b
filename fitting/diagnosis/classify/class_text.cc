// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/classify/class_text.h"

#include <vector>

#include <fmt/format.h>

#include "autodiff_sim/mesh/cloth_box.h"
#include "fitting/diagnosis/locate/discrepancy_text.h"

namespace clothfit {

ActingClass ClassOfActing(const Scene& scene, const ActingForce& force) {
  constexpr double kNothing = 0.05;  // of the sum without signs
  constexpr double kMostly = 0.9;    // of the work
  constexpr double kOneWay = 0.7;    // of the force: it has a direction
  ActingClass found;
  found.is_internal = force.net_force_share < kNothing && force.net_moment_share < kNothing;
  const double work = force.work_in + force.work_out;
  found.is_dissipative = force.work_out > kMostly * work;
  found.is_driving = force.work_in > kMostly * work;
  const bool is_always = force.first_frame <= 1 && force.last_frame >= scene.last_fitted_frame - 1;
  const std::string when =
      is_always ? "all the time"
                : fmt::format("between {:.2f} s and {:.2f} s", scene.FrameTime(force.first_frame),
                              scene.FrameTime(force.last_frame));
  const ClothBox cloth = BoxOf(scene.mesh);
  const double length = force.mean_direction.norm();
  const std::string along =
      length > kOneWay ? ", mostly along " + DirectionText(force.mean_direction / length) : "";
  found.words = fmt::format(
      "In the fitted model it acts {} on {}, with {:.2g} N/m^2 where it is strongest{}.", when,
      RegionText(cloth.low, cloth.high, force.low_uv, force.high_uv), force.peak, along);
  found.words += found.is_internal ? " It is the cloth's own: no net force, no net moment"
                                   : " It comes from outside the cloth";
  if (found.is_dissipative) found.words += ", and takes energy out of the motion";
  if (found.is_driving) found.words += ", and drives the motion";
  found.words += ".";
  return found;
}

std::string ClassText(const DiscrepancyClass& c) {
  std::vector<std::string> parts;
  if (c.is_from_outside) parts.emplace_back("comes from outside the cloth");
  if (c.is_dissipative) parts.emplace_back("takes energy out of the motion");
  if (c.is_driving) parts.emplace_back("drives the motion");
  if (c.tied_to == "world")
    parts.emplace_back("is the same wherever the cloth is or hangs on the place in the world");
  if (c.tied_to == "material") parts.emplace_back("sits at a place of the cloth");
  if (c.tied_to == "contact") parts.emplace_back("acts where the cloth is near the ground");
  if (c.tied_to == "clock") parts.emplace_back("acts for a time only");
  std::string words;
  for (std::size_t i = 0; i < parts.size(); ++i)
    words += (i == 0 ? "The missing force " : i + 1 < parts.size() ? ", " : " and ") + parts[i];
  if (!words.empty()) words += ".";
  if (c.is_from_outside) return words;
  return words + (words.empty() ? "" : " ") +
         "Whether it is the cloth's own or comes from outside cannot be told from this recording.";
}

}  // namespace clothfit
