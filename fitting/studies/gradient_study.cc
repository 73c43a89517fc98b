// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the simulation's derivatives are worth: how far from extrapolated differences, and what they
// cost, against the step of differences, the time step, the mesh, the number of parameters and the
// horizon.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/gradient_report.h"
#include "fitting/pictures/line_chart.h"
#include "fitting/rollout/window_cost.h"
#include "fitting/studies/recovery_study.h"
#include "fitting/studies/study.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// One scene, and what is differentiated.
struct Case {
  int particles = 9;   // a side
  int parameters = 4;  // the first of kParameters
  int horizon = 20;    // frames at 60 Hz
  int steps = 2;       // a frame
};

const std::vector<std::string> kParameters = {
    "stretch.stiffness", "bending.stiffness", "air_drag.normal", "shear.stiffness",
    "stretch.damping",   "bending.damping",   "shear.damping",   "air_drag.tangential"};
constexpr double kTight = 1e-11;  // of a step, see SimulationOptions

Job CaseJob(const std::string& varied, double value, const Case& one) {
  return {fmt::format("{}-{}", varied, value),
          {{"varied", varied},
           {"value", value},
           {"particles", one.particles},
           {"parameters", one.parameters},
           {"horizon", one.horizon},
           {"steps", one.steps}}};
}

std::vector<Job> GradientJobs(const StudyOptions& options) {
  std::vector<Job> jobs;
  const auto vary = [&](const std::string& varied, int Case::*member, std::vector<int> values) {
    for (const int value : values) {
      Case one;
      one.*member = value;
      jobs.push_back(CaseJob(varied, value, one));
    }
  };
  const bool full = options.full;
  vary("particles", &Case::particles, full ? std::vector{5, 9, 13, 21, 31} : std::vector{5, 9, 13});
  vary("parameters", &Case::parameters, {1, 2, 4, 8});
  vary("horizon", &Case::horizon,
       full ? std::vector{5, 10, 20, 40, 80, 160} : std::vector{5, 10, 20, 40});
  vary("steps", &Case::steps, full ? std::vector{1, 2, 4, 8, 16} : std::vector{1, 2, 4});
  return jobs;
}

struct Problem {
  FitConfig config;
  Scene scene;
  int horizon;
};

Problem MakeProblem(const nlohmann::json& input, unsigned seed) {
  SyntheticOptions recording = DemoRecording();
  recording.seed = seed;
  const int horizon = input.at("horizon"), particles = input.at("particles");
  recording.frame_count = horizon + 1;
  recording.held_out_share = 0.0;
  const SyntheticRecording made = MakeSyntheticRecording(recording);
  FitConfig config = DefaultConfig(made.recording);
  config.resolution = {particles, particles};
  config.max_step = 1.0 / (recording.frame_rate * input.at("steps").get<int>());
  const auto last = kParameters.begin() + input.at("parameters").get<int>();
  for (auto& [name, setting] : config.parameters)
    setting.free = std::find(kParameters.begin(), last, name) != last;
  Scene scene = MakeScene(made.recording, config);
  return {config, std::move(scene), horizon};
}

double Seconds(const std::function<bool()>& work) {
  std::vector<double> all;
  for (int i = 0; i < 3; ++i) {
    const auto start = std::chrono::steady_clock::now();
    if (!work()) throw std::runtime_error("the simulation fails at the start values");
    all.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(all.begin(), all.end());
  return all[1];
}

// The largest error of central differences of this step, over the largest entry of its column.
double DifferenceError(const Problem& problem, const FreeParameters& free, double step,
                       const Eigen::MatrixXd& exact) {
  double worst = 0.0;
  for (int k = 0; k < free.size(); ++k) {
    Eigen::VectorXd below, above, theta = free.start();
    theta[k] += step;
    const auto evaluate = [&](Eigen::VectorXd* f) {
      return EvaluateResiduals(problem.scene, problem.config, free, theta, problem.horizon, f,
                               nullptr);
    };
    if (!evaluate(&above)) return std::numeric_limits<double>::infinity();
    theta[k] -= 2.0 * step;
    if (!evaluate(&below)) return std::numeric_limits<double>::infinity();
    const Eigen::VectorXd difference = (above - below) / (2.0 * step);
    worst = std::max(worst, (difference - exact.col(k)).cwiseAbs().maxCoeff() /
                                exact.col(k).cwiseAbs().maxCoeff());
  }
  return worst;
}

nlohmann::json RunGradientJob(const StudyOptions& options, const Job& job, const JobContext&) {
  Problem problem = MakeProblem(job.input, options.seed);
  const double loose = problem.config.tolerance;
  const FreeParameters free(problem.config, problem.scene, MakeParameterTable());
  Eigen::VectorXd residuals;
  Eigen::MatrixXd exact, jacobian;
  const auto evaluate = [&](Eigen::MatrixXd* derivatives) {
    return EvaluateResiduals(problem.scene, problem.config, free, free.start(), problem.horizon,
                             &residuals, derivatives);
  };
  const double value_seconds = Seconds([&] { return evaluate(nullptr); });
  const double derivative_seconds = Seconds([&] { return evaluate(&jacobian); });
  problem.config.tolerance = kTight;
  evaluate(&exact);
  const GradientReport report = CheckFitGradient(problem.scene, problem.config, problem.horizon);
  double extrapolated = 0.0;
  for (const ColumnCheck& column : report.check.columns)
    extrapolated = std::max(extrapolated, column.difference_error);
  nlohmann::json curve = nlohmann::json::array();
  for (double step = 0.1; step > 0.5e-9; step /= 10.0) {
    problem.config.tolerance = kTight;
    const double tight_error = DifferenceError(problem, free, step, exact);
    problem.config.tolerance = loose;
    curve.push_back({step, tight_error, DifferenceError(problem, free, step, exact)});
  }
  return {{"worst", report.check.WorstRelativeError()},
          {"extrapolated", extrapolated},
          {"undecided", report.check.Count(GradientVerdict::kUndecided)},
          {"as_fitted", (jacobian - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff()},
          {"value_ms", 1e3 * value_seconds},
          {"derivative_ms", 1e3 * derivative_seconds},
          {"curve", curve}};
}

// Both on the same lines: the input of a case and what came of it.
std::string GradientRows(const std::vector<Job>& jobs, const std::vector<JobResult>& results,
                         bool markdown) {
  std::string text;
  for (const JobResult& result : results) {
    const auto job = std::find_if(jobs.begin(), jobs.end(),
                                  [&](const Job& one) { return one.name == result.name; });
    const nlohmann::json &in = job->input, &out = result.output;
    const double value = out.at("value_ms"), with = out.at("derivative_ms");
    double best = std::numeric_limits<double>::infinity(), best_loose = best;
    for (const nlohmann::json& point : out.at("curve")) {
      if (!point[1].is_null()) best = std::min(best, point[1].get<double>());
      if (!point[2].is_null()) best_loose = std::min(best_loose, point[2].get<double>());
    }
    text += fmt::format(markdown ? "| {} | {} | {:.1e} | {:.1e} | {} | {:.1e} | {:.1e} | {:.1e} | "
                                   "{:.1f} | {:.2f} | {:.0f} |\n"
                                 : "{},{},{},{},{},{},{},{},{},{},{}\n",
                        in.at("varied").get<std::string>(), in.at("value").get<double>(),
                        out.at("worst").get<double>(), out.at("extrapolated").get<double>(),
                        out.at("undecided").get<int>(), out.at("as_fitted").get<double>(), best,
                        best_loose, value, with / value, 2.0 * in.at("parameters").get<double>());
  }
  return text;
}

std::string CurveRows(const std::vector<JobResult>& results) {
  std::string text = "case,difference_step,error_solved_tight,error_solved_as_fitted\n";
  for (const JobResult& result : results) {
    for (const nlohmann::json& point : result.output.at("curve")) {
      const auto number = [&](int i) {
        return point[i].is_null() ? std::string() : FormatNumber(point[i].get<double>());
      };
      text += fmt::format("{},{},{},{}\n", result.name, number(0), number(1), number(2));
    }
  }
  return text;
}

Chart CurveChart(const std::vector<JobResult>& results, int column, const std::string& title) {
  Chart chart{title, "step of the differences", "error of the differences", true, true, {}};
  for (const JobResult& result : results) {
    if (!StartsWith(result.name, "horizon")) continue;
    ChartLine line{result.name + " frames", {}, false, true};
    for (const nlohmann::json& point : result.output.at("curve")) {
      if (!point[column].is_null())
        line.points.emplace_back(point[0].get<double>(), point[column].get<double>());
    }
    chart.lines.push_back(line);
  }
  return chart;
}

std::string GradientStudyReport(const StudyOptions&, const std::vector<Job>& jobs,
                                const std::vector<JobResult>& results, const StudyPlace& place) {
  WriteWholeFile(place.folder / "gradients.csv",
                 "varied,value,relative_error,error_of_extrapolation,undecided,as_fitted,"
                 "best_difference_tight,best_difference_as_fitted,simulation_ms,"
                 "derivatives_over_simulation,differences_over_simulation\n" +
                     GradientRows(jobs, results, false));
  WriteWholeFile(place.folder / "gradients-differences.csv", CurveRows(results));
  WriteWholeFile(place.folder / "gradients.svg",
                 ChartsAsSvg({CurveChart(results, 1, "Steps solved to 1e-11"),
                              CurveChart(results, 2, "Steps solved as in fits, 1e-7")}));
  return "| varied | value | from extrapolated differences | their own error | undecided | solved "
         "as in fits | best central difference | the same, solved as in fits | simulation, ms | "
         "with derivatives, simulations | central differences, simulations |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n" +
         GradientRows(jobs, results, true);
}

}  // namespace

Study GradientStudy() {
  Study study;
  study.name = "gradients";
  study.doc = "derivatives: accuracy and cost against step, mesh, parameters and horizon";
  study.uses_recordings = false;
  study.files = {"gradients-differences.csv"};
  study.jobs = GradientJobs;
  study.work = RunGradientJob;
  study.report = GradientStudyReport;
  return study;
}

}  // namespace clothfit
