// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A recording made ready for the simulation: mesh, handles, observations located on the cloth.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/step/simulation.h"
#include "fitting/config/config.h"
#include "fitting/scene/clouds.h"
#include "fitting/scene/silhouettes.h"
#include "tracking/camera/plucker_ray.h"
#include "tracking/recording/recording.h"

namespace clothfit {

struct MarkerObservation {
  int frame, id;
  SurfacePoint on_cloth;
  Eigen::Vector3d position;  // m, world
};

struct TrackObservation {
  int frame, camera, id;
  SurfacePoint on_cloth;
  Eigen::Vector2d pixel;
  std::optional<PluckerRay<double>> ray;  // where the cloth is attracted to it
};

// A point of the cloth that is held, and where, as a function of time.
class HandlePath {
 public:
  // A known path, one position a frame (gaps are bridged), interpolated by Catmull-Rom splines.
  HandlePath(const HandleDescription::Path& path, double frame_rate);
  // An unknown one: `count` control points, all at `start`, `spacing` seconds apart.
  HandlePath(const Eigen::Vector3d& start, int count, double spacing);

  bool is_known() const { return spacing_ == 0.0; }
  int num_controls() const { return is_known() ? 0 : static_cast<int>(points_.size()); }
  double spacing() const { return spacing_; }
  double frame_rate() const { return frame_rate_; }  // Hz, of a known path
  // The control points (m) of an unknown path, or a known one by frame.
  const std::vector<Eigen::Vector3d>& controls() const { return points_; }
  void SetControl(int index, const Eigen::Vector3d& position) { points_[index] = position; }

  Eigen::Vector3d At(double time) const;
  // The four control points that act at a time, and their weights (uniform cubic B-spline).
  void Weights(double time, int* first, std::array<double, 4>* weights) const;

 private:
  std::vector<Eigen::Vector3d> points_;  // a known path's frames, or control points
  double frame_rate_ = 0.0;
  double spacing_ = 0.0;  // s; 0 for a known path
};

struct SceneHandle {
  std::string name;
  SurfacePoint on_cloth;
  HandlePath path;
  double released_after;  // s; infinite where it holds to the end
};

struct Scene {
  Recording recording;
  ClothMesh mesh;
  World world;
  Eigen::VectorXd initial;  // 3N, m, at frame 0
  std::vector<SceneHandle> handles;
  std::vector<MarkerObservation> markers;  // by frame
  std::vector<TrackObservation> tracks;    // by frame
  // By frame, then camera; none unless they are fitted. Shared by the scenes of one recording.
  std::shared_ptr<const Silhouettes> silhouettes;
  std::shared_ptr<const Clouds> clouds;  // likewise
  int steps_per_frame = 1;
  double step = 0.0;                             // s
  double marker_sigma = 0.0, track_sigma = 0.0;  // m, px
  double layout_sigma = 0.0;                     // m along u and v, of markers' places; 0: exact
  double silhouette_sigma = 0.0;                 // px
  double cloud_sigma = 0.0;                      // m
  std::vector<bool> is_fitted;                   // one a frame: may its observations be fitted?
  int last_fitted_frame = 0;

  double FrameTime(int frame) const { return frame / recording.frame_rate; }
  std::vector<SurfacePoint> HandlePoints() const;
  bool IsHeldOut(int frame) const;
  // In a fitted frame and of a camera that is not held out.
  bool IsFitted(const TrackObservation& track) const { return IsFitted(track.frame, track.camera); }
  bool IsFitted(const CloudObservation& cloud) const {
    return cloud.camera ? IsFitted(cloud.frame, *cloud.camera) : is_fitted[cloud.frame];
  }
  bool IsFitted(int frame, int camera) const;
};

// "31 x 25"
std::string GridAsText(const Scene& scene);

// Throws InputError where the recording or the config cannot be used. `same`, where given, is a
// scene of the same recording whose silhouettes are used again, unless what is known to be wrong
// with masks differs.
Scene MakeScene(const Recording& recording, const FitConfig& config, const Scene* same = nullptr);

}  // namespace clothfit
