// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/scenes/hard_scenes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/contact_clock.h"
#include "autodiff_sim/terms/air_drag.h"

namespace clothfit {
namespace {

constexpr double kFrame = 1.0 / 30.0;  // s

void RemoveLosses(Simulation* simulation) {
  const std::vector<NamedParameter>& table = simulation->model().parameters();
  Eigen::VectorXd parameters = simulation->parameters();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::string& name = table[i].parameter.name;
    if (table[i].term == AirDrag::kName || name == "damping" || name == "friction")
      parameters[static_cast<Eigen::Index>(i)] = table[i].parameter.off;
  }
  simulation->SetParameters(parameters);
}

}  // namespace

std::vector<HardScene> HardScenes() {
  return {
      {"crumpled", "stands on end and falls into a heap", 0.5,
       [](int n) { return DroppedCloth(n, 0.5); }, 30},
      {"over", "a corner is lifted, drawn over the rest and left there: 300 frames", 1.0,
       [](int n) { return CornerDrawnOver(n, 1.0); }, 300},
      {"folded", "two layers, the upper dragged over the lower", 0.4,
       [](int n) { return FoldedCloth(n, 0.4, 0.008); }, 30},
      {"ball", "falls on a ball", 0.5, [](int n) { return ClothOverBall(n, 0.5); }, 30},
      {"bar", "drawn over a bar and off it", 0.5, [](int n) { return ClothOverBar(n, 0.5); }, 38},
      {"twisted", "held at four corners and twisted by a turn", 0.5,
       [](int n) { return TwistedCloth(n, 0.5, 1.0); }, 30}};
}

HardScene FindHardScene(const std::string& name) {
  std::string names;
  for (const HardScene& scene : HardScenes()) {
    if (scene.name == name) return scene;
    names += (names.empty() ? "" : ", ") + scene.name;
  }
  throw InputError("scene", name + "; expected one of " + names);
}

SceneRun RunHardScene(const HardScene& hard, const SceneOptions& options,
                      const std::function<void(const SceneFrame&)>& watch) {
  const ClothScene scene = hard.make(options.particles);
  SimulationOptions with_contact;
  with_contact.self_contact = true;
  with_contact.integrator = options.integrator;
  Simulation simulation(scene.mesh, scene.world, scene.handles, with_contact);
  UseSuppleCloth(&simulation);
  if (options.lossless) RemoveLosses(&simulation);
  const Drive drive = scene.MakeDrive();
  State state = simulation.MakeState(scene.x);
  SceneRun run;
  const std::vector<double>& areas = simulation.model().topology().areas;
  run.scale = hard.side * simulation.parameters()[kArealDensity] *
              std::accumulate(areas.begin(), areas.end(), 0.0) * scene.world.gravity.norm();
  run.frames.emplace_back();
  run.frames[0].x = state.x;
  run.frames[0].energies = simulation.Energies(state);
  const double start = Total(run.frames[0].energies);
  const int steps = std::max(1, static_cast<int>(std::lround(kFrame / options.step)));
  double lowest = 0.0;
  for (int f = 0; f < hard.num_frames; ++f) {
    SceneFrame frame;
    for (int i = 0; i < steps; ++i) {
      contact_times = {};
      const double begin = ThreadSeconds();
      const StepReport report = simulation.Advance(kFrame / steps, drive, &state);
      frame.seconds += ThreadSeconds() - begin;
      frame.detection += contact_times.detection;
      frame.response += contact_times.response;
      frame.report += report;
      if (report.status != StepStatus::kConverged) return run;
      frame.report.intersections += simulation.CountIntersections(state.x) +
                                    simulation.CountObstacleIntersections(state.x, state.time);
      frame.energies = simulation.Energies(state);
      frame.handle_work = run.frames.back().handle_work + frame.report.handle_work;
      frame.balance = Total(frame.energies) - frame.handle_work - start;
      run.largest_gain = std::max(run.largest_gain, frame.balance);
      run.largest_rise = std::max(run.largest_rise, frame.balance - lowest);
      lowest = std::min(lowest, frame.balance);
    }
    frame.time = state.time;
    frame.x = state.x;
    if (watch) watch(frame);
    run.frames.push_back(std::move(frame));
  }
  run.complete = true;
  return run;
}

}  // namespace clothfit
