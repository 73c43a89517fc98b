// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of a page that compares two runs, as data.
#pragma once

#include <vector>

#include "fitting/report/pair/run_pair.h"
#include "fitting/report/sections/sections.h"

namespace clothfit {

// What both left, number by number, with the difference.
ReportJson PairNumberSection(const RunPair& pair);
// Errors over the seconds of two recordings. Of one recording ErrorSection does, which is on the
// clock.
ReportJson PairErrorSection(const RunPair& pair);
// Root mean square over the cloth of the distance of two motions of one mesh, over time.
ReportJson ApartChart(const std::vector<double>& apart);
ReportJson PairParameterSection(const RunPair& pair,
                                const std::vector<PairedParameter>& parameters);
ReportJson PairSettingSection(const RunPair& pair);

}  // namespace clothfit
