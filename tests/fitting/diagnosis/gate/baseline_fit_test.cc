// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A baseline is not left in the first local minimum that its fit comes to.
#include "fitting/diagnosis/gate/baseline_fit.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

Recording StiffCloth() {
  SyntheticOptions options;
  options.resolution = {5, 5};
  options.frame_rate = 30.0;
  options.frame_count = 30;
  options.steps_per_frame = 4;
  options.parameters = {{"bending.stiffness", 2e-3},
                        {"bending.damping", 2e-5},
                        {"stretch.stiffness", 300.0},
                        {"stretch.damping", 0.5},
                        {"shear.damping", 0.2}};
  return MakeSyntheticRecording(options).recording;
}

TEST(BaselineFit, OtherStartsChangeWhatIsFreeWithinItsBounds) {
  FitConfig config = DefaultConfig(StiffCloth());
  config.parameters.at("shear.damping").free = false;
  config.parameters.at("stretch.damping").lower =
      0.9 * config.parameters.at("stretch.damping").value;
  const std::vector<FitConfig> starts = OtherStarts(config);
  ASSERT_EQ(starts.size(), 3U);
  for (const FitConfig& start : starts) {
    const auto ratio = [&](const char* name) {
      return start.parameters.at(name).value / config.parameters.at(name).value;
    };
    EXPECT_DOUBLE_EQ(ratio("shear.damping"), 1.0);
    EXPECT_DOUBLE_EQ(ratio("stretch.damping"), 0.9);
    EXPECT_NEAR(ratio("bending.damping"), 0.1, 1e-12);
    EXPECT_DOUBLE_EQ(ratio("air_drag.normal"), 1.0);
  }
  const auto value = [&](int i, const char* name) { return starts[i].parameters.at(name).value; };
  EXPECT_GT(value(1, "bending.stiffness"), 10.0 * value(0, "bending.stiffness"));
  EXPECT_LT(value(2, "stretch.stiffness"), 0.2 * value(0, "stretch.stiffness"));
}

TEST(BaselineFit, OtherStartsDiffer) {
  const auto starts_with_fixed = [](const std::vector<const char*>& names) {
    FitConfig config = DefaultConfig(StiffCloth());
    for (const char* name : names) config.parameters.at(name).free = false;
    const std::vector<FitConfig> starts = OtherStarts(config);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      EXPECT_FALSE(ConfigDifferences(starts[i], config).empty());
      for (std::size_t k = 0; k < i; ++k)
        EXPECT_FALSE(ConfigDifferences(starts[i], starts[k]).empty());
    }
    return starts.size();
  };
  EXPECT_EQ(starts_with_fixed({}), 3U);
  EXPECT_EQ(starts_with_fixed({"bending.stiffness"}), 2U);
  EXPECT_EQ(starts_with_fixed({"bending.stiffness", "stretch.stiffness"}), 1U);
  EXPECT_EQ(starts_with_fixed({"bending.stiffness", "stretch.stiffness", "stretch.damping",
                               "shear.damping", "bending.damping"}),
            0U);
}

TEST(BaselineFit, EndsNoHigherThanFromTheConfigsOwnStart) {
  const Recording recording = StiffCloth();
  FitConfig config = DefaultConfig(recording);
  config.initial_order = 1;
  config.max_iterations =
      3;  // so few that the config's start, which is far off, does not get there
  const Scene scene = MakeScene(recording, config);
  const FitResult own = RunFit(scene, config);
  std::vector<std::string> log;
  DiagnosisOptions options;
  options.log = [&](const std::string& line) { log.push_back(line); };
  const FittedScene fitted = FitBaseline(recording, config, options);
  EXPECT_LE(fitted.fit.cost_after, own.cost_after);
  const auto others = std::count_if(log.begin(), log.end(), [](const std::string& line) {
    return line.find("from other material parameters") != std::string::npos;
  });
  EXPECT_EQ(others, 3);  // it was worth trying
  EXPECT_EQ(fitted.config.max_iterations, 3);
}

}  // namespace
}  // namespace clothfit
