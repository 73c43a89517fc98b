// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/surface_evaluation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/closest_on_mesh.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/runs/prediction.h"
#include "fitting/scene/surface_truth.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

enum Part { kAll, kFitted, kHeldOut, kParts };

struct Distances {
  std::array<std::vector<double>, kParts> all;

  // Returns the root mean square of these.
  std::optional<double> Add(const std::vector<double>& distances, bool held_out) {
    if (distances.empty()) return std::nullopt;
    double sum = 0.0;
    for (const double d : distances) {
      all[kAll].push_back(d);
      all[held_out ? kHeldOut : kFitted].push_back(d);
      sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(distances.size()));
  }
};

std::optional<SurfaceError> Summarise(std::vector<double> distances) {
  if (distances.empty()) return std::nullopt;
  std::sort(distances.begin(), distances.end());
  SurfaceError error;
  error.count = distances.size();
  double sum = 0.0;
  for (const double d : distances) sum += d * d;
  const auto last = static_cast<double>(distances.size() - 1);
  error.rms = std::sqrt(sum / static_cast<double>(distances.size()));
  error.median = distances[static_cast<std::size_t>(0.5 * last)];
  error.quantile95 = distances[static_cast<std::size_t>(0.95 * last)];
  return error;
}

std::vector<double> FromCloud(const std::vector<Vector3d>& cloud, const ClosestOnMesh& surface) {
  std::vector<double> distances;
  for (const Vector3d& point : cloud) distances.push_back(surface.Find(point).on_triangle.distance);
  return distances;
}

std::vector<double> ToCloud(const std::vector<Vector3d>& cloud, const Eigen::VectorXd& x) {
  std::vector<double> distances;
  for (Eigen::Index i = 0; i < x.size() && !cloud.empty(); i += 3) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vector3d& point : cloud)
      least = std::min(least, (point - x.segment<3>(i)).squaredNorm());
    distances.push_back(std::sqrt(least));
  }
  return distances;
}

}  // namespace

SurfaceEvaluation EvaluateSurface(const RunFolder& run, const fs::path& truth_folder) {
  const FittedRun fitted = ReadFittedRun(run);
  const Scene& scene = fitted.scene;
  const FreeParameters free(fitted.config, scene, MakeParameterTable());
  const SurfaceTruth truth(truth_folder, scene);
  ClosestOnMesh surface(scene.mesh.triangles, scene.initial);
  Distances points, from_cloud, to_cloud;
  SurfaceEvaluation evaluation;
  const auto compare = [&](int frame, const State& state) {
    FrameErrors errors;
    errors.frame = frame;
    errors.held_out = scene.IsHeldOut(frame);
    errors.points = points.Add(truth.PointDistances(frame, state.x), errors.held_out);
    const std::vector<Vector3d> cloud = truth.Cloud(frame);
    surface.MoveTo(state.x);
    errors.from_cloud = from_cloud.Add(FromCloud(cloud, surface), errors.held_out);
    errors.to_cloud = to_cloud.Add(ToCloud(cloud, state.x), errors.held_out);
    evaluation.frames.push_back(errors);
  };
  const int last = scene.recording.frame_count - 1;
  const int reached =
      SimulateFrames(scene, fitted.config, free, run.ReadParameters(free), last, compare);
  if (reached <= last) {
    throw std::runtime_error(
        fmt::format("the simulation fails after frame {} of {}", reached - 1, last + 1));
  }
  for (int part = 0; part < kParts; ++part) {
    evaluation.points[part] = Summarise(points.all[part]);
    evaluation.from_cloud[part] = Summarise(from_cloud.all[part]);
    evaluation.to_cloud[part] = Summarise(to_cloud.all[part]);
  }
  return evaluation;
}

std::optional<double> ChamferScore(const FrameErrors& frame) {
  if (!frame.from_cloud || !frame.to_cloud) return std::nullopt;
  return 1e4 * (*frame.from_cloud * *frame.from_cloud + *frame.to_cloud * *frame.to_cloud);
}

std::string SurfaceAsMarkdown(const SurfaceEvaluation& evaluation) {
  std::string text =
      "| distance, mm | frames | rms | median | 95 % | of |\n|---|---|---:|---:|---:|---:|\n";
  constexpr const char* kNames[kParts] = {"all", "fitted", "held out"};
  const auto add = [&](const std::string& what,
                       const std::array<std::optional<SurfaceError>, 3>& errors) {
    for (int part = 0; part < kParts; ++part) {
      if (!errors[part]) continue;
      text += fmt::format("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {} |\n", what, kNames[part],
                          1e3 * errors[part]->rms, 1e3 * errors[part]->median,
                          1e3 * errors[part]->quantile95, errors[part]->count);
    }
  };
  add("same point of the cloth", evaluation.points);
  add("true cloud to fitted surface", evaluation.from_cloud);
  add("fitted particles to true cloud", evaluation.to_cloud);
  std::array<std::vector<double>, kParts> scores;
  for (const FrameErrors& frame : evaluation.frames) {
    const std::optional<double> score = ChamferScore(frame);
    if (!score) continue;
    for (const Part part : {kAll, frame.held_out ? kHeldOut : kFitted})
      scores[part].push_back(*score);
  }
  for (int part = 0; part < kParts; ++part) {
    if (scores[part].empty()) continue;
    const double sum = std::accumulate(scores[part].begin(), scores[part].end(), 0.0);
    text += fmt::format("{}chamfer score, 1e-4 m^2, {} frames: {:.3g} (mean of {})\n",
                        part == kAll ? "\n" : "", kNames[part],
                        sum / static_cast<double>(scores[part].size()), scores[part].size());
  }
  return text;
}

std::string SurfaceAsCsv(const SurfaceEvaluation& evaluation) {
  std::string text = "frame,held_out,points_rms,from_cloud_rms,to_cloud_rms,chamfer_score\n";
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.6f}", *value) : std::string();
  };
  for (const FrameErrors& f : evaluation.frames) {
    text += fmt::format("{},{},{},{},{},{}\n", f.frame, f.held_out ? 1 : 0, number(f.points),
                        number(f.from_cloud), number(f.to_cloud), number(ChamferScore(f)));
  }
  return text;
}

}  // namespace clothfit
