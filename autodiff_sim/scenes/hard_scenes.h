// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The scenes that contact is judged by, and how one is simulated and watched: whether every step
// converges, nothing passes through anything and no energy comes from nowhere. For the study, the
// benchmark and the tests alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "autodiff_sim/scenes/contact_scenes.h"

namespace clothfit {

struct HardScene {
  std::string name, doc;
  double side;                                    // m, of the square cloth
  std::function<ClothScene(int particles)> make;  // particles a side
  int num_frames;
};

// A fall that crumples, a corner drawn over for 300 frames, two layers, a ball, a bar, a twist. No
// obstacle moves in any.
std::vector<HardScene> HardScenes();
// Throws InputError where there is none of this name.
HardScene FindHardScene(const std::string& name);

struct SceneOptions {
  int particles = 11;         // a side; odd, so that the folded cloth has particles in its fold
  double step = 1.0 / 120.0;  // s, about; a frame is a number of whole steps
  Integrator integrator = Integrator::kBdf2;
  // Without drag, damping and friction, which could hide energy that comes from nowhere.
  bool lossless = false;
};

// What was seen in one frame, 1/30 s; the first is the start and has the state alone.
struct SceneFrame {
  double time = 0.0;  // s
  Eigen::VectorXd x;  // m, 3N
  std::vector<NamedEnergy> energies;
  double handle_work = 0.0;  // J, since the start
  // J: all energies less the handles' work less what that was at first; above 0 is gained.
  double balance = 0.0;
  StepReport report;  // of the frame's steps together, intersections counted
  // s of processor time: all of the steps; of it, finding what meets, and contact's forces.
  double seconds = 0.0, detection = 0.0, response = 0.0;
};

struct SceneRun {
  bool complete = false;  // every step converged; else the frames end before the one that did not
  std::vector<SceneFrame> frames;
  // J, the weight of the cloth times its side: what energies are compared with.
  double scale = 0.0;
  // J: the most by which the balance exceeds its start, and its own lowest value so far, after any
  // step.
  double largest_gain = 0.0, largest_rise = 0.0;
};

// With self-contact. `watch`, if given, sees every frame.
SceneRun RunHardScene(const HardScene& scene, const SceneOptions& options,
                      const std::function<void(const SceneFrame&)>& watch = nullptr);

}  // namespace clothfit
