// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Hasler et al. 2007, sec. 6, Figure 6: the error that remains against the stiffness of the
// attraction, over the error without any.
#include <cmath>

#include <fmt/format.h>

#include "fitting/pictures/line_chart.h"
#include "fitting/studies/study.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

// m: the distance at which both laws of one stiffness pull alike. The reciprocal's k / d^2 is
// stiffness * d there.
constexpr double kSameAt = 0.01;

bool IsReciprocal(const StudyFit& fit) { return fit.reciprocal > 0.0; }
double Stiffness(const StudyFit& fit) {
  return IsReciprocal(fit) ? fit.reciprocal / std::pow(kSameAt, 3) : fit.linear;
}
const char* Law(const StudyFit& fit) {
  return IsReciprocal(fit) ? "reciprocal" : fit.linear > 0.0 ? "linear" : "none";
}

std::vector<double> AttractorStiffnesses(const StudyOptions& options) {
  return ValuesOr(options, {10.0, 100.0, 1000.0},
                  {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0});
}

std::vector<Job> AttractionJobs(const StudyOptions& options) {
  const std::vector<double> values = AttractorStiffnesses(options);
  std::vector<Job> jobs;
  for (const std::string& experiment : options.experiments) {
    StudyFit fit;
    fit.experiment = experiment;
    fit.search = options.search;
    jobs.push_back(FitJob(experiment + "-none", fit, options));
    for (const char* points : {"markers", "tracks"}) {
      for (const bool reciprocal : {false, true}) {
        for (const double value : values) {
          fit.points = points;
          fit.linear = reciprocal ? 0.0 : value;
          fit.reciprocal = reciprocal ? value * std::pow(kSameAt, 3) : 0.0;
          jobs.push_back(FitJob(fmt::format("{}-{}-{}-{}", experiment, points, Law(fit), value),
                                fit, options));
        }
      }
    }
  }
  return jobs;
}

const DoneFit* Without(const std::vector<DoneFit>& fits, const StudyFit& fit) {
  return FindFit(fits, [&](const StudyFit& other) {
    return other.experiment == fit.experiment && other.points == "none";
  });
}

const char* Tracking(const StudyFit& fit) {
  return fit.points == "markers" ? "3D" : fit.points == "tracks" ? "2D" : "-";
}

std::string AttractionRows(const std::vector<DoneFit>& fits, bool markdown) {
  std::string text;
  for (const auto& [fit, result] : fits) {
    const DoneFit* const none = Without(fits, fit);
    const double normalised = none == nullptr ? NAN : result.error / none->result.error;
    text += fmt::format(
        markdown ? "| {} | {} | {} | {} | {:.0f} | {:.3f} | {:.1f} | {:.3f} | {:.0f} | {} |\n"
                 : "{},{},{},{},{},{},{},{},{},{}\n",
        fit.experiment, Tracking(fit), Law(fit), fmt::format("{:g}", Stiffness(fit)), result.error,
        normalised, result.truth_rms, result.roughness / result.true_roughness, result.simulations,
        result.converged);
  }
  return text;
}

Chart MakeChart(const std::vector<DoneFit>& fits, const std::string& law) {
  Chart chart{law + " attraction", "stiffness, N/m", "error over that without", true, false, {}};
  for (const auto& [fit, result] : fits) {
    const DoneFit* const none = Without(fits, fit);
    if (Law(fit) != law || none == nullptr) continue;
    const std::string name = fmt::format("{}, {}", fit.experiment, Tracking(fit));
    if (chart.lines.empty() || chart.lines.back().name != name)
      chart.lines.push_back({name, {}, false, true});
    chart.lines.back().points.emplace_back(Stiffness(fit), result.error / none->result.error);
  }
  return chart;
}

std::string AttractionStudyReport(const StudyOptions&, const std::vector<Job>& jobs,
                                  const std::vector<JobResult>& results, const StudyPlace& place) {
  const std::vector<DoneFit> fits = DoneFits(jobs, results);
  WriteWholeFile(place.folder / "attraction.csv",
                 "experiment,tracking,law,stiffness,error_px,normalised,truth_mm,"
                 "roughness_over_true,simulations,converged\n" +
                     AttractionRows(fits, false));
  WriteWholeFile(place.folder / "attraction.svg",
                 ChartsAsSvg({MakeChart(fits, "linear"), MakeChart(fits, "reciprocal")}));
  return "| experiment | tracking | law | stiffness, N/m | error, px | over none | mm from truth | "
         "roughness over true | simulations | converged |\n"
         "|---|---|---|---:|---:|---:|---:|---:|---:|---|\n" +
         AttractionRows(fits, true);
}

}  // namespace

Study AttractionStudy() {
  Study study;
  study.name = "attraction";
  study.doc = "Figure 6: the error that remains against the attraction's stiffness";
  study.values =
      "N/m, stiffnesses of all of a frame's attractors together; the reciprocal law pulls as the "
      "linear one at 1 cm";
  study.values_of = AttractorStiffnesses;
  study.jobs = AttractionJobs;
  study.report = AttractionStudyReport;
  return study;
}

}  // namespace clothfit
