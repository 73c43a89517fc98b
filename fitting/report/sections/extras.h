// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What other commands leave for a report in the run's folder report/: sections, fields, obstacles.
#pragma once

#include <vector>

#include "fitting/report/sections/sections.h"
#include "fitting/runs/obstacles.h"

namespace clothfit {

struct ReportExtras {
  std::vector<ReportJson> sections;
  std::vector<ScalarField> fields;
  std::vector<ObstacleSurface> obstacles;
};

// Reads report/*.json in the order of their names: {"sections": [...], "fields": [{"name",
// "title", "unit", "diverging", "values": {"after": "FILE.npy"}}], "obstacles": [{"name",
// "positions": "FILE.npy", "triangles": [[0, 1, 2], ...]}]}. Throws InputError.
ReportExtras ReadReportExtras(const std::filesystem::path& run, const ReportScene& report);

}  // namespace clothfit
