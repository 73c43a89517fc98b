// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/plan.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "autodiff_sim/base/normal_numbers.h"
#include "fitting/trials/finite_elements/laws.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kFitStep = 1.0 / 120.0;  // s, FitConfig::max_step
constexpr int kRefinement = 2;            // of the generator's mesh over the fit's
constexpr SyntheticScenario kCleanMotions[] = {
    SyntheticScenario::kTwoCornerSwing, SyntheticScenario::kTwoCornerShake,
    SyntheticScenario::kTwoCornerTurn, SyntheticScenario::kFourCornerSag,
    SyntheticScenario::kCornerLift};
constexpr TrialObservation kObservations[] = {TrialObservation::kMarkers, TrialObservation::kTracks,
                                              TrialObservation::kSilhouettes,
                                              TrialObservation::kMixture};

// FNV-1a: gives each trial a seed of its own that does not depend on the others.
std::uint64_t SeedOf(const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash >> 1;  // fits a signed number, as other programs read it
}

// s; slow motions are recorded for longer.
double DurationOf(SyntheticScenario motion) {
  const bool is_fast =
      motion == SyntheticScenario::kTwoCornerSwing || motion == SyntheticScenario::kTwoCornerShake;
  return is_fast ? 2.5 : 5.0;
}

// Points are followed where markers would be; what is not observed is taken out again later.
void SetObservation(TrialObservation observation, SyntheticOptions* recording) {
  const bool has_markers =
      observation == TrialObservation::kMarkers || observation == TrialObservation::kMixture;
  const bool is_mixture = observation == TrialObservation::kMixture;
  recording->markers = is_mixture ? Eigen::Vector2i(4, 4) : Eigen::Vector2i(7, 7);
  recording->marker_sigma = is_mixture ? 0.002 : 0.0015;
  recording->num_cameras = has_markers ? (is_mixture ? 2 : 0) : 3;
  recording->tracks = observation == TrialObservation::kTracks || is_mixture;
}

// The scene, its size and what is seen of it.
SyntheticOptions RecordingOf(SyntheticScenario motion, TrialObservation observation,
                             const TrialPlanOptions& options) {
  SyntheticOptions recording;
  recording.scenario = motion;
  recording.size = {kTrialClothSize, kTrialClothSize};
  recording.resolution = {options.resolution, options.resolution};
  recording.frame_count = options.frame_count;
  recording.frame_rate = options.frame_count / DurationOf(motion);
  const double step = options.same_generator ? kFitStep : 0.5 * kFitStep;
  // A hair less, so that a rate which divides the step does not round up.
  recording.steps_per_frame =
      std::max(1, static_cast<int>(std::ceil(1.0 / (recording.frame_rate * step) - 1e-9)));
  recording.refinement = options.same_generator ? 1 : kRefinement;
  SetObservation(observation, &recording);
  return recording;
}

// Around the typical fabric, a fifth of the logarithm off, at most two sigmas.
void DrawFabric(Fabric fabric, NormalNumbers* random, SyntheticOptions* recording) {
  for (const auto& [name, typical] : TypicalParameters(fabric)) {
    const double offset = std::clamp(random->Next(), -2.0, 2.0);
    recording->parameters[name] = typical * std::exp(0.2 * offset);
  }
}

// Numbers of a size by a tenth of it; places on the cloth by 2 cm. Places in the world stay, since
// by a little more or less the cloth misses an obstacle.
double Drawn(const Parameter& parameter, double value, bool is_amount, NormalNumbers* random) {
  const double offset = std::clamp(random->Next(), -2.0, 2.0);
  if (parameter.meaning == Meaning::kClothU || parameter.meaning == Meaning::kClothV)
    return std::clamp(value + 0.02 * offset, 0.0, kTrialClothSize);
  if (!is_amount || !SwitchesOff(parameter)) return value;
  return parameter.off + (value - parameter.off) * std::exp(0.1 * offset);
}

PlantedEffect Plant(const PlantableEffect& effect, EffectSize size, NormalNumbers* random) {
  PlantedEffect planted;
  planted.term = effect.term;
  planted.size = size;
  const double sign = effect.either_sign && random->Next() < 0.0 ? -1.0 : 1.0;
  for (const Parameter& parameter : TermOf(effect.term).parameters) {
    const auto amount = effect.amounts.find(parameter.name);
    const auto shape = effect.shape.find(parameter.name);
    const bool is_amount = amount != effect.amounts.end();
    if (!is_amount && shape == effect.shape.end()) continue;
    const double value =
        is_amount ? sign * amount->second[static_cast<std::size_t>(size)] : shape->second;
    planted.parameters[effect.term + "." + parameter.name] =
        Drawn(parameter, value, is_amount, random);
  }
  return planted;
}

PlantedFault DrawFault(FaultKind kind, const SyntheticOptions& recording, NormalNumbers* random) {
  const auto signed_amount = [random](double amount) {
    const double size = amount * std::exp(0.2 * std::clamp(random->Next(), -2.0, 2.0));
    return random->Next() < 0.0 ? -size : size;
  };
  PlantedFault fault;
  fault.kind = kind;
  const int num_markers = recording.markers.prod();
  fault.camera = recording.num_cameras > 0
                     ? std::abs(static_cast<int>(random->Next() * 1e3)) % recording.num_cameras
                     : 0;
  switch (kind) {
    case FaultKind::kCameraPose:
      for (int k = 0; k < 3; ++k) fault.turn[k] = signed_amount(0.003);
      for (int k = 0; k < 3; ++k) fault.shift[k] = signed_amount(0.004);
      break;
    case FaultKind::kCameraClock:
      fault.delay = signed_amount(0.01);
      break;
    case FaultKind::kCameraScale:
      fault.scale = signed_amount(0.01);
      break;
    case FaultKind::kMarkerShift:
      for (int k = 0; k < 2; ++k) fault.on_cloth[k] = signed_amount(0.005);
      break;
    case FaultKind::kMarkerSwap:
      fault.first_marker = num_markers / 2;
      fault.second_marker = num_markers / 2 + 1;
      break;
  }
  return fault;
}

bool FemKnowsAll(const std::vector<PlantableEffect>& effects) {
  return std::all_of(effects.begin(), effects.end(),
                     [](const PlantableEffect& effect) { return FemKnows(effect.term); });
}

// Collects the trials of a plan.
class Planner {
 public:
  Planner(const TrialPlanOptions& options, int seed) : options_(options), seed_(seed) {}
  std::vector<Trial> Take() { return std::move(trials_); }

  void AddClean(SyntheticScenario motion, TrialObservation observation, Fabric fabric) {
    if (!options_.only.empty()) return;
    Begin(TrialKind::kClean, "none-" + ToString(fabric), motion, observation, fabric, "");
  }

  void AddFault(FaultKind kind, SyntheticScenario motion, TrialObservation observation) {
    if (!IsWanted(ToString(kind))) return;
    NormalNumbers random =
        Begin(TrialKind::kFault, ToString(kind), motion, observation, Fabric::kWoven, "");
    trials_.back().fault = DrawFault(kind, trials_.back().recording, &random);
  }

  void AddEffect(TrialKind kind, const std::vector<PlantableEffect>& effects,
                 TrialObservation observation, EffectSize size) {
    std::string what;
    bool is_wanted = false;
    for (const PlantableEffect& effect : effects) {
      what += (what.empty() ? "" : "+") + effect.term;
      is_wanted = is_wanted || IsWanted(effect.term);
    }
    if (!is_wanted || (options_.finite_elements && !FemKnowsAll(effects))) return;
    NormalNumbers random = Begin(kind, what, effects.front().motion, observation,
                                 effects.front().fabric, "-" + ToString(size));
    for (const PlantableEffect& effect : effects) {
      trials_.back().effects.push_back(Plant(effect, size, &random));
      if (kind == TrialKind::kUnlisted) continue;
      for (const auto& [name, value] : trials_.back().effects.back().parameters)
        trials_.back().recording.parameters[name] = value;
    }
  }

 private:
  bool IsWanted(const std::string& name) const {
    return options_.only.empty() ||
           std::find(options_.only.begin(), options_.only.end(), name) != options_.only.end();
  }

  // A trial without effects; returns the numbers to draw them with.
  NormalNumbers Begin(TrialKind kind, const std::string& what, SyntheticScenario motion,
                      TrialObservation observation, Fabric fabric, const std::string& size) {
    Trial trial;
    trial.name = fmt::format("{}-{}-{}-{}{}-s{}", ToString(kind), what, ToString(motion),
                             ToString(observation), size, seed_);
    trial.kind = kind;
    trial.observation = observation;
    trial.fabric = fabric;
    trial.seed = SeedOf(trial.name);
    trial.finite_elements = options_.finite_elements;
    trial.recording = RecordingOf(motion, observation, options_);
    trial.recording.name = trial.name;
    trial.recording.seed = trial.seed;
    NormalNumbers random(trial.seed, 7);
    DrawFabric(fabric, &random, &trial.recording);
    trials_.push_back(std::move(trial));
    return random;
  }

  const TrialPlanOptions& options_;
  int seed_;
  std::vector<Trial> trials_;
};

// 60: five motions, four kinds of observation, three fabrics.
void AddCleanTrials(Planner* planner) {
  for (const SyntheticScenario motion : kCleanMotions) {
    for (const TrialObservation observation : kObservations) {
      for (const Fabric fabric : kFabrics) planner->AddClean(motion, observation, fabric);
    }
  }
}

// 60: five faults, three or six motions, four or two kinds of observation that it can befall.
void AddFaultTrials(Planner* planner) {
  constexpr SyntheticScenario kThree[] = {SyntheticScenario::kTwoCornerSwing,
                                          SyntheticScenario::kTwoCornerTurn,
                                          SyntheticScenario::kFourCornerSag};
  constexpr SyntheticScenario kFour[] = {kThree[0], kThree[1], kThree[2],
                                         SyntheticScenario::kCornerLift};
  constexpr SyntheticScenario kSix[] = {kFour[0],
                                        kFour[1],
                                        kFour[2],
                                        kFour[3],
                                        SyntheticScenario::kTwoCornerShake,
                                        SyntheticScenario::kTwoCornerLift};
  for (const FaultKind kind : kFaultKinds) {
    const bool is_marker = kind == FaultKind::kMarkerShift || kind == FaultKind::kMarkerSwap;
    if (is_marker) {
      for (const SyntheticScenario motion : kSix) {
        planner->AddFault(kind, motion, TrialObservation::kMarkers);
        planner->AddFault(kind, motion, TrialObservation::kMixture);
      }
      continue;
    }
    for (const SyntheticScenario motion : kFour) {
      planner->AddFault(kind, motion, TrialObservation::kTracks);
      planner->AddFault(kind, motion, TrialObservation::kSilhouettes);
      planner->AddFault(kind, motion, TrialObservation::kMixture);
    }
  }
}

// Each effect and motion in two kinds of observation, one with markers and one of pictures only, at
// three sizes.
void AddEffectTrials(TrialKind kind, const std::vector<PlantableEffect>& effects,
                     Planner* planner) {
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const TrialObservation with_markers =
        i % 3 == 2 ? TrialObservation::kMixture : TrialObservation::kMarkers;
    const TrialObservation pictures =
        i % 4 == 3 ? TrialObservation::kSilhouettes : TrialObservation::kTracks;
    for (const TrialObservation observation : {with_markers, pictures}) {
      for (const EffectSize size : kEffectSizes)
        planner->AddEffect(kind, {effects[i]}, observation, size);
    }
  }
}

const PlantableEffect& Find(const std::string& term, SyntheticScenario motion) {
  for (const PlantableEffect& effect : ListedEffects()) {
    if (effect.term == term && effect.motion == motion) return effect;
  }
  throw InputError("pairs", term + " is not planted in " + ToString(motion));
}

// 40: ten pairs that show in the same motion, two kinds of observation, two sizes.
void AddPairTrials(Planner* planner) {
  struct Pair {
    const char *first, *second;
    SyntheticScenario motion;
  };
  constexpr Pair kPairs[] = {
      {"wind", "heavy_patch", SyntheticScenario::kTwoCornerSwing},
      {"wind", "shear_friction", SyntheticScenario::kTwoCornerSwing},
      {"gust", "shear_orthotropy", SyntheticScenario::kTwoCornerSwing},
      {"gravity_tilt", "added_mass", SyntheticScenario::kTwoCornerSwing},
      {"obstacle_sphere", "heavy_patch", SyntheticScenario::kTwoCornerSwing},
      {"gust", "attractor", SyntheticScenario::kTwoCornerTurn},
      {"heavy_patch", "shear_friction", SyntheticScenario::kFourCornerSag},
      {"stretch_orthotropy", "stiff_seam_stretch", SyntheticScenario::kFourCornerSag},
      {"bending_orthotropy", "stiff_patch_bending", SyntheticScenario::kCornerLift},
      {"adhesion", "bending_friction", SyntheticScenario::kCornerLift}};
  for (const Pair& pair : kPairs) {
    const std::vector<PlantableEffect> both = {Find(pair.first, pair.motion),
                                               Find(pair.second, pair.motion)};
    for (const TrialObservation observation :
         {TrialObservation::kMarkers, TrialObservation::kTracks}) {
      for (const EffectSize size : {EffectSize::kMiddle, EffectSize::kLarge})
        planner->AddEffect(TrialKind::kPair, both, observation, size);
    }
  }
}

// One of each kind and a few more, for tests and to see that everything runs.
void AddQuickTrials(Planner* planner) {
  const SyntheticScenario swing = SyntheticScenario::kTwoCornerSwing;
  planner->AddClean(swing, TrialObservation::kMarkers, Fabric::kWoven);
  planner->AddClean(SyntheticScenario::kFourCornerSag, TrialObservation::kTracks, Fabric::kKnit);
  planner->AddFault(FaultKind::kCameraPose, swing, TrialObservation::kTracks);
  planner->AddFault(FaultKind::kMarkerSwap, swing, TrialObservation::kMarkers);
  for (const char* term : {"wind", "heavy_patch", "obstacle_sphere", "shear_friction"}) {
    planner->AddEffect(TrialKind::kListed, {Find(term, swing)}, TrialObservation::kMarkers,
                       EffectSize::kLarge);
  }
  planner->AddEffect(TrialKind::kUnlisted, {UnlistedEffects().front()}, TrialObservation::kMarkers,
                     EffectSize::kLarge);
  planner->AddEffect(TrialKind::kPair, {Find("wind", swing), Find("heavy_patch", swing)},
                     TrialObservation::kMarkers, EffectSize::kLarge);
}

void CheckOnly(const std::vector<std::string>& only) {
  std::vector<std::string> known = NamesOf(AbsentTerms());
  for (const PlantableEffect& effect : UnlistedEffects()) {
    if (std::find(known.begin(), known.end(), effect.term) == known.end())
      known.push_back(effect.term);
  }
  for (const FaultKind kind : kFaultKinds) known.push_back(ToString(kind));
  for (const std::string& name : only) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InputError("--only", "'" + name + "': " + Suggestion(name, known));
  }
}

void CheckSizes(const TrialPlanOptions& options) {
  const auto expect = [](bool right, const char* option, int value, const char* expected) {
    if (!right) throw InputError(option, fmt::format("{}: expected {}", value, expected));
  };
  expect(options.num_seeds >= 1, "--seeds", options.num_seeds, "1 or more");
  expect(options.first_seed >= 0, "--first-seed", options.first_seed, "0 or more");
  expect(options.frame_count >= 10, "--frames", options.frame_count, "10 or more");
  expect(options.resolution >= 4 && options.resolution <= 100, "--resolution", options.resolution,
         "4 to 100 particles a side");
}

// One trial of each of `count` stretches of the list, of (nearly) equal length: all kinds, effects,
// motions and sizes in proportion, and each trial as likely as any other.
std::vector<Trial> Sample(std::vector<Trial> trials, int count, int seed) {
  const std::size_t n = trials.size(), k = static_cast<std::size_t>(count);
  if (k >= n) return trials;
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<Trial> sample;
  for (std::size_t i = 0; i < k; ++i) {
    const std::size_t begin = i * n / k, end = (i + 1) * n / k;
    sample.push_back(std::move(trials[begin + random() % (end - begin)]));
  }
  return sample;
}

}  // namespace

std::string ToString(TrialKind kind) {
  constexpr const char* kNames[] = {"clean", "fault", "listed", "unlisted", "pair"};
  return kNames[static_cast<int>(kind)];
}

std::string ToString(TrialObservation observation) {
  constexpr const char* kNames[] = {"markers", "tracks", "silhouettes", "mixture"};
  return kNames[static_cast<int>(observation)];
}

std::string ToString(FaultKind kind) {
  constexpr const char* kNames[] = {"camera-pose", "camera-clock", "camera-scale", "marker-shift",
                                    "marker-swap"};
  return kNames[static_cast<int>(kind)];
}

std::map<std::string, double> Trial::UnlistedParameters() const {
  std::map<std::string, double> parameters;
  for (const PlantedEffect& effect : effects) {
    if (!IsListed(effect.term))
      parameters.insert(effect.parameters.begin(), effect.parameters.end());
  }
  return parameters;
}

std::vector<std::string> TrialPlanNames() {
  return {"clean", "fault", "listed", "unlisted", "pairs", "all", "quick"};
}

std::vector<Trial> MakeTrialPlan(const std::string& place, const std::string& plan,
                                 const TrialPlanOptions& options) {
  const std::vector<std::string> names = TrialPlanNames();
  if (std::find(names.begin(), names.end(), plan) == names.end())
    throw InputError(place, "'" + plan + "': " + Suggestion(plan, names));
  CheckOnly(options.only);
  CheckSizes(options);
  std::vector<Trial> trials;
  for (int seed = options.first_seed; seed < options.first_seed + options.num_seeds; ++seed) {
    Planner planner(options, seed);
    const bool all = plan == "all";
    if (all || plan == "clean") AddCleanTrials(&planner);
    if (all || plan == "fault") AddFaultTrials(&planner);
    if (all || plan == "listed") AddEffectTrials(TrialKind::kListed, ListedEffects(), &planner);
    if (all || plan == "unlisted")
      AddEffectTrials(TrialKind::kUnlisted, UnlistedEffects(), &planner);
    if (all || plan == "pairs") AddPairTrials(&planner);
    if (plan == "quick") AddQuickTrials(&planner);
    for (Trial& trial : planner.Take()) {
      if (trial.name.find(options.match) != std::string::npos) trials.push_back(std::move(trial));
    }
  }
  if (trials.empty() && !options.match.empty())
    throw InputError("--match",
                     "'" + options.match + "': no trial of the plan has that in its name");
  if (trials.empty()) {
    throw InputError("--only",
                     JoinNames(options.only) + ": the plan '" + plan + "' has none of these");
  }
  if (options.sample < 0)
    throw InputError("--sample", fmt::format("{}: expected 1 or more trials", options.sample));
  if (options.sample > 0) trials = Sample(std::move(trials), options.sample, options.first_seed);
  return trials;
}

std::string DescribePlan(const std::vector<Trial>& trials) {
  std::string text;
  for (const Trial& trial : trials) {
    text += trial.name;
    for (const PlantedEffect& effect : trial.effects) {
      for (const auto& [name, value] : effect.parameters)
        text += fmt::format(" {}={:.4g}", name, value);
    }
    text += "\n";
  }
  return text + fmt::format("{} trials\n", trials.size());
}

}  // namespace clothfit
