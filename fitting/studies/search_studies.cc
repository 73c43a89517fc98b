// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Studies of how is searched: Hasler et al. 2007, sec. 6.1 (the fabric in every frame), sec. 7
// (what it takes), and optimisers side by side.
#include <cmath>

#include <fmt/format.h>

#include "fitting/pictures/line_chart.h"
#include "fitting/studies/study.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

std::vector<Job> JobsOf(const StudyOptions& options, const std::vector<std::string>& searches) {
  std::vector<Job> jobs;
  for (const std::string& experiment : options.experiments) {
    for (int start = 0; start < options.starts; ++start) {
      for (const std::string& search : searches) {
        StudyFit fit;
        fit.experiment = experiment;
        fit.search = search;
        fit.start = start;
        std::string name = fmt::format("{}-{}-start{}", experiment, search, start);
        name[name.find('/')] = '-';
        jobs.push_back(FitJob(name, fit, options));
      }
    }
  }
  return jobs;
}

const char* const kHeader =
    "| experiment | start | search | unknowns | error, px | mm from truth | simulations | s | "
    "converged |\n|---|---:|---|---:|---:|---:|---:|---:|---|\n";

std::string SearchRows(const std::vector<DoneFit>& fits, bool markdown) {
  std::string text;
  for (const auto& [fit, result] : fits) {
    text +=
        fmt::format(markdown ? "| {} | {} | {} | {} | {:.0f} | {:.2f} | {:.0f} | {:.1f} | {} |\n"
                             : "{},{},{},{},{},{},{},{},{}\n",
                    fit.experiment, fit.start, fit.search, result.unknowns, result.error,
                    result.truth_rms, result.simulations, result.seconds, result.converged);
  }
  return text;
}

void WriteCsv(const StudyPlace& place, const std::string& name, const std::vector<DoneFit>& fits) {
  WriteWholeFile(place.folder / (name + ".csv"),
                 "experiment,start,search,unknowns,error_px,truth_mm,simulations,seconds,"
                 "converged\n" +
                     SearchRows(fits, false));
}

// The best error so far, one chart an experiment.
std::string HistoryAsSvg(const std::vector<DoneFit>& fits) {
  std::vector<Chart> charts;
  for (const auto& [fit, result] : fits) {
    if (charts.empty() || charts.back().title != fit.experiment)
      charts.push_back({fit.experiment, "simulations", "error, px", true, true, {}});
    ChartLine line{fit.search, {}, true, false};
    for (const SearchPoint& point : result.history)
      line.points.emplace_back(point.simulations, point.error);
    if (!line.points.empty()) line.points.emplace_back(result.simulations, line.points.back().y());
    charts.back().lines.push_back(line);
  }
  return ChartsAsSvg(charts);
}

// One loop over two, each with the same optimiser.
std::string LocalOverTwoLoops(const std::vector<DoneFit>& fits) {
  std::string text =
      "\nOne loop over two (Hasler et al. 2007: error almost 2, time 0.1):\n\n"
      "| experiment | optimiser | error | simulations | time | distance from truth |\n"
      "|---|---|---:|---:|---:|---:|\n";
  for (const DoneFit& two : fits) {
    const std::string optimiser = two.fit.search.substr(0, two.fit.search.find('/'));
    const DoneFit* const one = FindFit(fits, [&](const StudyFit& fit) {
      return fit.experiment == two.fit.experiment && fit.start == two.fit.start &&
             fit.search == optimiser + "/one-loop";
    });
    if (two.fit.search != optimiser + "/two-loop" || one == nullptr) continue;
    text += fmt::format(
        "| {} | {} | {:.2f} | {:.2f} | {:.2f} | {:.2f} |\n", two.fit.experiment, optimiser,
        one->result.error / two.result.error, one->result.simulations / two.result.simulations,
        one->result.seconds / two.result.seconds, one->result.truth_rms / two.result.truth_rms);
  }
  return text;
}

std::string WorkTable(const StudyOptions& options) {
  return fmt::format(
      "\nOne fit: {} frames of 7 cameras of {} x {} px, {} x {} particles, 4 steps a frame, {} "
      "parameters of the fabric, all paths of handles unknown, one core; ended by the pass that "
      "reached {} simulations. "
      "Hasler et al. 2007: more than 410 frames of 7 cameras, 10 to 30 h on 7 Opterons of "
      "2.2 GHz, 70 to 210 h of one.\n",
      options.frames, options.picture, 3 * options.picture / 4, options.particles,
      options.particles, options.fabric.size(), options.simulations);
}

// A study of these searches with its table, curves and a last word.
Study SearchStudy(
    const std::string& name, const std::string& doc, const std::vector<std::string>& searches,
    const std::function<std::string(const StudyOptions&, const std::vector<DoneFit>&)>& last_word) {
  Study study;
  study.name = name;
  study.doc = doc;
  study.jobs = [searches](const StudyOptions& options) { return JobsOf(options, searches); };
  study.report = [name, last_word](const StudyOptions& options, const std::vector<Job>& jobs,
                                   const std::vector<JobResult>& results, const StudyPlace& place) {
    const std::vector<DoneFit> fits = DoneFits(jobs, results);
    WriteCsv(place, name, fits);
    WriteWholeFile(place.folder / (name + ".svg"), HistoryAsSvg(fits));
    return kHeader + SearchRows(fits, true) + last_word(options, fits);
  };
  return study;
}

}  // namespace

Study LocalParameterStudy() {
  return SearchStudy("local-parameters",
                     "section 6.1: the fabric in every frame against the two loops",
                     {"pattern/two-loop", "pattern/one-loop", "lm/two-loop", "lm/one-loop"},
                     [](const StudyOptions&, const std::vector<DoneFit>& fits) {
                       return LocalOverTwoLoops(fits);
                     });
}

Study RuntimeStudy() {
  return SearchStudy(
      "runtime", "section 7: what a fit takes", {"lm/joint", "pattern/two-loop"},
      [](const StudyOptions& options, const std::vector<DoneFit>&) { return WorkTable(options); });
}

Study OptimiserStudy() {
  return SearchStudy(
      "optimisers", "optimisers and strategies from the same starts",
      {"lm/joint", "lm/two-loop", "pattern/two-loop", "annealing/two-loop", "bobyqa/two-loop",
       "nelder-mead/two-loop"},
      [](const StudyOptions&, const std::vector<DoneFit>&) { return std::string(); });
}

}  // namespace clothfit
