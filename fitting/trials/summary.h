// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Scores of trials as text: a row a trial, which can be read again, and the summary.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fitting/trials/score.h"

namespace clothfit {

// One row a trial. ReadScores reads it back; it throws InputError, naming the place, where the text
// is no such table.
std::string ScoresAsCsv(const std::vector<TrialScore>& scores);
std::vector<TrialScore> ReadScores(const std::string& place, const std::string& csv);

// An effect is a fair trial where it is at least this many times the detection limit.
constexpr double kFairOverLimit = 3.0;
// True where it is, and where the diagnosis tells no limit.
bool IsFair(const TrialScore& score);

// How many of these scores, of those that have an answer, say yes.
Coverage CountYes(const std::vector<TrialScore>& scores,
                  const std::optional<bool> TrialScore::*answer,
                  const std::function<bool(const TrialScore&)>& which = {});

// Not a number where there are none.
double Median(std::vector<double> values);

// The tables of docs/studies/trials.md: shares with Wilson intervals beside what is asked for.
std::string ScoresAsMarkdown(const std::vector<TrialScore>& scores);

}  // namespace clothfit
