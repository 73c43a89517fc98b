// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/compare/order_by_all_frames.h"

#include <algorithm>

namespace clothfit {

bool IsSame(const JudgedModel& a, const JudgedModel& b) {
  return a.candidate.summary.name == b.candidate.summary.name;
}

const JudgedModel* Named(const JudgedModel& one, const std::vector<JudgedModel>& models) {
  const auto same = std::find_if(models.begin(), models.end(),
                                 [&](const JudgedModel& other) { return IsSame(one, other); });
  return same == models.end() ? nullptr : &*same;
}

void OrderByAllFrames(const std::vector<JudgedModel>& whole, bool decide,
                      std::vector<JudgedModel>* forecasts) {
  const double best = forecasts->front().log_evidence;
  const JudgedModel* const best_of_forecasts = Named(forecasts->front(), whole);
  if (best_of_forecasts == nullptr) return;
  for (JudgedModel& one : *forecasts) {
    const JudgedModel* const same = Named(one, whole);
    if (same == nullptr) {
      if (decide) one.log_evidence += best_of_forecasts->log_evidence - best;
    } else if (decide) {
      one.log_evidence = same->log_evidence;
    } else {
      const double behind = whole.front().log_evidence - same->log_evidence;
      one.log_evidence = std::max(one.log_evidence, best - behind);
    }
  }
  SortByEvidence(forecasts);
}

}  // namespace clothfit
