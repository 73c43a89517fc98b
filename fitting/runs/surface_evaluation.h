// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far a fitted surface is from the true one. For evaluation only: no fit includes this.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/runs/run_folder.h"

namespace clothfit {

// Distances (m) over some frames.
struct SurfaceError {
  std::size_t count = 0;
  double rms = 0.0, median = 0.0, quantile95 = 0.0;
};

struct FrameErrors {
  int frame = 0;
  bool held_out = false;
  // Root mean square (m): of true points from the same points (u, v) of the fitted surface
  // (truth/points.csv); of a cloud's points from the nearest of the fitted surface, and of the
  // fitted particles from the nearest of the cloud (truth/cloud_000000.csv ...).
  std::optional<double> points, from_cloud, to_cloud;
};

struct SurfaceEvaluation {
  std::vector<FrameErrors> frames;
  // All frames, the fitted ones, and those held out; empty where there are none.
  std::array<std::optional<SurfaceError>, 3> points, from_cloud, to_cloud;
};

// 1e4 times the sum of the two mean squared distances (m^2) between surface and cloud, by which
// Kairanda et al. 2022 (phi-SfT) and those after them score a frame; empty without a cloud.
std::optional<double> ChamferScore(const FrameErrors& frame);

// Simulates the run's cloth, open loop, and compares it with what `truth` (a recording's folder)
// has in truth/. Throws InputError where it has neither points.csv nor a cloud, or one is
// malformed.
SurfaceEvaluation EvaluateSurface(const RunFolder& run, const std::filesystem::path& truth);

// The table, and one row a frame.
std::string SurfaceAsMarkdown(const SurfaceEvaluation& evaluation);
std::string SurfaceAsCsv(const SurfaceEvaluation& evaluation);

}  // namespace clothfit
