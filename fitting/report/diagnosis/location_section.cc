// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where and when a force is missing.
#include <cmath>

#include <fmt/format.h>

#include "fitting/report/diagnosis/sections.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

double Rounded(double value) { return std::round(1e5 * value) / 1e5; }

// |f| (N/m^2) of each particle.
Eigen::VectorXd SizeOf(const Eigen::VectorXd& force) {
  const Eigen::Map<const Eigen::Matrix3Xd> vectors(force.data(), 3, force.size() / 3);
  return vectors.colwise().norm().transpose();
}

ReportJson RowsOf(const Eigen::VectorXd& values, const std::array<int, 2>& grid) {
  ReportJson rows = ReportJson::array();
  for (int j = 0; j < grid[1]; ++j) {
    ReportJson row = ReportJson::array();
    for (int i = 0; i < grid[0]; ++i) row.push_back(Rounded(values[i + j * grid[0]]));
    rows.push_back(row);
  }
  return rows;
}

ReportJson MapBlock(const Eigen::Vector2d& size, const std::string& title) {
  return {{"kind", "heatmap"},
          {"title", title},
          {"group", "force"},
          {"value", {{"title", "Missing force"}, {"unit", "N/m^2"}}},
          {"u", {{"title", "u, warp"}, {"unit", "m"}, {"range", {0.0, size.x()}}}},
          {"v", {{"title", "v, weft"}, {"unit", "m"}, {"range", {0.0, size.y()}}}}};
}

// Over the cloth: one map that follows the clock, and the most of all frames.
void AddMaps(const ReportScene& report, const std::vector<Eigen::VectorXd>& force,
             ReportJson* blocks) {
  const ClothMesh& mesh = report.scene().mesh;
  if (!mesh.is_grid()) return;
  const Eigen::Vector2d& size = report.scene().recording.cloth.size;
  ReportJson now = MapBlock(size, "At the frame shown"),
             most = MapBlock(size, "Most of all frames");
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(mesh.num_particles());
  now["frames"] = true;
  now["values"] = ReportJson::array();
  for (const Eigen::VectorXd& frame : force) {
    const Eigen::VectorXd sizes = SizeOf(frame);
    largest = largest.cwiseMax(sizes);
    now["values"].push_back(RowsOf(sizes, mesh.grid));
  }
  most["values"] = RowsOf(largest, mesh.grid);
  blocks->push_back(now);
  blocks->push_back(most);
}

// Over u and time, and over v and time: the mean across.
void AddCourses(const ReportScene& report, const std::vector<Eigen::VectorXd>& force,
                ReportJson* blocks) {
  const ClothMesh& mesh = report.scene().mesh;
  if (!mesh.is_grid()) return;
  const double end = static_cast<double>(force.size() - 1) / report.scene().recording.frame_rate;
  for (int axis = 0; axis < 2; ++axis) {
    ReportJson map = MapBlock(report.scene().recording.cloth.size,
                              axis == 0 ? "Over u and time" : "Over v and time");
    const ReportJson along = map.at(axis == 0 ? "u" : "v");
    map["u"] = {{"title", "time"}, {"unit", "s"}, {"range", {0.0, end}}};
    map["v"] = along;
    ReportJson rows = ReportJson::array();
    for (int k = 0; k < mesh.grid[axis]; ++k) {
      ReportJson row = ReportJson::array();
      for (const Eigen::VectorXd& frame : force) {
        const Eigen::VectorXd sizes = SizeOf(frame);
        double sum = 0.0;
        for (int l = 0; l < mesh.grid[1 - axis]; ++l)
          sum += axis == 0 ? sizes[k + l * mesh.grid[0]] : sizes[l + k * mesh.grid[0]];
        row.push_back(Rounded(sum / mesh.grid[1 - axis]));
      }
      rows.push_back(row);
    }
    map["values"] = rows;
    map["stretch"] = true;
    blocks->push_back(map);
  }
}

ReportJson CourseChart(const ReportScene& report, const std::vector<Eigen::VectorXd>& force) {
  ReportJson mean = ReportJson::array(), most = ReportJson::array();
  for (int f = 0; f < report.scene().recording.frame_count; ++f) {
    const auto index = static_cast<std::size_t>(f);
    const bool is_known = index < force.size();
    const Eigen::VectorXd sizes = is_known ? SizeOf(force[index]) : Eigen::VectorXd();
    mean.push_back(is_known ? ReportJson(Rounded(sizes.mean())) : ReportJson());
    most.push_back(is_known ? ReportJson(Rounded(sizes.maxCoeff())) : ReportJson());
  }
  return {{"kind", "lines"},
          {"title", "Missing force over time"},
          {"frames", true},
          {"narrow", false},
          {"y", {{"title", "Missing force"}, {"unit", "N/m^2"}, {"from_zero", true}}},
          {"series",
           {{{"name", "mean over the cloth"}, {"values", mean}},
            {{"name", "strongest place"}, {"values", most}}}}};
}

}  // namespace

ReportJson LocationSection(const ReportScene& report, const DiagnosisRecord& record,
                           ReportBlobs* blobs) {
  ReportJson blocks = ReportJson::array();
  const ReportJson discrepancy = record.json.value("mismatch", ReportJson());
  if (discrepancy.is_object()) {
    const ReportJson& p = discrepancy.at("p_value");
    blocks.push_back(TextBlock({discrepancy.at("words").get<std::string>(),
                                p.is_number() ? fmt::format("p = {:.2g}, against recordings in "
                                                            "which nothing is missing.",
                                                            p.get<double>())
                                              : ""}));
  }
  if (!record.force.empty()) {
    AddMaps(report, record.force, &blocks);
    AddCourses(report, record.force, &blocks);
    blocks.push_back(CourseChart(report, record.force));
  }
  const fs::path picture = record.folder / "missing-force-cloth.png";
  if (fs::exists(picture)) blocks.push_back(PictureBlock(picture, "On the cloth", blobs));
  ReportJson section =
      SectionOf("location", "Where and when a force is missing", blocks, "Location");
  section["lead"] =
      "The force per area that the baseline lacks, estimated over the cloth and over time. The 3D "
      "view above can be coloured by it.";
  return section;
}

}  // namespace clothfit
