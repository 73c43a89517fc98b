// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of a diagnosis' page, as docs/report.md describes them.
#pragma once

#include "fitting/report/diagnosis/record.h"
#include "fitting/report/sections/sections.h"

namespace clothfit {

// Every candidate by what it explains, with and without projection; what cannot be told apart.
ReportJson RankingSection(const DiagnosisRecord& record);
// Where and when a force is missing: maps and courses. Empty blocks where none is.
ReportJson LocationSection(const ReportScene& report, const DiagnosisRecord& record,
                           ReportBlobs* blobs);
ReportJson ClassSection(const DiagnosisRecord& record);
// Held-out errors of every model that was fitted.
ReportJson ValidationSection(const ReportScene& report, const DiagnosisRecord& record);
// Parameters of what was found, with intervals.
ReportJson AnswerSection(const ReportScene& report, const DiagnosisRecord& record);
// What recordings of nothing but the baseline would show.
ReportJson NullSection(const DiagnosisRecord& record);
ReportJson DiagnosisTimeSection(const DiagnosisRecord& record);
ReportJson DiagnosisFilesSection(const ReportScene& report, const DiagnosisRecord& record);

}  // namespace clothfit
