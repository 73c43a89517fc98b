// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings made by simulation, whose truth is known.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/step/simulation.h"
#include "tracking/recording/recording.h"
#include "tracking/recording/surface/truth.h"
#include "tracking/synthetic/motion.h"
#include "tracking/synthetic/pictures.h"

namespace clothfit {

struct SyntheticOptions {
  std::string name = "synthetic";
  SyntheticScenario scenario = SyntheticScenario::kTwoCornerSwing;

  // cloth
  Eigen::Vector2d size = {0.4, 0.4};      // m along u and v
  Eigen::Vector2i resolution = {11, 11};  // particles that the recording tells a fit to use
  int refinement = 1;    // the generator's cells along each side of one of those: above 1 the fit's
                         // mesh is not the one that made the recording
  bool buckling = true;  // of clothfit's own simulation, below its mesh: see ClothMesh
  bool tell_density = true;                  // is cloth.areal_density known to a fit?
  std::map<std::string, double> parameters;  // full name -> value; others at their initial value

  // time
  double frame_rate = 60.0;  // Hz
  int frame_count = 90;
  int steps_per_frame = 2;
  Integrator integrator = Integrator::kBdf2;
  double held_out_share = 1.0 / 3.0;  // of the frames, at the end; 0 = none

  // observations
  Eigen::Vector2i markers = {5,
                             5};  // points along u and v, in the middle of equal fields; 0 = none
  double marker_sigma = 0.002;    // m
  double layout_sigma = 0.0;      // m along u and v, of what is told of markers' places
  int num_cameras = 0;            // around the cloth; with images, in a room and at its ceiling
  bool tracks = true;             // does each camera track the markers' points?
  double track_sigma = 0.5;       // px
  int cloud_points = 0;           // of the surface in each frame, at chance places; 0 = none
  double cloud_sigma = 0.003;     // m, of each coordinate
  bool images = false;            // does each camera take pictures?
  SyntheticPictureOptions pictures;         // then
  std::vector<std::string> hidden_handles;  // handles whose path is not told
  std::uint64_t seed = 1;                   // of the noise

  Eigen::Vector2i truth_points = {9, 9};  // along u and v, edges included

  double Duration() const;  // s, from the first frame to the last

  // Throws InputError where a value is of no use: the place of its key, which keys.h names, the
  // value and what was expected.
  using PlaceOfKey = std::function<std::string(const std::string& key)>;
  void Check(const PlaceOfKey& place_of) const;
  void Check(const std::string& place) const;  // "PLACE: KEY"
};

struct SyntheticRecording {
  Recording recording;
  SyntheticSurface surface;                          // of the generator's mesh
  std::vector<std::vector<Eigen::Vector3d>> clouds;  // m, world, by frame; none without them
  std::vector<TruthPoint> truth_points;              // noise-free
  std::map<std::string, double> truth_parameters;    // every parameter by its full name
};

// What simulates, where it is not clothfit's own list of terms, and who looks on.
struct SyntheticGenerator {
  // Makes the simulation of a scenario; empty: with clothfit's own terms.
  std::function<Simulation(ClothMesh mesh, const World& world,
                           const std::vector<SurfacePoint>& handles,
                           const SimulationOptions& options)>
      make;
  // Simulates in place of clothfit's own simulation altogether. parameters: all by their full
  // names.
  std::function<SyntheticSurface(const SyntheticOptions& options, const SyntheticMotion& motion,
                                 const std::map<std::string, double>& parameters,
                                 const SyntheticProgress& progress)>
      simulate;
  // Full name -> value, over those of the options; for terms that clothfit's list does not have.
  std::map<std::string, double> parameters;
  // Called after each step of clothfit's own simulation that converged, with the states at its
  // ends.
  std::function<void(const Simulation& simulation, const State& before, const State& after)>
      observe;
};

// Positions are rounded to a micrometre and pixels to a thousandth, as they will be on disk. The
// same options give the same recording. Throws InputError where the options are of no use or a
// parameter is not the generator's, and std::runtime_error where the simulation diverges.
SyntheticRecording MakeSyntheticRecording(const SyntheticOptions& options,
                                          const SyntheticProgress& progress = {},
                                          const SyntheticGenerator& generator = {});

// The files of its folder with truth/, but no pictures: contents by name.
std::map<std::string, std::string> FilesOf(const SyntheticRecording& synthetic);

// Makes the recording and writes all of it, pictures too.
SyntheticRecording Synthesize(const SyntheticOptions& options, const std::filesystem::path& folder,
                              Overwrite overwrite, const SyntheticProgress& progress = {});

}  // namespace clothfit
