// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/config/config.h"

#include <cmath>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/keys.h"
#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::string ReadErrorOf(const std::string& yaml) {
  const TestFolder folder;
  const auto file = folder.Write("fit.yaml", yaml);
  FitConfig config = DefaultConfig({});
  return InputErrorOf([&] { ReadConfig(file, &config); });
}

// Every value is another than the default, and the numbers have no short decimals.
FitConfig AwkwardConfig() {
  FitConfig config = DefaultConfig({});
  config.recording = "/somewhere/a recording: #1";
  config.resolution = {12, 13};
  config.buckling = false;
  config.max_step = 1.0 / 77.0;
  config.integrator = Integrator::kBackwardEuler;
  config.tolerance = std::sqrt(2.0) * 1e-9;
  config.self_contact = true;
  config.check_intersections = true;
  config.initial_order = 2;
  config.initial_position_sigma = 1.0 / 300.0;
  config.initial_velocity_sigma = 1.0 / 7.0;
  config.spline_spacing = 1.0 / 9.0;
  config.spline_acceleration = 100.0 / 3.0;
  config.spline_speed = 5.0 / 3.0;
  config.coarse_resolution = 5;
  config.window_resolution = 23;
  config.use_tracks = false;
  config.use_silhouettes = true;
  config.leave_out_outliers = false;
  config.alpha = 1.0 / 3.0;
  config.beta = 1e-17;
  config.cloud_points = 77;
  config.cloud_coverage = 1.0 / 7.0;
  config.loss = LossKind::kCauchy;
  config.loss_scale = 2.0 / 3.0;
  config.frames = std::array<int, 2>{3, 88};
  config.hold_out = true;
  config.attract = true;
  config.window = 0.0;
  config.polish = false;
  config.loops = Strategy::kTwoLoop;
  config.optimiser = "pattern";
  config.max_simulations = 1e3 / 7.0;
  config.polish_hard = false;
  config.finest = 45;
  config.refined = true;
  config.every = 2;
  config.max_iterations = 7;
  config.function_tolerance = 1e-300;
  config.parameters["air_drag.normal"] = {1.0 / 3.0, false, 1e-17, 1e17 / 7.0,
                                          2.0 / 3.0, 1.1,   {},    false};
  return config;
}

TEST(DefaultConfig, CoversEveryParameterAndIsRight) {
  const FitConfig config = DefaultConfig({});
  for (const NamedParameter& named : MakeParameterTable()) {
    ASSERT_EQ(config.parameters.count(named.name), 1u) << named.name;
    const ParameterSetting& setting = config.parameters.at(named.name);
    EXPECT_EQ(setting.value, named.parameter.initial);
    EXPECT_EQ(setting.prior, named.parameter.initial);
    EXPECT_EQ(setting.prior_sigma, named.parameter.prior_factor);
    EXPECT_EQ(setting.lower, named.parameter.lower);
    EXPECT_EQ(setting.upper, named.parameter.upper);
  }
  EXPECT_NO_THROW(config.Check("defaults"));
}

TEST(DefaultConfig, FreesThePlaceOfObstaclesThatWereMeasuredRoughly) {
  Recording recording;
  recording.obstacles = {{"table", BoxShape{{1.0, 1.0, 0.1}}, {{}}}};
  EXPECT_FALSE(DefaultConfig(recording).parameters.at("obstacle.shift_z").free);
  EXPECT_TRUE(DefaultConfig(recording).parameters.at("obstacle.friction").free);
  recording.noise.obstacles = 0.02;
  FitConfig config = DefaultConfig(recording);
  EXPECT_TRUE(config.parameters.at("obstacle.shift_x").free);
  EXPECT_TRUE(config.parameters.at("obstacle.shift_z").free);
  EXPECT_EQ(config.parameters.at("obstacle.shift_z").prior_sigma, 0.02);
  EXPECT_FALSE(config.parameters.at("obstacle.growth").free);  // there is nothing round
  recording.obstacles.push_back({"bar", BarShape{0.02, 1.0}, {{}}});
  config = DefaultConfig(recording);
  EXPECT_TRUE(config.parameters.at("obstacle.growth").free);
  EXPECT_NO_THROW(config.Check("config"));
  recording.obstacles.clear();
  EXPECT_FALSE(DefaultConfig(recording).parameters.at("obstacle.shift_z").free);
  EXPECT_FALSE(DefaultConfig(recording).parameters.at("obstacle.friction").free);
}

TEST(DefaultConfig, FollowsTheRecording) {
  Recording recording;
  EXPECT_FALSE(DefaultConfig(recording).parameters.at("ground.friction").free);
  EXPECT_FALSE(DefaultConfig(recording).parameters.at("cloth.areal_density").free);
  EXPECT_EQ(DefaultConfig(recording).initial_order, -1);
  recording.ground_height = 0.0;
  recording.cloth.areal_density = 3.5;  // above the usual bounds
  recording.cloth.initial = PointPlacement{};
  const FitConfig config = DefaultConfig(recording);
  EXPECT_TRUE(config.parameters.at("ground.friction").free);
  EXPECT_FALSE(config.parameters.at("ground.stiffness").free);
  EXPECT_EQ(config.parameters.at("cloth.areal_density").value, 3.5);
  EXPECT_EQ(config.parameters.at("cloth.areal_density").prior, 3.5);
  EXPECT_FALSE(config.parameters.at("cloth.areal_density").free);
  EXPECT_EQ(config.initial_order, 0);
  EXPECT_TRUE(config.parameters.at("cloth.shrink_warp").free);
  EXPECT_EQ(config.parameters.at("cloth.shrink_warp").value, 0.01);
  EXPECT_NO_THROW(config.Check("defaults"));
}

TEST(ConfigToYaml, RoundTripsExactly) {
  const TestFolder folder;
  const FitConfig config = AwkwardConfig();
  const auto file = folder.Write("fit.yaml", ConfigToYaml(config));
  FitConfig again = DefaultConfig({});
  EXPECT_GE(ConfigDifferences(config, again).size(), ConfigKeys().size());  // all but one differ
  ReadConfig(file, &again);
  EXPECT_THAT(ConfigDifferences(config, again), IsEmpty());
  EXPECT_EQ(ConfigToYaml(again), ConfigToYaml(config));
  EXPECT_EQ(again.function_tolerance, config.function_tolerance);
  EXPECT_EQ(again.parameters.at("air_drag.normal").upper, 1e17 / 7.0);
  EXPECT_EQ(again.frames, config.frames);
  EXPECT_EQ(again.hold_out, config.hold_out);
  EXPECT_EQ(again.parameters.at("air_drag.normal").shared, false);
  EXPECT_FALSE(again.parameters.at("gravity.scale").shared);  // as its term says
}

TEST(ReadConfig, ChangesOnlyWhatItNames) {
  const TestFolder folder;
  const auto file =
      folder.Write("fit.yaml", "strategy: {window: 0.25}\nparameters: {bending.stiffness: 3e-5}\n");
  FitConfig config = AwkwardConfig();
  ReadConfig(file, &config);
  EXPECT_THAT(ConfigDifferences(AwkwardConfig(), config),
              testing::ElementsAre("strategy.window (0, not 0.25)",
                                   HasSubstr("parameters.bending.stiffness ({value: 2e-05")));
}

TEST(ReadConfig, FindsARelativeRecordingBesideTheFile) {
  const TestFolder folder;
  EXPECT_EQ(ReadConfigRecording(folder.Write("a/fit.yaml", "recording: ../rec\n")),
            (folder.path() / "rec").string());
  EXPECT_EQ(ReadConfigRecording(folder.Write("a/fit.yaml", "recording: /x/y\n")), "/x/y");
  EXPECT_EQ(ReadConfigRecording(folder.Write("a/fit.yaml", "strategy: {}\n")), "");
}

TEST(ReadConfig, RefusesUnknownKeysWithTheNearestRightOne) {
  EXPECT_THAT(ReadErrorOf("stratgy: {}"), HasSubstr("fit.yaml: stratgy: unknown key; did you mean "
                                                    "'strategy'?"));
  EXPECT_THAT(ReadErrorOf("strategy: {windw: 1}"), HasSubstr("did you mean 'window'?"));
  EXPECT_THAT(ReadErrorOf("parameters: {air_drag.norml: 1}"),
              HasSubstr("did you mean 'air_drag.normal'?"));
  EXPECT_THAT(ReadErrorOf("parameters: {air_drag.normal: {valu: 1}}"),
              HasSubstr("parameters.air_drag.normal.valu: unknown key; did you mean 'value'?"));
}

TEST(ReadConfig, RefusesWrongTypesAndRanges) {
  EXPECT_THAT(ReadErrorOf("format: clothfit-config/9"), HasSubstr("expected clothfit-config/1"));
  EXPECT_THAT(ReadErrorOf("strategy: 3"), HasSubstr("strategy: expected a map"));
  EXPECT_THAT(ReadErrorOf("strategy: {window: soon}"),
              HasSubstr("strategy.window: expected a finite number, found 'soon'"));
  EXPECT_THAT(ReadErrorOf("strategy: {window: -0.5}"),
              HasSubstr("strategy.window: -0.5: expected 0 or more"));
  EXPECT_THAT(ReadErrorOf("strategy: {polish: maybe}"),
              HasSubstr("'maybe': expected one of true, false"));
  EXPECT_THAT(ReadErrorOf("strategy: {max_iterations: 1.5}"), HasSubstr("expected an integer"));
  EXPECT_THAT(ReadErrorOf("simulation: {max_step: 0}"), HasSubstr("expected a number above 0"));
  EXPECT_THAT(ReadErrorOf("simulation: {integrator: rk4}"),
              HasSubstr("expected one of bdf2, backward_euler"));
  EXPECT_THAT(ReadErrorOf("observations: {frames: [5, 3]}"), HasSubstr("[5, 3]: expected a first"));
  EXPECT_THAT(ReadErrorOf("observations: {frames: [5]}"), HasSubstr("a list of 2 integers"));
  EXPECT_THAT(ReadErrorOf("observations: {markers: false, tracks: false}"),
              HasSubstr("nothing to fit"));
  EXPECT_THAT(ReadErrorOf("observations: {beta: 0}"), HasSubstr("nothing to fit"));
  EXPECT_THAT(ReadErrorOf("observations: {alpha: -1}"), HasSubstr("-1: expected 0 or more"));
  EXPECT_THAT(ReadErrorOf("cloth: {resolution: [0, 5]}"), HasSubstr("[0, 5]: expected 2 to 1000"));
  EXPECT_THAT(ReadErrorOf("initial_state: {order: 3}"), HasSubstr("an integer from -1 to 2"));
}

TEST(ReadConfig, ChecksParameters) {
  const auto error_of = [](const std::string& setting) {
    return ReadErrorOf("parameters: {air_drag.normal: " + setting + "}");
  };
  EXPECT_THAT(error_of("50"), HasSubstr("parameters.air_drag.normal.value: 50 kg/m^3: expected "
                                        "0.001 to 20 (or 0, off, where it is fixed)"));
  EXPECT_THAT(error_of("0"), HasSubstr("where it is free (this is its off value)"));
  EXPECT_THAT(error_of("{free: 1}"), HasSubstr("'1': expected true or false"));
  EXPECT_THAT(error_of("{lower: 0}"), HasSubstr("lower: 0: expected a number above 0"));
  EXPECT_THAT(error_of("{lower: 30}"), HasSubstr("expected a number above the lower bound 30"));
  EXPECT_THAT(error_of("{prior: -1}"), HasSubstr("prior: -1: expected a number above 0"));
  EXPECT_THAT(error_of("{prior_sigma: 1}"), HasSubstr("prior_sigma: 1: expected a factor"));
  EXPECT_THAT(ReadErrorOf("parameters: {gravity.scale: {prior_sigma: 0}}"),
              HasSubstr("prior_sigma: 0: expected an amount"));
  FitConfig config = DefaultConfig({});
  const TestFolder folder;
  ReadConfig(folder.Write("a.yaml", "parameters: {air_drag.normal: {value: 0, free: false}}"),
             &config);
  EXPECT_EQ(config.parameters.at("air_drag.normal").value, 0.0);
}

TEST(SetParameter, TakesFullNamesWithinBounds) {
  FitConfig config = DefaultConfig({});
  SetParameter("--set", "air_drag.normal=0.8", &config);
  EXPECT_EQ(config.parameters.at("air_drag.normal").value, 0.8);
  EXPECT_TRUE(config.parameters.at("air_drag.normal").free);
  EXPECT_EQ(config.parameters.at("air_drag.normal").prior,
            DefaultConfig({}).parameters.at("air_drag.normal").value);
  const auto error_of = [&](const std::string& text) {
    return InputErrorOf([&] { SetParameter("--set", text, &config); });
  };
  EXPECT_THAT(error_of("air_drag.normal=30"),
              HasSubstr("air_drag.normal = 30 kg/m^3: expected 0.001 to 20, or 0 for off"));
  EXPECT_THAT(error_of("air_drag.normal=x"), HasSubstr("expected air_drag.normal=NUMBER"));
  EXPECT_THAT(error_of("air_drag.normal="), HasSubstr("expected air_drag.normal=NUMBER"));
  EXPECT_THAT(error_of("air_drag=1"), HasSubstr("--set: 'air_drag': "));
  EXPECT_THAT(error_of("normal=1"), HasSubstr("did you mean 'air_drag.normal'?"));
}

TEST(SetFree, TakesTermsAndFullNames) {
  FitConfig config = DefaultConfig({});
  SetFree("--fix", "air_drag", false, &config);
  EXPECT_FALSE(config.parameters.at("air_drag.normal").free);
  EXPECT_FALSE(config.parameters.at("air_drag.tangential").free);
  SetFree("--free", "air_drag.saturation", true, &config);
  EXPECT_TRUE(config.parameters.at("air_drag.saturation").free);
  EXPECT_FALSE(config.parameters.at("air_drag.normal").free);
  SetFree("--free", "cloth.areal_density", true, &config);
  EXPECT_TRUE(config.parameters.at("cloth.areal_density").free);
  EXPECT_THAT(InputErrorOf([&] { SetFree("--free", "bendign", true, &config); }),
              HasSubstr("--free: 'bendign': did you mean 'bending'?"));
}

TEST(SwitchOff, PutsATermAtItsOffValuesAndFixesIt) {
  FitConfig config = DefaultConfig({});
  SwitchOff("--without", "air_drag", &config);
  int switched = 0;
  for (const NamedParameter& named : MakeParameterTable()) {
    if (named.term != "air_drag") continue;
    ++switched;
    EXPECT_EQ(config.parameters.at(named.name).value, named.parameter.off);
    EXPECT_FALSE(config.parameters.at(named.name).free);
  }
  EXPECT_EQ(switched, 3);
  EXPECT_NO_THROW(config.Check("command line"));  // off lies below the bounds
  EXPECT_THAT(InputErrorOf([&] { SetFree("--free", "air_drag", true, &config); }),
              HasSubstr("a free parameter starts inside its bounds, 0.001 to 20"));
  EXPECT_THAT(InputErrorOf([&] { SwitchOff("--without", "cloth", &config); }),
              HasSubstr("--without: 'cloth': "));
}

TEST(Attract, GivesThePullAStartOfItsOwn) {
  FitConfig config = DefaultConfig({});
  Attract(&config);
  EXPECT_TRUE(config.attract);
  EXPECT_EQ(config.parameters.at("attraction_point.linear").value, 1.0);
  SetParameter("--set", "attraction_point.linear=7", &config);
  Attract(&config);
  EXPECT_EQ(config.parameters.at("attraction_point.linear").value, 7.0);
  SwitchOff("--without", "attraction_point", &config);
  SetParameter("--set", "attraction_point.reciprocal=0.01", &config);
  Attract(&config);
  EXPECT_EQ(config.parameters.at("attraction_point.linear").value, 0.0);
}

}  // namespace
}  // namespace clothfit
