// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The beginning of a recording: files that are put into a folder one by one, whether a recording is
// there already or is to become one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tracking/files/output_folder.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// What recording.yaml has to say. Cameras and videos know only some of it.
struct SceneStart {
  std::optional<Eigen::Vector2d> size;  // m, of the cloth
  std::optional<int> frame_count;
  std::optional<double> frame_rate;       // Hz
  std::optional<double> ground_height;    // m; the cloth lies on it unless an origin is given
  std::optional<Eigen::Vector3d> origin;  // m, world, of the flat cloth at frame 0
  Eigen::Vector3d u_axis = Eigen::Vector3d::UnitX();
  Eigen::Vector3d v_axis = Eigen::Vector3d::UnitY();
  std::optional<double> areal_density;     // kg/m^2
  std::vector<HandleDescription> handles;  // by default there are none
  double held_out_share = 0.0;             // of the frames, at the end
};

// The options of the command that still have to be given: "--size", for example.
std::vector<std::string> MissingOptions(const SceneStart& start);

// Holds out this share of the frames, at the end; of zero none, else one at least. Throws
// InputError, naming --held-out, where it is not 0 to less than 1.
void HoldOut(double share, Recording* recording);

// "take" for "runs/take" and "runs/take/".
std::string NameOfFolder(const std::filesystem::path& folder);

// The folder of a recording, old or new, to put more into it. Replaced is only what an import wrote
// before. `command`: "import video", for example.
OutputFolder OpenRecording(const std::filesystem::path& folder, const std::string& command,
                           Overwrite overwrite);

// Writes recording.yaml and nothing else. Everything has to be there, and right, in `start`; throws
// InputError otherwise.
void WriteStart(const SceneStart& start, OutputFolder* folder);

// Writes cameras.yaml. Throws InputError where a camera is wrong, or where the pictures or tracks
// that lie in the folder are of another one.
void WriteCameras(const std::vector<Camera>& cameras, OutputFolder* folder);

}  // namespace clothfit
