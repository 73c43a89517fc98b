// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// NumPy's .npy format, version 1.0: an array of little-endian doubles that numpy.load reads.
// Reference: numpy.lib.format, "NPY format".
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// The file's bytes for a list of equally many 3D points a frame (3N each, point after point): an
// array of frames x N x 3.
std::string PointsAsNpy(const std::vector<Eigen::VectorXd>& frames);

// Reads such an array: of frames x N x 3, or, for one number a point, of frames x N. One entry a
// frame. Throws InputError where the file is neither.
std::vector<Eigen::VectorXd> ReadPointsNpy(const std::filesystem::path& file);
std::vector<Eigen::VectorXd> ReadScalarsNpy(const std::filesystem::path& file);

}  // namespace clothfit
