// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whole diagnoses of a strip of cloth in which more than one thing is wrong.
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/names.h"
#include "fitting/diagnosis/answer/effect_words.h"
#include "fitting/diagnosis/answer/json_text.h"
#include "fitting/diagnosis/pipeline/diagnose.h"
#include "tests/support/strip.h"

namespace clothfit {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::StartsWith;
using testing::UnorderedElementsAre;
using Names = std::vector<std::string>;

constexpr const char* kPose = "camera cam1: pose";

// What every answer has, whatever it is.
void ExpectToldAlike(const Diagnosis& diagnosis) {
  EXPECT_THAT(DiagnosisAsJson(diagnosis),
              HasSubstr("\"verdict\": \"" + ToString(diagnosis.verdict) + "\""));
  for (const std::string& effect : diagnosis.effects)
    EXPECT_THAT(diagnosis.words, HasSubstr(PlainName(effect)));
  ASSERT_TRUE(diagnosis.answer);
  EXPECT_TRUE(
      std::any_of(diagnosis.models.begin(), diagnosis.models.end(), [&](const Model& model) {
        return model.is_kept && model.effects == diagnosis.answer->effects;
      }));
  for (const EffectParameter& p : diagnosis.answer->parameters)
    EXPECT_LE(p.lower90, p.upper90) << p.name;
}

// One diagnosis a test: tests may run in processes of their own, and it takes all the time.

// A third effect is left, so that a law is learned, of a family that does not explain as much.
TEST(TwoEffects, AreNamedAndHeldAgainstALaw) {
  const std::map<std::string, double> effects = {
      {"wind.x", 2.0}, {"added_mass.normal", 0.12}, {"hem.high_v", 0.024}};
  const Recording recording = MakeSyntheticRecording(Strip(effects)).recording;
  const Diagnosis diagnosis =
      Diagnose(recording, Told(recording), OnlyAmong({"wind", "added_mass", "law_field"}));
  // What is left of the third is less than noise.
  EXPECT_EQ(diagnosis.verdict, Verdict::kNamed) << diagnosis.words;
  EXPECT_THAT(diagnosis.effects, UnorderedElementsAre("added_mass", "wind"));
  ExpectToldAlike(diagnosis);
  ASSERT_TRUE(diagnosis.answer);
  EXPECT_EQ(diagnosis.answer->effects, diagnosis.effects);
  ASSERT_FALSE(diagnosis.confidence_set.empty());
  EXPECT_EQ(diagnosis.confidence_set.front(), diagnosis.effects.front());

  const Model& last = diagnosis.models.back();
  EXPECT_THAT(last.effects, ElementsAre("law_field"));
  EXPECT_FALSE(last.is_kept);
  EXPECT_FALSE(diagnosis.law);

  EXPECT_EQ(diagnosis.motions.resolution[0], 10);  // refined
  EXPECT_EQ(diagnosis.motions.answer.front().size(), diagnosis.motions.baseline.front().size());
  const Names names = NamesOf(diagnosis.answer->parameters);
  EXPECT_THAT(names, IsSupersetOf({"added_mass.normal", "wind.x"}));
}

TEST(TwoEffects, MayBeACamerasFaultAndWind) {
  const Recording recording = SeenAskew({{"wind.x", 3.0}}, {0.03, -0.02, 0.0});
  const Diagnosis diagnosis =
      Diagnose(recording, Told(recording), OnlyAmong({"wind", "gravity_tilt"}));
  EXPECT_EQ(diagnosis.verdict, Verdict::kNamed) << diagnosis.words;
  EXPECT_THAT(diagnosis.effects, ElementsAre(kPose, "wind"));
  ExpectToldAlike(diagnosis);
  ASSERT_TRUE(diagnosis.answer);
  const std::vector<EffectParameter>& parameters = diagnosis.answer->parameters;
  const auto x = std::find_if(parameters.begin(), parameters.end(),
                              [](const EffectParameter& p) { return p.name == "wind.x"; });
  ASSERT_NE(x, parameters.end());
  EXPECT_GT(x->lower90, 0.0);
  EXPECT_THAT(diagnosis.confidence_set, Contains("wind"));
}

// Of what is left with the camera put right wind explains half; the rest is of a term that is not
// looked for, so much of it that mesh and step do not make as much.
TEST(TwoEffects, AreNotAllThatIsMissing) {
  const Recording recording =
      SeenAskew({{"wind.x", 3.0}, {"added_mass.normal", 0.45}}, {0.06, -0.04, 0.0});
  const Diagnosis diagnosis = Diagnose(recording, Told(recording), OnlyAmong({"wind"}));
  ASSERT_THAT(diagnosis.effects, ElementsAre(kPose, "wind"));
  ExpectToldAlike(diagnosis);
  ASSERT_TRUE(diagnosis.answer);
  ASSERT_LT(diagnosis.answer->explained, 0.8) << diagnosis.words;
  EXPECT_EQ(diagnosis.verdict, Verdict::kNoneOfTheAbove);
}

// Wind that has no name, and a camera's fault that explains less than it.
TEST(TwoEffects, MayBeACamerasFaultAndALaw) {
  const Recording recording = SeenAskew({{"wind.x", 3.0}}, {0.008, -0.004, 0.0});
  DiagnosisOptions options = OnlyAmong({"law_air"});
  options.max_effects = 1;
  const Diagnosis diagnosis = Diagnose(recording, Told(recording), options);
  EXPECT_EQ(diagnosis.verdict, Verdict::kNoneOfTheAbove) << diagnosis.words;
  ASSERT_FALSE(diagnosis.models.empty());
  EXPECT_THAT(diagnosis.models.front().effects, ElementsAre(kPose));
  EXPECT_TRUE(diagnosis.models.front().is_kept);
  ASSERT_TRUE(diagnosis.law);
  EXPECT_THAT(diagnosis.law->model.effects, Contains("law_air"));
  EXPECT_THAT(diagnosis.law->formula, StartsWith("velocity of the air along x = "));
  ExpectToldAlike(diagnosis);
  EXPECT_THAT(diagnosis.effects, Contains(kPose));
}

}  // namespace
}  // namespace clothfit
