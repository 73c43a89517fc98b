// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The formulae of the synthetic motions.
#include "tracking/synthetic/motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLying = 0.002;  // m above the ground

const std::vector<std::pair<std::string, SyntheticScenario>>& NamedScenarios() {
  static const std::vector<std::pair<std::string, SyntheticScenario>> names = {
      {"two-corner-swing", SyntheticScenario::kTwoCornerSwing},
      {"corner-lift", SyntheticScenario::kCornerLift},
      {"two-corner-lift", SyntheticScenario::kTwoCornerLift},
      {"two-corner-shake", SyntheticScenario::kTwoCornerShake},
      {"two-corner-turn", SyntheticScenario::kTwoCornerTurn},
      {"four-corner-sag", SyntheticScenario::kFourCornerSag}};
  return names;
}

// From 0 to 1 while s goes from 0 to 1, with two vanishing derivatives at both ends.
double SmoothStep(double s) {
  const double t = std::clamp(s, 0.0, 1.0);
  return t * t * t * (10.0 + t * (6.0 * t - 15.0));
}

// 1 in the middle of the recording, 0 at both its ends.
double Envelope(double time, double duration) {
  constexpr double kRamp = 0.2;  // of the duration
  return SmoothStep(time / (kRamp * duration)) * SmoothStep((duration - time) / (kRamp * duration));
}

// Hanging in the plane y = 0 below the height 0, with u along x.
FlatPlacement Hanging(const Vector2d& size) {
  return {Vector3d(-0.5 * size.x(), 0.0, 0.0), Vector3d::UnitX(), Vector3d(0.0, 0.0, -1.0)};
}

// Hangs in the plane y = 0 below the height 0. Both corners move to and fro (y), up and down (z)
// and sideways (x); against each other they turn and come closer. Gentle enough that the cloth does
// not crumple: where it does, a recording tells of its start and little of its parameters.
SyntheticMotion TwoCornerSwing(const Vector2d& size, double duration) {
  SyntheticMotion motion;
  motion.initial = Hanging(size);
  const double length = size.y(), width = size.x();
  for (const double side : {-1.0, 1.0}) {
    const auto path = [=](double time) {
      const double amount = Envelope(time, duration), t = 2.0 * M_PI * time;
      const double closer = 0.02 * width * std::pow(std::sin(0.4 * t), 2);
      const double turn = 0.05 * width * std::sin(1.3 * t);
      const Vector3d moved(0.04 * length * std::sin(0.9 * t) - side * closer,
                           0.12 * length * std::sin(0.9 * t) + side * turn,
                           0.05 * length * std::sin(1.7 * t));
      return Vector3d(Vector3d(0.5 * side * width, 0.0, 0.0) + amount * moved);
    };
    const bool left = side < 0.0;
    motion.handles.push_back({left ? "left" : "right", Vector2d(left ? 0.0 : width, 0.0), path});
  }
  return motion;
}

// Lies flat; the corner (0, 0) goes up and a little towards the opposite one, and then swings, for
// the most part sideways. Not so far that what hangs from it would pass through itself.
SyntheticMotion CornerLift(const Vector2d& size, double duration) {
  SyntheticMotion motion;
  motion.ground_height = 0.0;
  motion.initial = {Vector3d(0.0, 0.0, kLying), Vector3d::UnitX(), Vector3d::UnitY()};
  const auto path = [=](double time) {
    const double s = time / duration, length = size.norm(),
                 t = 2.0 * M_PI * (time - 0.4 * duration);
    const double swing = SmoothStep((s - 0.4) / 0.2);
    const Vector2d along = size / length, aside(-along.y(), along.x());
    const Vector2d across =
        length *
        ((0.23 * SmoothStep((s - 0.1) / 0.45) + 0.03 * swing * std::sin(0.55 * t)) * along +
         0.05 * swing * std::sin(0.8 * t) * aside);
    const double height = length * (0.45 * SmoothStep(s / 0.5) + 0.02 * swing * std::sin(1.1 * t));
    return Vector3d(across.x(), across.y(), kLying + height);
  };
  motion.handles.push_back({"corner", Vector2d::Zero(), path});
  return motion;
}

// Lies flat; the corners of the edge v = 0 go up and over, one a little ahead of the other, and
// swing along v at the end.
SyntheticMotion TwoCornerLift(const Vector2d& size, double duration) {
  SyntheticMotion motion;
  motion.ground_height = 0.0;
  motion.initial = {Vector3d(0.0, 0.0, kLying), Vector3d::UnitX(), Vector3d::UnitY()};
  for (const double u : {0.0, size.x()}) {
    const double ahead = u > 0.0 ? 0.0 : 0.05;
    const auto path = [=](double time) {
      const double s = time / duration + ahead * SmoothStep(time / (0.2 * duration));
      const double lift = SmoothStep(s / 0.5);
      const double swing = 0.1 * size.y() * SmoothStep((s - 0.4) / 0.2) *
                           std::sin(2.0 * M_PI * 0.9 * (time - 0.4 * duration));
      const double closer = (u > 0.0 ? -0.03 : 0.03) * size.x() * lift;
      return Vector3d(u + closer, 0.35 * size.y() * lift + swing, kLying + 0.75 * size.y() * lift);
    };
    motion.handles.push_back({u > 0.0 ? "right" : "left", Vector2d(u, 0.0), path});
  }
  return motion;
}

// Hangs as above; both corners shake to and fro (y) and up and down (z), a little closer than taut.
// What goes with the speed or its square shows here, beside the slow swing.
SyntheticMotion TwoCornerShake(const Vector2d& size, double duration) {
  SyntheticMotion motion;
  motion.initial = Hanging(size);
  const double length = size.y(), width = size.x();
  for (const double side : {-1.0, 1.0}) {
    const auto path = [=](double time) {
      const double amount = Envelope(time, duration), t = 2.0 * M_PI * time;
      const Vector3d moved(-0.02 * width * side, 0.08 * length * std::sin(1.6 * t),
                           0.03 * length * std::sin(2.3 * t));
      return Vector3d(Vector3d(0.5 * side * width, 0.0, 0.0) + amount * moved);
    };
    const bool left = side < 0.0;
    motion.handles.push_back({left ? "left" : "right", Vector2d(left ? 0.0 : width, 0.0), path});
  }
  return motion;
}

// Hangs as above; the corners turn by a quarter about the vertical between them, and sway gently
// along y: what comes from one side of the world meets the cloth face on first, edge on at last.
SyntheticMotion TwoCornerTurn(const Vector2d& size, double duration) {
  SyntheticMotion motion;
  motion.initial = Hanging(size);
  const double length = size.y(), half = 0.5 * size.x();
  for (const double side : {-1.0, 1.0}) {
    const auto path = [=](double time) {
      const double angle = 0.25 * 2.0 * M_PI * SmoothStep((time / duration - 0.15) / 0.6);
      const double sway = 0.04 * length * std::sin(0.7 * 2.0 * M_PI * time);
      return Vector3d(side * half * std::cos(angle),
                      side * half * std::sin(angle) + Envelope(time, duration) * sway, 0.0);
    };
    const bool left = side < 0.0;
    motion.handles.push_back({left ? "left" : "right", Vector2d(left ? 0.0 : size.x(), 0.0), path});
  }
  return motion;
}

// Lies level in the air, held by its four corners, and sags. The corners come closer to the middle
// and rise and sink, those of the edge u = 0 after the others. Weight acts across the cloth here,
// and along it where it hangs.
SyntheticMotion FourCornerSag(const Vector2d& size, double duration) {
  SyntheticMotion motion;
  motion.initial = {Vector3d(-0.5 * size.x(), -0.5 * size.y(), 0.0), Vector3d::UnitX(),
                    Vector3d::UnitY()};
  const double length = size.maxCoeff();
  for (const Vector2d& corner :
       {Vector2d(0.0, 0.0), Vector2d(1.0, 0.0), Vector2d(0.0, 1.0), Vector2d(1.0, 1.0)}) {
    const Vector2d uv = corner.cwiseProduct(size), from_middle = uv - 0.5 * size;
    const auto path = [=](double time) {
      const double closer = 0.06 * SmoothStep(time / (0.4 * duration));
      const double phase = 2.0 * M_PI * (0.8 * time - (corner.x() > 0.5 ? 0.0 : 0.15));
      const double height = 0.06 * length * Envelope(time, duration) * std::sin(phase);
      return Vector3d((1.0 - closer) * from_middle.x(), (1.0 - closer) * from_middle.y(), height);
    };
    const std::string name = std::string(corner.y() > 0.5 ? "far" : "near") + "_" +
                             (corner.x() > 0.5 ? "right" : "left");
    motion.handles.push_back({name, uv, path});
  }
  return motion;
}

}  // namespace

std::vector<std::string> SyntheticScenarioNames() {
  std::vector<std::string> names;
  for (const auto& [name, scenario] : NamedScenarios()) names.push_back(name);
  return names;
}

std::string ToString(SyntheticScenario scenario) {
  for (const auto& [name, value] : NamedScenarios()) {
    if (value == scenario) return name;
  }
  return "unknown";
}

SyntheticScenario ParseSyntheticScenario(const std::string& place, const std::string& name) {
  for (const auto& [known, scenario] : NamedScenarios()) {
    if (known == name) return scenario;
  }
  throw InputError(place, "'" + name + "': " + Suggestion(name, SyntheticScenarioNames()));
}

SyntheticMotion MakeSyntheticMotion(SyntheticScenario scenario, const Vector2d& size,
                                    double duration) {
  switch (scenario) {
    case SyntheticScenario::kCornerLift:
      return CornerLift(size, duration);
    case SyntheticScenario::kTwoCornerLift:
      return TwoCornerLift(size, duration);
    case SyntheticScenario::kTwoCornerShake:
      return TwoCornerShake(size, duration);
    case SyntheticScenario::kTwoCornerTurn:
      return TwoCornerTurn(size, duration);
    case SyntheticScenario::kFourCornerSag:
      return FourCornerSag(size, duration);
    case SyntheticScenario::kTwoCornerSwing:
      break;
  }
  return TwoCornerSwing(size, duration);
}

}  // namespace clothfit
