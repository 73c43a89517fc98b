// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/validate/model_validation.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "fitting/diagnosis/fitted/fit_quality.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/diagnosis/gate/null_residuals.h"

namespace clothfit {
namespace {

constexpr double kFarBeyond = 0.3;       // of what a model gains, in recordings without it
constexpr double kBlockSeconds = 0.2;    // of the bootstrap
constexpr double kTwinsAreUnlike = 1.5;  // times what is left: its recordings are not like this one
constexpr int kFewestFrames = 8;         // in each half, to be worth it

// The source of observations whose fault is put right; see MeasureAgainstOthers.
std::optional<int> FaultySource(const FittedModel& model, const Ranking& ranking) {
  const std::vector<int>& faults = model.candidate.faults;
  if (faults.empty()) return {};
  const Fault& fault = ranking.faults[static_cast<std::size_t>(faults.front())];
  if (IsOfMarkers(fault.kind)) return kMarkerSource;
  if (!ShowsInTracks(fault)) return {};
  return fault.source;
}

// Of what is predicted, root mean square.
double NoiseOf(const Scene& scene, bool is_in_pixels) {
  if (!HasPoints(scene)) return 0.0;
  return is_in_pixels ? scene.track_sigma * std::sqrt(2.0) : scene.marker_sigma * std::sqrt(3.0);
}

HeldOutValidation ValidateBy(const HeldOutErrors& before, const HeldOutErrors& after,
                             bool is_in_pixels, const IrreducibleError& irreducible,
                             const ValidationStart& start) {
  const Scene& scene = start.before.scene;
  const int block = static_cast<int>(std::lround(kBlockSeconds * scene.recording.frame_rate));
  HeldOutValidation validation = Validate(before, after, block, irreducible, start.options.seed);
  validation.is_in_pixels = is_in_pixels;
  return validation;
}

// What is wrong with one source is held to all the others.
std::optional<HeldOutValidation> ValidateAgainstOthers(int source, const FittedModel& model,
                                                       const ValidationStart& start) {
  const std::optional<HeldOutErrors> before = MeasureAgainstOthers(start.before, source);
  const std::optional<HeldOutErrors> after = MeasureAgainstOthers(model.scene, source);
  if (!before || !after) return {};
  const bool is_in_pixels = source != kMarkerSource;
  const double noise = NoiseOf(start.before.scene, is_in_pixels);
  HeldOutValidation validation = ValidateBy(*before, *after, is_in_pixels, {noise, 0.0}, start);
  validation.is_against_others = true;
  return validation;
}

// What mesh and step do to a prediction is held against physics, not against a camera.
IrreducibleError IrreducibleErrorOf(const FittedModel& model, bool is_in_pixels,
                                    const ValidationStart& start) {
  const bool is_physics = model.candidate.faults.empty();
  const double discretisation = is_physics ? start.ranking.PredictionError() : 0.0;
  return {NoiseOf(start.before.scene, is_in_pixels), discretisation};
}

// The fit to the frames before `first` alone, begun where that of all fitted frames has ended.
std::optional<FittedScene> FitUntil(int first, const FittedScene& fitted,
                                    const DiagnosisOptions& options) {
  ModelStart start = GoOn(fitted);
  start.recording.splits.held_out_frames = {first, start.recording.frame_count - 1};
  return FitModel(fitted, start, kModelIterations, FitRunner(options));
}

// The model, put on the fit without it: a tenth of its amounts, so that it is neither off nor far.
ModelStart HardlyOn(const FittedModel& model, const FittedScene& without) {
  constexpr double kOfAmounts = 0.1;
  const ModelStart on = GoOn(model.scene);
  ModelStart start = GoOn(without);
  const auto take_over = [&](const std::string& name) -> ParameterSetting& {
    return start.config.parameters.at(name) = on.config.parameters.at(name);
  };
  for (const std::string& name : model.candidate.names) {
    ParameterSetting& setting = take_over(name);
    const double off = ParameterNamed(name).off;
    setting.value = off + kOfAmounts * (setting.value - off);
  }
  for (const auto& [name, value] : model.candidate.probe) take_over(name);
  return start;
}

// What a model gains in recordings in which it is not, at most.
struct NullGain {
  double cost = -HUGE_VAL;  // of fitted frames
  double held_out =
      -HUGE_VAL;  // mean of squares, of those in which it gains enough to be looked at
};

// gain: of cost, in the recording itself.
std::optional<NullGain> GainOfNull(const FittedModel& model, const ValidationStart& start,
                                   double gain) {
  constexpr int kTwins = 3, kTwinIterations = 2 * kModelIterations;
  const FitRunner runner(start.options);
  const std::optional<LinearisedFit> linear = Linearise(start.before);
  if (!linear) return {};
  const std::vector<FittedScene> drawn =
      DrawNearFit(start.before, linear->rows, kTwins, start.options.seed);
  std::vector<std::optional<NullGain>> gains(drawn.size());
  ParallelFor(static_cast<int>(drawn.size()), NumThreads(0), [&](int i, int) {
    const auto k = static_cast<std::size_t>(i);
    std::optional<Recording> twin = TwinRecording(drawn[k], start.options.seed + k);
    if (!twin) return;
    ModelStart without = GoOn(drawn[k]);
    without.recording = std::move(*twin);
    without.config.use_silhouettes = false;
    std::optional<FittedScene> before = FitModel(drawn[k], without, kTwinIterations, runner);
    if (!before) return;
    const std::optional<FittedScene> after =
        FitModel(*before, HardlyOn(model, *before), kTwinIterations, runner);
    if (!after) return;
    // As of the recording itself: what comes as far without it from there had found a local
    // minimum.
    std::optional<FittedScene> again =
        FitModel(*after, WithoutEffect(*before, *after), kTwinIterations, runner);
    before = Cheaper(std::move(before), std::move(again));
    // A finer mesh has an error of its own.
    const double more = OfDifference() * OfDifference();
    const double off = MeasureHeldOut(*before).Rms(), on = MeasureHeldOut(*after).Rms();
    gains[k] = NullGain{more * (before->fit.cost_after - after->fit.cost_after),
                        more * (off * off - on * on)};
  });
  std::optional<NullGain> most;
  for (const std::optional<NullGain>& of_twin : gains) {
    if (!of_twin) continue;
    if (!most) most.emplace();
    most->cost = std::max(most->cost, of_twin->cost);
    // Where a model gains next to nothing it would never be held to a prediction.
    if (of_twin->cost > kIdle * gain) most->held_out = std::max(most->held_out, of_twin->held_out);
  }
  return most;
}

}  // namespace

HeldOutValidation ValidateOnHeldOut(const FittedModel& model, const ValidationStart& start) {
  if (const std::optional<int> source = FaultySource(model, start.ranking)) {
    const std::optional<HeldOutValidation> validation =
        ValidateAgainstOthers(*source, model, start);
    if (validation) return *validation;
  }
  const bool is_in_pixels = model.scene.scene.markers.empty();
  return ValidateBy(start.errors, model.errors, is_in_pixels,
                    IrreducibleErrorOf(model, is_in_pixels, start), start);
}

std::optional<HeldOutValidation> ValidateOnEarlier(const FittedModel& model,
                                                   const ValidationStart& start,
                                                   std::optional<double> by_chance) {
  const Scene& scene = model.scene.scene;
  const auto& held_out = scene.recording.splits.held_out_frames;
  const bool is_at_end = held_out && held_out->last == scene.recording.frame_count - 1;
  const int last = scene.last_fitted_frame, first = (last + 1) / 2;
  if (!is_at_end || first < kFewestFrames) return {};
  const bool is_in_pixels = scene.markers.empty();
  IrreducibleError irreducible = IrreducibleErrorOf(model, is_in_pixels, start);
  const HeldOutValidation worse =
      ValidateBy(model.errors, start.errors, is_in_pixels, irreducible, start);
  const bool speak_against =
      worse.improvement_lower95 > 0.0 || model.errors.Rms() > kAsGood * start.errors.Rms();
  if (speak_against) return {};
  if (by_chance) irreducible.discretisation = *by_chance;
  const std::optional<FittedScene> before = FitUntil(first, start.before, start.options);
  const std::optional<FittedScene> after = FitUntil(first, model.scene, start.options);
  if (!before || !after) return {};
  HeldOutValidation validation =
      ValidateBy(MeasureHeldOut(*before, last), MeasureHeldOut(*after, last), is_in_pixels,
                 irreducible, start);
  validation.earlier = Splits::FrameRange{first, last};
  return validation;
}

std::optional<HeldOutValidation> ValidateOnTwins(const FittedModel& model,
                                                 const ValidationStart& start) {
  const Scene& scene = model.scene.scene;
  const bool is_in_pixels = scene.markers.empty();
  if (!HasPoints(scene)) return {};
  const double off = start.ranking.residual_rms;
  if (start.ranking.discretisation_rms > kTwinsAreUnlike * off || off > kUnusableResidual)
    return {};
  if (!ValidateBy(start.errors, model.errors, is_in_pixels, {}, start).is_validated) return {};
  const double gain = start.before.fit.cost_after - model.scene.fit.cost_after;
  if (!(gain > 0.0)) return {};
  const std::optional<NullGain> null = GainOfNull(model, start, gain);
  if (!null) return {};
  // The recordings have their noise, too.
  const double by_chance = std::sqrt(std::max(0.0, null->held_out));
  HeldOutValidation validation =
      ValidateBy(start.errors, model.errors, is_in_pixels, {0.0, by_chance}, start);
  validation.noise = NoiseOf(scene, is_in_pixels);
  validation.irreducible = std::hypot(validation.noise, by_chance);
  validation.gain_of_null = null->cost / gain;
  // Where it gains many times as much as in any of them, so few frames need not be certain of it:
  // that their errors fall, and by more than there, is enough.
  const double fall = validation.before * validation.before - validation.after * validation.after;
  const bool is_beyond = *validation.gain_of_null < kFarBeyond && fall > by_chance * by_chance;
  validation.is_validated =
      is_beyond || (validation.is_validated && *validation.gain_of_null < 1.0);
  return validation;
}

std::optional<HeldOutValidation> ValidateOtherwise(const FittedModel& model,
                                                   const ValidationStart& start) {
  if (!model.candidate.faults.empty()) return {};
  const std::string& name = model.candidate.summary.name;
  const auto say = [&](const std::string& stage) {
    if (start.options.progress) start.options.progress(stage, 0.65);
  };
  const auto log = [&](const std::string& line, const HeldOutValidation& validation) {
    if (start.options.log)
      start.options.log(line + (validation.is_validated ? "validated" : "not validated"));
  };
  say("fitting recordings of the baseline with " + name);
  std::optional<double> by_chance;
  if (const std::optional<HeldOutValidation> validation = ValidateOnTwins(model, start)) {
    log(fmt::format("{} gains {:.0f} % as much on recordings of the baseline alone; held out "
                    "{:.4g} -> {:.4g}, where they may tell {:.4g}: ",
                    name, 100.0 * *validation->gain_of_null, validation->before, validation->after,
                    validation->irreducible),
        *validation);
    if (validation->is_validated) return validation;
    const double squared = std::max(0.0, validation->irreducible * validation->irreducible -
                                             validation->noise * validation->noise);
    if (*validation->gain_of_null < 1.0) by_chance = std::sqrt(squared);
  }
  say("predicting earlier frames with " + name);
  const std::optional<HeldOutValidation> validation = ValidateOnEarlier(model, start, by_chance);
  if (!validation) return {};
  log(fmt::format("fitted to frames before {} alone, {} predicts those to {} with an error of "
                  "{:.4g}, not {:.4g}: ",
                  validation->earlier->first, name, validation->earlier->last, validation->after,
                  validation->before),
      *validation);
  return validation->is_validated ? validation : std::nullopt;
}

HeldOutValidation ValidateByAnyTest(const FittedModel& model, const ValidationStart& start) {
  HeldOutValidation validation = ValidateOnHeldOut(model, start);
  if (validation.is_validated || !start.options.validate) return validation;
  return ValidateOtherwise(model, start).value_or(validation);
}

}  // namespace clothfit
