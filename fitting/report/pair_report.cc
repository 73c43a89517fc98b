// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The page of two fits side by side.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/report/kinds.h"
#include "fitting/report/pair/sections.h"
#include "fitting/report/scene_page.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

bool IsOneMesh(const ClothMesh& a, const ClothMesh& b) {
  return a.triangles == b.triangles && a.uv == b.uv;
}

// The particles of one mesh as a motion of another carries them along, linear within its triangles.
std::vector<Eigen::VectorXd> OnMesh(const ClothMesh& mesh, const ClothMesh& own,
                                    const std::vector<Eigen::VectorXd>& motion) {
  const std::vector<SurfacePoint> points = LocateOnCloth(own, mesh.uv);
  std::vector<Eigen::VectorXd> moved;
  for (const Eigen::VectorXd& x : motion) {
    Eigen::VectorXd& frame = moved.emplace_back(3 * mesh.num_particles());
    for (int i = 0; i < mesh.num_particles(); ++i) frame.segment<3>(3 * i) = points[i].At(x);
  }
  return moved;
}

// The scene of the finer mesh with both motions, the other's brought to it.
ReportScene SceneOfBoth(RunPair* pair) {
  const bool second_is_finer = pair->second.scene.scene().mesh.num_particles() >
                               pair->first.scene.scene().mesh.num_particles();
  PairedRun& fine = second_is_finer ? pair->second : pair->first;
  PairedRun& coarse = second_is_finer ? pair->first : pair->second;
  Motion other = coarse.scene.motions.front();
  ReportScene report = std::move(fine.scene);
  const ClothMesh& mesh = report.scene().mesh;
  if (!IsOneMesh(mesh, coarse.scene.scene().mesh)) {
    other.positions = OnMesh(mesh, coarse.scene.scene().mesh, other.positions);
    report.notes.push_back(
        fmt::format("The meshes differ: {} is drawn on that of {}, linear between its own "
                    "particles. Its errors "
                    "are those on its own mesh.",
                    coarse.name, fine.name));
  }
  report.motions.push_back(std::move(other));
  if (second_is_finer) std::swap(report.motions.front(), report.motions.back());
  return report;
}

// m, by frame and particle, as far as both go.
std::vector<Eigen::VectorXd> DistancesApart(const Motion& first, const Motion& second) {
  std::vector<Eigen::VectorXd> distances;
  for (std::size_t f = 0; f < std::min(first.positions.size(), second.positions.size()); ++f) {
    const Eigen::VectorXd apart = second.positions[f] - first.positions[f];
    distances.emplace_back(
        Eigen::Map<const Eigen::Matrix3Xd>(apart.data(), 3, apart.size() / 3).colwise().norm());
  }
  return distances;
}

// The distance of the two cloths as a field on both.
ScalarField ApartField(const ReportScene& report, const std::vector<Eigen::VectorXd>& distances) {
  ScalarField field{"apart", "Distance of the two cloths", "m", false, {}};
  const Eigen::VectorXd unknown = Eigen::VectorXd::Constant(
      report.scene().mesh.num_particles(), std::numeric_limits<double>::quiet_NaN());
  for (const Motion& motion : report.motions)
    for (std::size_t f = 0; f < motion.positions.size(); ++f)
      field.values[motion.name].push_back(f < distances.size() ? distances[f] : unknown);
  return field;
}

std::vector<double> RootMeanSquares(const std::vector<Eigen::VectorXd>& frames) {
  std::vector<double> roots;
  for (const Eigen::VectorXd& frame : frames)
    roots.push_back(frame.norm() / std::sqrt(static_cast<double>(frame.size())));
  return roots;
}

std::string ErrorsTitle(const RunPair& pair) {
  return fmt::format("Error in {} → in {}", pair.first.name, pair.second.name);
}

std::vector<ErrorChange> ChangesOf(const RunPair& pair) {
  std::vector<ErrorChange> errors;
  for (const PairedError& error : PairErrors(pair.first.facts, pair.second.facts))
    errors.push_back({error.kind, error.held_out, error.unit, error.first, error.second});
  return errors;
}

// Sections that ask both runs; their scenes may be taken away afterwards.
struct PairContent {
  PageVerdict verdict;
  std::string title, errors_title;
  std::vector<ErrorChange> errors;
  ReportJson numbers, parameters, settings;
};

PairContent ContentOf(const RunPair& pair) {
  const std::vector<PairedParameter> parameters =
      PairParameters(pair.first.scene, pair.second.scene);
  return {JudgePair(pair, parameters), pair.first.name + " beside " + pair.second.name,
          ErrorsTitle(pair),           ChangesOf(pair),
          PairNumberSection(pair),     PairParameterSection(pair, parameters),
          PairSettingSection(pair)};
}

ReportPage PageOfOneRecording(RunPair pair, PairContent content, const ReportAssets& assets,
                              const ReportOptions& options) {
  const std::vector<std::vector<FrameMisfit>> misfits = {pair.first.misfits, pair.second.misfits};
  const ReportScene report = SceneOfBoth(&pair);
  const std::vector<Eigen::VectorXd> apart =
      DistancesApart(report.motions.front(), report.motions.back());
  std::vector<ScalarField> fields = CommonFields(report);
  const ReportJson map = ClothMapSection(report, fields);
  fields.push_back(ApartField(report, apart));
  ReportJson errors = ErrorSection(report, misfits);
  errors["blocks"].push_back(ApartChart(RootMeanSquares(apart)));
  return MakeScenePage(
      {report,
       content.verdict,
       content.title,
       content.errors_title,
       content.errors,
       std::move(fields),
       ObstaclesOf(report),
       {content.numbers, content.parameters, errors, content.settings, map, CameraSection(report)},
       {},
       true},
      assets, options);
}

ReportPage PageOfTwoRecordings(const RunPair& pair, const PairContent& content,
                               const ReportAssets& assets) {
  ReportJson json;
  json["title"] = content.title;
  json["errors_title"] = content.errors_title;
  json["errors"] = ErrorsAsJson(content.errors);
  json["sections"] = ReportJson::array();
  for (const ReportJson& section :
       {content.numbers, content.parameters, PairErrorSection(pair), content.settings})
    if (!section.at("blocks").empty()) json["sections"].push_back(section);
  json["notes"] = ReportJson::array(
      {"The runs are of two recordings: their cloths are not shown together, for they move in "
       "worlds of their own. Each run's own page shows its cloth."});
  return AsReportPage(std::move(json), content.verdict, {}, assets);
}

}  // namespace

ReportPage MakePairReport(const fs::path& folder, const fs::path& other, const ReportAssets& assets,
                          const ReportOptions& options) {
  try {
    RunPair pair = ReadRunPair(folder, other, options.pictures);
    const PairContent content = ContentOf(pair);
    if (!pair.is_one_recording) return PageOfTwoRecordings(pair, content, assets);
    return PageOfOneRecording(std::move(pair), content, assets, options);
  } catch (const ReportJson::exception& error) {
    throw InputError(folder.string() + " or " + other.string(),
                     std::string("is damaged, or of another version of clothfit: ") + error.what());
  }
}

}  // namespace clothfit
