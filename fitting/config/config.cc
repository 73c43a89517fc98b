// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The defaults of a fit, and what makes a config usable.
#include "fitting/config/config.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/keys.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

ParameterSetting DefaultSetting(const Parameter& parameter) {
  ParameterSetting setting;
  setting.value = setting.prior = parameter.initial;
  setting.lower = parameter.lower;
  setting.upper = parameter.upper;
  setting.prior_sigma = parameter.prior_factor;
  setting.free = parameter.is_free;
  return setting;
}

// Contact with what the recording has not.
void FixWhatIsNotThere(const Recording& recording, FitConfig* config) {
  for (const TermInfo& term : AllTerms()) {
    const bool lacks = (term.needs == Needs::kGround && !recording.ground_height) ||
                       (term.needs == Needs::kObstacles && recording.obstacles.empty());
    if (!lacks) continue;
    for (const Parameter& p : term.parameters)
      config->parameters.at(term.name + "." + p.name).free = false;
  }
}

// Obstacles of which it is said how well they are placed.
void FreePlaceOfObstacles(const Recording& recording, FitConfig* config) {
  if (!recording.noise.obstacles || recording.obstacles.empty()) return;
  const bool has_round =
      std::any_of(recording.obstacles.begin(), recording.obstacles.end(), [](const auto& obstacle) {
        return std::holds_alternative<BallShape>(obstacle.shape) ||
               std::holds_alternative<BarShape>(obstacle.shape);
      });
  for (const NamedParameter& named : MakeParameterTable()) {
    const Places places = named.parameter.places;
    if (places == Places::kNothing || (places == Places::kRoundObstacles && !has_round)) continue;
    ParameterSetting& setting = config->parameters.at(named.name);
    setting.free = true;
    setting.prior_sigma = *recording.noise.obstacles;
  }
}

void CheckPrior(const std::string& place, const Parameter& parameter,
                const ParameterSetting& setting) {
  const bool is_log = parameter.scale == Scale::kLog;
  if (is_log && !(setting.lower > 0.0)) {
    throw InputError(place + ".lower", fmt::format("{}: expected a number above 0 for a parameter "
                                                   "on a logarithmic scale",
                                                   setting.lower));
  }
  if (!(setting.lower < setting.upper)) {
    throw InputError(place + ".upper", fmt::format("{}: expected a number above the lower bound {}",
                                                   setting.upper, setting.lower));
  }
  if (is_log && !(setting.prior > 0.0)) {
    throw InputError(place + ".prior", fmt::format("{}: expected a number above 0", setting.prior));
  }
  const double least = is_log ? 1.0 : 0.0;
  if (!(setting.prior_sigma > least)) {
    throw InputError(
        place + ".prior_sigma",
        fmt::format("{}: expected {} above {}", setting.prior_sigma,
                    is_log ? "a factor (the scale is logarithmic)" : "an amount", least));
  }
}

void CheckValue(const std::string& place, const Parameter& parameter,
                const ParameterSetting& setting) {
  const bool inside = setting.value >= setting.lower && setting.value <= setting.upper;
  if (inside || (!setting.free && setting.value == parameter.off)) return;
  const std::string off = setting.value == parameter.off
                              ? " where it is free (this is its off value)"
                              : fmt::format(" (or {}, off, where it is fixed)", parameter.off);
  throw InputError(place + ".value",
                   fmt::format("{} {}: expected {} to {}{}", setting.value, parameter.unit,
                               setting.lower, setting.upper, off));
}

void CheckParameters(const std::string& place,
                     const std::map<std::string, ParameterSetting>& settings) {
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const NamedParameter& named : table) {
    const auto found = settings.find(named.name);
    const std::string key = place + ": parameters." + named.name;
    if (found == settings.end()) throw InputError(key, "is missing");
    CheckPrior(key, named.parameter, found->second);
    CheckValue(key, named.parameter, found->second);
  }
  for (const auto& [name, setting] : settings) {
    if (FindParameter(table, name) >= 0) continue;
    throw InputError(place + ": parameters." + name, "no such parameter");
  }
}

}  // namespace

void ForgetChosenMesh(FitConfig* config) {
  if (config->refined) config->resolution = {0, 0};
  config->refined = false;
}

FitConfig DefaultConfig(const Recording& recording) {
  FitConfig config;
  config.recording = recording.path.string();
  // What is tracked in pictures or measured by depth has outliers.
  if (!recording.tracks.empty() || HasMasks(recording) || HasClouds(recording))
    config.loss = LossKind::kHuber;
  config.use_silhouettes = HasMasks(recording);
  config.use_clouds = HasClouds(recording);
  // Outlines alone lead over a rugged way: after 30 iterations it is chance how far a fit has come.
  if (HasMasks(recording) && recording.tracks.empty() && recording.markers.empty() &&
      !HasClouds(recording))
    config.max_iterations = kIterationsOfOutlines;
  for (const NamedParameter& named : MakeParameterTable()) {
    config.parameters[named.name] = DefaultSetting(named.parameter);
  }
  FixWhatIsNotThere(recording, &config);
  if (const std::optional<double>& known = recording.cloth.areal_density) {
    ParameterSetting& density = config.parameters.at("cloth.areal_density");
    density.value = density.prior = *known;
    density.lower = std::min(density.lower, *known);
    density.upper = std::max(density.upper, *known);
  }
  // Measured points place the cloth to within their noise; a flat placement is as it was laid out.
  const bool is_measured = std::holds_alternative<PointPlacement>(recording.cloth.initial);
  config.initial_order = is_measured ? 0 : -1;
  // So are then the cloth's measures, laid out from the largest distances that were ever seen
  // between points; small folds take up about a hundredth more. A few millimetres decide whether an
  // edge hangs slack.
  for (const char* name : {"cloth.shrink_warp", "cloth.shrink_weft"}) {
    constexpr double kTypicalShrinkage = 0.01;
    ParameterSetting& shrinkage = config.parameters.at(name);
    shrinkage.free = is_measured;
    if (is_measured) shrinkage.value = shrinkage.prior = kTypicalShrinkage;
  }
  FreePlaceOfObstacles(recording, &config);
  return config;
}

void FitConfig::Check(const std::string& place) const {
  for (const ConfigKey& key : ConfigKeys()) {
    const std::string problem = key.problem(*this);
    if (problem.empty()) continue;
    throw InputError(place + ": " + key.full_name(), key.write(*this) + ": " + problem);
  }
  CheckParameters(place, parameters);
  if (FitsMarkers() || FitsTracks() || FitsClouds() || FitsSilhouettes()) return;
  throw InputError(place + ": observations",
                   "neither markers nor tracks nor clouds nor silhouettes: nothing to fit");
}

}  // namespace clothfit
