// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/verdict/joint_verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// Of a recording with markers, as a fit of several writes it. Noise leaves a chi-square up to 1.1.
Json EntryOf(const std::string& name, double chi_square, const std::string& lack_of_support) {
  return {{"name", name},
          {"held_out_whole", false},
          {"fit", {{"marker_rms_m", 0.002}}},
          {"held_out", Json::object()},
          {"before", {{"fit", {{"marker_rms_m", 0.01}}}}},
          {"misfit", {{"chi_square", chi_square}, {"limit", 1.1}}},
          {"noise", {{"marker_m", 0.001}, {"track_px", 0.5}}},
          {"lack_of_support", lack_of_support}};
}

std::vector<std::string> SentencesOn(const std::vector<Json>& entries) {
  return JudgeJointFit(
             {{"status", "converged"}, {"recordings", entries}, {"parameters", Json::object()}})
      .sentences;
}

TEST(JointVerdict, TellsInWhichRecordingsNothingHoldsTheCloth) {
  const std::string lack = "nothing holds it";
  EXPECT_THAT(SentencesOn({EntryOf("a", 9.0, ""), EntryOf("b", 9.0, lack)}),
              Contains("In b nothing holds it."));
  EXPECT_THAT(SentencesOn({EntryOf("a", 9.0, lack), EntryOf("b", 9.0, lack)}),
              Contains("In a, b nothing holds it."));
  EXPECT_THAT(SentencesOn({EntryOf("a", 9.0, lack), EntryOf("b", 9.0, "it lies")}),
              testing::IsSupersetOf({"In a nothing holds it.", "In b it lies."}));
}

TEST(JointVerdict, TellsItOfNoRecordingThatIsExplained) {
  const std::string lack = "nothing holds it";
  EXPECT_THAT(SentencesOn({EntryOf("a", 9.0, ""), EntryOf("b", 1.0, lack)}),
              Not(Contains(HasSubstr(lack))));
  Json earlier = EntryOf("b", 9.0, lack);
  earlier.erase("lack_of_support");  // as earlier versions wrote it
  EXPECT_THAT(SentencesOn({EntryOf("a", 9.0, ""), earlier}), Not(Contains(HasSubstr(lack))));
}

// A prediction that breaks down was not told of at all, and the whole was as good as without it.
TEST(JointVerdict, TellsOfAPredictionThatBreaksDown) {
  Json broken = EntryOf("b", 1.0, "");
  broken["held_out_whole"] = true;
  broken["fit"] = Json::object();
  broken["held_out"] = {{"marker_rms_m", 0.001}};  // of the frames that were reached
  broken["frames"] = {{"recorded", 151}, {"fitted", 0}, {"simulated", 1}};
  const std::string sentence =
      "b, which was not fitted, is not predicted to its end: 1 of 151 frames can be simulated with "
      "what was found.";
  const auto sentences = SentencesOn({EntryOf("a", 9.0, ""), broken});
  EXPECT_THAT(sentences, Contains(sentence));
  EXPECT_THAT(sentences, Not(Contains(HasSubstr("predicted to 1"))));
  const auto grade = [&](const Json& held_out) {
    return JudgeJointFit({{"status", "converged"},
                          {"recordings", {EntryOf("a", 9.0, ""), held_out}},
                          {"parameters", Json::object()}})
        .grade;
  };
  EXPECT_EQ(grade(broken), PageVerdict::Grade::kPoor);
  Json whole = broken;
  whole["frames"]["simulated"] = 151;
  EXPECT_EQ(grade(whole), PageVerdict::Grade::kPartial);
}

}  // namespace
}  // namespace clothfit
