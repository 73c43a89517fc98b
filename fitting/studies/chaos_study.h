// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far two simulations part that differ in one particle only (Hasler 2007, Figure 1), and how
// the simulation's own derivatives grow along the way. A square cloth that stands on
// end drops into a heap.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"

namespace clothfit {

struct ChaosOptions {
  double side = 1.0;          // m
  int particles = 30;         // a side
  double offset = 0.02;       // m, of one particle at the start, across the cloth
  double duration = 2.0;      // s
  double step = 1.0 / 120.0;  // s
  bool self_contact = true;
};

// One time at which both were looked at.
struct ChaosFrame {
  double time = 0.0;         // s
  Eigen::VectorXd x, moved;  // m, 3N: as given, and with the particle moved
  double rms = 0.0;          // m, between the two
  double largest = 0.0;      // m
  // Of the first: the derivative of all positions by the particle's offset, root mean square over
  // particles, no unit; and what it would make of the offset, m.
  double sensitivity = 0.0, predicted = 0.0;
  // 1/s: of the sensitivity since the frame before, d ln(sensitivity) / dt.
  double growth = 0.0;
};

struct ChaosResult {
  ClothMesh mesh;
  std::vector<ChaosFrame> frames;
  // 1/s: mean over the time from when the cloth first moved to when the runs are a tenth of the
  // side apart, or to the end.
  double mean_growth = 0.0;
  int intersections = 0;  // of both, after every frame
  bool complete = false;  // all steps of both converged
};

// 30 frames a second. progress(frame) after each.
ChaosResult RunChaosStudy(const ChaosOptions& options, const std::function<void(int)>& progress);

std::string ChaosAsCsv(const ChaosResult& result);
std::string ChaosAsMarkdown(const ChaosOptions& options, const ChaosResult& result);
std::string ChaosAsSvg(const ChaosResult& result);  // distance and sensitivity over time
// Both runs at four times, one below the other. A png file.
void DrawChaos(const ChaosOptions& options, const ChaosResult& result, const std::string& file);

}  // namespace clothfit
