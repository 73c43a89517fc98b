// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ranges are checked by SyntheticOptions::Check; here it is only decided what a word means.
#include "tracking/synthetic_keys.h"

#include <algorithm>
#include <utility>

#include "autodiff_sim/error.h"
#include "tracking/text.h"

namespace clothfit {
namespace {

using Words = std::vector<std::string>;
using Kind = SyntheticKey::Kind;

// The place in the options that a key sets.
template <class T>
using Member = std::function<T&(SyntheticOptions&)>;

std::string Parse(const std::string& word, double* value) {
  const std::optional<double> number = ParseNumber(word);
  if (!number) return "'" + word + "': expected a number";
  *value = *number;
  return "";
}

std::string Parse(const std::string& word, int* value) {
  const std::optional<int> number = ParseInteger(word);
  if (!number) return "'" + word + "': expected an integer";
  *value = *number;
  return "";
}

std::string Parse(const std::string& word, std::uint64_t* value) {
  int number = 0;
  if (Parse(word, &number).empty() && number >= 0) {
    *value = static_cast<std::uint64_t>(number);
    return "";
  }
  return "'" + word + "': expected an integer of 0 or more";
}

std::string Format(double value) { return FormatNumber(value); }
std::string Format(int value) { return std::to_string(value); }
std::string Format(std::uint64_t value) { return std::to_string(value); }

SyntheticKey BareKey(std::string name, std::string type, std::string doc) {
  SyntheticKey key;
  key.option = "--" + name;
  std::replace(key.option.begin(), key.option.end(), '_', '-');
  key.name = std::move(name);
  key.type = std::move(type);
  key.doc = std::move(doc);
  return key;
}

template <class T>
SyntheticKey NumberKey(std::string name, std::string type, std::string doc,
                       T& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), std::move(type), std::move(doc));
  key.set = [member](const Words& words, SyntheticOptions* options) {
    return Parse(words[0], &member(*options));
  };
  key.words = [member](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    return Words{Format(member(copy))};
  };
  return key;
}

// Several numbers, in an Eigen vector or an array.
template <class Vector>
SyntheticKey VectorKey(std::string name, std::string type, std::string doc, int count,
                       Vector& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), std::move(type), std::move(doc));
  key.count = count;
  key.set = [member](const Words& words, SyntheticOptions* options) {
    auto* const values = member(*options).data();
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string problem = Parse(words[i], &values[i]);
      if (!problem.empty()) return problem;
    }
    return std::string();
  };
  key.words = [member, count](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    Words words;
    for (int i = 0; i < count; ++i) words.push_back(Format(member(copy).data()[i]));
    return words;
  };
  return key;
}

SyntheticKey FlagKey(std::string name, std::string doc, bool& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), "true|false", std::move(doc));
  key.kind = Kind::kFlag;
  key.set = [member](const Words& words, SyntheticOptions* options) {
    if (words[0] != "true" && words[0] != "false")
      return "'" + words[0] + "': expected true or false";
    member(*options) = words[0] == "true";
    return std::string();
  };
  key.words = [member](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    return Words{member(copy) ? "true" : "false"};
  };
  return key;
}

// One of several names.
template <class T>
SyntheticKey NameKey(std::string name, const Words& names, const std::string& doc,
                     T (*parse)(const std::string& place, const std::string& name),
                     T& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), "NAME", doc + "; " + JoinNames(names));
  key.set = [names, parse, member](const Words& words, SyntheticOptions* options) {
    if (std::find(names.begin(), names.end(), words[0]) == names.end())
      return "'" + words[0] + "': " + Suggestion(words[0], names);
    member(*options) = parse("", words[0]);
    return std::string();
  };
  key.words = [member](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    return Words{ToString(member(copy))};
  };
  return key;
}

SyntheticKey ParametersKey() {
  SyntheticKey key = BareKey("parameters", "TERM.PARAMETER=VALUE",
                             "value of a parameter, else its initial one; may be repeated");
  key.option = "--set";
  key.kind = Kind::kMap;
  key.set = [](const Words& words, SyntheticOptions* options) {
    for (const std::string& word : words) {
      const std::size_t equals = word.find('=');
      const auto value =
          equals == std::string::npos ? std::nullopt : ParseNumber(word.substr(equals + 1));
      if (!value) return "'" + word + "': expected TERM.PARAMETER=NUMBER";
      options->parameters.insert_or_assign(word.substr(0, equals), *value);
    }
    return std::string();
  };
  key.words = [](const SyntheticOptions& options) {
    Words words;
    for (const auto& [name, value] : options.parameters)
      words.push_back(name + "=" + FormatNumber(value));
    return words;
  };
  return key;
}

SyntheticKey HiddenHandlesKey() {
  SyntheticKey key =
      BareKey("hide_handle", "NAME", "do not tell the path of this handle; may be repeated");
  key.kind = Kind::kList;
  key.set = [](const Words& words, SyntheticOptions* options) {
    options->hidden_handles = words;
    return std::string();
  };
  key.words = [](const SyntheticOptions& options) { return options.hidden_handles; };
  return key;
}

SyntheticKey HideDensityKey() {
  SyntheticKey key = FlagKey("hide_density", "do not tell the areal density",
                             [](SyntheticOptions& o) -> bool& { return o.tell_density; });
  const auto not_of = [](const Words& words) {
    return words[0] == "true" ? Words{"false"} : words[0] == "false" ? Words{"true"} : words;
  };
  key.set = [set = key.set, not_of](const Words& words, SyntheticOptions* options) {
    return set(not_of(words), options);
  };
  key.words = [words = key.words, not_of](const SyntheticOptions& options) {
    return not_of(words(options));
  };
  return key;
}

SyntheticKey VideoKey() {
  SyntheticKey key = BareKey("video", "CONTAINER",
                             "write videos and no PNG: mkv (loses nothing), mp4 or avi; none");
  key.set = [](const Words& words, SyntheticOptions* options) {
    options->pictures.video = words[0] == "none" ? "" : words[0];
    return std::string();
  };
  key.words = [](const SyntheticOptions& options) {
    return Words{options.pictures.video.empty() ? "none" : options.pictures.video};
  };
  return key;
}

using Options = SyntheticOptions;

std::vector<SyntheticKey> SceneKeys() {
  return {
      NameKey<SyntheticScenario>("scenario", SyntheticScenarioNames(), "what happens",
                                 ParseSyntheticScenario,
                                 [](Options& o) -> SyntheticScenario& { return o.scenario; }),
      VectorKey<Eigen::Vector2d>("size", "U V", "m along u and v", 2,
                                 [](Options& o) -> Eigen::Vector2d& { return o.size; }),
      VectorKey<Eigen::Vector2i>("resolution", "NU NV", "particles along u and v", 2,
                                 [](Options& o) -> Eigen::Vector2i& { return o.resolution; }),
      NumberKey<int>("refinement", "N", "simulate with this many times as many cells each way",
                     [](Options& o) -> int& { return o.refinement; }),
      NumberKey<int>("frames", "N", "number of frames",
                     [](Options& o) -> int& { return o.frame_count; }),
      NumberKey<double>("rate", "HZ", "frames a second",
                        [](Options& o) -> double& { return o.frame_rate; }),
      NumberKey<int>("steps", "N", "simulated steps a frame",
                     [](Options& o) -> int& { return o.steps_per_frame; }),
      ParametersKey(),
  };
}

std::vector<SyntheticKey> ObservationKeys() {
  return {
      VectorKey<Eigen::Vector2i>("markers", "MU MV", "markers along u and v; 0 0: none", 2,
                                 [](Options& o) -> Eigen::Vector2i& { return o.markers; }),
      NumberKey<double>("noise", "M", "sigma of the markers, m",
                        [](Options& o) -> double& { return o.marker_sigma; }),
      NumberKey<int>("cameras", "N",
                     "cameras around the cloth; with images the last is at the ceiling",
                     [](Options& o) -> int& { return o.num_cameras; }),
      FlagKey("tracks", "each camera tracks the markers' points (5 x 5 without markers)",
              [](Options& o) -> bool& { return o.tracks; }),
      NumberKey<double>("track_noise", "PX", "sigma of the tracks, px",
                        [](Options& o) -> double& { return o.track_sigma; }),
      NumberKey<std::uint64_t>("seed", "N", "of the noise and the texture",
                               [](Options& o) -> std::uint64_t& { return o.seed; }),
      NumberKey<double>("held_out", "SHARE", "share of the frames, at the end",
                        [](Options& o) -> double& { return o.held_out_share; }),
      HiddenHandlesKey(),
      HideDensityKey(),
      VectorKey<Eigen::Vector2i>("truth_points", "TU TV", "points of the truth along u and v", 2,
                                 [](Options& o) -> Eigen::Vector2i& { return o.truth_points; }),
  };
}

std::vector<SyntheticKey> PictureKeys() {
  return {
      FlagKey("images", "take pictures with each camera",
              [](Options& o) -> bool& { return o.images; }),
      VectorKey<Eigen::Vector2i>("picture_size", "W H", "px", 2,
                                 [](Options& o) -> Eigen::Vector2i& { return o.pictures.size; }),
      VectorKey<std::array<double, 5>>(
          "distortion", "K1 K2 P1 P2 K3", "of the lenses, as OpenCV has it", 5,
          [](Options& o) -> std::array<double, 5>& { return o.pictures.distortion; }),
      NameKey<ClothPattern>("texture", ClothPatternNames(), "of the cloth", ParseClothPattern,
                            [](Options& o) -> ClothPattern& { return o.pictures.pattern; }),
      NumberKey<double>("specular", "SHARE", "of the lamp's light in the middle of a highlight",
                        [](Options& o) -> double& { return o.pictures.specular; }),
      NumberKey<int>("samples", "N", "rays a pixel along x and along y",
                     [](Options& o) -> int& { return o.pictures.samples; }),
      NumberKey<double>("sensor_noise", "LEVELS", "sigma of each channel, grey levels of 255",
                        [](Options& o) -> double& { return o.pictures.noise; }),
      NumberKey<double>("shot_noise", "LEVELS",
                        "sigma that white has besides, grey levels; as the root of the level",
                        [](Options& o) -> double& { return o.pictures.shot_noise; }),
      NumberKey<double>("light_drift", "SHARE", "by which the light slowly rises and falls",
                        [](Options& o) -> double& { return o.pictures.light_drift; }),
      NumberKey<double>("exposure", "S", "s that the shutter is open; 0: no motion blur",
                        [](Options& o) -> double& { return o.pictures.exposure; }),
      NumberKey<int>("exposure_samples", "N", "moments that one exposure is the mean of",
                     [](Options& o) -> int& { return o.pictures.exposure_samples; }),
      VideoKey(),
      NumberKey<int>("threads", "N", "that render; 0: all; the pictures do not depend on it",
                     [](Options& o) -> int& { return o.pictures.threads; }),
  };
}

}  // namespace

const std::vector<SyntheticKey>& SyntheticKeys() {
  static const std::vector<SyntheticKey> keys = [] {
    std::vector<SyntheticKey> all = SceneKeys();
    for (const auto& more : {ObservationKeys(), PictureKeys()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return keys;
}

}  // namespace clothfit
