// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/sections/extras.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/files/npy_file.h"
#include "tracking/text/json_text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

void CheckValues(const fs::path& file, const std::vector<Eigen::VectorXd>& values,
                 const Motion& motion) {
  const Eigen::Index particles = motion.positions.empty() ? 0 : motion.positions[0].size() / 3;
  if (values.size() == motion.positions.size() &&
      (values.empty() || values[0].size() == particles)) {
    return;
  }
  throw InputError(file.string(),
                   fmt::format("has {} frames of {} numbers; expected {} of {}, as '{}' has",
                               values.size(), values.empty() ? 0 : values[0].size(),
                               motion.positions.size(), particles, motion.name));
}

ScalarField ReadField(const fs::path& folder, const ReportJson& json, const ReportScene& report) {
  ScalarField field{json.at("name"),
                    json.at("title"),
                    json.value("unit", "1"),
                    json.value("diverging", false),
                    {}};
  for (const Motion& motion : report.motions) {
    const auto name = json.at("values").find(motion.name);
    if (name == json.at("values").end()) continue;
    const fs::path file = folder / name->get<std::string>();
    field.values[motion.name] = ReadScalarsNpy(file);
    CheckValues(file, field.values[motion.name], motion);
  }
  return field;
}

ObstacleSurface ReadObstacle(const fs::path& folder, const ReportJson& json) {
  const fs::path file = folder / json.at("positions").get<std::string>();
  ObstacleSurface obstacle{json.value("name", "obstacle"), ReadPointsNpy(file), {}, false};
  if (obstacle.positions.empty()) throw InputError(file.string(), "holds no frame");
  const Eigen::Index vertices = obstacle.positions[0].size() / 3;
  for (const ReportJson& triangle : json.at("triangles")) {
    for (const auto vertex : triangle.get<std::array<std::int32_t, 3>>()) {
      if (vertex < 0 || vertex >= vertices) {
        throw InputError(file.string(), fmt::format("has {} vertices; a triangle names vertex {}",
                                                    vertices, vertex));
      }
      obstacle.triangles.push_back(vertex);
    }
  }
  return obstacle;
}

void ReadExtra(const fs::path& file, const ReportScene& report, ReportExtras* extras) {
  ReadJson<ReportJson>(file, "is no addition to a report", [&](const ReportJson& json) {
    for (const ReportJson& section : json.value("sections", ReportJson::array())) {
      for (const char* key : {"id", "title", "blocks"}) section.at(key);
      extras->sections.push_back(section);
    }
    for (const ReportJson& field : json.value("fields", ReportJson::array())) {
      extras->fields.push_back(ReadField(file.parent_path(), field, report));
    }
    for (const ReportJson& obstacle : json.value("obstacles", ReportJson::array())) {
      extras->obstacles.push_back(ReadObstacle(file.parent_path(), obstacle));
    }
  });
}

}  // namespace

ReportExtras ReadReportExtras(const fs::path& run, const ReportScene& report) {
  ReportExtras extras;
  const fs::path folder = run / "report";
  if (!fs::is_directory(folder)) return extras;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) ReadExtra(file, report, &extras);
  return extras;
}

}  // namespace clothfit
