// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors over time, and over the cloth.
#include <cmath>

#include "fitting/report/sections/sections.h"

namespace clothfit {
namespace {

using Member = std::optional<double> FrameMisfit::*;

ReportJson Series(const Motion& motion, const std::vector<FrameMisfit>& frames, Member member,
                  double factor, bool* is_empty) {
  ReportJson values = ReportJson::array();
  for (const FrameMisfit& frame : frames) {
    const std::optional<double>& value = frame.*member;
    values.push_back(value ? ReportJson(factor * *value) : ReportJson());
    *is_empty = *is_empty && !value;
  }
  return {{"name", motion.title}, {"role", motion.name}, {"values", values}};
}

void AddChart(const ReportScene& report, const std::vector<std::vector<FrameMisfit>>& misfits,
              Member member, const char* title, const char* unit, double factor,
              ReportJson* blocks) {
  ReportJson series = ReportJson::array();
  bool is_empty = true;
  for (std::size_t m = 0; m < misfits.size(); ++m) {
    series.push_back(Series(report.motions[m], misfits[m], member, factor, &is_empty));
  }
  if (is_empty) return;
  blocks->push_back({{"kind", "lines"},
                     {"title", title},
                     {"frames", true},
                     {"y", {{"title", title}, {"unit", unit}, {"from_zero", true}}},
                     {"series", series}});
}

Eigen::VectorXd RootMeanSquare(const std::vector<Eigen::VectorXd>& frames) {
  Eigen::ArrayXd sum = Eigen::ArrayXd::Zero(frames.front().size()), count = sum;
  for (const Eigen::VectorXd& frame : frames) {
    const auto is_known = frame.array().isFinite();
    sum += is_known.select(frame.array().square(), 0.0);
    count += is_known.cast<double>();
  }
  return (sum / count).sqrt().matrix();  // not a number where nothing is known
}

ReportJson Rows(const Eigen::VectorXd& values, const std::array<int, 2>& grid, double factor) {
  ReportJson rows = ReportJson::array();
  for (int j = 0; j < grid[1]; ++j) {
    ReportJson row = ReportJson::array();
    for (int i = 0; i < grid[0]; ++i) {
      const double value = factor * values[i + j * grid[0]];
      row.push_back(std::isfinite(value) ? ReportJson(std::round(1e4 * value) / 1e4)
                                         : ReportJson());
    }
    rows.push_back(row);
  }
  return rows;
}

ReportJson ClothMap(const ReportScene& report, const ScalarField& field, const Motion& motion) {
  const ClothMesh& mesh = report.scene().mesh;
  const Eigen::Vector2d size = report.scene().recording.cloth.size;
  const bool is_length = field.unit == "m";
  const Eigen::VectorXd values = RootMeanSquare(field.values.at(motion.name));
  return {{"kind", "heatmap"},
          {"title", motion.title},
          {"value", {{"title", field.title}, {"unit", is_length ? "mm" : field.unit}}},
          {"group", field.name},
          {"u", {{"title", "u, warp"}, {"unit", "m"}, {"range", {0.0, size.x()}}}},
          {"v", {{"title", "v, weft"}, {"unit", "m"}, {"range", {0.0, size.y()}}}},
          {"values", Rows(values, mesh.grid, is_length ? 1e3 : 1.0)}};
}

}  // namespace

ReportJson CameraSection(const ReportScene& report) {
  ReportJson blocks = ReportJson::array();
  if (!report.scene().recording.cameras.empty()) blocks.push_back({{"kind", "cameras"}});
  ReportJson section = SectionOf("cameras", "Through the cameras", blocks, "Cameras");
  section["lead"] = "The outline of the simulated cloth over what each camera saw, in step.";
  return section;
}

ReportJson ErrorSection(const ReportScene& report,
                        const std::vector<std::vector<FrameMisfit>>& misfits) {
  ReportJson blocks = ReportJson::array();
  const auto add = [&](Member member, const char* title, const char* unit, double factor) {
    AddChart(report, misfits, member, title, unit, factor, &blocks);
  };
  add(&FrameMisfit::markers, "Markers", "mm", 1e3);
  add(&FrameMisfit::tracks, "Tracks", "px", 1.0);
  add(&FrameMisfit::clouds, "Clouds, distance from the surface", "mm", 1e3);
  add(&FrameMisfit::silhouettes, "Silhouettes, pixels that differ", "px", 1.0);
  add(&FrameMisfit::truth, "Distance from the truth", "mm", 1e3);
  ReportJson section = SectionOf("errors", "Error over time", blocks, "Errors");
  section["lead"] =
      "Root mean square in each frame, silhouettes as the mean over the cameras. Hatched frames "
      "were held out. Click to go to a frame.";
  return section;
}

ReportJson ClothMapSection(const ReportScene& report, const std::vector<ScalarField>& fields) {
  const ScalarField& field = fields.front();
  ReportJson blocks = ReportJson::array();
  if (report.scene().mesh.is_grid()) {
    for (const Motion& motion : report.motions) {
      if (!motion.positions.empty()) blocks.push_back(ClothMap(report, field, motion));
    }
    if (blocks.size() > 1) {  // beside the start's errors those of the fit may all look alike
      ReportJson own = blocks.back();
      own["title"] = own["title"].get<std::string>() + ", in colours of its own";
      own.erase("group");
      blocks.push_back(own);
    }
  }
  ReportJson section = SectionOf("cloth-map", "Where on the cloth", blocks, "Cloth");
  section["lead"] = field.title + ", root mean square over all frames, in the material.";
  return section;
}

}  // namespace clothfit
