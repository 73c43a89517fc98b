// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that decides a fit, as one plain struct, and its YAML file. Defaults work with no
// file.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "autodiff_sim/step/cloth_model.h"
#include "tracking/recording/recording.h"

namespace clothfit {

// What a fit does with one parameter.
struct ParameterSetting {
  double value = 0.0;  // start of the fit, or the value where it is fixed
  bool free = false;
  double lower = 0.0, upper = 0.0;
  // The prior's centre, and one sigma: a factor above 1 for a parameter on a log scale, else an
  // amount.
  double prior = 0.0, prior_sigma = 1.0;
  // Not in files: the scale it is moved on, where that is not its parameter's own. What may vanish
  // cannot be moved by factors.
  std::optional<Scale> scale;
  // Of a fit of several recordings: whether all have one value of it; where left out, see IsShared.
  std::optional<bool> shared;
};

enum class LossKind { kNone, kHuber, kCauchy };

// Which unknowns are searched together.
enum class Strategy {
  kJoint,    // all, over all frames at once
  kTwoLoop,  // the fabric outside, the handles of each frame inside (Hasler 2007, sec. 5)
  kOneLoop,  // fabric and handles of each frame, one frame after the other (sec. 6.1)
};
std::string ToString(Strategy strategy);  // "joint", "two-loop", "one-loop"
// Throws InputError, naming the place.
Strategy ParseStrategy(const std::string& place, const std::string& name);

constexpr int kIterationsOfOutlines = 100;  // max_iterations where nothing else is observed

struct FitConfig {
  std::string recording;  // the folder; the config of a run can be used again as it is

  // cloth
  std::array<int, 2> resolution = {0, 0};  // particles along u and v; 0 = as the recording says
  // Particles along the longer side of the finest mesh that a fit may choose where no resolution is
  // given; 0: it keeps the recording's.
  int finest = 31;
  bool refined = false;  // the resolution is one that a fit has chosen; a fit chooses anew
  bool buckling = true;  // below the mesh, see ClothMesh

  // simulation
  double max_step = 1.0 / 120.0;  // s; a frame is divided into equal steps no longer than this
  Integrator integrator = Integrator::kBdf2;
  double tolerance = 1e-7;           // of a step, see SimulationOptions
  bool check_intersections = false;  // after every step, see SimulationOptions
  bool self_contact = false;         // the cloth keeps clear of itself, see SimulationOptions

  // parameters, every one by its full name
  std::map<std::string, ParameterSetting> parameters;

  // initial state: offsets of the positions and velocities at frame 0 by polynomials in (u, v) that
  // vanish at the handles; order -1 = none, 0 constant, 1 bilinear, 2 biquadratic
  int initial_order = -1;
  double initial_position_sigma = 0.005;  // m, prior of each coefficient
  double initial_velocity_sigma = 0.1;    // m/s

  // unknown handle paths: uniform cubic B-splines
  double spline_spacing = 1.0 / 12.0;  // s between control points
  double spline_acceleration = 20.0;   // m/s^2, one sigma of the prior on a path's acceleration
  double spline_speed = 1.0;           // m/s, one sigma of the prior on its speed

  // observations
  bool use_markers = true;
  bool use_tracks = true;
  bool use_silhouettes = false;    // by the soft error, see fitting/residuals/soft_silhouette.h
  bool use_clouds = false;         // and depth pictures, see fitting/residuals/cloud_residuals.h
  bool leave_out_outliers = true;  // markers and tracks off by far more than their noise
  // E = alpha E_s + beta E_a (Hasler 2007, sec. 6.2): weights of the silhouettes' squared residuals
  // and of those of markers, tracks and clouds. 0 leaves them out.
  double alpha = 1.0;
  double beta = 1.0;
  int cloud_points = 1000;      // of one cloud, at most; it is thinned evenly
  double cloud_coverage = 1.0;  // weight of the cloth's distances from clouds that should show it
  LossKind loss = LossKind::kNone;
  double loss_scale = 3.0;  // in sigmas
  std::optional<std::array<int, 2>>
      frames;     // inclusive range of frames to fit; all but held-out ones
  int every = 1;  // of them one in so many, from the first on
  // Of a fit of several recordings: this one is predicted, and nothing of it fitted.
  bool hold_out = false;
  // pull of the markers and of the tracks' rays on the cloth while fitting, as strong as
  // attraction_point.* and attraction_ray.* say: see docs/model.md
  bool attract = false;

  // strategy
  Strategy loops = Strategy::kJoint;
  std::string optimiser = "lm";  // of OptimiserNames(); the rest of the strategy is that of "lm"
  double max_simulations = 0.0;  // of the whole recording, of all but "lm"; 0: until it converges
  // Where Levenberg-Marquardt comes to rest without having converged, a derivative-free search of
  // the fabric on the hard error follows, if silhouettes are fitted.
  bool polish_hard = true;
  // s, of the first windows, which grow until they are all frames; 0: all frames at once
  double window = 0.25;
  // Windows are fitted with this many particles along the longer side of a grid that has at least
  // half as many again; 0: with all
  int window_resolution = 19;
  // Outlines alone: first with no more particles than this along the longer side of a grid, then
  // with all; 0: no
  int coarse_resolution = 9;
  bool polish = true;  // then fit all frames at once, open loop, from where the windows ended
  // Of Levenberg-Marquardt: of the polish; of each window without one, else fewer.
  int max_iterations = 60;
  double function_tolerance = 1e-6;  // relative change of the cost at which to stop

  bool FitsMarkers() const { return use_markers && beta > 0.0; }
  bool FitsTracks() const { return use_tracks && beta > 0.0; }
  bool FitsClouds() const { return use_clouds && beta > 0.0; }
  bool FitsSilhouettes() const { return use_silhouettes && alpha > 0.0; }

  // Throws InputError, naming `place` and the key, where a value is out of range.
  void Check(const std::string& place) const;
};

// A mesh that an earlier fit has chosen: the next one begins where that did.
void ForgetChosenMesh(FitConfig* config);

// Defaults for this recording: which parameters are free depends on what it has (ground or none, a
// known areal density or none).
FitConfig DefaultConfig(const Recording& recording);

// Reads a config over the defaults: a file may name only what it changes. Throws InputError with
// file, key, value and what was expected; an unknown key is answered with the nearest right one.
void ReadConfig(const std::filesystem::path& file, FitConfig* config);
// The recording that a config file names, where a relative path starts at the file's folder; empty
// where it names none.
std::string ReadConfigRecording(const std::filesystem::path& file);

// The complete config as YAML that reads back the same.
std::string ConfigToYaml(const FitConfig& config);

// One key in which two configs differ, with its values as YAML.
struct ConfigDifference {
  std::string key, doc;  // "strategy.window", "parameters.bending.stiffness.free"
  std::string value, other;
};
// In the order of the file; of parameters number by number. The recording counts too.
std::vector<ConfigDifference> CompareConfigs(const FitConfig& config, const FitConfig& other);

// One line a key in which they differ: "strategy.window (1, not 0.5)". Empty where they are equal.
std::vector<std::string> ConfigDifferences(const FitConfig& config, const FitConfig& other);

// Changes by the command line. `place` is the option, for messages.
// SetParameter("--set", "air_drag.normal=0.8"), SetFree("--free", "gravity.scale"), ...;
// a term's name stands for all of its parameters. SwitchOff puts a term at its off values and fixes
// it. A value may lie outside its bounds only where it is the off value.
void SetParameter(const std::string& place, const std::string& assignment, FitConfig* config);
void SetFree(const std::string& place, const std::string& name, bool free, FitConfig* config);
void SwitchOff(const std::string& place, const std::string& term, FitConfig* config);
// Lets markers and rays pull at the cloth while fitting, each kind by 1 N/m where its pull is 0.
void Attract(FitConfig* config);

}  // namespace clothfit
