// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/script_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "autodiff_sim/base/printable.h"
#include "fitting/files/version.h"

namespace clothfit {

std::string FillIn(const std::string& text, const std::map<std::string, std::string>& values) {
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '@' ? text.find('@', at + 1) : std::string::npos;
    const auto value =
        end == std::string::npos ? values.end() : values.find(text.substr(at + 1, end - at - 1));
    if (value == values.end()) {
      filled += text[at++];
      continue;
    }
    filled += value->second;
    at = end + 1;
  }
  return filled;
}

// JSON's escapes are Python's too.
std::string AsPythonText(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

std::string AsTuples(const Eigen::VectorXd& numbers) {
  std::string text;
  for (Eigen::Index i = 0; i < numbers.size(); i += 3)
    text += fmt::format("{}({:.7g}, {:.7g}, {:.7g})", i == 0 ? "" : ", ", numbers[i],
                        numbers[i + 1], numbers[i + 2]);
  return text;
}

std::string AsTuples(const std::vector<Eigen::Vector3d>& points) {
  Eigen::VectorXd numbers(3 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    numbers.segment<3>(3 * static_cast<Eigen::Index>(i)) = points[i];
  return AsTuples(numbers);
}

std::string PathsInPython(const RunCloth& cloth) {
  std::string text;
  for (const PinnedParticle& pin : cloth.pins) {
    std::vector<Eigen::Vector3d> path;
    for (const Eigen::VectorXd& x : cloth.motion.frames)
      path.emplace_back(x.segment<3>(3 * pin.particle));
    text += fmt::format("    {}: [{}],\n", pin.particle, AsTuples(path));
  }
  return text;
}

std::string Digits(double value) { return fmt::format("{:.7g}", value); }

std::string AsComments(const std::vector<std::string>& sentences, const std::string& begin) {
  std::string text;
  for (const std::string& sentence : sentences)
    text += begin + Printable(sentence, sentence.size() * 8 + 1) + "\n";
  return text.empty() ? begin + "nothing\n" : text;
}

std::map<std::string, std::string> ValuesOfCloth(const RunCloth& cloth) {
  const ClothMaterial& material = cloth.material;
  const Eigen::Vector3d& g = cloth.gravity;
  return {{"NAME", AsPythonText(cloth.motion.name)},
          {"VERSION", Version()},
          {"RATE", Digits(cloth.motion.frame_rate)},
          {"FRAMES", std::to_string(cloth.motion.frames.size())},
          {"GRAVITY", fmt::format("{:.7g}, {:.7g}, {:.7g}", g.x(), g.y(), g.z())},
          {"START", AsTuples(cloth.motion.frames[0])},
          {"REST", AsTuples(cloth.rest)},
          {"PINS", PathsInPython(cloth)},
          {"LEFT_OUT", AsComments(cloth.left_out, "# - ")},
          {"STRETCH", Digits(material.stretch)},
          {"PLATE", Digits(material.bending)},
          {"DRAG_NORMAL", Digits(material.drag_normal)},
          {"FRICTION", Digits(cloth.ground_friction)}};
}

}  // namespace clothfit
