// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/markdown_text.h"

#include <fmt/format.h>

#include "fitting/diagnosis/answer/headline.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::string WhatToDoNext(const Diagnosis& diagnosis) {
  switch (diagnosis.verdict) {
    case Verdict::kNothingMissing:
      return "Use the fit in `fit/`. A motion twice as fast would show more.";
    case Verdict::kNamed:
      if (diagnosis.confidence_set.size() > 1 || !diagnosis.sets_beside.empty()) {
        return "Report all that the recording cannot tell apart, or record a motion that tells "
               "them apart and diagnose that.";
      }
      return "Go on with `config.yaml`, which has it: `clothfit fit`, `simulate` and `predict` "
             "take it.";
    case Verdict::kObservationFault:
      return "Mend the recording and diagnose it again.";
    case Verdict::kNoneOfTheAbove:
      return "Look where and when a force is missing, on the page that `clothfit report` makes of "
             "this folder, and what was there when it was recorded.";
    case Verdict::kUndecided:
      return "Record a shorter or gentler motion, or state the material parameters that are known.";
    case Verdict::kInterrupted:
      break;
  }
  return "Give the same command with `--resume`: it goes on.";
}

std::string UnitOf(const Candidate& candidate) {
  const std::string unit = candidate.parameters.empty() ? "" : candidate.parameters[0].unit;
  return unit.empty() || unit == "1" ? "" : " " + unit;
}

std::string CandidateTable(const Diagnosis& diagnosis) {
  std::string text =
      "\n### Candidates\n\n| | explains | score | without projection | p | false discovery | "
      "detection limit | |\n|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Candidate& c : diagnosis.ranking) {
    text +=
        fmt::format("| {} | {:.0f} % | {:.4g} | {:.4g} | {:.2g} | {:.2g} | {:.2g}{} | {} |\n",
                    c.name, 100.0 * c.share, c.score, c.raw_score, c.p_value, c.q_value,
                    c.detection_limit, UnitOf(c), c.is_short_listed ? "short-listed" : c.why_not);
  }
  return text;
}

std::string ModelTable(const Diagnosis& diagnosis) {
  std::string text =
      "\n### Models\n\n| effects | cost | explains | log evidence | held out before | after | "
      "improvement, at least | |\n|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Model& m : diagnosis.models) {
    text += fmt::format("| {} | {:.6g} | {:.0f} % | {:.4g} | {:.4g} | {:.4g} | {:.3g} | {} |\n",
                        JoinNames(m.effects), m.cost, 100.0 * m.explained, m.log_evidence,
                        m.validation.before, m.validation.after, m.validation.improvement_lower95,
                        m.is_kept ? "kept" : "");
  }
  return text;
}

}  // namespace

std::string DiagnosisAsMarkdown(const Diagnosis& diagnosis) {
  std::string text = "# " + HeadlineOf(diagnosis) + "\n";
  for (const std::string& paragraph : DetailsOf(diagnosis)) text += "\n" + paragraph + "\n";
  text += "\n## What to do next\n\n" + WhatToDoNext(diagnosis) + "\n";
  text += "\n## For specialists\n" + CandidateTable(diagnosis) + ModelTable(diagnosis);
  text += "\n### Time\n\n";
  for (const auto& [stage, seconds] : diagnosis.seconds)
    text += fmt::format("- {}: {:.1f} s\n", stage, seconds);
  return text;
}

}  // namespace clothfit
