// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where any point of a fitted cloth is in any frame, by simulating from frame 0 with what the fit
// found. Frames beyond the fitted ones are simulated on, along the handles' known paths.
#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

#include "fitting/runs/run_folder.h"

namespace clothfit {

// A run as it is needed to simulate it again.
struct FittedRun {
  FitConfig config;
  Scene scene;
};
// Reads the run's config and the recording that it names. Throws InputError.
FittedRun ReadFittedRun(const RunFolder& run);
// A recording with what a fit of it would begin with. Throws InputError, also where that cannot be
// simulated.
FittedRun ReadUnfitted(const std::filesystem::path& recording);

// Where is the point (u, v), m, in a frame? `line`: of the file that asks, 0 for none.
struct PredictionQuery {
  int frame = 0;
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  int line = 0;
};

// Reads columns frame,u,v. Throws InputError, naming file and line, where a frame is not the
// recording's or a point not on the cloth, and where there is no row.
std::vector<PredictionQuery> ReadQueries(const std::filesystem::path& file, const Scene& scene);

// Positions (m, world), one a query in the same order. Throws std::runtime_error where the
// simulation does not reach a frame.
std::vector<Eigen::Vector3d> Predict(const FittedRun& fitted, const RunFolder& run,
                                     const std::vector<PredictionQuery>& queries);

// Columns frame,u,v,x,y,z.
void WritePredictions(const std::filesystem::path& file,
                      const std::vector<PredictionQuery>& queries,
                      const std::vector<Eigen::Vector3d>& positions, Overwrite overwrite);

}  // namespace clothfit
