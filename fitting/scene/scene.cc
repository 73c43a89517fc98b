// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// From a recording to a scene.
#include "fitting/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <ceres/cubic_interpolation.h>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/obstacle_body.h"
#include "autodiff_sim/mesh/obj_file.h"
#include "tracking/recording/surface/initial_placement.h"

namespace clothfit {
namespace {

// Positions frame by frame, with gaps bridged linearly and the ends held.
std::vector<Eigen::Vector3d> FillGaps(const HandleDescription::Path& path) {
  std::vector<Eigen::Vector3d> filled(path.size());
  int last = -1;
  for (int f = 0; f < static_cast<int>(path.size()); ++f) {
    if (!path[f]) continue;
    for (int g = last + 1; g <= f; ++g) {
      const double share = last < 0 ? 1.0 : static_cast<double>(g - last) / (f - last);
      filled[g] = last < 0 ? *path[f] : (1.0 - share) * *path[last] + share * *path[f];
    }
    last = f;
  }
  for (int g = last + 1; last >= 0 && g < static_cast<int>(path.size()); ++g)
    filled[g] = *path[last];
  return filled;
}

Obstacle MakeObstacle(const ObstacleDescription& description, double frame_rate) {
  Obstacle obstacle;
  if (const auto* ball = std::get_if<BallShape>(&description.shape)) {
    obstacle = MakeBall(ball->radius);
  } else if (const auto* bar = std::get_if<BarShape>(&description.shape)) {
    obstacle = MakeBar(bar->radius, 0.5 * bar->length);
  } else if (const auto* box = std::get_if<BoxShape>(&description.shape)) {
    obstacle = MakeBoxObstacle(0.5 * box->size, box->below);
  } else {
    const ObjSurface surface = ReadObjSurface(std::get<MeshShape>(description.shape).file.string());
    Eigen::VectorXd points(3 * static_cast<Eigen::Index>(surface.positions.size()));
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
      points.segment<3>(3 * static_cast<Eigen::Index>(i)) = surface.positions[i];
    obstacle = MakeMeshObstacle(points, surface.triangles);
  }
  obstacle.name = description.name;
  obstacle.frame_rate = frame_rate;
  obstacle.path.clear();
  for (const ObstacleDescription::Pose& pose : description.path) {
    const double angle = pose.rotation.norm();
    RigidPose placed;
    placed.origin_in_world = pose.position;
    if (angle > 0.0)
      placed.world_from_body = Eigen::AngleAxisd(angle, pose.rotation / angle).toRotationMatrix();
    obstacle.path.push_back(placed);
  }
  return obstacle;
}

void AddHandles(const Recording& recording, const FitConfig& config, Scene* scene) {
  std::vector<Eigen::Vector2d> uv;
  for (const HandleDescription& handle : recording.handles) uv.push_back(handle.uv);
  const std::vector<SurfacePoint> points = LocateOnCloth(scene->mesh, uv);
  const double spacings = scene->FrameTime(recording.frame_count - 1) / config.spline_spacing;
  // One stretch at least, that of a single frame; a stretch takes four control points.
  const double wanted = std::max(1.0, std::ceil(spacings)) + 3.0;
  // Each has three unknowns, and a fit keeps some matrices of unknowns squared, of 300 MB each.
  constexpr double kMostControls = 2000.0;
  const auto unknown = std::count_if(recording.handles.begin(), recording.handles.end(),
                                     [](const HandleDescription& h) { return !h.path; });
  if (static_cast<double>(unknown) * wanted > kMostControls) {
    throw InputError((recording.path / "recording.yaml").string(),
                     "the unknown paths of " + std::to_string(unknown) +
                         " handles take more than 2000 control points; raise "
                         "handle_paths.spline_spacing, or lower frame_count");
  }
  const int controls = unknown > 0 ? static_cast<int>(wanted) : 4;
  for (std::size_t h = 0; h < points.size(); ++h) {
    const HandleDescription& handle = recording.handles[h];
    const bool known = handle.path && std::any_of(handle.path->begin(), handle.path->end(),
                                                  [](const auto& p) { return p.has_value(); });
    HandlePath path =
        known ? HandlePath(*handle.path, recording.frame_rate)
              : HandlePath(points[h].At(scene->initial), controls, config.spline_spacing);
    const double released = handle.released_after ? scene->FrameTime(*handle.released_after)
                                                  : std::numeric_limits<double>::infinity();
    scene->handles.push_back({handle.name, points[h], std::move(path), released});
  }
}

void AddObservations(const Recording& recording, const FitConfig& config, Scene* scene) {
  std::vector<Eigen::Vector2d> uv;
  if (config.FitsMarkers()) {
    for (const Marker& m : recording.markers) uv.push_back(m.uv);
    const std::vector<SurfacePoint> points = LocateOnCloth(scene->mesh, uv);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Marker& m = recording.markers[i];
      scene->markers.push_back({m.frame, m.id, points[i], m.position});
    }
  }
  if (config.FitsTracks()) {
    uv.clear();
    for (const Track& t : recording.tracks) uv.push_back(t.uv);
    const std::vector<SurfacePoint> points = LocateOnCloth(scene->mesh, uv);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Track& t = recording.tracks[i];
      TrackObservation track{t.frame, t.camera, t.id, points[i], t.pixel, std::nullopt};
      track.ray = RayThroughPixel(recording.cameras[t.camera], t.pixel);
      scene->tracks.push_back(track);
    }
  }
  const auto by_frame = [](const auto& a, const auto& b) { return a.frame < b.frame; };
  std::stable_sort(scene->markers.begin(), scene->markers.end(), by_frame);
  std::stable_sort(scene->tracks.begin(), scene->tracks.end(), by_frame);
}

void ChooseFrames(const Recording& recording, const FitConfig& config, Scene* scene) {
  if (config.frames && ((*config.frames)[0] < 0 || (*config.frames)[1] >= recording.frame_count ||
                        (*config.frames)[0] > (*config.frames)[1])) {
    throw InputError(
        "--frames (observations.frames)",
        std::to_string((*config.frames)[0]) + " " + std::to_string((*config.frames)[1]) +
            "; expected first <= last within 0 to " + std::to_string(recording.frame_count - 1));
  }
  const std::array<int, 2> all = {0, recording.frame_count - 1};
  const auto [first, last] = config.frames.value_or(all);
  for (int f = 0; f < recording.frame_count; ++f) {
    const bool is_within = f >= first && f <= last;
    const bool is_chosen = is_within && (f - first) % config.every == 0;
    scene->is_fitted.push_back(is_chosen && !scene->IsHeldOut(f));
  }
  for (const MarkerObservation& m : scene->markers) {
    if (scene->is_fitted[m.frame])
      scene->last_fitted_frame = std::max(scene->last_fitted_frame, m.frame);
  }
  for (const TrackObservation& t : scene->tracks) {
    if (scene->IsFitted(t)) scene->last_fitted_frame = std::max(scene->last_fitted_frame, t.frame);
  }
}

void AddClouds(const FitConfig& config, const Scene* same, Scene* scene) {
  if (!config.FitsClouds() || !HasClouds(scene->recording)) return;
  const bool is_same =
      same != nullptr && same->clouds && same->clouds->most_points == config.cloud_points;
  scene->clouds = is_same
                      ? same->clouds
                      : std::make_shared<Clouds>(LoadClouds(scene->recording, config.cloud_points));
  for (const CloudObservation& cloud : scene->clouds->observations) {
    if (scene->IsFitted(cloud))
      scene->last_fitted_frame = std::max(scene->last_fitted_frame, cloud.frame);
  }
}

bool HaveSameMasks(const Recording& a, const Recording& b) {
  return std::equal(a.files.begin(), a.files.end(), b.files.begin(), b.files.end(),
                    [](const CameraFiles& of_a, const CameraFiles& of_b) {
                      return of_a.mask_faults == of_b.mask_faults;
                    });
}

void AddSilhouettes(const FitConfig& config, const Scene* same, Scene* scene) {
  if (!config.FitsSilhouettes()) return;
  scene->silhouettes = same != nullptr && HaveSameMasks(same->recording, scene->recording)
                           ? same->silhouettes
                           : nullptr;
  if (!scene->silhouettes) {
    scene->silhouettes = std::make_shared<Silhouettes>(LoadSilhouettes(
        scene->recording, [&](int frame, int camera) { return scene->IsFitted(frame, camera); }));
  }
  for (const SilhouetteObservation& s : scene->silhouettes->observations) {
    if (s.field) scene->last_fitted_frame = std::max(scene->last_fitted_frame, s.frame);
  }
}

}  // namespace

HandlePath::HandlePath(const HandleDescription::Path& path, double frame_rate)
    : points_(FillGaps(path)), frame_rate_(frame_rate) {}

HandlePath::HandlePath(const Eigen::Vector3d& start, int count, double spacing)
    : points_(static_cast<std::size_t>(count), start), spacing_(spacing) {}

void HandlePath::Weights(double time, int* first, std::array<double, 4>* weights) const {
  const double s = std::max(0.0, time / spacing_);
  *first = std::clamp(static_cast<int>(s), 0, num_controls() - 4);
  const double t = std::min(s - *first, 1.0), r = 1.0 - t;
  *weights = {r * r * r / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
              (3.0 * r * r * r - 6.0 * r * r + 4.0) / 6.0, t * t * t / 6.0};
}

Eigen::Vector3d HandlePath::At(double time) const {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  if (is_known()) {
    const ceres::Grid1D<double, 3> grid(points_.front().data(), 0,
                                        static_cast<int>(points_.size()));
    ceres::CubicInterpolator<ceres::Grid1D<double, 3>>(grid).Evaluate(time * frame_rate_,
                                                                      position.data());
    return position;
  }
  int first = 0;
  std::array<double, 4> weights;
  Weights(time, &first, &weights);
  for (int k = 0; k < 4; ++k) position += weights[k] * points_[first + k];
  return position;
}

std::vector<SurfacePoint> Scene::HandlePoints() const {
  std::vector<SurfacePoint> points;
  for (const SceneHandle& handle : handles) points.push_back(handle.on_cloth);
  return points;
}

bool Scene::IsHeldOut(int frame) const {
  const auto& range = recording.splits.held_out_frames;
  return range && frame >= range->first && frame <= range->last;
}

bool Scene::IsFitted(int frame, int camera) const {
  return is_fitted[frame] && !IsHeldOutCamera(recording, camera);
}

std::string GridAsText(const Scene& scene) {
  return fmt::format("{} x {}", scene.mesh.grid[0], scene.mesh.grid[1]);
}

Scene MakeScene(const Recording& recording, const FitConfig& config, const Scene* same) {
  Scene scene;
  scene.recording = recording;
  if (config.hold_out)
    scene.recording.splits.held_out_frames = Splits::FrameRange{0, recording.frame_count - 1};
  scene.world.gravity = recording.gravity;
  scene.world.ground_height = recording.ground_height;
  for (const ObstacleDescription& obstacle : recording.obstacles) {
    scene.world.obstacles.push_back(
        std::make_shared<Obstacle>(MakeObstacle(obstacle, recording.frame_rate)));
  }
  const double steps = std::ceil(1.0 / (recording.frame_rate * config.max_step) - 1e-9);
  constexpr double kMostSteps = 1e6;  // of a frame: minutes
  if (steps > kMostSteps) {
    throw InputError("simulation.max_step",
                     "a frame takes more than a million steps; raise it, or "
                     "frame_rate of the recording");
  }
  scene.steps_per_frame = std::max(1, static_cast<int>(steps));
  scene.step = 1.0 / (recording.frame_rate * scene.steps_per_frame);
  scene.marker_sigma = recording.noise.marker.value_or(kDefaultMarkerSigma);
  scene.layout_sigma = recording.noise.layout.value_or(0.0);
  scene.track_sigma = recording.noise.track.value_or(kDefaultTrackSigma);
  scene.cloud_sigma = recording.noise.cloud.value_or(kDefaultCloudSigma);
  scene.silhouette_sigma = recording.noise.silhouette.value_or(kDefaultSilhouetteSigma);
  PlacedCloth placed = PlaceCloth(recording, config.resolution);
  scene.mesh = std::move(placed.mesh);
  scene.mesh.buckles = config.buckling;
  scene.initial = std::move(placed.x);
  AddHandles(recording, config, &scene);
  AddObservations(recording, config, &scene);
  ChooseFrames(recording, config, &scene);
  AddClouds(config, same, &scene);
  AddSilhouettes(config, same, &scene);
  return scene;
}

}  // namespace clothfit
