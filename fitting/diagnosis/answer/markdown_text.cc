// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/markdown_text.h"

#include <fmt/format.h>

#include "fitting/diagnosis/answer/headline.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "tracking/text/text.h"

namespace clothfit {

std::string DiagnosisAsMarkdown(const Diagnosis& diagnosis) {
  std::string text = fmt::format("# {}\n\n{}\n", HeadlineOf(diagnosis), DetailsOf(diagnosis));
  text +=
      "\n## Candidates\n\n| | explains | score | without projection | p | false discovery | "
      "detection limit | |\n|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Candidate& c : diagnosis.ranking) {
    text += fmt::format("| {} | {:.0f} % | {:.4g} | {:.4g} | {:.2g} | {:.2g} | {:.2g} {} | {} |\n",
                        c.name, 100.0 * c.share, c.score, c.raw_score, c.p_value, c.q_value,
                        c.detection_limit, c.parameters.empty() ? "" : c.parameters[0].unit,
                        c.is_short_listed ? "short-listed" : c.why_not);
  }
  text +=
      "\n## Models\n\n| effects | cost | explains | log evidence | held out before | after | "
      "improvement, at least | |\n|---|---:|---:|---:|---:|---:|---:|---|\n";
  for (const Model& m : diagnosis.models) {
    text += fmt::format("| {} | {:.6g} | {:.0f} % | {:.4g} | {:.4g} | {:.4g} | {:.3g} | {} |\n",
                        JoinNames(m.effects), m.cost, 100.0 * m.explained, m.log_evidence,
                        m.validation.before, m.validation.after, m.validation.improvement_lower95,
                        m.is_kept ? "kept" : "");
  }
  text += "\n## Time\n\n";
  for (const auto& [stage, seconds] : diagnosis.seconds)
    text += fmt::format("- {}: {:.1f} s\n", stage, seconds);
  return text;
}

}  // namespace clothfit
