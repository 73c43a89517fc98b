// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The truth that may lie beside a recording, in truth/. For evaluation only: a fit that includes
// this header is a defect. It is apart from tracking/recording/recording.h so that none does by
// accident.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// A noise-free point of the surface.
struct TruthPoint {
  int frame = 0;
  Eigen::Vector2d uv;        // m, on the cloth
  Eigen::Vector3d position;  // m, world
};

// truth/points.csv of a recording's folder, in file order. Throws InputError when it is missing or
// malformed; the file may be missing where HasTruthPoints says so.
std::vector<TruthPoint> ReadTruthPoints(const std::filesystem::path& recording_folder);
bool HasTruthPoints(const std::filesystem::path& recording_folder);

// truth/parameters.yaml: values by full parameter name, such as "air_drag.normal". Nested maps are
// joined with a dot. Throws InputError when it is missing, malformed or holds anything but numbers.
std::map<std::string, double> ReadTruthParameters(const std::filesystem::path& recording_folder);
bool HasTruthParameters(const std::filesystem::path& recording_folder);

// The text of these files, and their names in a recording's folder.
std::string TruthPointsAsCsv(const std::vector<TruthPoint>& points);
std::string TruthParametersAsYaml(const std::map<std::string, double>& parameters);
inline constexpr const char* kTruthPointsFile = "truth/points.csv";
inline constexpr const char* kTruthParametersFile = "truth/parameters.yaml";

}  // namespace clothfit
