// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The sections of a report below its first screen, as data: docs/report-internals.md has the schema
// of each kind of block. A new section needs a function here, or a JSON file in the run's folder
// report/, and nothing in the page.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "fitting/report/fields/scalar_field.h"
#include "fitting/report/page/blocks.h"
#include "fitting/report/scene/frame_misfit.h"

namespace clothfit {

// Every camera's pictures with the outlines over them. Empty blocks where there is no camera.
ReportJson CameraSection(const ReportScene& report);
// `misfits`: one list a motion, in the motions' order.
ReportJson ErrorSection(const ReportScene& report,
                        const std::vector<std::vector<FrameMisfit>>& misfits);
// Root mean square over time of the first field, by particle, of each motion. Empty blocks where
// the mesh is no grid.
ReportJson ClothMapSection(const ReportScene& report, const std::vector<ScalarField>& fields);
ReportJson ParameterSection(const ReportScene& report);
// The same of a summary and a config alone; truth: by full name, of those that are known.
ReportJson ParameterSection(const ReportJson& summary, const FitConfig& config,
                            const std::map<std::string, double>& truth);
ReportJson ConvergenceSection(const ReportScene& report);
ReportJson TimeSection(const ReportScene& report);
ReportJson ConfigurationSection(const ReportScene& report);

}  // namespace clothfit
