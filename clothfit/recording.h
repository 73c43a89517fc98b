// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A recording: what was observed of one cloth.
#pragma once

#include <memory>
#include <optional>

#include "clothfit/base.h"

namespace clothfit::v0 {

struct RecordingData;  // of the library

// A point of the cloth, measured in space.
struct Marker {
  int frame = 0;
  int id = 0;             // the same id is the same point of the cloth in every frame
  Vector2 uv = {};        // m, where on the cloth
  Vector3 position = {};  // m, world
};

// A point of the cloth that is held.
struct Handle {
  std::string name;
  Vector2 uv = {};  // m, where on the cloth
  // m, world, one a frame; not a number where it is not known. Empty: the path is to be fitted.
  std::vector<Vector3> path;
};

// A recording as values, for one that is made in memory. The cloth lies flat at frame 0:
// x(u, v) = origin + u * u_axis + v * v_axis, unless `initial` tells otherwise.
struct RecordingParts {
  std::string name = "recording";
  double frame_rate = 30.0;  // Hz
  int frame_count = 1;
  Vector3 gravity = {0.0, 0.0, -9.81};       // m/s^2, world
  std::optional<double> ground_height;       // m; the ground is the plane z = height
  Vector2 size = {1.0, 1.0};                 // m, of the cloth along u (warp) and v (weft)
  std::array<int, 2> resolution = {31, 31};  // particles along u and v
  std::optional<double> areal_density;       // kg/m^2; a fit estimates it where it is not known
  Vector3 origin = {};
  Vector3 u_axis = {1.0, 0.0, 0.0}, v_axis = {0.0, 1.0, 0.0};  // unit, at right angles
  // Some points of the cloth at frame 0 (frame and id are not looked at); at least three. Empty:
  // flat, as said above.
  std::vector<Marker> initial;
  std::vector<Handle> handles;
  std::vector<Marker> markers;
  std::optional<double> marker_sigma;  // m, standard deviation of the markers; empty: 0.002
  std::optional<std::array<int, 2>> held_out_frames;  // first and last that no fit may see
};

// Shared and never changed: copies are cheap and may be used by several threads.
class CLOTHFIT_API Recording {
 public:
  // A recording's folder, see docs/file-formats.md. Throws InputError.
  static Recording Read(const std::string& folder);
  // Throws InputError, naming the key as if it stood in a file, where a value is wrong.
  explicit Recording(const RecordingParts& parts);

  std::string folder() const;  // empty where it was made in memory
  std::string name() const;
  double frame_rate() const;  // Hz
  int frame_count() const;
  Vector2 size() const;  // m
  std::array<int, 2> resolution() const;
  Array marker_positions() const;  // markers x 3, m, world
  Array marker_uv() const;         // markers x 2, m
  std::vector<int> marker_frames() const;
  std::vector<int> marker_ids() const;
  std::vector<Handle> handles() const;
  std::vector<std::string> camera_names() const;
  int track_count() const;

  // A table for people, several lines; and what is allowed but worth knowing, a line each.
  std::string Describe() const;
  std::vector<std::string> Warnings() const;

  // Throws InputError where the folder cannot be written, or holds anything else.
  void Write(const std::string& folder, Existing existing = Existing::kRefuse) const;

  // Finds masks, tracks and markers in the pictures of calibrated cameras, writes them into a
  // folder and returns them as a recording of its own.
  Recording Track(const std::string& folder, Existing existing = Existing::kRefuse,
                  const Callbacks& callbacks = {}) const;

  explicit Recording(std::shared_ptr<const RecordingData> data);
  const RecordingData& data() const { return *data_; }

 private:
  std::shared_ptr<const RecordingData> data_;
};

}  // namespace clothfit::v0
