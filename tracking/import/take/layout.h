// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the markers of a take sit on its cloth, as the user says or as their distances do.
#pragma once

#include <string>
#include <vector>

#include "tracking/import/take/recording.h"

namespace clothfit {

struct LayoutOfTake {
  std::vector<Eigen::Vector2d> uv;  // m, one a marker
  Eigen::Vector2d size;             // m, of the cloth
  double rms = 0.0;                 // m, of flat distances against the largest that were measured
};

// The take begins with a frame that has every marker; the distances are those of LargestDistances,
// `held` are the markers that are handles. `notes` gets a sentence for the user on what was found.
LayoutOfTake MakeLayout(const MarkerTake& take, const std::vector<size_t>& held,
                        const Eigen::MatrixXd& distances, const TakeOptions& options,
                        std::vector<std::string>* notes);

}  // namespace clothfit
