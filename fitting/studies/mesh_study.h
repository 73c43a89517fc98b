// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far cloth on a coarse mesh is from the truth, at the true parameters and after a fit, with
// plain springs and with springs that buckle below the mesh (docs/model.md). The truth is made
// elsewhere, e.g. by finite elements on a fine mesh.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tracking/synthetic/recording.h"

namespace clothfit {

struct MeshStudyOptions {
  SyntheticGenerator generator;                      // of the truth
  std::vector<int> particles = {9, 13, 19, 25, 31};  // along a side, of the meshes that are judged
  int truth_cells = 48;     // along a side, of the mesh that makes the truth; even
  int frame_count = 60;     // at 30 Hz
  bool fit = true;          // as well
  int max_iterations = 40;  // of a fit
  int num_threads = 2;      // cases at the same time; has no influence on the result
};

// m, root mean square over the true surface's points; NaN where a simulation does not get there.
struct MeshError {
  double fitted = 0.0, held_out = 0.0;  // over those frames
};

struct MeshCase {
  std::string motion;
  int particles = 0;
  bool buckles = false;
  MeshError at_truth;    // simulated with the true parameters
  MeshError after_fit;   // NaN where there was none
  int iterations = 0;    // of the fit
  double seconds = 0.0;  // of the fit, beside others
};

// One corner lifted, two lifted, swung by two corners, shaken by two corners in wind: by motion,
// then membrane, then particles. `done` is called after each, from any thread but one at a time.
std::vector<MeshCase> RunMeshStudy(const MeshStudyOptions& options,
                                   const std::function<void(const MeshCase&)>& done);

// The p of error ~ spacing^p over a motion's cases of one membrane, by least squares of logarithms.
double OrderOfConvergence(const std::vector<MeshCase>& cases, const std::string& motion,
                          bool buckles);

std::string MeshStudyAsCsv(const std::vector<MeshCase>& cases);
std::string MeshStudyAsMarkdown(const std::vector<MeshCase>& cases);
std::string MeshStudyAsSvg(
    const std::vector<MeshCase>& cases);  // error over spacing, a chart a motion

}  // namespace clothfit
