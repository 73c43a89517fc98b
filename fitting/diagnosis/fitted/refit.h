// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fitted scene fitted again: further, without some of its parameters, from elsewhere, or nudged
// to what was observed.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/rollout/nudging.h"

namespace clothfit {

// Where a fit of a model begins.
struct ModelStart {
  Recording recording;
  FitConfig config;
};

// Keeps an estimate inside, off the bounds themselves so that a logarithm can move it.
double Inside(double value, const ParameterSetting& setting);

// Change of the cost, relative to it, at which a fit ends: of the size of noise. What is left of
// the way is linear, and the projection goes it.
inline constexpr double kEnoughForDiagnosis = 1e-4;
// The same where costs of models are compared: of points a tenth of that. Some forty rows of
// outlines say as much as one, so that there it is a few hundredths of a nat already.
double EnoughToDecide(const Scene& scene);

// A few iterations of all frames at once: it begins near, or is nudged.
FitConfig QuickConfig(FitConfig config, int most_iterations, double tolerance);

// A fitted model, to be fitted further.
ModelStart GoOn(const FittedScene& model);

// The same without some of its parameters (full names): off, and not fitted.
ModelStart GoOnWithout(const FittedScene& model, const std::vector<std::string>& names);

// The same scene without the model's effect, begun from what the model found for everything else.
ModelStart WithoutEffect(const FittedScene& before, const FittedScene& model);

// The same from the material parameters that a config was given, where that is free.
ModelStart WithMaterialOf(const FitConfig& given, ModelStart start);

// How a fit begins: with all frames at once, or with windows that grow (ShootingWindows).
enum class Start { kPlain, kWindows };

// What is fitted while every marker and every track's ray pulls at the cloth, at first so strongly
// that the motion follows within some 25 ms, then weaker and weaker, as it is at the last:
// IsNudged. On a mesh of 13 particles a side at most, where the motion is as good. Empty where the
// fit fails, or where there is nothing to nudge it to.
std::optional<FittedScene> FitNudged(const ModelStart& start, double damping,
                                     const FitRunner& runner);

// Fits it from its config's own material parameters and no offsets of the start, all over again.
// Empty where the fit fails, or where there are no windows.
std::optional<FittedScene> FitAfresh(const ModelStart& start, Start how, int most_iterations,
                                     const FitRunner& runner,
                                     double tolerance = kEnoughForDiagnosis);

// Fits it, from the handles' paths and initial state of `fitted`. Empty where the fit fails.
std::optional<FittedScene> FitModel(const FittedScene& fitted, const ModelStart& start,
                                    int most_iterations, const FitRunner& runner,
                                    double tolerance = kEnoughForDiagnosis);

// Which lengths of forecasts are fitted, and by how many iterations each at most.
struct ForecastLengths {
  int first = 0, last = kAllLengths;  // the last one is not
  int most_iterations = std::numeric_limits<int>::max();
};

// A fit gone on with on another grid. Empty where that fails.
std::optional<FittedScene> FitOnGrid(const std::array<int, 2>& grid, const FittedScene& fitted,
                                     int most_iterations, const FitRunner& runner);

// Fits it to forecasts on a grid, from the handles' paths and initial state of `after`, where that
// is given. Empty where the fit fails, or where there are no windows.
std::optional<FittedScene> FitToForecasts(const ModelStart& start, const std::array<int, 2>& grid,
                                          const ForecastLengths& lengths, const FitRunner& runner,
                                          const FittedScene* after = nullptr);

// A fit to forecasts gone on with: windows that grow further, then all frames.
std::optional<FittedScene> FitBeyondForecasts(const FittedScene& forecasts, int most_iterations,
                                              const FitRunner& runner);

// That, and, where it leaves more than kLargeResidual, a fit by windows that grow on the grid
// `coarse`, from the material of the config `given` and the other parameters of `forecasts`, gone
// on with on theirs: the material of forecasts may lead to another valley. Where either costs more
// than `before`, the fit to all frames without the newest effect, one from where that ended, too:
// a model's minimum costs no more than that of a model within it. The cheapest; empty where all
// fail.
std::optional<FittedScene> FitToAllFrames(const FitConfig& given, const FittedScene& before,
                                          const FittedScene& forecasts,
                                          const std::array<int, 2>& coarse, int most_iterations,
                                          const FitRunner& runner);

// Of two fits of the same model the one that costs less; empty where both are.
std::optional<FittedScene> Cheaper(std::optional<FittedScene> a, std::optional<FittedScene> b);

}  // namespace clothfit
