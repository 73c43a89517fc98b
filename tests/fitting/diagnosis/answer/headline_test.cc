// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The answer in one sentence, the same wherever it stands.
#include "fitting/diagnosis/answer/headline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fitting/diagnosis/answer/json_text.h"
#include "fitting/diagnosis/answer/markdown_text.h"
#include "fitting/diagnosis/answer/summary_text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kWindInBrief = "ind of 0.5 m/s (0.4 to 0.6) along +y";
constexpr const char* kPoseFault = "camera cam1: pose";

Model ModelOf(const std::string& effect, const std::vector<EffectParameter>& parameters) {
  Model model;
  model.effects = {effect};
  model.parameters = parameters;
  return model;
}

Model WindModel() {
  return ModelOf("wind", {{"wind.x", "m/s", 0.0, 0.0, 0.0},
                          {"wind.y", "m/s", 0.5, 0.4, 0.6},
                          {"wind.z", "m/s", 0.0, 0.0, 0.0}});
}

Model TiltModel() {
  return ModelOf("gravity_tilt", {{"gravity_tilt.angle_1", "rad", 0.07, 0.06, 0.08},
                                  {"gravity_tilt.angle_2", "rad", 0.0, 0.0, 0.0}});
}

Diagnosis NamedAmong(const std::vector<Model>& set) {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNamed;
  diagnosis.models = set;
  diagnosis.answer = set.front();
  diagnosis.effects = set.front().effects;
  for (const Model& model : set) diagnosis.confidence_set.push_back(model.effects.back());
  return diagnosis;
}

TEST(Headline, NamesTheOneEffectWithItsAmount) {
  EXPECT_EQ(HeadlineOf(NamedAmong({WindModel()})), std::string("W") + kWindInBrief + ".");
}

TEST(Headline, NamesAllThatTheRecordingCannotTell) {
  const std::string tilt = "gravity tilt of 4.01 degrees (3.44 to 4.58)";
  EXPECT_EQ(HeadlineOf(NamedAmong({WindModel(), TiltModel()})),
            std::string("W") + kWindInBrief + ", or " + tilt + ": this recording cannot tell.");
  EXPECT_EQ(
      HeadlineOf(NamedAmong({WindModel(), TiltModel(), ModelOf("hem", {})})),
      std::string("W") + kWindInBrief + ", " + tilt + ", or hem: this recording cannot tell.");
}

// The amounts are those of the answer, not of the round in which the effect was found.
TEST(Headline, NamesWhatWasFoundBesides) {
  Diagnosis diagnosis = NamedAmong({WindModel(), TiltModel()});
  diagnosis.effects = diagnosis.answer->effects = {"wind", "hem"};
  diagnosis.answer->parameters.push_back({"hem.low_u", "kg/m", 0.05, 0.04, 0.06});
  diagnosis.models[0].parameters[1].value = 7.0;
  const std::string hem = "hem of 0.05 kg/m (0.04 to 0.06) along the side of least u";
  EXPECT_EQ(HeadlineOf(diagnosis), std::string("W") + kWindInBrief +
                                       ", or gravity tilt of 4.01 degrees (3.44 to 4.58): this " +
                                       "recording cannot tell; besides, " + hem + ".");
  diagnosis.confidence_set = {"wind"};
  EXPECT_EQ(HeadlineOf(diagnosis), std::string("W") + kWindInBrief + " and " + hem + ".");
}

TEST(Headline, NamesWhatALaterEffectCannotBeToldFrom) {
  Diagnosis diagnosis = NamedAmong({WindModel()});
  diagnosis.effects = diagnosis.answer->effects = {"wind", "hem"};
  diagnosis.sets_beside = {{"hem", "gravity_tilt"}};
  const Model tilt = TiltModel();
  Model beside = tilt;
  beside.effects = {"wind", "gravity_tilt"};
  beside.parameters[0].value = 0.05;
  diagnosis.models = {WindModel(), tilt, beside};
  const std::string words = "hem, or gravity tilt of 2.86 degrees (2.29 to 4.58)";
  EXPECT_EQ(HeadlineOf(diagnosis), std::string("W") + kWindInBrief + "; besides, " + words +
                                       ": this recording cannot tell.");
  EXPECT_THAT(DescribeDiagnosis(diagnosis),
              HasSubstr("This recording cannot tell hem from gravity turned away"));
}

TEST(Headline, OfAFaultSaysWhatItIsOf) {
  const Model pose = ModelOf(kPoseFault, {{"camera cam1: pose shift x", "m", 0.03, 0.02, 0.04}});
  Diagnosis diagnosis = NamedAmong({pose});
  diagnosis.verdict = Verdict::kObservationFault;
  EXPECT_EQ(HeadlineOf(diagnosis),
            "Pose of camera cam1 off by 0.03 m (0.02 to 0.04): a fault of the observation, not of "
            "the physics.");
  diagnosis = NamedAmong({pose, WindModel()});
  diagnosis.verdict = Verdict::kObservationFault;
  EXPECT_EQ(HeadlineOf(diagnosis), std::string("Pose of camera cam1 off by 0.03 m (0.02 to 0.04), "
                                               "or w") +
                                       kWindInBrief + ": this recording cannot tell.");
}

TEST(Headline, OfNoNameSaysSo) {
  Diagnosis diagnosis;
  EXPECT_EQ(HeadlineOf(diagnosis), "Nothing is missing that this recording could show.");
  diagnosis.verdict = Verdict::kUndecided;
  diagnosis.residual_rms = 1.9;
  EXPECT_EQ(HeadlineOf(diagnosis),
            "Undecided: another mesh and step might leave as much as the baseline does.");
  diagnosis.promised = 0.6;
  EXPECT_EQ(HeadlineOf(diagnosis), "Undecided: the baseline's fit has come to no minimum.");
  diagnosis.verdict = Verdict::kInterrupted;
  EXPECT_EQ(HeadlineOf(diagnosis), "Interrupted before anything was found.");
  diagnosis.verdict = Verdict::kNoneOfTheAbove;
  EXPECT_EQ(HeadlineOf(diagnosis),
            "Something is missing, and nothing in the catalogue explains it.");
  diagnosis.law.emplace();
  EXPECT_THAT(HeadlineOf(diagnosis), HasSubstr("a law was learned from it."));
  diagnosis = NamedAmong({WindModel()});
  diagnosis.verdict = Verdict::kNoneOfTheAbove;
  EXPECT_EQ(
      HeadlineOf(diagnosis),
      std::string("Something is missing, of which this is only a part: w") + kWindInBrief + ".");
  diagnosis.verdict = Verdict::kInterrupted;
  EXPECT_EQ(HeadlineOf(diagnosis), std::string("Interrupted; so far: w") + kWindInBrief + ".");
}

TEST(Headline, IsTheSameForPeopleAndForPrograms) {
  Diagnosis diagnosis = NamedAmong({WindModel(), TiltModel()});
  diagnosis.separating = {"twice as fast", 0.012, 0.003};
  diagnosis.words = DescribeDiagnosis(diagnosis);
  int checked = 0;
  for (const Verdict verdict :
       {Verdict::kNothingMissing, Verdict::kNamed, Verdict::kObservationFault,
        Verdict::kNoneOfTheAbove, Verdict::kUndecided, Verdict::kInterrupted}) {
    diagnosis.verdict = verdict;
    diagnosis.words = DescribeDiagnosis(diagnosis);
    const std::string headline = HeadlineOf(diagnosis);
    EXPECT_THAT(DiagnosisAsText(diagnosis), StartsWith(headline + "\n"));
    EXPECT_THAT(DiagnosisAsMarkdown(diagnosis), StartsWith("# " + headline + "\n\n"));
    const auto json = nlohmann::json::parse(DiagnosisAsJson(diagnosis));
    EXPECT_EQ(json.at("headline"), headline);
    EXPECT_THAT(json.at("words").get<std::string>(), StartsWith(headline + " "));
    EXPECT_THAT(headline, Not(HasSubstr("_")));
    ++checked;
  }
  EXPECT_EQ(checked, 6);
}

TEST(Headline, IsFollowedByWhatWouldTellThemApart) {
  Diagnosis diagnosis = NamedAmong({WindModel(), TiltModel()});
  diagnosis.separating = {"twice as fast", 0.012, 0.003};
  const std::vector<std::string> details = DetailsOf(diagnosis);
  ASSERT_GT(details.size(), 2u);
  EXPECT_EQ(details[0],
            "The same motion twice as fast would: they would be 12 mm apart, here it is 3.0.");
  EXPECT_THAT(details[1], StartsWith("What was left out: air that moves"));
}

TEST(Headline, IsNotRepeatedByWhatFollows) {
  Diagnosis diagnosis = NamedAmong({WindModel(), TiltModel()});
  diagnosis.effects = diagnosis.answer->effects = {"wind", "hem", "bending_friction"};
  for (const EffectParameter& p :
       std::vector<EffectParameter>{{"hem.low_u", "kg/m", 0.05, 0.04, 0.06},
                                    {"hem.low_v", "kg/m", 0.03, 0.02, 0.04},
                                    {"bending_friction.moment", "N", 0.002, 0.001, 0.003},
                                    {"bending_friction.onset", "1/m", 10.0, 5.0, 20.0}})
    diagnosis.answer->parameters.push_back(p);
  const std::string words = DescribeDiagnosis(diagnosis);
  int checked = 0;
  for (const char* amount : {"0.5 m/s (0.4 to 0.6)", "4.01 degrees", "0.05 kg/m", "0.03 kg/m",
                             "0.002 N (0.001 to 0.003)", "Bending friction: onset 10 1/m"}) {
    const std::size_t first = words.find(amount);
    ASSERT_NE(first, std::string::npos) << amount;
    EXPECT_EQ(words.find(amount, first + 1), std::string::npos) << amount;
    ++checked;
  }
  EXPECT_EQ(checked, 6);
  EXPECT_THAT(words, Not(HasSubstr("Hem:")));
}

}  // namespace
}  // namespace clothfit
