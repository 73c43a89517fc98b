// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/fitted/fit_runner.h"

#include <algorithm>
#include <optional>
#include <string>

#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/fitted/kept_fit.h"
#include "fitting/files/sha256.h"
#include "fitting/files/whole_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace fs = std::filesystem;
namespace {

constexpr const char* kEnding = ".cbor";

std::optional<FitResult> ReadKept(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    return FitFromBytes(ReadTextFile(file));
  } catch (const InputError&) {  // not readable: as good as none
    return std::nullopt;
  }
}

// All that it is given, as bytes.
class Bytes {
 public:
  void Add(const std::string& text) {
    Add(static_cast<double>(text.size()));
    bytes_ += text;
  }
  void Add(double number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number)); }
  template <class Derived>
  void Add(const Eigen::DenseBase<Derived>& matrix) {
    Add(static_cast<double>(matrix.size()));
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      for (Eigen::Index j = 0; j < matrix.cols(); ++j) Add(static_cast<double>(matrix(i, j)));
    }
  }
  const std::string& get() const { return bytes_; }

 private:
  std::string bytes_;
};

void AddObservations(const Scene& scene, Bytes* bytes) {
  for (const double sigma : {scene.marker_sigma, scene.track_sigma, scene.silhouette_sigma})
    bytes->Add(sigma);
  for (const Camera& camera : scene.recording.cameras) {
    for (const double number : {camera.fx, camera.fy, camera.cx, camera.cy}) bytes->Add(number);
    for (const double number : camera.distortion) bytes->Add(number);
    bytes->Add(camera.camera_from_world_rotation);
    bytes->Add(camera.camera_from_world_translation);
  }
  for (const MarkerObservation& marker : scene.markers) {
    bytes->Add(marker.frame);
    bytes->Add(marker.id);
    bytes->Add(marker.on_cloth.At(scene.mesh.uv));
    bytes->Add(marker.position);
  }
  for (const TrackObservation& track : scene.tracks) {
    bytes->Add(track.frame);
    bytes->Add(track.camera);
    bytes->Add(track.id);
    bytes->Add(track.on_cloth.At(scene.mesh.uv));
    bytes->Add(track.pixel);
  }
  if (!scene.silhouettes) return;
  for (const SilhouetteObservation& seen : scene.silhouettes->observations) {
    bytes->Add(seen.frame);
    bytes->Add(seen.camera);
    bytes->Add(static_cast<double>(seen.mask.Count()));
    for (const Eigen::Vector2d& point : seen.outline) bytes->Add(point);
  }
}

// What else of a recording moves a cloth.
void AddMotion(const Scene& scene, Bytes* bytes) {
  const Recording& recording = scene.recording;
  bytes->Add(recording.frame_rate);
  bytes->Add(recording.gravity);
  bytes->Add(recording.ground_height.value_or(-1e9));
  bytes->Add(scene.initial);
  for (const bool is_fitted : scene.is_fitted) bytes->Add(is_fitted ? 1.0 : 0.0);
  for (const std::string& camera : recording.splits.held_out_cameras) bytes->Add(camera);
  for (const SceneHandle& handle : scene.handles) {
    bytes->Add(handle.name);
    bytes->Add(handle.on_cloth.At(scene.mesh.uv));
    bytes->Add(handle.released_after);
    for (int frame = 0; frame < recording.frame_count; ++frame)
      bytes->Add(handle.path.At(scene.FrameTime(frame)));
  }
  for (const ObstacleDescription& obstacle : recording.obstacles) {
    bytes->Add(obstacle.name);
    for (const ObstacleDescription::Pose& pose : obstacle.path) {
      bytes->Add(pose.position);
      bytes->Add(pose.rotation);
    }
  }
}

}  // namespace

std::string FitKey(const Scene& scene, const FitConfig& config, const FitCheckpoint* from) {
  Bytes bytes;
  bytes.Add(CLOTHFIT_VERSION);
  bytes.Add(ConfigToYaml(config));
  AddObservations(scene, &bytes);
  AddMotion(scene, &bytes);
  if (from != nullptr) {
    bytes.Add(from->coarse ? 1.0 : 0.0);
    bytes.Add(from->next_window);
    bytes.Add(from->theta);
    bytes.Add(from->information);
    bytes.Add(from->mean);
  }
  return Sha256(bytes.get());
}

FitResult FitRunner::Run(const Scene& scene, const FitConfig& config, const FitCheckpoint* from,
                         FitCallbacks callbacks) const {
  callbacks.stop = stop_;
  if (folder_.empty()) return RunFit(scene, config, callbacks, from);
  const fs::path file = folder_ / (FitKey(scene, config, from) + kEnding);
  if (const std::optional<FitResult> kept = ReadKept(file)) return *kept;
  const FitResult result = RunFit(scene, config, callbacks, from);
  if (result.status != FitStatus::kInterrupted && !IsStopped())
    WriteWholeFile(file, FitAsBytes(result));
  return result;
}

int NumKeptFits(const fs::path& folder) {
  if (!fs::is_directory(folder)) return 0;
  const fs::directory_iterator files(folder);
  return static_cast<int>(std::count_if(begin(files), end(files), [](const fs::directory_entry& f) {
    return f.path().extension() == kEnding;
  }));
}

}  // namespace clothfit
