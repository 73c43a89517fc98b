// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Words that follow the numbers.
#include "fitting/report/verdict/page_verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace clothfit {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Grade = PageVerdict::Grade;

VerdictFacts GoodFacts() {
  VerdictFacts facts;
  facts.status = "converged";
  facts.errors = {{"markers", false, "m", 0.0113, 0.0028}, {"markers", true, "m", 0.02, 0.003}};
  facts.noise_factor = 1.0;
  facts.num_free = 3;
  facts.recorded_frames = facts.simulated_frames = 50;
  return facts;
}

TEST(PageVerdict, OfAGoodFitSaysSoWithItsNumbers) {
  const PageVerdict verdict = JudgeFit(GoodFacts());
  EXPECT_EQ(verdict.grade, Grade::kGood);
  EXPECT_EQ(ToString(verdict.grade), "good");
  EXPECT_THAT(verdict.sentences, Contains("The markers are off by 2.8 mm (root mean square), 75 % "
                                          "less than at the start (11 mm)."));
  EXPECT_THAT(verdict.sentences, Contains(HasSubstr("predicts as well as it fits")));
  EXPECT_THAT(verdict.sentences, Contains("All 3 free parameters are determined by the data."));
}

TEST(PageVerdict, IsNoBetterThanItsWorstPart) {
  VerdictFacts noisy = GoodFacts();
  noisy.noise_factor = 1.8;
  EXPECT_EQ(JudgeFit(noisy).grade, Grade::kPartial);
  EXPECT_THAT(JudgeFit(noisy).headline, HasSubstr("not to within its noise"));
  noisy.noise_factor = 20.0;
  EXPECT_EQ(JudgeFit(noisy).grade, Grade::kPoor);

  VerdictFacts unforeseen = GoodFacts();
  unforeseen.errors[1].after = 0.006;
  EXPECT_EQ(JudgeFit(unforeseen).grade, Grade::kPartial);
  EXPECT_THAT(JudgeFit(unforeseen).headline, HasSubstr("predicts it less well"));
  unforeseen.errors[1].after = 0.1;
  EXPECT_EQ(JudgeFit(unforeseen).grade, Grade::kPoor);

  VerdictFacts unfinished = GoodFacts();
  unfinished.status = "not converged";
  EXPECT_EQ(JudgeFit(unfinished).grade, Grade::kPartial);
  EXPECT_THAT(JudgeFit(unfinished).sentences,
              Contains("The fit has not converged: it may get better."));
  unfinished.rugged_cost = "the fit came to rest where it did";
  EXPECT_THAT(JudgeFit(unfinished).sentences, Contains("The fit came to rest where it did."));
  EXPECT_THAT(JudgeFit(unfinished).sentences, Not(Contains(HasSubstr("it may get better"))));

  VerdictFacts stopped = GoodFacts();
  stopped.status = "interrupted";
  EXPECT_THAT(JudgeFit(stopped).sentences, Contains("The fit was interrupted: it may get better."));
  stopped.status = "failed";
  EXPECT_THAT(JudgeFit(stopped).sentences, Contains("The fit failed."));
  EXPECT_THAT(JudgeFit(stopped).sentences, Not(Contains(HasSubstr("it may get better"))));

  VerdictFacts falling = GoodFacts();
  falling.lack_of_support = "nothing holds it";
  EXPECT_THAT(JudgeFit(falling).sentences, Not(Contains("Nothing holds it.")));  // it did fall
  falling.noise_factor = 20.0;
  EXPECT_THAT(JudgeFit(falling).sentences, Contains("Nothing holds it."));

  VerdictFacts broken = GoodFacts();
  broken.simulated_frames = 12;
  EXPECT_EQ(JudgeFit(broken).grade, Grade::kPoor);
  EXPECT_THAT(JudgeFit(broken).sentences, Contains("Only 12 of 50 frames could be simulated."));
}

Misfit MisfitOf(double chi_square, double without_discretisation) {
  Misfit misfit;
  misfit.chi_square = chi_square;
  misfit.limit = 1.05;
  misfit.discretisation = 0.8;
  misfit.without_discretisation = without_discretisation;
  return misfit;
}

TEST(PageVerdict, CallsNothingGoodThatLeavesMoreThanNoise) {
  VerdictFacts facts = GoodFacts();
  facts.recording = "recordings/r";
  facts.misfit = MisfitOf(1.04, 1.0);
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kGood);
  facts.misfit = MisfitOf(1.2, 1.04);
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kPartial);
  EXPECT_THAT(JudgeFit(facts).headline, HasSubstr("as far as its mesh can"));
  EXPECT_THAT(JudgeFit(facts).sentences, Not(Contains(HasSubstr("clothfit diagnose"))));
  facts.misfit = MisfitOf(1.2, 1.1);
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kPartial);
  EXPECT_THAT(JudgeFit(facts).headline, HasSubstr("not to within its noise"));
  EXPECT_THAT(JudgeFit(facts).sentences, Contains(HasSubstr("clothfit diagnose recordings/r")));
}

TEST(PageVerdict, SaysWhereHeldOutFramesCannotBeJudged) {
  VerdictFacts facts = GoodFacts();
  facts.errors[1].after = 0.1;
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kPoor);
  facts.unknown_handles = {"left", "right"};
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kGood);
  EXPECT_THAT(JudgeFit(facts).sentences, Contains(HasSubstr("cannot be judged")));
  EXPECT_THAT(JudgeFit(facts).sentences, Not(Contains(HasSubstr("than it fits"))));
}

TEST(PageVerdict, NamesWhatTheDataLeaveOpen) {
  VerdictFacts facts = GoodFacts();
  facts.undetermined = {"air_drag.normal"};
  facts.at_bound = {"stretch.damping"};
  const std::vector<std::string> sentences = JudgeFit(facts).sentences;
  EXPECT_THAT(sentences, Contains("1 of 3 free parameters is left to its prior: air_drag.normal."));
  EXPECT_THAT(sentences, Contains(HasSubstr("At a bound")));
}

TEST(PageVerdict, OfARecordingThatWasHeldOutJudgesThePrediction) {
  VerdictFacts facts;
  facts.status = "converged";
  facts.is_predicted = true;
  facts.errors = {{"markers", true, "m", 0.02, 0.012}};
  facts.recorded_frames = facts.simulated_frames = 50;
  facts.misfit.emplace();
  facts.misfit->chi_square = 6.0;
  facts.misfit->limit = 1.2;
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kPartial);
  EXPECT_THAT(JudgeFit(facts).headline, HasSubstr("better than with the start values, but not"));
  EXPECT_THAT(JudgeFit(facts).sentences, Contains(HasSubstr("off by 12 mm")));
  facts.errors[0].after = 0.03;
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kPoor);
  EXPECT_THAT(JudgeFit(facts).headline, HasSubstr("no better than with the start values"));
  facts.misfit->chi_square = 1.1;
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kGood);
  facts.simulated_frames = 20;
  EXPECT_EQ(JudgeFit(facts).grade, Grade::kPoor);
  EXPECT_THAT(JudgeFit(facts).headline, HasSubstr("is not predicted to its end"));
}

TEST(PageVerdict, SpeaksOfWhatThereIs) {
  VerdictFacts facts = GoodFacts();
  facts.errors = {{"silhouettes", false, "px", 2887.0, 1215.0}};
  const PageVerdict verdict = JudgeFit(facts);
  EXPECT_THAT(verdict.sentences, Contains(HasSubstr("differ by 1215 px in a picture, 58 % less")));
  EXPECT_THAT(verdict.sentences, Not(Contains(HasSubstr("held out"))));
  facts.errors.clear();
  EXPECT_NO_THROW(JudgeFit(facts));
}

}  // namespace
}  // namespace clothfit
