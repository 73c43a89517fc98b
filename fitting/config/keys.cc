// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/config/keys.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/optimise/optimiser.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// The texts of an enumeration.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

const Choices<bool> kYesOrNo = {{"true", true}, {"false", false}};
const Choices<Integrator> kIntegrators = {{"bdf2", Integrator::kBdf2},
                                          {"backward_euler", Integrator::kBackwardEuler}};
const Choices<LossKind> kLosses = {
    {"none", LossKind::kNone}, {"huber", LossKind::kHuber}, {"cauchy", LossKind::kCauchy}};

const Choices<Strategy> kStrategies = {{"joint", Strategy::kJoint},
                                       {"two-loop", Strategy::kTwoLoop},
                                       {"one-loop", Strategy::kOneLoop}};

template <class Value>
std::vector<std::string> NamesOf(const Choices<Value>& choices) {
  std::vector<std::string> names;
  for (const auto& [name, value] : choices) names.push_back(name);
  return names;
}

template <class Value>
std::string NameOf(const Choices<Value>& choices, Value value) {
  for (const auto& [name, choice] : choices) {
    if (choice == value) return name;
  }
  return "";
}

template <class Value>
ConfigKey ChoiceKey(std::string section, std::string name, std::string doc,
                    Value FitConfig::*member, const Choices<Value>& choices) {
  ConfigKey key{std::move(section), std::move(name), std::move(doc), {}, {}, {}};
  key.doc += "; " + JoinNames(NamesOf(choices));
  key.read = [member, choices](const YamlValue& yaml, FitConfig* config) {
    const std::string text = yaml.Text();
    for (const auto& [choice, value] : choices) {
      if (choice == text) {
        config->*member = value;
        return;
      }
    }
    yaml.Fail("'" + text + "': expected one of " + JoinNames(NamesOf(choices)));
  };
  key.write = [member, choices](const FitConfig& config) {
    return NameOf(choices, config.*member);
  };
  key.problem = [](const FitConfig&) { return std::string(); };
  return key;
}

enum class Range { kAboveZero, kAtLeastZero };

ConfigKey NumberKey(std::string section, std::string name, std::string doc,
                    double FitConfig::*member, Range range) {
  ConfigKey key{std::move(section), std::move(name), std::move(doc), {}, {}, {}};
  key.read = [member](const YamlValue& yaml, FitConfig* config) {
    config->*member = yaml.Number();
  };
  key.write = [member](const FitConfig& config) { return FormatNumber(config.*member); };
  key.problem = [member, range](const FitConfig& config) {
    const double value = config.*member;
    if (range == Range::kAboveZero) return value > 0.0 ? "" : "expected a number above 0";
    return value >= 0.0 ? "" : "expected 0 or more";
  };
  return key;
}

ConfigKey IntegerKey(std::string section, std::string name, std::string doc, int FitConfig::*member,
                     int lowest, int highest) {
  ConfigKey key{std::move(section), std::move(name), std::move(doc), {}, {}, {}};
  key.read = [member](const YamlValue& yaml, FitConfig* config) {
    config->*member = yaml.Integer();
  };
  key.write = [member](const FitConfig& config) { return std::to_string(config.*member); };
  key.problem = [member, lowest, highest](const FitConfig& config) {
    const int value = config.*member;
    if (value >= lowest && value <= highest) return std::string();
    return fmt::format("expected an integer from {} to {}", lowest, highest);
  };
  return key;
}

ConfigKey ResolutionKey() {
  ConfigKey key{"cloth", "resolution", "particles along u and v; [0, 0]: as the recording says",
                {},      {},           {}};
  key.read = [](const YamlValue& yaml, FitConfig* config) {
    const Eigen::Vector2i pair = yaml.IntegerPair();
    config->resolution = {pair.x(), pair.y()};
  };
  key.write = [](const FitConfig& config) {
    return fmt::format("[{}, {}]", config.resolution[0], config.resolution[1]);
  };
  key.problem = [](const FitConfig& config) {
    const auto& [nu, nv] = config.resolution;
    const bool is_default = nu == 0 && nv == 0;
    if (is_default || (std::min(nu, nv) >= 2 && std::max(nu, nv) <= kMostResolution))
      return std::string();
    return fmt::format("expected 2 to {} particles along u and v, or [0, 0]", kMostResolution);
  };
  return key;
}

ConfigKey OptimiserKey() {
  ConfigKey key{"strategy", "optimiser", "", {}, {}, {}};
  key.doc = "what searches; " + JoinNames(OptimiserNames());
  key.read = [](const YamlValue& yaml, FitConfig* config) { config->optimiser = yaml.Text(); };
  key.write = [](const FitConfig& config) { return config.optimiser; };
  key.problem = [](const FitConfig& config) {
    const std::vector<std::string>& names = OptimiserNames();
    const bool right = std::find(names.begin(), names.end(), config.optimiser) != names.end();
    return right ? "" : "expected one of " + JoinNames(names);
  };
  return key;
}

ConfigKey FramesKey() {
  ConfigKey key{"observations",
                "frames",
                "first and last frame to fit; []: all that are not held out",
                {},
                {},
                {}};
  key.read = [](const YamlValue& yaml, FitConfig* config) {
    config->frames.reset();
    if (yaml.Items().empty()) return;
    const Eigen::Vector2i pair = yaml.IntegerPair();
    config->frames = std::array<int, 2>{pair.x(), pair.y()};
  };
  key.write = [](const FitConfig& config) {
    return config.frames ? fmt::format("[{}, {}]", (*config.frames)[0], (*config.frames)[1])
                         : std::string("[]");
  };
  key.problem = [](const FitConfig& config) {
    const bool right =
        !config.frames || ((*config.frames)[0] >= 0 && (*config.frames)[1] >= (*config.frames)[0]);
    return right ? "" : "expected a first frame from 0 on and a last one not before it";
  };
  return key;
}

std::vector<ConfigKey> MakeConfigKeys() {
  return {
      ResolutionKey(),
      IntegerKey("cloth", "finest",
                 "without a resolution: particles along the longer side of the finest mesh that a "
                 "fit may choose; 0: it keeps the recording's",
                 &FitConfig::finest, 0, kMostResolution),
      ChoiceKey("cloth", "refined",
                "the resolution is one that a fit has chosen; a fit chooses anew",
                &FitConfig::refined, kYesOrNo),
      ChoiceKey("cloth", "buckling",
                "wrinkles that are shorter than the mesh limit compression; false: springs resist "
                "it as they resist tension",
                &FitConfig::buckling, kYesOrNo),
      NumberKey("simulation", "max_step", "s; frames are divided into equal steps, none longer",
                &FitConfig::max_step, Range::kAboveZero),
      ChoiceKey("simulation", "integrator", "how a step is made", &FitConfig::integrator,
                kIntegrators),
      NumberKey("simulation", "tolerance", "error of a step's positions, in mean edges",
                &FitConfig::tolerance, Range::kAboveZero),
      ChoiceKey("simulation", "self_contact",
                "the cloth does not pass through itself; see the parameters contact.*",
                &FitConfig::self_contact, kYesOrNo),
      ChoiceKey("simulation", "check_intersections",
                "count after every step where the cloth passes through anything; of a fit: of its "
                "result",
                &FitConfig::check_intersections, kYesOrNo),
      IntegerKey("initial_state", "order",
                 "polynomial offsets of the state at frame 0; -1: none, 0: constant, 1: bilinear, "
                 "2: biquadratic",
                 &FitConfig::initial_order, -1, 2),
      NumberKey("initial_state", "position_sigma", "m, prior of each offset of the positions",
                &FitConfig::initial_position_sigma, Range::kAboveZero),
      NumberKey("initial_state", "velocity_sigma", "m/s, prior of each offset of the velocities",
                &FitConfig::initial_velocity_sigma, Range::kAboveZero),
      NumberKey("handle_paths", "spline_spacing", "s between control points of an unknown path",
                &FitConfig::spline_spacing, Range::kAboveZero),
      NumberKey("handle_paths", "spline_acceleration",
                "m/s^2, one sigma of an unknown path's acceleration",
                &FitConfig::spline_acceleration, Range::kAboveZero),
      NumberKey("handle_paths", "spline_speed", "m/s, one sigma of an unknown path's speed",
                &FitConfig::spline_speed, Range::kAboveZero),
      ChoiceKey("observations", "markers", "fit the markers", &FitConfig::use_markers, kYesOrNo),
      ChoiceKey("observations", "tracks", "fit the tracks", &FitConfig::use_tracks, kYesOrNo),
      ChoiceKey("observations", "silhouettes", "fit the outlines of the masks",
                &FitConfig::use_silhouettes, kYesOrNo),
      ChoiceKey("observations", "clouds", "fit clouds and depth pictures", &FitConfig::use_clouds,
                kYesOrNo),
      ChoiceKey("observations", "leave_out_outliers",
                "leave out markers and tracks that are off by far more than their noise",
                &FitConfig::leave_out_outliers, kYesOrNo),
      NumberKey("observations", "alpha", "weight of the silhouettes; 0: none", &FitConfig::alpha,
                Range::kAtLeastZero),
      NumberKey("observations", "beta", "weight of markers, tracks and clouds; 0: none",
                &FitConfig::beta, Range::kAtLeastZero),
      IntegerKey("observations", "cloud_points",
                 "points of a cloud that are fitted, at most: one of each cell of a grid",
                 &FitConfig::cloud_points, 1, kMostCloudPoints),
      NumberKey("observations", "cloud_coverage",
                "weight of the cloth's distances from clouds that should show it; 0: none",
                &FitConfig::cloud_coverage, Range::kAtLeastZero),
      ChoiceKey("observations", "loss", "how outliers count", &FitConfig::loss, kLosses),
      NumberKey("observations", "loss_scale", "sigmas from which an observation is an outlier",
                &FitConfig::loss_scale, Range::kAboveZero),
      FramesKey(),
      IntegerKey("observations", "every", "of these frames, fit one in so many", &FitConfig::every,
                 1, kMostFrames),
      ChoiceKey("observations", "hold_out",
                "of a fit of several recordings: predict this one and fit nothing of it",
                &FitConfig::hold_out, kYesOrNo),
      ChoiceKey("observations", "attract",
                "markers and rays of tracks pull at the cloth by attraction_*.* while fitting",
                &FitConfig::attract, kYesOrNo),
      ChoiceKey("strategy", "loops", "which unknowns are searched together", &FitConfig::loops,
                kStrategies),
      OptimiserKey(),
      NumberKey("strategy", "max_simulations",
                "of the whole recording, of all optimisers but lm; 0: until they converge",
                &FitConfig::max_simulations, Range::kAtLeastZero),
      ChoiceKey("strategy", "polish_hard",
                "where lm stalls, search on the hard silhouette error without derivatives",
                &FitConfig::polish_hard, kYesOrNo),
      NumberKey("strategy", "window",
                "s, of the first windows, which grow to all frames; 0: all frames at once",
                &FitConfig::window, Range::kAtLeastZero),
      IntegerKey("strategy", "window_resolution",
                 "particles along the longer side of a coarser grid for windows; 0: none",
                 &FitConfig::window_resolution, 0, 1000),
      IntegerKey(
          "strategy", "coarse_resolution",
          "without windows: particles along the longer side of a coarser first grid; 0: none",
          &FitConfig::coarse_resolution, 0, 1000),
      ChoiceKey("strategy", "polish", "after the windows, fit all frames at once, open loop",
                &FitConfig::polish, kYesOrNo),
      IntegerKey("strategy", "max_iterations", "of all frames at once; windows need fewer; 0: none",
                 &FitConfig::max_iterations, 0, 10000),
      NumberKey("strategy", "function_tolerance", "relative change of the cost at which to stop",
                &FitConfig::function_tolerance, Range::kAboveZero),
  };
}

}  // namespace

std::string ToString(Strategy strategy) { return NameOf(kStrategies, strategy); }

Strategy ParseStrategy(const std::string& place, const std::string& name) {
  for (const auto& [text, value] : kStrategies) {
    if (text == name) return value;
  }
  throw InputError(place, "'" + name + "': expected one of " + JoinNames(NamesOf(kStrategies)));
}

const std::vector<ConfigKey>& ConfigKeys() {
  static const std::vector<ConfigKey> keys = MakeConfigKeys();
  return keys;
}

}  // namespace clothfit
