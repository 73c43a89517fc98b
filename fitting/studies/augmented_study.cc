// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Hasler et al. 2007, sec. 6.2, Figure 9: what silhouettes and tracked points find together, over
// what they would find if each were alone. At true minima it is never below 1, since
// min (a + b) >= min a + min b: below 1 a search alone has not found its minimum.
#include <cmath>

#include <fmt/format.h>

#include "fitting/pictures/line_chart.h"
#include "fitting/studies/study.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

std::vector<double> SilhouetteWeights(const StudyOptions& options) {
  return ValuesOr(options, {0.001, 0.01, 0.1},
                  {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1, 3e-1, 1.0});
}

std::vector<Job> AugmentedJobs(const StudyOptions& options) {
  const std::vector<double> alphas = SilhouetteWeights(options);
  std::vector<Job> jobs;
  for (const std::string& experiment : options.experiments) {
    StudyFit fit;
    fit.experiment = experiment;
    fit.search = options.search;
    fit.points = "markers";
    const auto add = [&](double alpha, double beta) {
      fit.alpha = alpha;
      fit.beta = beta;
      jobs.push_back(FitJob(fmt::format("{}-{}-{}", experiment, alpha, beta), fit, options));
    };
    add(1.0, 0.0);
    add(0.0, 1.0);
    for (const double alpha : alphas) add(alpha, 1.0);
  }
  return jobs;
}

// E_ab / (alpha E_10 + beta E_01); NaN where one of them is missing.
double Normalised(const std::vector<DoneFit>& fits, const DoneFit& done) {
  const auto alone = [&](double alpha, double beta) {
    const DoneFit* const found = FindFit(fits, [&](const StudyFit& fit) {
      return fit.experiment == done.fit.experiment && fit.alpha == alpha && fit.beta == beta;
    });
    return found == nullptr ? NAN : found->result.error;
  };
  double sum = 0.0;
  if (done.fit.alpha > 0.0) sum += done.fit.alpha * alone(1.0, 0.0);
  if (done.fit.beta > 0.0) sum += done.fit.beta * alone(0.0, 1.0);
  return done.result.error / sum;
}

std::string AugmentedRows(const std::vector<DoneFit>& fits, bool markdown) {
  std::string text;
  for (const DoneFit& done : fits) {
    const auto& [fit, result] = done;
    text += fmt::format(
        markdown ? "| {} | {} | {} | {:.6g} | {:.3f} | {:.1f} | {:.2f} | {:.1f} | {:.0f} |\n"
                 : "{},{},{},{},{},{},{},{},{}\n",
        fit.experiment, fit.alpha, fit.beta, result.error, Normalised(fits, done),
        result.all_pixels, result.attractor, result.truth_rms, result.simulations);
  }
  return text;
}

std::string AugmentedStudyReport(const StudyOptions&, const std::vector<Job>& jobs,
                                 const std::vector<JobResult>& results, const StudyPlace& place) {
  const std::vector<DoneFit> fits = DoneFits(jobs, results);
  Chart chart{
      "Augmented error", "alpha, mm/px, where beta is 1", "normalised error", true, false, {}};
  for (const DoneFit& done : fits) {
    if (done.fit.beta == 0.0 || done.fit.alpha == 0.0) continue;
    if (chart.lines.empty() || chart.lines.back().name != done.fit.experiment)
      chart.lines.push_back({done.fit.experiment, {}, false, true});
    chart.lines.back().points.emplace_back(done.fit.alpha, Normalised(fits, done));
  }
  WriteWholeFile(place.folder / "augmented.csv",
                 "experiment,alpha,beta,error,normalised,silhouette_px,attractor_mm,truth_mm,"
                 "simulations\n" +
                     AugmentedRows(fits, false));
  WriteWholeFile(place.folder / "augmented.svg", ChartsAsSvg({chart}));
  return "| experiment | alpha | beta | E | normalised | px a picture | attractor, mm | mm from "
         "truth | simulations |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n" +
         AugmentedRows(fits, true);
}

}  // namespace

Study AugmentedStudy() {
  Study study;
  study.name = "augmented";
  study.doc = "Figure 9: silhouettes and tracked points in one error, over each alone";
  study.values = "alpha, mm/px, weights of the silhouettes where that of the points is 1";
  study.values_of = SilhouetteWeights;
  study.jobs = AugmentedJobs;
  study.report = AugmentedStudyReport;
  return study;
}

}  // namespace clothfit
