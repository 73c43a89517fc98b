// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/prediction.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/runs/fit_run.h"
#include "tracking/files/output_file.h"
#include "tracking/outliers/outliers.h"
#include "tracking/recording/folder/validation.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// A point of a mesh whose outline is no rectangle may be inside its size and yet off the cloth.
void CheckOnMesh(const SurfacePoint& point, const PredictionQuery& query,
                 const std::string& place) {
  constexpr double kSlack = 1e-6;  // of a triangle: rounding of the file
  if (*std::min_element(point.weights.begin(), point.weights.end()) >= -kSlack) return;
  throw InputError(
      place, fmt::format("(u, v) = ({}, {}) is outside the cloth", query.uv.x(), query.uv.y()));
}

std::vector<SurfacePoint> Locate(const Scene& scene, const std::vector<PredictionQuery>& queries) {
  std::vector<Eigen::Vector2d> uv;
  for (const PredictionQuery& query : queries) uv.push_back(query.uv);
  return LocateOnCloth(scene.mesh, uv);
}

std::string LineOf(const fs::path& file, int line) {
  return fmt::format("{}: line {}", file.string(), line);
}

}  // namespace

FittedRun ReadFittedRun(const RunFolder& run) {
  const std::string folder = ReadConfigRecording(run.ConfigFile());
  if (folder.empty()) throw InputError(run.ConfigFile().string(), "names no recording");
  Recording recording = ReadRecording(folder);
  FitConfig config = DefaultConfig(recording);
  ReadConfig(run.ConfigFile(), &config);
  if (config.leave_out_outliers) LeaveOutOutliers(&recording);
  Scene scene = MakeScene(recording, config);
  return {std::move(config), std::move(scene)};
}

FittedRun ReadUnfitted(const fs::path& recording) {
  Recording whole = ReadRecording(recording);
  FitConfig config = DefaultConfig(whole);
  Scene scene = MakeScene(whole, config);
  CheckSimulable(scene);
  return {std::move(config), std::move(scene)};
}

std::vector<PredictionQuery> ReadQueries(const fs::path& file, const Scene& scene) {
  std::vector<PredictionQuery> queries;
  ReadCsv(file, {"frame", "u", "v"}, [&](const CsvRow& row) {
    const PredictionQuery query{row.Integer(0), row.Vector2(1), row.line()};
    CheckFrame(scene.recording, query.frame, LineOf(file, query.line));
    CheckOnCloth(scene.recording, query.uv, LineOf(file, query.line));
    queries.push_back(query);
  });
  if (queries.empty()) throw InputError(file.string(), "holds no points");
  const std::vector<SurfacePoint> points = Locate(scene, queries);
  for (size_t i = 0; i < points.size(); ++i) {
    CheckOnMesh(points[i], queries[i], LineOf(file, queries[i].line));
  }
  return queries;
}

std::vector<Eigen::Vector3d> Predict(const FittedRun& fitted, const RunFolder& run,
                                     const std::vector<PredictionQuery>& queries) {
  const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
  const std::vector<SurfacePoint> points = Locate(fitted.scene, queries);
  int last_frame = 0;
  for (const PredictionQuery& query : queries) last_frame = std::max(last_frame, query.frame);

  std::vector<Eigen::Vector3d> positions(queries.size());
  const auto observe = [&](int frame, const State& state) {
    for (size_t i = 0; i < queries.size(); ++i) {
      if (queries[i].frame == frame) positions[i] = points[i].At(state.x);
    }
  };
  const int reached = SimulateFrames(fitted.scene, fitted.config, free, run.ReadParameters(free),
                                     last_frame, observe);
  if (reached <= last_frame) {
    throw std::runtime_error(fmt::format(
        "the simulation fails after frame {}; frame {} is asked for", reached - 1, last_frame));
  }
  return positions;
}

void WritePredictions(const fs::path& file, const std::vector<PredictionQuery>& queries,
                      const std::vector<Eigen::Vector3d>& positions, Overwrite overwrite) {
  std::string text = "frame,u,v,x,y,z\n";
  for (size_t i = 0; i < queries.size(); ++i) {
    const auto& [frame, uv, line] = queries[i];
    const Eigen::Vector3d& x = positions[i];
    text += fmt::format("{},{},{},{},{},{}\n", frame, FormatNumber(uv.x()), FormatNumber(uv.y()),
                        FormatNumber(x.x()), FormatNumber(x.y()), FormatNumber(x.z()));
  }
  WriteOutputFile(file, text, overwrite);
}

}  // namespace clothfit
