// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/surface/truth.h"

#include <fmt/format.h>

#include "tracking/text/csv.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

fs::path PointsFile(const fs::path& recording_folder) {
  return recording_folder / kTruthPointsFile;
}

fs::path ParametersFile(const fs::path& recording_folder) {
  return recording_folder / kTruthParametersFile;
}

// Puts the numbers of a map and of the maps in it under their joined names.
void Flatten(const YamlValue& map, const std::string& prefix,
             std::map<std::string, double>* parameters) {
  for (const auto& [key, value] : map.Entries()) {
    if (value.IsMap()) {
      Flatten(value, prefix + key + ".", parameters);
    } else if (!parameters->emplace(prefix + key, value.Number()).second) {
      value.Fail("appears twice");
    }
  }
}

}  // namespace

bool HasTruthPoints(const fs::path& recording_folder) {
  return IsThere(PointsFile(recording_folder));
}

bool HasTruthParameters(const fs::path& recording_folder) {
  return IsThere(ParametersFile(recording_folder));
}

std::vector<TruthPoint> ReadTruthPoints(const fs::path& recording_folder) {
  std::vector<TruthPoint> points;
  ReadCsv(PointsFile(recording_folder), {"frame", "u", "v", "x", "y", "z"}, [&](const CsvRow& row) {
    points.push_back({row.Integer(0), row.Vector2(1), row.Vector3(3)});
  });
  return points;
}

std::map<std::string, double> ReadTruthParameters(const fs::path& recording_folder) {
  std::map<std::string, double> parameters;
  Flatten(YamlValue::Load(ParametersFile(recording_folder)), "", &parameters);
  return parameters;
}

std::string TruthPointsAsCsv(const std::vector<TruthPoint>& points) {
  std::string text = "frame,u,v,x,y,z\n";
  for (const TruthPoint& point : points) {
    text += fmt::format("{},{},{},{},{},{}\n", point.frame, point.uv.x(), point.uv.y(),
                        point.position.x(), point.position.y(), point.position.z());
  }
  return text;
}

std::string TruthParametersAsYaml(const std::map<std::string, double>& parameters) {
  std::string text;
  for (const auto& [name, value] : parameters) text += fmt::format("{}: {}\n", name, value);
  return text.empty() ? "{}\n" : text;
}

}  // namespace clothfit
