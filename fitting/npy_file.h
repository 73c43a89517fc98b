// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// NumPy's .npy format, version 1.0: an array of little-endian doubles that numpy.load reads.
// Reference: numpy.lib.format, "NPY format".
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// The file's bytes for a list of equally many 3D points a frame (3N each, point after point): an
// array of frames x N x 3.
std::string PointsAsNpy(const std::vector<Eigen::VectorXd>& frames);

}  // namespace clothfit
