// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Every struct is taken apart by a structured binding, which names each of its members: one that is
// added does not compile before it is either put or left out on purpose.
#include "fitting/fit/fit_inputs.h"

#include <type_traits>

#include "fitting/files/version.h"

namespace clothfit {
namespace {

// Numbers are put as they lie in memory; whatever may differ in length comes after its length.
class InputBytes {
 public:
  template <class... Values>
  void PutAll(const Values&... values) {
    (Put(values), ...);
  }
  std::string Take() { return std::move(bytes_); }

 private:
  template <class Number,
            std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>, bool> = true>
  void Put(const Number& number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
  }
  void Put(const std::string& text) {
    Put(text.size());
    bytes_ += text;
  }
  template <class Derived>
  void Put(const Eigen::PlainObjectBase<Derived>& matrix) {
    PutAll(matrix.rows(), matrix.cols());
    for (Eigen::Index i = 0; i < matrix.size(); ++i) Put(matrix.data()[i]);
  }
  template <class Value, std::size_t kSize>
  void Put(const std::array<Value, kSize>& values) {
    for (const Value& value : values) Put(value);
  }
  template <class Value>
  void Put(const std::vector<Value>& values) {
    Put(values.size());
    for (const Value& value : values) Put(value);
  }
  template <class Value>
  void Put(const std::map<std::string, Value>& values) {
    Put(values.size());
    for (const auto& [name, value] : values) PutAll(name, value);
  }
  template <class Value>
  void Put(const std::optional<Value>& value) {
    Put(value.has_value());
    if (value) Put(*value);
  }
  template <class Value>
  void Put(const std::shared_ptr<Value>& value) {
    Put(value != nullptr);
    if (value) Put(*value);
  }
  template <class... Kinds>
  void Put(const std::variant<Kinds...>& value) {
    Put(value.index());
    std::visit([this](const auto& kind) { Put(kind); }, value);
  }

  // The recording.
  void Put(const FlatPlacement& placement) {
    const auto& [origin, u_axis, v_axis] = placement;
    PutAll(origin, u_axis, v_axis);
  }
  void Put(const PlacedPoint& point) {
    const auto& [uv, position] = point;
    PutAll(uv, position);
  }
  void Put(const PointPlacement& placement) {
    const auto& [points] = placement;
    Put(points);
  }
  void Put(const MeshPlacement& placement) {
    [[maybe_unused]] const auto& [file] = placement;  // it is the scene's mesh
  }
  void Put(const ClothDescription& cloth) {
    const auto& [size, resolution, areal_density, initial] = cloth;
    PutAll(size, resolution, areal_density, initial);
  }
  void Put(const HandleDescription& handle) {
    const auto& [name, uv, path, path_sigma, released_after] = handle;
    PutAll(name, uv, path, path_sigma, released_after);
  }
  void Put(const BallShape& ball) {
    const auto& [radius] = ball;
    Put(radius);
  }
  void Put(const BarShape& bar) {
    const auto& [radius, length] = bar;
    PutAll(radius, length);
  }
  void Put(const BoxShape& box) {
    const auto& [size, below] = box;
    PutAll(size, below);
  }
  void Put(const MeshShape& mesh) {
    [[maybe_unused]] const auto& [file] = mesh;  // it is the scene's obstacle
  }
  void Put(const ObstacleDescription::Pose& pose) {
    const auto& [position, rotation] = pose;
    PutAll(position, rotation);
  }
  void Put(const ObstacleDescription& obstacle) {
    const auto& [name, shape, path] = obstacle;
    PutAll(name, shape, path);
  }
  void Put(const NoiseSigmas& noise) {
    const auto& [marker, layout, track, silhouette, cloud, cloud_spacing, obstacles] = noise;
    PutAll(marker, layout, track, silhouette, cloud, cloud_spacing, obstacles);
  }
  void Put(const Splits::FrameRange& range) {
    const auto& [first, last] = range;
    PutAll(first, last);
  }
  void Put(const Splits& splits) {
    const auto& [held_out_frames, held_out_cameras] = splits;
    PutAll(held_out_frames, held_out_cameras);
  }
  void Put(const Marker& marker) {
    const auto& [frame, id, uv, position] = marker;
    PutAll(frame, id, uv, position);
  }
  void Put(const Track& track) {
    const auto& [frame, camera, id, uv, pixel] = track;
    PutAll(frame, camera, id, uv, pixel);
  }
  void Put(const MaskFaults& faults) {
    const auto& [later, fat] = faults;
    PutAll(later, fat);
  }
  void Put(const CameraFiles& files) {
    // Masks and depth are the scene's silhouettes and clouds; no fit looks at the other pictures.
    [[maybe_unused]] const auto& [images, masks, depth, mask_faults, video, background] = files;
    Put(mask_faults);
  }
  void Put(const Camera& camera) {
    const auto& [name, width, height, fx, fy, cx, cy, distortion, rotation, translation] = camera;
    PutAll(name, width, height, fx, fy, cx, cy, distortion, rotation, translation);
  }
  void Put(const Recording& recording) {
    [[maybe_unused]] const auto& [path, name, frame_rate, frame_count, gravity, ground_height,
                                  cloth, handles, obstacles, noise, splits, cameras, files, clouds,
                                  markers, tracks, put_right, left_out] = recording;
    PutAll(frame_rate, frame_count, gravity, ground_height, cloth, handles, obstacles, noise,
           splits, cameras, files, markers, tracks);
  }

  // The scene.
  void Put(const ClothMesh& mesh) {
    const auto& [uv, triangles, grid, buckles] = mesh;
    PutAll(uv, triangles, grid, buckles);
  }
  void Put(const OwnedFeatures& features) {
    const auto& [indices, count] = features;
    PutAll(indices, count);
  }
  void Put(const MeshFeatures& features) {
    const auto& [triangles, edges, owned_vertices, owned_edges] = features;
    PutAll(triangles, edges, owned_vertices, owned_edges);
  }
  void Put(const RigidPose& pose) {
    const auto& [world_from_body, origin_in_world] = pose;
    PutAll(world_from_body, origin_in_world);
  }
  void Put(const Obstacle& obstacle) {
    const auto& [name, points, features, radius, half_sides, path, frame_rate] = obstacle;
    PutAll(name, points, features, radius, half_sides, path, frame_rate);
  }
  void Put(const World& world) {
    const auto& [gravity, ground_height, obstacles] = world;
    PutAll(gravity, ground_height, obstacles);
  }
  void Put(const SurfacePoint& point) {
    const auto& [nodes, weights] = point;
    PutAll(nodes, weights);
  }
  void Put(const HandlePath& path) {
    static_assert(sizeof(path) == sizeof(path.controls()) + 2 * sizeof(double));
    PutAll(path.controls(), path.frame_rate(), path.spacing());
  }
  void Put(const SceneHandle& handle) {
    const auto& [name, on_cloth, path, released_after] = handle;
    PutAll(name, on_cloth, path, released_after);
  }
  void Put(const MarkerObservation& marker) {
    const auto& [frame, id, on_cloth, position] = marker;
    PutAll(frame, id, on_cloth, position);
  }
  void Put(const PluckerRay<double>& ray) {
    const auto& [direction, moment] = ray;
    PutAll(direction, moment);
  }
  void Put(const TrackObservation& track) {
    const auto& [frame, camera, id, on_cloth, pixel, ray] = track;
    PutAll(frame, camera, id, on_cloth, pixel, ray);
  }
  void Put(const BitMask& mask) { PutAll(mask.width(), mask.height(), mask.words()); }
  void Put(const SilhouetteObservation& seen) {
    const auto& [frame, camera, mask, field, outline] = seen;
    PutAll(frame, camera, mask, field.has_value(), outline);  // the field is the mask's
  }
  void Put(const Silhouettes& silhouettes) {
    [[maybe_unused]] const auto& [observations, warnings] = silhouettes;
    Put(observations);
  }
  void Put(const CloudObservation& cloud) {
    const auto& [frame, camera, points, spacing] = cloud;
    PutAll(frame, camera, points, spacing);
  }
  void Put(const Clouds& clouds) {
    [[maybe_unused]] const auto& [observations, warnings, most_points] = clouds;
    Put(observations);
  }
  void Put(const Scene& scene) {
    const auto& [recording, mesh, world, initial, handles, markers, tracks, silhouettes, clouds,
                 steps_per_frame, step, marker_sigma, track_sigma, layout_sigma, silhouette_sigma,
                 cloud_sigma, is_fitted, last_fitted_frame] = scene;
    PutAll(recording, mesh, world, initial, handles, markers, tracks, silhouettes, clouds,
           steps_per_frame, step, marker_sigma, track_sigma, layout_sigma, silhouette_sigma,
           cloud_sigma, is_fitted, last_fitted_frame);
  }

  // The fit.
  void Put(const ParameterSetting& setting) {
    const auto& [value, free, lower, upper, prior, prior_sigma, scale, shared] = setting;
    PutAll(value, free, lower, upper, prior, prior_sigma, scale, shared);
  }
  void Put(const FitConfig& config) {
    [[maybe_unused]] const auto& [recording, resolution, finest, refined, buckling, max_step,
                                  integrator, tolerance, check_intersections, self_contact,
                                  parameters, initial_order, initial_position_sigma,
                                  initial_velocity_sigma, spline_spacing, spline_acceleration,
                                  spline_speed, use_markers, use_tracks, use_silhouettes,
                                  use_clouds, leave_out_outliers, alpha, beta, cloud_points,
                                  cloud_coverage, loss, loss_scale, frames, every, hold_out,
                                  attract, loops, optimiser, max_simulations, polish_hard, window,
                                  window_resolution, coarse_resolution, polish, max_iterations,
                                  function_tolerance] = config;
    PutAll(resolution, buckling, max_step, integrator, tolerance, check_intersections, self_contact,
           parameters, initial_order, initial_position_sigma, initial_velocity_sigma,
           spline_spacing, spline_acceleration, spline_speed, use_markers, use_tracks,
           use_silhouettes, use_clouds, leave_out_outliers, alpha, beta, cloud_points,
           cloud_coverage, loss, loss_scale, frames, every, hold_out, attract, loops, optimiser,
           max_simulations, polish_hard, window, window_resolution, coarse_resolution, polish,
           max_iterations, function_tolerance);
  }
  void Put(const FitCheckpoint& from) {
    const auto& [coarse, next_window, theta] = from;
    PutAll(coarse, next_window, theta);
  }

  std::string bytes_;
};

}  // namespace

std::string FitInputsAsBytes(const Scene& scene, const FitConfig& config,
                             const FitCheckpoint* from) {
  InputBytes bytes;
  bytes.PutAll(Version(), scene, config, from != nullptr);
  if (from != nullptr) bytes.PutAll(*from);
  return bytes.Take();
}

}  // namespace clothfit
