// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files of points without names: PLY (Turk 1994; text, little and big endian), PCD (version 0.7 of
// the Point Cloud Library; text and binary) and CSV with the columns x,y,z.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// Extensions of these, in lower case, with the dot.
const std::vector<std::string>& CloudExtensions();

// The points, in the file's own order and unit; rows that are not finite are left out, and so is
// all that a file says of them besides. Throws InputError, one line.
std::vector<Eigen::Vector3d> ReadCloudFile(const std::filesystem::path& file);

// As PLY, binary, little endian, in single precision, which at 10 m is 1e-6 m.
std::string CloudAsPly(const std::vector<Eigen::Vector3d>& points);

}  // namespace clothfit
