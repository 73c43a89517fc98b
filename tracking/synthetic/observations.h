// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a synthetic recording observes of its simulation. `frames` holds every particle's position
// (3N, m, world) in every frame.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "tracking/synthetic/recording.h"

namespace clothfit {

// To the nearest micrometre, as the nearest double to its decimal. m.
Eigen::Vector3d RoundedPosition(const Eigen::Vector3d& position);

// The cameras. Without images a ring about the cloth's first place, else a room's about its motion.
void AddCameras(const SyntheticOptions& options, const std::vector<Eigen::VectorXd>& frames,
                Recording* recording);

// Markers with noise, and their sigma.
void AddMarkers(const SyntheticOptions& options, const ClothMesh& mesh,
                const std::vector<Eigen::VectorXd>& frames, Recording* recording);

// Tracks with noise where a point falls on the picture, and their sigma. Nothing hides
// anything: a point is seen through the cloth.
void AddTracks(const SyntheticOptions& options, const ClothMesh& mesh,
               const std::vector<Eigen::VectorXd>& frames, Recording* recording);

// Clouds of points with noise, by frame, and their sigma; none without any. Nothing hides anything.
std::vector<std::vector<Eigen::Vector3d>> MakeClouds(const SyntheticOptions& options,
                                                     const ClothMesh& mesh,
                                                     const std::vector<Eigen::VectorXd>& frames,
                                                     Recording* recording);

std::vector<TruthPoint> TruthPoints(const SyntheticOptions& options, const ClothMesh& mesh,
                                    const std::vector<Eigen::VectorXd>& frames);

}  // namespace clothfit
