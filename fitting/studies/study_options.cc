// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/study_options.h"

#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/studies/comparison.h"
#include "tracking/synthetic/presets.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

void Expect(bool right, const char* option, const std::string& found, const char* expected) {
  if (!right) throw InputError(option, fmt::format("{}: expected {}", found, expected));
}

void ExpectInteger(const char* option, int value, int least, int most) {
  Expect(value >= least && value <= most, option, std::to_string(value),
         fmt::format("{} to {}", least, most).c_str());
}

}  // namespace

void StudyOptions::Check() const {
  for (const std::string& name : experiments) PresetOptions("--experiments", name);
  Expect(!experiments.empty(), "--experiments", "none", "one or more");
  ExpectInteger("--frames", frames, 5, 10000);
  ExpectInteger("--particles", particles, 3, 200);
  ExpectInteger("--picture", picture, 64, 4096);
  ExpectInteger("--generator", generator, 5, 401);
  Expect(generator % 2 == 1, "--generator", std::to_string(generator), "an odd number");
  ExpectInteger("--points", points, 1, 100000);
  ExpectInteger("--starts", starts, 1, 1000);
  Expect(simulations > 0.0, "--simulations", FormatNumber(simulations), "a number above 0");
  const Contender contender = ParseContender("--search", search);
  const bool is_pattern =
      contender.optimiser == "pattern" && contender.strategy != Strategy::kOneLoop;
  ExpectInteger("--under-way", under_way, 1, 1000);
  Expect(under_way == 1 || is_pattern, "--under-way", search,
         "pattern/two-loop or pattern/joint as --search");
  const std::vector<NamedParameter> table = MakeParameterTable();
  for (const std::string& name : fabric) RequireParameter(table, name, "--fabric");
  const bool ordered = std::all_of(values.begin(), values.end(), [](double v) { return v > 0.0; });
  Expect(ordered, "--values", "0 or less", "numbers above 0");
}

StudyOptions FullSize() {
  StudyOptions options;
  options.full = true;
  options.frames = 300;
  options.generator = 61;
  options.picture = 640;
  options.particles = 31;
  options.fabric = {"stretch.stiffness", "stretch.damping",     "shear.stiffness",
                    "shear.damping",     "bending.stiffness",   "bending.damping",
                    "air_drag.normal",   "air_drag.tangential", "ground.friction"};
  options.simulations = 100000.0;
  options.points = 300;
  options.starts = 3;
  return options;
}

}  // namespace clothfit
