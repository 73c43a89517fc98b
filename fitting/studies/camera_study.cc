// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Hasler et al. 2007, sec. 6.3, Figure 10: the error against the number of cameras, over that with
// seven. An error that is summed over the cameras grows with their number anyway, so the error in
// all seven, the fitted ones or not, and the distance from the truth stand beside it.
#include <cmath>

#include <fmt/format.h>

#include "fitting/pictures/line_chart.h"
#include "fitting/studies/study.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

constexpr int kAll = 7;

std::vector<double> NumbersOfCameras(const StudyOptions& options) {
  return ValuesOr(options, {1, 2, 3, 5, 7}, {1, 2, 3, 4, 5, 6, 7});
}

std::vector<Job> CameraJobs(const StudyOptions& options) {
  const std::vector<double> counts = NumbersOfCameras(options);
  std::vector<Job> jobs;
  for (const std::string& experiment : options.experiments) {
    for (const double count : counts) {
      StudyFit fit;
      fit.experiment = experiment;
      fit.search = options.search;
      fit.cameras = static_cast<int>(count);
      jobs.push_back(FitJob(fmt::format("{}-{}-cameras", experiment, fit.cameras), fit, options));
    }
  }
  return jobs;
}

// Something of a fit over the same with all cameras.
double OverSeven(const std::vector<DoneFit>& fits, const DoneFit& done,
                 double StudyFitResult::*member) {
  const DoneFit* const all = FindFit(fits, [&](const StudyFit& fit) {
    return fit.experiment == done.fit.experiment && fit.cameras == kAll;
  });
  return all == nullptr ? NAN : done.result.*member / all->result.*member;
}

std::string CameraRows(const std::vector<DoneFit>& fits, bool markdown) {
  std::string text;
  for (const DoneFit& done : fits) {
    text += fmt::format(markdown ? "| {} | {} | {:.0f} | {:.3f} | {:.1f} | {:.2f} | {:.1f} | "
                                   "{:.2f} | {:.0f} |\n"
                                 : "{},{},{},{},{},{},{},{},{}\n",
                        done.fit.experiment, done.fit.cameras, done.result.error,
                        OverSeven(fits, done, &StudyFitResult::error), done.result.all_pixels,
                        OverSeven(fits, done, &StudyFitResult::all_pixels), done.result.truth_rms,
                        OverSeven(fits, done, &StudyFitResult::truth_rms), done.result.simulations);
  }
  return text;
}

Chart MakeChart(const std::vector<DoneFit>& fits, const std::string& label,
                double StudyFitResult::*member) {
  Chart chart{label, "cameras", "over that with seven", false, false, {}};
  for (const DoneFit& done : fits) {
    if (chart.lines.empty() || chart.lines.back().name != done.fit.experiment)
      chart.lines.push_back({done.fit.experiment, {}, false, true});
    chart.lines.back().points.emplace_back(done.fit.cameras, OverSeven(fits, done, member));
  }
  return chart;
}

std::string CameraStudyReport(const StudyOptions&, const std::vector<Job>& jobs,
                              const std::vector<JobResult>& results, const StudyPlace& place) {
  const std::vector<DoneFit> fits = DoneFits(jobs, results);
  WriteWholeFile(place.folder / "cameras.csv",
                 "experiment,cameras,error_px,error_over_seven,all_px,all_over_seven,truth_mm,"
                 "truth_over_seven,simulations\n" +
                     CameraRows(fits, false));
  WriteWholeFile(
      place.folder / "cameras.svg",
      ChartsAsSvg({MakeChart(fits, "Error of the cameras used", &StudyFitResult::error),
                   MakeChart(fits, "Error in all seven", &StudyFitResult::all_pixels),
                   MakeChart(fits, "Distance from the truth", &StudyFitResult::truth_rms)}));
  return "| experiment | cameras | error, px | over seven | px a picture, all seven | over seven | "
         "mm from truth | over seven | simulations |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|---:|\n" +
         CameraRows(fits, true);
}

}  // namespace

Study CameraStudy() {
  Study study;
  study.name = "cameras";
  study.doc = "Figure 10: the error against the number of cameras";
  study.values = "numbers of cameras, 1 to 7";
  study.values_of = NumbersOfCameras;
  study.jobs = CameraJobs;
  study.report = CameraStudyReport;
  return study;
}

}  // namespace clothfit
