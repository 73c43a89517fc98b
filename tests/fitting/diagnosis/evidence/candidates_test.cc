// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/evidence/candidates.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/fitted/named_parameter.h"
#include "fitting/rollout/free_parameters.h"

namespace clothfit {
namespace {

Recording LyingCloth() {
  Recording recording;
  recording.cloth.size = {0.4, 0.4};
  recording.cloth.resolution = {3, 3};
  recording.ground_height = -1.0;
  return recording;
}

FitConfig NothingFree(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = false;
  return config;
}

FreeEntry EntryOf(const FreeParameters& free, const std::string& name) {
  for (const FreeEntry& entry : free.entries()) {
    if (entry.name == name) return entry;
  }
  throw std::out_of_range(name);
}

// A damping that is left out has a logarithmic scale elsewhere, and a factor as its prior's sigma.
TEST(WithProbes, MovesWhatIsNothingByAmounts) {
  const Recording recording = LyingCloth();
  FitConfig config = NothingFree(recording);
  ParameterSetting& damping = config.parameters.at("stretch.damping");
  damping.value = 0.0;
  damping.prior = 3.0;
  damping.prior_sigma = 10.0;
  const Scene scene = MakeScene(recording, config);
  const CandidateTerm candidate{"stretch.damping", "stretch", {"stretch.damping"}, {true}, {}};
  const FreeParameters free(WithProbes(config, {{&candidate, {}}}), scene, MakeParameterTable());
  ASSERT_EQ(free.Fabric().size(), 1U);
  const FreeEntry entry = free.entries()[0];
  EXPECT_FALSE(entry.is_log);
  EXPECT_EQ(free.start()[0], 0.0);
  EXPECT_EQ(entry.prior, 0.0);
  EXPECT_EQ(entry.prior_sigma, 30.0);  // N s/m
}

TEST(WithProbes, KeepsTheScaleOfWhatIsOffAboveNothing) {
  const Recording recording = LyingCloth();
  const FitConfig config = NothingFree(recording);
  const Scene scene = MakeScene(recording, config);
  const Extent extent{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}, {0.4, 0.4}, 1.0};
  int logarithmic = 0, linear = 0;
  for (const CandidateTerm& candidate : ListCandidates(config, scene, extent, {}, 1)) {
    const FreeParameters free(WithProbes(config, {{&candidate, candidate.probes.front()}}), scene,
                              MakeParameterTable());
    for (const std::string& name : candidate.switches) {
      const Parameter parameter = ParameterNamed(name);
      const FreeEntry entry = EntryOf(free, name);
      EXPECT_EQ(entry.is_log, parameter.scale == Scale::kLog && parameter.off > 0.0) << name;
      const double off = entry.is_log ? std::log(parameter.off) : parameter.off;
      EXPECT_LE(entry.lower, off) << name;
      EXPECT_GE(entry.upper, off) << name;
      EXPECT_TRUE(std::isfinite(entry.prior) && entry.prior_sigma > 0.0) << name;
      ++(entry.is_log ? logarithmic : linear);
    }
  }
  EXPECT_GT(logarithmic, 0);
  EXPECT_GT(linear, 0);
}

TEST(EndsOfLine, AreWhereABarGoesOnBeyondTheCloth) {
  Probe bar;
  for (const std::string name : {"x1", "y1", "z1", "x2", "y2", "z2"})
    bar["obstacle_capsule." + name] = 0.0;
  bar["obstacle_capsule.radius"] = 0.03;
  bar["obstacle_capsule.y1"] = 0.3;
  bar["obstacle_capsule.y2"] = -0.4;
  bar["obstacle_capsule.z2"] = 0.2;
  const std::vector<std::string> along_y = {"obstacle_capsule.y1", "obstacle_capsule.y2"};
  EXPECT_EQ(EndsOfLine(bar), along_y);
  Probe edge;
  for (const auto& [name, value] : bar)
    if (name != "obstacle_capsule.radius") edge["obstacle_table" + name.substr(16)] = value;
  const std::vector<std::string> of_edge = {"obstacle_table.y1", "obstacle_table.y2"};
  EXPECT_EQ(EndsOfLine(edge), of_edge);
}

// A bar that is as short as thick may be a ball: how long it is has to be found.
TEST(EndsOfLine, AreFoundOfWhatIsShort) {
  const Probe ball = {{"obstacle_sphere.x", 0.1},
                      {"obstacle_sphere.y", 0.2},
                      {"obstacle_sphere.z", 0.3},
                      {"obstacle_sphere.radius", 0.05}};
  EXPECT_TRUE(EndsOfLine(ball).empty());
  EXPECT_TRUE(EndsOfLine({}).empty());
  EXPECT_TRUE(EndsOfLine({{"crease.angle", 0.1}, {"crease.offset", 0.2}}).empty());
  const Probe bar = {{"obstacle_capsule.x1", 0.08},    {"obstacle_capsule.y1", 0.2},
                     {"obstacle_capsule.z1", 0.3},     {"obstacle_capsule.x2", 0.12},
                     {"obstacle_capsule.y2", 0.2},     {"obstacle_capsule.z2", 0.3},
                     {"obstacle_capsule.radius", 0.05}};
  EXPECT_TRUE(EndsOfLine(bar).empty());
}

TEST(FreeParameters, RefusesALogarithmOfNothing) {
  const Recording recording = LyingCloth();
  FitConfig config = NothingFree(recording);
  const Scene scene = MakeScene(recording, config);
  ParameterSetting& stiffness = config.parameters.at("stretch.stiffness");
  stiffness.free = true;
  EXPECT_NO_THROW(FreeParameters(config, scene, MakeParameterTable()));
  stiffness.lower = 0.0;
  EXPECT_THROW(FreeParameters(config, scene, MakeParameterTable()), InputError);
}

}  // namespace
}  // namespace clothfit
