// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/evidence/candidates.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "autodiff_sim/term/tilted_down.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/fitted/named_parameter.h"

namespace clothfit {
namespace {

// Whether the scene has what the term acts at.
bool CanAct(const TermInfo& term, const World& world) {
  return (term.needs != Needs::kGround || world.ground_height) &&
         (term.needs != Needs::kObstacles || !world.obstacles.empty());
}

// Others help a fit or an estimate, keep apart what is known to be there, or are a second form of
// one that is looked for.
bool IsAskedFor(Role role, CandidateSet set) {
  if (set == CandidateSet::kNone) return false;
  if (set == CandidateSet::kLaws) return role == Role::kLaw;
  return role == Role::kMayBeMissing || role == Role::kOrdinary;
}

bool IsOff(const NamedParameter& named, const FitConfig& values) {
  const ParameterSetting& setting = values.parameters.at(named.name);
  return setting.value == named.parameter.off && !setting.free;
}

std::vector<double> ProbeValues(const Parameter& parameter, const Extent& extent) {
  std::vector<double> values;
  for (int k = 0; k < parameter.probes.count; ++k) {
    const double value = AtShare(parameter, parameter.probes.values[k], extent);
    values.push_back(std::clamp(value, parameter.lower, parameter.upper));
  }
  return values;
}

std::vector<const NamedParameter*> Shapes(const std::vector<NamedParameter>& table,
                                          const std::string& term) {
  std::vector<const NamedParameter*> shapes;
  for (const NamedParameter& named : table) {
    if (named.term == term && !SwitchesOff(named.parameter)) shapes.push_back(&named);
  }
  return shapes;
}

// The direction that a probe's tilts turn up to.
Eigen::Vector3d TiltedUp(const std::vector<const NamedParameter*>& shapes, const Probe& probe,
                         const Extent& extent) {
  std::array<double, 2> tilts = {0.0, 0.0};
  std::size_t k = 0;
  for (const NamedParameter* shape : shapes) {
    if (shape->parameter.meaning == Meaning::kTilt && k < tilts.size())
      tilts[k++] = probe.at(shape->name);
  }
  return -TiltedDown<double>(MakeDownFrame(extent.gravity), tilts[0], tilts[1]);
}

int NumTilts(const std::vector<const NamedParameter*>& shapes, const Probe& probe) {
  return static_cast<int>(
      std::count_if(shapes.begin(), shapes.end(), [&](const NamedParameter* shape) {
        return shape->parameter.meaning == Meaning::kTilt && probe.at(shape->name) != 0.0;
      }));
}

// The place that a plane has along the vertical, as far through the box along its own direction.
void PutAlongTilt(const std::vector<const NamedParameter*>& shapes, const Extent& extent,
                  Probe* probe) {
  for (const NamedParameter* shape : shapes) {
    const Parameter& p = shape->parameter;
    if (p.meaning != Meaning::kAlongTilt) continue;
    double& place = probe->at(shape->name);
    const double share =
        (place - extent.low.z()) / std::max(1e-9, extent.high.z() - extent.low.z());
    const Eigen::Vector3d up = TiltedUp(shapes, *probe, extent);
    const double middle = 0.5 * up.dot(extent.low + extent.high);
    const double reach = 0.5 * up.cwiseAbs().dot(extent.high - extent.low);
    place = std::clamp(middle + (2.0 * share - 1.0) * reach, p.lower, p.upper);
  }
}

// One of all combinations of the shapes' values.
Probe Combination(const std::vector<const NamedParameter*>& shapes,
                  const std::vector<std::vector<double>>& values, std::size_t index) {
  Probe probe;
  for (std::size_t s = 0; s < shapes.size(); index /= values[s++].size())
    probe[shapes[s]->name] = values[s][index % values[s].size()];
  return probe;
}

// All combinations of the shapes' values, or `most` of them at chance but always the same.
std::vector<Probe> Combinations(const std::vector<const NamedParameter*>& shapes,
                                const Extent& extent, int most) {
  std::vector<std::vector<double>> values;
  std::size_t total = 1;
  for (const NamedParameter* shape : shapes) {
    values.push_back(ProbeValues(shape->parameter, extent));
    total *= values.back().size();
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < total; ++i) {
    if (NumTilts(shapes, Combination(shapes, values, i)) < 2) chosen.push_back(i);
  }
  if (chosen.size() > static_cast<std::size_t>(most)) {
    std::mt19937_64 random(total);
    for (std::size_t i = chosen.size() - 1; i > 0; --i)
      std::swap(chosen[i], chosen[random() % (i + 1)]);
    chosen.resize(static_cast<std::size_t>(most));
    std::sort(chosen.begin(), chosen.end());
  }
  std::vector<Probe> probes;
  for (const std::size_t index : chosen) {
    Probe probe = Combination(shapes, values, index);
    PutAlongTilt(shapes, extent, &probe);
    probes.push_back(std::move(probe));
  }
  return probes;
}

CandidateTerm MakeCandidate(const std::string& name, const TermInfo& term,
                            const std::vector<const NamedParameter*>& switches,
                            std::vector<Probe> probes) {
  CandidateTerm candidate{name, term.name, {}, {}, std::move(probes), term.role};
  for (const NamedParameter* named : switches) {
    const Parameter& p = named->parameter;
    candidate.switches.push_back(named->name);
    candidate.is_one_sided.push_back(p.off == 0.0 && p.lower >= 0.0);
  }
  return candidate;
}

// From its value on, with a prior as wide as the logarithm's reaches in the parameter's unit.
void MoveByAmounts(ParameterSetting* setting) {
  setting->scale = Scale::kLinear;
  setting->prior_sigma *= setting->prior;
  setting->prior = setting->value;
}

}  // namespace

std::vector<CandidateTerm> ListCandidates(const FitConfig& values, const Scene& scene,
                                          const Extent& extent,
                                          const std::vector<std::string>& excluded, int most_probes,
                                          CandidateSet set) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  std::vector<CandidateTerm> candidates;
  for (const TermInfo& term : AllTerms()) {
    const bool is_excluded =
        std::find(excluded.begin(), excluded.end(), term.name) != excluded.end();
    if (is_excluded || !IsAskedFor(term.role, set) || !CanAct(term, scene.world)) continue;
    std::vector<const NamedParameter*> off, on;
    for (const NamedParameter& named : table) {
      if (named.term != term.name || !SwitchesOff(named.parameter)) continue;
      (IsOff(named, values) ? off : on).push_back(&named);
    }
    if (off.empty()) continue;
    const std::vector<const NamedParameter*> shapes = Shapes(table, term.name);
    if (set == CandidateSet::kLaws) {
      if (!on.empty()) continue;  // learned already
      constexpr double kMiddle = 0.5;
      Probe middle;
      for (const NamedParameter* shape : shapes)
        middle[shape->name] = AtShare(shape->parameter, kMiddle, extent);
      candidates.push_back(MakeCandidate(term.name, term, off, {middle}));
      continue;
    }
    if (on.empty()) {
      candidates.push_back(
          MakeCandidate(term.name, term, off, Combinations(shapes, extent, most_probes)));
      continue;
    }
    // A part of a term that is on: what stands at its off value without being its start value.
    for (const NamedParameter* named : off) {
      if (named->parameter.off != 0.0) continue;
      const bool takes_part = named->parameter.lower > 0.0 || named->parameter.initial != 0.0;
      if (takes_part) candidates.push_back(MakeCandidate(named->name, term, {named}, {Probe{}}));
    }
  }
  return candidates;
}

std::vector<Probe> ProbesNear(const CandidateTerm& candidate, const Probe& probe,
                              const Extent& extent, double step) {
  std::vector<Probe> near;
  const std::vector<NamedParameter>& table = MakeParameterTable();
  const std::vector<const NamedParameter*> shapes = Shapes(table, candidate.term);
  for (const NamedParameter* shape : shapes) {
    const auto at = probe.find(shape->name);
    if (at == probe.end()) continue;
    const std::vector<double> values = ProbeValues(shape->parameter, extent);
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    const bool is_log = shape->parameter.scale == Scale::kLog;
    const double spacing = values.size() < 2 ? 0.0
                           : is_log
                               ? std::log(*most / *least) / static_cast<double>(values.size() - 1)
                               : (*most - *least) / static_cast<double>(values.size() - 1);
    if (!(spacing > 0.0)) continue;
    for (const double sign : {-1.0, 1.0}) {
      Probe moved = probe;
      const double value = is_log ? at->second * std::exp(sign * step * spacing)
                                  : at->second + sign * step * spacing;
      moved[shape->name] = std::clamp(value, shape->parameter.lower, shape->parameter.upper);
      if (shape->parameter.meaning == Meaning::kTilt) {  // about the middle of what was recorded
        const Eigen::Vector3d turned =
            TiltedUp(shapes, moved, extent) - TiltedUp(shapes, probe, extent);
        for (const NamedParameter* other : shapes) {
          if (other->parameter.meaning == Meaning::kAlongTilt)
            moved[other->name] += turned.dot(0.5 * (extent.low + extent.high));
        }
      }
      near.push_back(std::move(moved));
    }
  }
  return near;
}

std::vector<std::string> EndsOfLine(const Probe& probe) {
  if (probe.empty()) return {};
  const std::string first = probe.begin()->first;
  const std::string term = first.substr(0, first.find('.') + 1);
  const auto find = [&](const std::string& name) { return probe.find(term + name); };
  double longest = 0.0, squares = 0.0;
  std::vector<std::string> ends;
  for (const char axis : {'x', 'y', 'z'}) {
    const auto one = find(std::string(1, axis) + "1"), other = find(std::string(1, axis) + "2");
    if (one == probe.end() || other == probe.end()) return {};
    const double apart = std::abs(other->second - one->second);
    squares += apart * apart;
    if (apart <= longest) continue;
    longest = apart;
    ends = {one->first, other->first};
  }
  const auto radius = find("radius");
  const bool is_thick = radius != probe.end() && std::sqrt(squares) <= 2.0 * radius->second;
  return is_thick ? std::vector<std::string>() : ends;
}

FitConfig WithProbes(const FitConfig& values,
                     const std::vector<std::pair<const CandidateTerm*, Probe>>& probes) {
  FitConfig config = values;
  for (const auto& [candidate, probe] : probes) {
    for (const auto& [name, value] : probe) config.parameters.at(name).value = value;
    for (const std::string& name : candidate->switches) {
      ParameterSetting& setting = config.parameters.at(name);
      setting.free = true;
      setting.lower = std::min(setting.lower, setting.value);
      if (setting.value <= 0.0 && ParameterNamed(name).scale == Scale::kLog)
        MoveByAmounts(&setting);
    }
  }
  return config;
}

}  // namespace clothfit
