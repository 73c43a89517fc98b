// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// diagnosis.md: sentences before tables.
#include "fitting/diagnosis/answer/markdown_text.h"

#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fitting/diagnosis/answer/headline.h"

namespace clothfit {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr Verdict kVerdicts[] = {Verdict::kNothingMissing,   Verdict::kNamed,
                                 Verdict::kObservationFault, Verdict::kNoneOfTheAbove,
                                 Verdict::kUndecided,        Verdict::kInterrupted};

Diagnosis WindIsNamed() {
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNamed;
  Model model;
  model.effects = {"wind"};
  model.parameters = {{"wind.x", "m/s", 0.5, 0.4, 0.6},
                      {"wind.y", "m/s", 0.0, 0.0, 0.0},
                      {"wind.z", "m/s", 0.0, 0.0, 0.0}};
  diagnosis.models = {model};
  diagnosis.answer = model;
  diagnosis.effects = diagnosis.confidence_set = model.effects;
  diagnosis.acting.emplace();
  diagnosis.acting_class.emplace();
  diagnosis.acting_class->words = "It acts all the time on the whole cloth.";
  Candidate candidate;
  candidate.name = "heavy_patch";
  candidate.parameters = {{"heavy_patch.share", "1", 0.1, 0.0, 0.2}};
  candidate.detection_limit = 0.63;
  candidate.why_not = "explains 2 %";
  diagnosis.ranking = {candidate};
  diagnosis.seconds = {{"baseline", 1.0}};
  return diagnosis;
}

TEST(MarkdownText, HasSentencesFirstAndTablesForSpecialists) {
  const std::string text = DiagnosisAsMarkdown(WindIsNamed());
  const std::size_t specialists = text.find("\n## For specialists\n");
  ASSERT_NE(specialists, std::string::npos);
  const std::string before = text.substr(0, specialists);
  EXPECT_THAT(before, HasSubstr("\n\nIt acts all the time on the whole cloth.\n\n"));
  EXPECT_THAT(before, HasSubstr("\n## What to do next\n\nGo on with `config.yaml`"));
  for (const char* table_word : {"|", "projection", "false discovery", "detection limit", "heavy"})
    EXPECT_THAT(before, Not(HasSubstr(table_word)));
  const std::string after = text.substr(specialists);
  EXPECT_THAT(after, HasSubstr("| heavy_patch | "));
  EXPECT_THAT(after, HasSubstr("| 0.63 | explains 2 % |"));  // without a unit of 1
  EXPECT_THAT(after, HasSubstr("- baseline: 1.0 s\n"));
}

TEST(MarkdownText, HasNoStatusForATitleAndANextStepForEachVerdict) {
  Diagnosis diagnosis = WindIsNamed();
  std::set<std::string> steps;
  for (const Verdict verdict : kVerdicts) {
    diagnosis.verdict = verdict;
    const std::string text = DiagnosisAsMarkdown(diagnosis);
    EXPECT_THAT(text, Not(HasSubstr("# " + ToString(verdict) + "\n")));
    const std::string head = "## What to do next\n\n";
    const std::size_t begin = text.find(head) + head.size();
    steps.insert(text.substr(begin, text.find('\n', begin) - begin));
  }
  EXPECT_EQ(steps.size(), std::size(kVerdicts));
  diagnosis.verdict = Verdict::kNamed;
  diagnosis.confidence_set = {"wind", "gust"};
  EXPECT_THAT(DiagnosisAsMarkdown(diagnosis), HasSubstr("Report all that the recording cannot"));
}

}  // namespace
}  // namespace clothfit
