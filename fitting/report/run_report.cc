// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of a fit.
#include "fitting/report/kinds.h"
#include "fitting/report/scene_page.h"
#include "fitting/report/verdict/facts.h"

namespace clothfit {
namespace {

std::vector<ReportJson> SectionsOfRun(const ReportScene& report,
                                      const std::vector<ScalarField>& fields,
                                      const std::vector<ReportJson>& extras) {
  std::vector<ReportJson> sections = {CameraSection(report),
                                      ErrorSection(report, MeasureMotions(report)),
                                      ClothMapSection(report, fields), ParameterSection(report)};
  sections.insert(sections.end(), extras.begin(), extras.end());
  sections.push_back(ConvergenceSection(report));
  sections.push_back(TimeSection(report));
  sections.push_back(ConfigurationSection(report));
  return sections;
}

}  // namespace

ReportPage MakeReport(const RunFolder& run, const ReportAssets& assets,
                      const ReportOptions& options) {
  const ReportScene report = GatherReportScene(run, options.pictures);
  const ReportExtras extras = ReadReportExtras(run.path(), report);
  std::vector<ScalarField> fields = CommonFields(report);
  const VerdictFacts facts = FactsOf(report.record);
  std::vector<ReportJson> sections = SectionsOfRun(report, fields, extras.sections);
  fields.insert(fields.end(), extras.fields.begin(), extras.fields.end());
  return MakeScenePage({report,
                        JudgeFit(facts),
                        report.scene().recording.name,
                        "Error at the start → after the fit",
                        facts.errors,
                        std::move(fields),
                        ObstaclesOf(report, extras.obstacles),
                        std::move(sections),
                        {}},
                       assets, options);
}

}  // namespace clothfit
