// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The pictures of a synthetic recording: rendered, exposed and written one by one.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/mesh/cloth_mesh.h"
#include "tracking/recording/recording.h"
#include "tracking/synthetic/procedural_texture.h"
#include "tracking/synthetic/sensor.h"

namespace clothfit {

// Where the simulated cloth is, at any time from the first frame to the last.
struct SyntheticSurface {
  ClothMesh mesh;
  double interval = 1.0;                   // s between the positions below
  std::vector<Eigen::VectorXd> positions;  // 3N, m, world

  // Interpolated linearly; before the start and after the end the cloth rests.
  Eigen::VectorXd At(double time) const;
};

struct SyntheticPictureOptions {
  Eigen::Vector2i size = {640, 480};   // px
  std::array<double, 5> distortion{};  // k1, k2, p1, p2, k3 of every camera
  ClothPattern pattern = ClothPattern::kRich;
  double specular = 0.0;      // share of the lamp's light in a highlight's middle
  int samples = 2;            // rays a pixel along x and y
  double noise = 2.0;         // grey levels of 255, one sigma
  double shot_noise = 0.0;    // grey levels, sigma that a white pixel has besides
  double light_drift = 0.03;  // share by which the light rises and falls with time
  double exposure = 0.0;      // s; 0: an instant
  int exposure_samples = 5;   // moments that one exposure is the mean of
  std::string video;          // empty: PNG; else the container: mp4, mkv or avi
  int threads = 0;            // 0: as many as the machine runs; the pictures do not depend on it

  // Tells `expect` of each key, as keys.h names it, whether its value is of use.
  using Expect =
      std::function<void(bool right, const std::string& key, const std::string& expected)>;
  void Check(const Expect& expect) const;
};

// Called with the share that is done, 0 to 1, and what is being done; never from two threads at a
// time.
using SyntheticProgress = std::function<void(double share, const std::string& stage)>;

// The names of the files that WriteSyntheticPictures writes.
std::vector<std::string> SyntheticPictureFiles(const SyntheticPictureOptions& options,
                                               const Recording& recording);

// Writes images/ or videos/, background/ and truth/masks/ into the recording's folder, for the
// cameras of the recording. Of each picture the noise depends on the seed, the camera and the frame
// alone. Throws InputError where a file cannot be written.
void WriteSyntheticPictures(const SyntheticPictureOptions& options, std::uint64_t seed,
                            const Recording& recording, const SyntheticSurface& surface,
                            const std::filesystem::path& folder,
                            const SyntheticProgress& progress = {});

}  // namespace clothfit
