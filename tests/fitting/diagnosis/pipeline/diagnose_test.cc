// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole diagnoses of small recordings that were simulated on a finer mesh with a shorter step.
#include "fitting/diagnosis/pipeline/diagnose.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/names.h"
#include "autodiff_sim/term/tilted_down.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/diagnosis/answer/json_text.h"
#include "fitting/diagnosis/compare/log_evidence.h"
#include "fitting/diagnosis/evidence/candidates.h"
#include "fitting/diagnosis/rank/ranking.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

SyntheticOptions Small() {
  SyntheticOptions options;
  options.resolution = {6, 6};
  options.refinement = 2;
  options.frame_rate = 30.0;
  options.frame_count = 36;
  options.steps_per_frame = 8;
  options.seed = 5;
  return options;
}

// A baseline that knows most of the material parameters, so that a test takes seconds, and its
// drag, without which a wind's speed cannot be told.
FitConfig Baseline(const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  for (auto& [name, setting] : config.parameters) setting.free = false;
  for (const char* name : {"stretch.stiffness", "shear.stiffness", "bending.stiffness"})
    config.parameters.at(name).free = true;
  config.max_iterations = 8;
  return config;
}

DiagnosisOptions Quick() {
  DiagnosisOptions options;
  options.max_models = 2;
  options.max_effects = 1;
  options.num_nulls = 200;
  options.finest_side = 9;
  return options;
}

TEST(Diagnose, NamesTheWind) {
  SyntheticOptions options = Small();
  options.parameters["wind.x"] = 2.5;  // so much that the coarse mesh matters little
  const Recording recording = MakeSyntheticRecording(options).recording;
  DiagnosisOptions quick = Quick();
  std::string log;
  quick.log = [&](const std::string& line) { log += line + "\n"; };
  const Diagnosis diagnosis = Diagnose(recording, Baseline(recording), quick);
  EXPECT_EQ(diagnosis.verdict, Verdict::kNamed) << diagnosis.words;
  ASSERT_TRUE(diagnosis.answer.has_value());
  EXPECT_EQ(diagnosis.answer->effects, std::vector<std::string>{"wind"});
  const auto x =
      std::find_if(diagnosis.answer->parameters.begin(), diagnosis.answer->parameters.end(),
                   [](const EffectParameter& p) { return p.name == "wind.x"; });
  ASSERT_NE(x, diagnosis.answer->parameters.end());
  EXPECT_NEAR(x->value, 2.5, 0.15);
  EXPECT_LT(x->lower90, x->upper90);
  EXPECT_TRUE(diagnosis.answer->validation.is_validated);
  EXPECT_LT(diagnosis.answer->validation.after, diagnosis.answer->validation.before);
  EXPECT_THAT(diagnosis.words, HasSubstr("wind"));
  EXPECT_THAT(DiagnosisAsJson(diagnosis), HasSubstr("\"verdict\": \"named\""));
  EXPECT_GE(diagnosis.answer->log_evidence, kStrongEvidence);
  // On a finer mesh in the end, all of it.
  EXPECT_THAT(log, HasSubstr("on 81 particles"));
  const DiagnosisMotions& motions = diagnosis.motions;
  const Eigen::Index size = 3 * motions.resolution[0] * motions.resolution[1];
  EXPECT_EQ(motions.resolution[0], 9);
  ASSERT_FALSE(motions.missing_force.empty());
  for (const auto* frames : {&motions.baseline, &motions.answer, &motions.missing_force})
    EXPECT_EQ(frames->front().size(), size);
  ASSERT_TRUE(diagnosis.misfit);
  EXPECT_FALSE(diagnosis.misfit->IsNoiseAndMesh());
  EXPECT_NEAR(diagnosis.residual_rms, std::sqrt(diagnosis.misfit->chi_square), 1e-12);
  const std::vector<double>& draws = diagnosis.null_left_rms;
  ASSERT_EQ(draws.size(), static_cast<std::size_t>(Quick().num_nulls));
}

TEST(Diagnose, ThatIsInterruptedAnswersByItsLastRound) {
  SyntheticOptions options = Small();
  options.parameters["wind.x"] = 2.5;
  const Recording recording = MakeSyntheticRecording(options).recording;
  DiagnosisOptions quick = Quick();
  quick.max_effects = 2;
  std::atomic<bool> stop = false;
  quick.stop = &stop;
  std::vector<Diagnosis> told;
  quick.so_far = [&](const Diagnosis& so_far) {
    told.push_back(so_far);
    stop = true;  // as soon as the first effect is known
  };
  const Diagnosis diagnosis = Diagnose(recording, Baseline(recording), quick);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(diagnosis.verdict, Verdict::kInterrupted);
  EXPECT_EQ(diagnosis.effects, std::vector<std::string>{"wind"});
  EXPECT_EQ(diagnosis.words, told[0].words);
  EXPECT_THAT(diagnosis.words, testing::StartsWith("Interrupted; so far:"));
  ASSERT_TRUE(diagnosis.answer && diagnosis.fit);
  EXPECT_GE(diagnosis.answer->log_evidence, kStrongEvidence);
  EXPECT_FALSE(diagnosis.motions.answer.empty());
  // An amount, and no interval of a search that was stopped.
  EXPECT_THAT(diagnosis.words, HasSubstr("amounts may still change, and have no intervals."));
  EXPECT_THAT(diagnosis.words, HasSubstr("wind of "));
  EXPECT_THAT(diagnosis.words, testing::Not(testing::ContainsRegex("\\([-+.0-9e]+ to ")));
  ASSERT_FALSE(diagnosis.answer->parameters.empty());
  for (const EffectParameter& p : diagnosis.answer->parameters) {
    EXPECT_TRUE(std::isfinite(p.value)) << p.name;
    EXPECT_TRUE(std::isnan(p.lower90) && std::isnan(p.upper90)) << p.name;
  }
}

TEST(Diagnose, FindsNothingMissingWhereNothingIs) {
  const Recording recording = MakeSyntheticRecording(Small()).recording;
  const Diagnosis diagnosis = Diagnose(recording, Baseline(recording), Quick());
  EXPECT_EQ(diagnosis.verdict, Verdict::kNothingMissing) << diagnosis.words;
  EXPECT_TRUE(diagnosis.effects.empty());
}

TEST(Diagnose, TakesALayoutThatIsOffForWhatItIs) {
  SyntheticOptions options = Small();
  options.layout_sigma = 0.003;
  Recording recording = MakeSyntheticRecording(options).recording;
  EXPECT_EQ(Diagnose(recording, Baseline(recording), Quick()).verdict, Verdict::kNothingMissing);
  recording.noise.layout.reset();  // not told of it
  EXPECT_NE(Diagnose(recording, Baseline(recording), Quick()).verdict, Verdict::kNothingMissing);
}

TEST(Diagnose, UsesNoFinerMeshThanItMay) {
  const Recording recording = MakeSyntheticRecording(Small()).recording;
  DiagnosisOptions options = Quick();
  options.finest_side = 4;
  options.excluded = NamesOf(AllTerms());
  const Diagnosis diagnosis = Diagnose(recording, Baseline(recording), options);
  ASSERT_GT(recording.cloth.resolution.x(), 4);
  EXPECT_EQ(diagnosis.motions.resolution, (std::array<int, 2>{4, 4}));
}

TEST(Diagnose, BlamesTheCameraThatStandsElsewhere) {
  SyntheticOptions options = Small();
  options.markers = {0, 0};
  options.num_cameras = 3;
  Recording recording = MakeSyntheticRecording(options).recording;
  const Eigen::Vector3d shift(0.015, -0.01, 0.0);
  Camera& camera = recording.cameras[1];
  camera.camera_from_world_translation -= camera.camera_from_world_rotation * shift;
  FitConfig config = Baseline(recording);
  config.loss = LossKind::kNone;
  const Diagnosis diagnosis = Diagnose(recording, config, Quick());
  EXPECT_EQ(diagnosis.verdict, Verdict::kObservationFault) << diagnosis.words;
  EXPECT_THAT(diagnosis.effects, Contains("camera " + camera.name + ": pose"));
}

TEST(Candidates, AreWhatIsOffAndCouldAct) {
  const Recording recording = MakeSyntheticRecording(Small()).recording;
  FitConfig config = DefaultConfig(recording);
  SwitchOff("test", "air_drag", &config);
  SetParameter("test", "bending.damping=0", &config);
  SetFree("test", "bending.damping", false, &config);
  const Scene scene = MakeScene(recording, config);
  Extent extent{{-1, -1, -1}, {1, 1, 1}, {0.4, 0.4}, 1.5};
  std::vector<std::string> names;
  for (const CandidateTerm& c : ListCandidates(config, scene, extent, {"gust"}, 8)) {
    names.push_back(c.name);
    EXPECT_LE(c.probes.size(), 8U) << c.name;
    EXPECT_GE(c.probes.size(), 1U) << c.name;
    EXPECT_EQ(c.switches.size(), c.is_one_sided.size());
  }
  EXPECT_THAT(names, Contains("wind"));
  EXPECT_THAT(names, Contains("air_drag"));
  EXPECT_THAT(names, Contains("bending.damping"));
  EXPECT_THAT(names, Not(Contains("gust")));      // excluded
  EXPECT_THAT(names, Not(Contains("adhesion")));  // no ground
  EXPECT_THAT(names, Not(Contains("gravity")));   // on
  EXPECT_THAT(names, Not(Contains("attraction_point")));
}

// A plane may be a table or a wall on any side; each that is tried cuts what the cloth passes
// through.
TEST(Candidates, PlanesAreTriedFromAllSides) {
  const Recording recording = MakeSyntheticRecording(Small()).recording;
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  const Extent extent{{2.0, -0.3, 0.5}, {2.5, 0.1, 1.0}, {0.4, 0.4}, 1.5};
  const DownFrame frame = MakeDownFrame(extent.gravity);
  const auto check = [&](const Probe& probe) {
    const Eigen::Vector3d up = -TiltedDown<double>(frame, probe.at("obstacle_plane.angle_1"),
                                                   probe.at("obstacle_plane.angle_2"));
    const double height = probe.at("obstacle_plane.height");
    const double middle = 0.5 * up.dot(extent.low + extent.high);
    const double reach = 0.5 * up.cwiseAbs().dot(extent.high - extent.low);
    EXPECT_GT(height, middle - reach - 0.1) << up.transpose();
    EXPECT_LT(height, middle + reach) << up.transpose();
    return up;
  };
  Eigen::Matrix<double, 3, 2> sides = Eigen::Matrix<double, 3, 2>::Zero();
  int count = 0;
  for (const CandidateTerm& c : ListCandidates(config, scene, extent, {}, 8)) {
    if (c.name != "obstacle_plane") continue;
    for (const Probe& probe : c.probes) {
      const Eigen::Vector3d up = check(probe);
      sides.col(0) = sides.col(0).cwiseMax(up);
      sides.col(1) = sides.col(1).cwiseMin(up);
      for (const Probe& near : ProbesNear(c, probe, extent, 0.25)) check(near);
      ++count;
    }
  }
  EXPECT_EQ(count, 8);
  EXPECT_NEAR(sides(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(sides(1, 0), 1.0, 1e-12);
  EXPECT_NEAR(sides(2, 0), 1.0, 1e-12);
  EXPECT_NEAR(sides(0, 1), -1.0, 1e-12);
  EXPECT_NEAR(sides(1, 1), -1.0, 1e-12);
}

}  // namespace
}  // namespace clothfit
