// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/mesh_study.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/bending.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "autodiff_sim/terms/shear.h"
#include "autodiff_sim/terms/spring.h"
#include "autodiff_sim/terms/wind.h"
#include "fitting/fit/fit.h"
#include "fitting/fit/search.h"
#include "fitting/pictures/line_chart.h"

namespace clothfit {
namespace {

constexpr double kSide = 0.9;  // m

struct Motion {
  const char* name;
  SyntheticScenario scenario;
  bool in_wind;
};
constexpr Motion kMotions[] = {{"one corner lifted", SyntheticScenario::kCornerLift, false},
                               {"two corners lifted", SyntheticScenario::kTwoCornerLift, false},
                               {"swung", SyntheticScenario::kTwoCornerSwing, false},
                               {"shaken in wind", SyntheticScenario::kTwoCornerShake, true}};

SyntheticOptions TruthOf(const Motion& motion, const MeshStudyOptions& options) {
  SyntheticOptions truth;
  truth.name = motion.name;
  truth.scenario = motion.scenario;
  truth.size = {kSide, kSide};
  truth.refinement = 2;
  truth.resolution.setConstant(options.truth_cells / truth.refinement + 1);
  truth.frame_rate = 30.0;
  truth.frame_count = options.frame_count;
  truth.markers = {12, 12};
  truth.truth_points = {13, 13};
  truth.parameters = ValuesOf<StretchSpring, Shear, Bending, AirDrag>(
      {600.0, 1.0}, {60.0, 0.3}, {1.4e-3, 2e-5}, {0.7, 0.1, 0.02});
  truth.parameters["cloth.areal_density"] = 0.2;
  if (motion.in_wind) truth.parameters.merge(ValuesOf<UniformWind>({0.35, 0.42, 0.0}));
  return truth;
}

// Sums of squared distances over fitted and held-out frames.
class ErrorSum {
 public:
  void Add(bool is_held_out, double squared) {
    sum_[is_held_out] += squared;
    ++count_[is_held_out];
  }
  MeshError Error() const { return {Root(0), Root(1)}; }

 private:
  double Root(int i) const { return count_[i] == 0 ? NAN : std::sqrt(sum_[i] / count_[i]); }
  double sum_[2] = {};
  int count_[2] = {};
};

MeshError Follow(const SyntheticRecording& truth, const Scene& scene, const FitConfig& config,
                 const FreeParameters& free, const Eigen::VectorXd& theta) {
  std::vector<Eigen::Vector2d> uv;
  for (const TruthPoint& point : truth.truth_points)
    if (point.frame == 0) uv.push_back(point.uv);
  const std::vector<SurfacePoint> on_cloth = LocateOnCloth(scene.mesh, uv);
  ErrorSum sum;
  std::size_t next = 0;
  const int last = scene.recording.frame_count - 1;
  const int reached =
      SimulateFrames(scene, config, free, theta, last, [&](int frame, const State& state) {
        for (std::size_t i = 0; i < uv.size(); ++i, ++next) {
          const Eigen::Vector3d d = on_cloth[i].At(state.x) - truth.truth_points[next].position;
          sum.Add(scene.IsHeldOut(frame), d.squaredNorm());
        }
      });
  return reached > last ? sum.Error() : MeshError{NAN, NAN};
}

MeshCase RunCase(const Motion& motion, const SyntheticRecording& truth, int particles, bool buckles,
                 const MeshStudyOptions& options) {
  MeshCase result{motion.name, particles, buckles, {}, {NAN, NAN}, 0, 0.0};
  FitConfig config = DefaultConfig(truth.recording);
  config.resolution = {particles, particles};
  config.buckling = buckles;
  config.max_iterations = options.max_iterations;
  FitConfig truth_config = config;
  for (const auto& [name, value] : truth.truth_parameters) {
    const auto setting = truth_config.parameters.find(name);
    if (setting != truth_config.parameters.end()) setting->second.value = value;
  }
  const std::vector<NamedParameter> table = MakeParameterTable();
  const Scene scene = MakeScene(truth.recording, config);
  const FreeParameters known(truth_config, scene, table);
  result.at_truth = Follow(truth, scene, truth_config, known, known.start());
  if (!options.fit) return result;
  if (motion.in_wind) SetFree("mesh study", UniformWind::kName, true, &config);
  const FitResult fit = FitByStrategy(scene, config);
  result.iterations = fit.iterations;
  result.seconds = fit.seconds;
  if (fit.status == FitStatus::kFailed) return result;
  result.after_fit = Follow(truth, scene, config, FreeParameters(config, scene, table), fit.theta);
  return result;
}

std::vector<std::string> MotionsOf(const std::vector<MeshCase>& cases) {
  std::vector<std::string> names;
  for (const MeshCase& one : cases)
    if (names.empty() || names.back() != one.motion) names.push_back(one.motion);
  return names;
}

const char* MembraneOf(const MeshCase& one) { return one.buckles ? "buckling" : "plain"; }

std::string InMillimetres(double metres) {
  return std::isfinite(metres) ? fmt::format("{:.1f}", 1e3 * metres) : "";
}

double SpacingOf(const MeshCase& one) { return kSide / (one.particles - 1); }

}  // namespace

std::vector<MeshCase> RunMeshStudy(const MeshStudyOptions& options,
                                   const std::function<void(const MeshCase&)>& done) {
  constexpr int kNumMotions = static_cast<int>(std::size(kMotions));
  std::vector<SyntheticRecording> truths(kNumMotions);
  ParallelFor(kNumMotions, options.num_threads, [&](int i, int) {
    truths[i] = MakeSyntheticRecording(TruthOf(kMotions[i], options), {}, options.generator);
  });
  const int num_meshes = static_cast<int>(options.particles.size());
  std::vector<MeshCase> cases(2 * num_meshes * kNumMotions);
  std::mutex mutex;
  ParallelFor(static_cast<int>(cases.size()), options.num_threads, [&](int i, int) {
    const int motion = i / (2 * num_meshes), mesh = i % num_meshes;
    MeshCase result = RunCase(kMotions[motion], truths[motion], options.particles[mesh],
                              i / num_meshes % 2 == 1, options);
    const std::lock_guard<std::mutex> lock(mutex);
    if (done) done(result);
    cases[i] = std::move(result);
  });
  return cases;
}

double OrderOfConvergence(const std::vector<MeshCase>& cases, const std::string& motion,
                          bool buckles) {
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const MeshCase& one : cases) {
    if (one.motion != motion || one.buckles != buckles || !(one.at_truth.fitted > 0.0)) continue;
    const double x = std::log(SpacingOf(one)), y = std::log(one.at_truth.fitted);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return n < 2.0 ? NAN : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

std::string MeshStudyAsCsv(const std::vector<MeshCase>& cases) {
  std::string text =
      "motion,membrane,particles,spacing,true_fitted,true_held_out,fit_fitted,fit_held_out,"
      "iterations,seconds\n";
  for (const MeshCase& one : cases) {
    text += fmt::format("{},{},{},{:.5f},{:.6f},{:.6f},{:.6f},{:.6f},{},{:.1f}\n", one.motion,
                        MembraneOf(one), one.particles, SpacingOf(one), one.at_truth.fitted,
                        one.at_truth.held_out, one.after_fit.fitted, one.after_fit.held_out,
                        one.iterations, one.seconds);
  }
  return text;
}

std::string MeshStudyAsMarkdown(const std::vector<MeshCase>& cases) {
  std::string text =
      "Distance from the truth, mm, root mean square: at the true parameters in fitted frames, "
      "then "
      "after a fit in fitted and held-out frames.\n\n"
      "| motion | membrane | particles | true parameters | fitted | held out | iterations | s |\n"
      "|---|---|---:|---:|---:|---:|---:|---:|\n";
  for (const MeshCase& one : cases) {
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {:.0f} |\n", one.motion,
                        MembraneOf(one), one.particles, InMillimetres(one.at_truth.fitted),
                        InMillimetres(one.after_fit.fitted), InMillimetres(one.after_fit.held_out),
                        one.iterations, one.seconds);
  }
  text += "\n| motion | order, plain | order, buckling |\n|---|---:|---:|\n";
  for (const std::string& motion : MotionsOf(cases)) {
    text +=
        fmt::format("| {} | {:.1f} | {:.1f} |\n", motion, OrderOfConvergence(cases, motion, false),
                    OrderOfConvergence(cases, motion, true));
  }
  return text;
}

std::string MeshStudyAsSvg(const std::vector<MeshCase>& cases) {
  std::vector<Chart> charts;
  for (const std::string& motion : MotionsOf(cases)) {
    Chart chart{motion, "spacing, mm", "distance from the truth, mm", true, true, {}};
    for (const bool buckles : {false, true}) {
      const std::string membrane = buckles ? "buckling" : "plain";
      ChartLine at_truth{membrane + ", true parameters", {}, false, true};
      ChartLine after_fit{membrane + ", fitted", {}, false, true};
      for (const MeshCase& one : cases) {
        if (one.motion != motion || one.buckles != buckles) continue;
        const double spacing = 1e3 * SpacingOf(one);
        at_truth.points.emplace_back(spacing, 1e3 * one.at_truth.fitted);
        if (std::isfinite(one.after_fit.fitted))
          after_fit.points.emplace_back(spacing, 1e3 * one.after_fit.fitted);
      }
      chart.lines.push_back(std::move(at_truth));
      if (!after_fit.points.empty()) chart.lines.push_back(std::move(after_fit));
    }
    charts.push_back(std::move(chart));
  }
  return ChartsAsSvg(charts);
}

}  // namespace clothfit
