// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/recording.h"

#include <cmath>
#include <utility>

#include "autodiff_sim/base/names.h"
#include "clothfit/detail/boundary.h"
#include "clothfit/detail/data.h"
#include "tracking/features/tracking_folder.h"
#include "tracking/recording/warnings/summary.h"

namespace clothfit::v0 {
namespace {

HandleDescription::Path PathOf(const Handle& handle) {
  HandleDescription::Path path;
  for (const Vector3& p : handle.path) {
    const bool is_known = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    path.push_back(is_known ? std::optional(ToEigen(p)) : std::nullopt);
  }
  return path;
}

ClothDescription ClothOf(const RecordingParts& parts) {
  ClothDescription cloth;
  cloth.size = ToEigen(parts.size);
  cloth.resolution = {parts.resolution[0], parts.resolution[1]};
  cloth.areal_density = parts.areal_density;
  if (parts.initial.empty()) {
    cloth.initial =
        FlatPlacement{ToEigen(parts.origin), ToEigen(parts.u_axis), ToEigen(parts.v_axis)};
    return cloth;
  }
  PointPlacement placement;
  for (const Marker& point : parts.initial)
    placement.points.push_back({ToEigen(point.uv), ToEigen(point.position)});
  cloth.initial = placement;
  return cloth;
}

clothfit::Recording RecordingOf(const RecordingParts& parts) {
  clothfit::Recording recording;
  recording.name = parts.name;
  recording.frame_rate = parts.frame_rate;
  recording.frame_count = parts.frame_count;
  recording.gravity = ToEigen(parts.gravity);
  recording.ground_height = parts.ground_height;
  recording.cloth = ClothOf(parts);
  for (const Handle& handle : parts.handles) {
    HandleDescription description;
    description.name = handle.name;
    description.uv = ToEigen(handle.uv);
    if (!handle.path.empty()) description.path = PathOf(handle);
    recording.handles.push_back(description);
  }
  for (const Marker& m : parts.markers)
    recording.markers.push_back({m.frame, m.id, ToEigen(m.uv), ToEigen(m.position)});
  recording.noise.marker = parts.marker_sigma;
  if (const auto& range = parts.held_out_frames)
    recording.splits.held_out_frames = Splits::FrameRange{(*range)[0], (*range)[1]};
  CheckRecording(recording);
  return recording;
}

std::shared_ptr<const RecordingData> Shared(clothfit::Recording recording) {
  return std::make_shared<const RecordingData>(RecordingData{std::move(recording)});
}

// One number a marker.
template <class Get>
std::vector<int> OfMarkers(const RecordingData& data, const Get& get) {
  std::vector<int> values;
  for (const clothfit::Marker& marker : data.recording.markers) values.push_back(get(marker));
  return values;
}

}  // namespace

Recording::Recording(std::shared_ptr<const RecordingData> data) : data_(std::move(data)) {}

Recording::Recording(const RecordingParts& parts)
    : data_(AtBoundary([&] { return Shared(RecordingOf(parts)); })) {}

Recording Recording::Read(const std::string& folder) {
  return AtBoundary([&] {
    const auto path = std::filesystem::absolute(folder).lexically_normal();
    return Recording(Shared(ReadRecording(path)));
  });
}

std::string Recording::folder() const { return data_->recording.path.string(); }
std::string Recording::name() const { return data_->recording.name; }
double Recording::frame_rate() const { return data_->recording.frame_rate; }
int Recording::frame_count() const { return data_->recording.frame_count; }
Vector2 Recording::size() const { return ToArray(data_->recording.cloth.size); }
int Recording::track_count() const { return static_cast<int>(data_->recording.tracks.size()); }

std::array<int, 2> Recording::resolution() const {
  const Eigen::Vector2i& resolution = data_->recording.cloth.resolution;
  return {resolution[0], resolution[1]};
}

Array Recording::marker_positions() const {
  std::vector<Eigen::Vector3d> positions;
  for (const clothfit::Marker& marker : data_->recording.markers)
    positions.push_back(marker.position);
  return ToRows(positions, 3);
}

Array Recording::marker_uv() const {
  std::vector<Eigen::Vector2d> uv;
  for (const clothfit::Marker& marker : data_->recording.markers) uv.push_back(marker.uv);
  return ToRows(uv, 2);
}

std::vector<int> Recording::marker_frames() const {
  return OfMarkers(*data_, [](const clothfit::Marker& marker) { return marker.frame; });
}

std::vector<int> Recording::marker_ids() const {
  return OfMarkers(*data_, [](const clothfit::Marker& marker) { return marker.id; });
}

std::vector<Handle> Recording::handles() const {
  std::vector<Handle> handles;
  for (const HandleDescription& description : data_->recording.handles) {
    Handle handle{description.name, ToArray(description.uv), {}};
    if (description.path)
      for (const auto& p : *description.path)
        handle.path.push_back(p ? ToArray(*p) : Vector3{NAN, NAN, NAN});
    handles.push_back(std::move(handle));
  }
  return handles;
}

std::vector<std::string> Recording::camera_names() const {
  return NamesOf(data_->recording.cameras);
}

std::string Recording::Describe() const {
  return AtBoundary([&] { return DescribeRecording(data_->recording); });
}

std::vector<std::string> Recording::Warnings() const {
  return AtBoundary([&] { return clothfit::Warnings(data_->recording); });
}

void Recording::Write(const std::string& folder, Existing existing) const {
  AtBoundary([&] { WriteRecording(data_->recording, folder, ToOverwrite(existing)); });
}

Recording Recording::Track(const std::string& folder, Existing existing,
                           const Callbacks& callbacks) const {
  return AtBoundary([&] {
    TrackingCallbacks all;
    all.stop = callbacks.stop;
    const double frames = data_->recording.frame_count;
    if (callbacks.progress)
      all.on_frame = [&](int done) { callbacks.progress("tracking", done / frames); };
    TrackIntoFolder(data_->recording, {}, folder, ToOverwrite(existing), all);
    return Read(folder);
  });
}

}  // namespace clothfit::v0
