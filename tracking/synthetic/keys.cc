// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ranges are checked by SyntheticOptions::Check; here it is only decided what a word means.
#include "tracking/synthetic/keys.h"

#include <utility>

#include "tracking/synthetic/key_kinds.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using namespace synthetic_key_kinds;  // NOLINT(google-build-using-namespace): its other half
using Kind = SyntheticKey::Kind;

SyntheticKey ParametersKey() {
  SyntheticKey key =
      BareKey("parameters", "TERM.PARAMETER=VALUE",
              "value of a parameter, else its initial one, with --images that of a heavy "
              "cotton; may be repeated");
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

std::vector<SyntheticKey> MotionKeys() {
  return {
      NameKey<SyntheticScenario>("scenario", SyntheticScenarioNames(), "what happens",
                                 ParseSyntheticScenario,
                                 [](Options& o) -> SyntheticScenario& { return o.scenario; }),
      NumberKey<int>("frames", "N", "number of frames",
                     [](Options& o) -> int& { return o.frame_count; }),
      NumberKey<double>("rate", "HZ", "frames a second",
                        [](Options& o) -> double& { return o.frame_rate; }),
      NumberKey<int>("steps", "N", "simulated steps a frame",
                     [](Options& o) -> int& { return o.steps_per_frame; }),
  };
}

std::vector<SyntheticKey> ClothKeys() {
  return {
      VectorKey<Eigen::Vector2d>("size", "U V", "m along u and v", 2,
                                 [](Options& o) -> Eigen::Vector2d& { return o.size; }),
      VectorKey<Eigen::Vector2i>("resolution", "NU NV", "particles along u and v", 2,
                                 [](Options& o) -> Eigen::Vector2i& { return o.resolution; }),
      NumberKey<int>("refinement", "N", "simulate with this many times as many cells each way",
                     [](Options& o) -> int& { return o.refinement; }),
      ParametersKey(),
  };
}

std::vector<SyntheticKey> ObservationKeys() {
  return {
      VectorKey<Eigen::Vector2i>("markers", "MU MV", "markers along u and v; 0 0: none", 2,
                                 [](Options& o) -> Eigen::Vector2i& { return o.markers; }),
      NumberKey<double>("noise", "M", "sigma of the markers, m",
                        [](Options& o) -> double& { return o.marker_sigma; }),
      NumberKey<double>("layout_noise", "M",
                        "sigma of what is told of markers' places on the cloth, m",
                        [](Options& o) -> double& { return o.layout_sigma; }),
      NumberKey<int>("cameras", "N",
                     "cameras around the cloth; with images the last is at the ceiling",
                     [](Options& o) -> int& { return o.num_cameras; }),
      FlagKey("tracks", "each camera tracks the markers' points (5 x 5 without markers)",
              [](Options& o) -> bool& { return o.tracks; }),
      NumberKey<double>("track_noise", "PX", "sigma of the tracks, px",
                        [](Options& o) -> double& { return o.track_sigma; }),
      NumberKey<int>("cloud_points", "N", "points without names in each frame; 0: none",
                     [](Options& o) -> int& { return o.cloud_points; }),
      NumberKey<double>("cloud_noise", "M", "sigma of these, m",
                        [](Options& o) -> double& { return o.cloud_sigma; }),
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
    std::vector<SyntheticKey> all;
    const auto add = [&all](const char* group, std::vector<SyntheticKey> keys_of_group) {
      for (SyntheticKey& key : keys_of_group) {
        key.group = group;
        all.push_back(std::move(key));
      }
    };
    add("The motion", MotionKeys());
    add("The cloth", ClothKeys());
    add("The observations", ObservationKeys());
    add("The pictures", PictureKeys());
    return all;
  }();
  return keys;
}

}  // namespace clothfit
