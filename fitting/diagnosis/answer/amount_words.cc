// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/amount_words.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <fmt/format.h>

#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/diagnosis/locate/discrepancy_text.h"

namespace clothfit {
namespace {

constexpr double kDegrees = 180.0 / M_PI;
constexpr double kNothingBeside = 0.1;  // of the largest of the same unit

std::string WithUnit(const EffectParameter& p, double factor, const std::string& unit) {
  const std::string text = fmt::format("{:.3g}{}", factor * p.value, unit);
  if (!std::isfinite(p.lower90) || !std::isfinite(p.upper90)) return text;
  return text + fmt::format(" ({:.3g} to {:.3g})", factor * p.lower90, factor * p.upper90);
}

// x, y and z of a term's amounts in one unit.
bool IsVector(const std::vector<EffectParameter>& amounts) {
  if (amounts.size() != 3) return false;
  const char* const ends[] = {".x", ".y", ".z"};
  for (std::size_t k = 0; k < amounts.size(); ++k) {
    const std::string& name = amounts[k].name;
    if (name.substr(name.size() - std::min<std::size_t>(2, name.size())) != ends[k]) return false;
  }
  return amounts[0].unit == amounts[1].unit && amounts[1].unit == amounts[2].unit;
}

bool IsTilt(const std::vector<EffectParameter>& amounts) {
  return amounts.size() == 2 && amounts[0].unit == "rad" && amounts[1].unit == "rad";
}

// A place in the world by its three numbers, from the first of them on.
bool IsPlace(const std::vector<EffectParameter>& shapes, std::size_t first) {
  constexpr Meaning kPlace[] = {Meaning::kPlaceX, Meaning::kPlaceY, Meaning::kPlaceZ};
  for (std::size_t k = 0; k < 3; ++k) {
    if (first + k >= shapes.size() || ParameterNamed(shapes[first + k].name).meaning != kPlace[k])
      return false;
  }
  return true;
}

// With a direction where there is one; empty where they are several.
std::string AsOneNumber(const std::vector<EffectParameter>& amounts) {
  if (IsTilt(amounts)) return Alone(SizeOf(amounts));
  if (!IsVector(amounts)) return "";
  const EffectParameter size = SizeOf(amounts);
  if (!(size.value > 0.0)) return Alone(size);
  const Eigen::Vector3d along(amounts[0].value, amounts[1].value, amounts[2].value);
  return Alone(size) + " along " + DirectionText(along / size.value);
}

}  // namespace

std::string Alone(const EffectParameter& p) {
  const bool is_angle = p.unit == "rad";
  const bool is_bare = p.unit == "1" || p.unit.empty();
  return WithUnit(p, is_angle ? kDegrees : 1.0,
                  is_angle  ? " degrees"
                  : is_bare ? ""
                            : " " + p.unit);
}

EffectParameter SizeOf(const std::vector<EffectParameter>& parts) {
  EffectParameter size{"", parts.front().unit};
  double squares = 0.0, below = 0.0, above = 0.0;
  for (const EffectParameter& p : parts) squares += p.value * p.value;
  size.value = std::sqrt(squares);
  for (const EffectParameter& p : parts) {
    const double along = size.value > 0.0 ? p.value / size.value : 1.0;
    const double down = p.value - p.lower90, up = p.upper90 - p.value;
    below += std::pow(along * (along > 0.0 ? down : up), 2);
    above += std::pow(along * (along > 0.0 ? up : down), 2);
  }
  size.lower90 = std::max(0.0, size.value - std::sqrt(below));
  size.upper90 = size.value + std::sqrt(above);
  return size;
}

std::string AmountsOfTerm(const std::vector<EffectParameter>& amounts) {
  std::string words = AsOneNumber(amounts);
  if (!words.empty()) return words;
  for (const EffectParameter& p : amounts) {
    const auto is_larger = [&](const EffectParameter& other) {
      return other.unit == p.unit && std::abs(p.value) < kNothingBeside * std::abs(other.value);
    };
    if (std::any_of(amounts.begin(), amounts.end(), is_larger)) continue;
    words += (words.empty() ? "" : ", ") + Alone(p) + " " + ParameterNamed(p.name).doc;
  }
  return words;
}

std::string ShapesOfTerm(const std::vector<EffectParameter>& shapes) {
  std::string words;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string doc = ParameterNamed(shapes[i].name).doc;
    words += words.empty() ? "" : ", ";
    if (i + 1 < shapes.size() && ParameterNamed(shapes[i].name).meaning == Meaning::kTilt) {
      words += "turned by " + Alone(SizeOf({shapes[i], shapes[i + 1]}));
      ++i;
      continue;
    }
    if (!IsPlace(shapes, i)) {
      words += fmt::format("{} {}", shapes[i].name.substr(shapes[i].name.find('.') + 1),
                           Alone(shapes[i]));
      continue;
    }
    const auto error = [&](std::size_t k) {
      return 0.5 * (shapes[i + k].upper90 - shapes[i + k].lower90);
    };
    words += fmt::format("{} at ({:.3f}, {:.3f}, {:.3f}) m", doc, shapes[i].value,
                         shapes[i + 1].value, shapes[i + 2].value);
    const auto within = [&](std::size_t k) {
      return std::isfinite(error(k)) ? fmt::format("{:.2g}", error(k)) : std::string("any");
    };
    if (std::isfinite(error(0)) || std::isfinite(error(1)) || std::isfinite(error(2)))
      words += fmt::format(" within ({}, {}, {}) m", within(0), within(1), within(2));
    i += 2;
  }
  return words;
}

std::string FirstPlace(const std::vector<EffectParameter>& shapes) {
  for (std::size_t i = 0; i + 2 < shapes.size(); ++i) {
    if (IsPlace(shapes, i))
      return fmt::format("{} at ({:.2f}, {:.2f}, {:.2f}) m", ParameterNamed(shapes[i].name).doc,
                         shapes[i].value, shapes[i + 1].value, shapes[i + 2].value);
  }
  return "";
}

}  // namespace clothfit
