// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit's summary.json says, as verdicts need it.
#pragma once

#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "fitting/report/records/run_record.h"
#include "fitting/report/verdict/page_verdict.h"

namespace clothfit {

// Of summary.json, or of a recording's entry in that of a fit of several: the errors that are
// known, fitted ones first, and the misfit.
std::vector<ErrorChange> ErrorsOf(const nlohmann::ordered_json& summary);
std::optional<Misfit> MisfitOf(const nlohmann::ordered_json& summary);

// Of a fit of one recording.
VerdictFacts FactsOf(const RunRecord& record);

}  // namespace clothfit
