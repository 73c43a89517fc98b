// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/scene/scene.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/pictures/run_pictures.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<const Silhouettes> LoadAllMasks(const Recording& recording) {
  if (!HasMasks(recording)) return nullptr;
  return std::make_shared<const Silhouettes>(
      LoadSilhouettes(recording, [](int, int) { return false; }));
}

}  // namespace

std::vector<ObstacleSurface> ObstaclesOf(const ReportScene& report,
                                         const std::vector<ObstacleSurface>& brought) {
  const std::vector<NamedParameter>& table = MakeParameterTable();
  const nlohmann::ordered_json& summary = report.record.summary;
  Eigen::VectorXd values(static_cast<Eigen::Index>(table.size()));
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::string& name = table[i].name;
    double& value = values[static_cast<Eigen::Index>(i)];
    value = report.fitted.config.parameters.at(name).value;
    if (!summary.contains("parameters") || !summary["parameters"].contains(name)) continue;
    const nlohmann::ordered_json& found = summary["parameters"][name].at("value");
    if (found.is_number()) value = found.get<double>();
  }
  std::vector<ObstacleSurface> surfaces =
      ObstacleSurfaces(report.scene(), values, report.motions.back().positions);
  surfaces.insert(surfaces.end(), brought.begin(), brought.end());
  return surfaces;
}

std::vector<Eigen::VectorXd> SimulateStart(const FittedRun& fitted) {
  const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
  std::vector<Eigen::VectorXd> positions;
  SimulateFrames(fitted.scene, fitted.config, free, free.start(),
                 fitted.scene.recording.frame_count - 1,
                 [&](int, const State& state) { positions.push_back(state.x); });
  return positions;
}

void CheckTrajectory(const fs::path& file, const Scene& scene,
                     const std::vector<Eigen::VectorXd>& trajectory) {
  if (trajectory.empty()) throw InputError(file.string(), "holds no frame");
  const auto particles = static_cast<int>(trajectory.front().size() / 3);
  if (particles != scene.mesh.num_particles() ||
      static_cast<int>(trajectory.size()) > scene.recording.frame_count) {
    throw InputError(file.string(),
                     fmt::format("has {} frames of {} particles; expected at most "
                                 "{} of {}: was the recording changed since?",
                                 trajectory.size(), particles, scene.recording.frame_count,
                                 scene.mesh.num_particles()));
  }
}

ReportScene GatherReportScene(FittedRun fitted, const fs::path& pictures) {
  ReportScene report{{}, std::move(fitted), {}, nullptr, {}, {}, {}};
  const Scene& scene = report.fitted.scene;
  RunPictures found = FindPictures(scene.recording, pictures);
  if (found.are_lost) {
    report.notes.emplace_back(
        "The pictures that were tracked are no longer where they were; 'clothfit report --pictures "
        "RECORDING' says where they are.");
  }
  report.pictures = std::move(found.recording);
  report.silhouettes = LoadAllMasks(scene.recording);
  for (const fs::path& folder :
       {scene.recording.path, report.pictures ? report.pictures->path : fs::path()}) {
    if (folder.empty() || !report.truth.empty() || !HasTruthPoints(folder)) continue;
    report.truth = ReadTruthPoints(folder);
  }
  return report;
}

ReportScene GatherReportScene(const RunFolder& run, const fs::path& pictures) {
  RunRecord record = ReadRunRecord(run);
  FittedRun fitted = ReadFittedRun(run);
  CheckTrajectory(run.path() / "trajectory.npy", fitted.scene, record.trajectory);
  ReportScene report = GatherReportScene(std::move(fitted), pictures);
  report.record = std::move(record);
  report.motions = {{"before", "Start", SimulateStart(report.fitted)},
                    {"after", "Fit", report.record.trajectory}};
  if (report.motions[0].positions.size() < report.motions[1].positions.size()) {
    report.notes.push_back(
        fmt::format("With the start values the simulation breaks down after {} frames.",
                    report.motions[0].positions.size()));
  }
  return report;
}

}  // namespace clothfit
