// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fits, and the runs that they leave.
#pragma once

#include <memory>
#include <optional>

#include "clothfit/config.h"

namespace clothfit::v0 {

struct RunData;  // of the library

// What a fit found of one unknown.
struct Estimate {
  std::string name, unit;
  double value = 0.0, start = 0.0;
  bool free = false;
  // Where free: the ends of the 95 % interval, whether the data determine it rather than its
  // prior, and whether it stands at a bound.
  double lower = 0.0, upper = 0.0;
  bool determined = false, at_bound = false;
};

// Root mean square distances from what was observed; empty where there is none of the kind.
struct Errors {
  std::optional<double> markers;      // m
  std::optional<double> tracks;       // px
  std::optional<double> clouds;       // m, of their points from the surface
  std::optional<double> silhouettes;  // px that differ, in a picture
};

struct FitOptions {
  // Folder of the run; empty: a folder for the time being, removed with the last copy of the Run.
  std::string folder;
  Existing existing = Existing::kRefuse;
  Callbacks callbacks;
};

// A finished or interrupted fit. Shared and never changed: copies are cheap.
class CLOTHFIT_API Run {
 public:
  // The folder of an earlier fit. Throws InputError where it is incomplete or damaged.
  static Run Read(const std::string& folder);

  std::string folder() const;
  std::string status() const;   // "converged", "not converged", "interrupted" or "failed"
  std::string verdict() const;  // how good the fit is, in a sentence
  std::vector<std::string> sentences() const;  // and why
  double seconds() const;                      // that the fit took
  std::vector<Estimate> estimates() const;     // physical parameters first
  double Value(const std::string& parameter) const;
  Errors fitted() const, held_out() const;  // of fitted and of held-out frames

  const Array& trajectory() const;  // frames x particles x 3, m, world
  const Array& uv() const;          // particles x 2, m, on the cloth
  // Three particles a triangle, counter-clockwise in (u, v).
  const std::vector<std::array<int, 3>>& triangles() const;

  // Where points of the cloth are: point i is (u, v)[i] (m) at frame[i]. Points x 3, m, world.
  // Frames beyond the fitted ones are simulated on along the known paths of the handles.
  Array Predict(const std::vector<int>& frame, const std::vector<Vector2>& uv) const;

  // The run as one page to open in a browser.
  void Report(const std::string& file, Existing existing = Existing::kRefuse) const;
  // For other programs; lengths in m, z up. `format`:
  //   gltf     binary glTF 2.0 (.glb), a morph target a frame; y is up
  //   usda     Universal Scene Description as text, an animated mesh
  //   pc2, mdd point caches for the run's mesh.obj, the second LightWave's
  //   obj, ply a file a frame, in a folder `file`: Wavefront OBJ, binary PLY
  //   csv      table of frame, time (s), particle, u, v, x, y, z
  //   npy      NumPy array, frames x particles x 3
  //   video    pictures of the first camera with the simulated outline (.mp4)
  //   mjcf, newton, blender
  //            the cloth itself, to be simulated by MuJoCo, Newton and Blender
  void Export(const std::string& format, const std::string& file,
              Existing existing = Existing::kRefuse) const;

  explicit Run(std::shared_ptr<const RunData> data);
  const RunData& data() const { return *data_; }

 private:
  std::shared_ptr<const RunData> data_;
};

// Fits a simulated cloth to a recording. A recording of pictures alone is tracked first, by
// Recording::Track. Where the config has no cloth.resolution the fit begins with the recording's
// and may choose a finer one, up to cloth.finest; the run's config names it. Throws InputError, and
// std::runtime_error where the simulation fails already at the start.
CLOTHFIT_API Run Fit(const Recording& recording, const Config& config,
                     const FitOptions& options = {});

}  // namespace clothfit::v0
