// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/fit_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/closest_on_mesh.h"
#include "autodiff_sim/step/handle_constraints.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/fit/search.h"
#include "fitting/rollout/window_simulator.h"
#include "fitting/runs/expected_time.h"
#include "fitting/runs/workload.h"
#include "tracking/silhouette/raster.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::vector<Eigen::VectorXd> SimulatePositions(const Scene& scene, const FitConfig& config,
                                               const FreeParameters& free,
                                               const Eigen::VectorXd& theta, int last_frame,
                                               StepReport* steps) {
  std::vector<Eigen::VectorXd> positions;
  SimulateFrames(
      scene, config, free, theta, last_frame,
      [&](int, const State& state) { positions.push_back(state.x); }, steps);
  return positions;
}

double DistanceFromCloth(const Scene& scene, const Eigen::Vector3d& point) {
  return ClosestOnMesh(scene.mesh.triangles, scene.initial).Find(point).on_triangle.distance;
}

// A camera that cannot see the cloth as it lies at the start, although its mask shows it, gives the
// fit nothing to go by.
void CheckSilhouettesOfStart(const Scene& scene) {
  constexpr double kInside = 0.01;  // m
  for (const SilhouetteObservation& seen : scene.silhouettes->observations) {
    if (seen.frame > 0) break;  // they are in the order of frames
    if (!seen.field) continue;
    const Camera& camera = scene.recording.cameras[seen.camera];
    const std::string place =
        (scene.recording.path / "cameras.yaml").string() + ": camera '" + camera.name + "'";
    const double distance = DistanceFromCloth(scene, CameraCentre(camera));
    if (distance < kInside) {
      throw InputError(place, fmt::format("stands {:.1f} mm from the cloth as it lies at frame 0; "
                                          "expected a camera that looks at it from outside",
                                          1e3 * distance));
    }
    BitMask mask;
    SilhouetteRaster(camera, scene.mesh.triangles).Draw(scene.initial, &mask);
    if (mask.Count() > 0) continue;
    throw InputError(place,
                     "does not see the cloth as it lies at frame 0, but its mask does; is it "
                     "this camera's, and is the cloth's initial placement right?");
  }
}

void LogContact(const Scene& scene, const FitConfig& config, const StepReport& steps,
                const RunFolder& run) {
  const std::string line = DescribeContact(scene, config, steps);
  if (!line.empty()) run.AppendLog(line);
}

// `time` is told where it is not null.
FitCallbacks WithRun(const FitCallbacks& callbacks, const RunFolder& run, ExpectedTime* time) {
  FitCallbacks all = callbacks;
  all.progress = [&run, &callbacks, time,
                  begin = std::chrono::steady_clock::now()](const FitProgress& progress) {
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    run.AppendProgress(progress, passed.count());
    const std::string line = time ? time->Tell(progress.fraction, passed.count()) : "";
    if (!line.empty()) run.AppendLog(line);
    if (!line.empty() && callbacks.note) callbacks.note(line);
    if (callbacks.progress) callbacks.progress(progress);
  };
  all.log = [&run, &callbacks](const std::string& line) {
    run.AppendLog(line);
    if (callbacks.log) callbacks.log(line);
  };
  return all;
}

}  // namespace

void CheckSimulable(const Scene& scene) {
  std::vector<HandleTarget> targets;
  for (const SceneHandle& handle : scene.handles) {
    targets.push_back({handle.on_cloth, handle.path.At(0.0)});
  }
  HandleConstraints{targets};
  CheckAffordable(scene, WorkOfSimulation(scene));
}

void CheckContact(const Scene& scene, const FitConfig& config) {
  if (!config.self_contact && scene.world.obstacles.empty()) return;
  const FreeParameters free(config, scene, MakeParameterTable());
  Simulation simulation(scene.mesh, scene.world, scene.HandlePoints(), StepOptions(config));
  simulation.SetParameters(free.Values(free.start()));
  Eigen::VectorXd x, v;
  free.InitialState(free.start(), &x, &v);
  try {
    simulation.CheckStart(simulation.MakeState(x));
  } catch (const InputError& error) {
    const std::string text = error.what();
    if (StartsWith(text, "contact.")) throw;  // a parameter, not of the recording
    throw InputError((scene.recording.path / "recording.yaml").string(), text);
  }
}

std::string DescribeContact(const Scene& scene, const FitConfig& config, const StepReport& steps) {
  std::string text;
  if (config.self_contact || !scene.world.obstacles.empty()) {
    text = fmt::format(
        "contact: at most {} pairs of the cloth and {} with obstacles or the ground; {} iterates "
        "shortened, {} steps blocked by what moves, {} patterns made anew, {} steps halved",
        steps.most_contact_pairs, steps.most_obstacle_contacts, steps.limited_iterates,
        steps.blocked_steps, steps.pattern_rebuilds, steps.halvings);
  }
  if (!config.check_intersections) return text;
  return text + fmt::format("{}intersections after any step: {}", text.empty() ? "" : "; ",
                            steps.intersections);
}

void CheckFittable(const Scene& scene, const FitConfig& config) {
  CheckSimulable(scene);
  CheckAffordable(scene, WorkOfFit(scene, config));
  if (scene.silhouettes) CheckSilhouettesOfStart(scene);
  const bool any_marker =
      std::any_of(scene.markers.begin(), scene.markers.end(),
                  [&](const MarkerObservation& m) { return scene.is_fitted[m.frame]; });
  const bool any_track = std::any_of(scene.tracks.begin(), scene.tracks.end(),
                                     [&](const TrackObservation& t) { return scene.IsFitted(t); });
  const bool any_silhouette =
      scene.silhouettes &&
      std::any_of(scene.silhouettes->observations.begin(), scene.silhouettes->observations.end(),
                  [](const SilhouetteObservation& s) { return s.field; });
  const bool any_cloud =
      scene.clouds &&
      std::any_of(scene.clouds->observations.begin(), scene.clouds->observations.end(),
                  [&](const CloudObservation& cloud) { return scene.IsFitted(cloud); });
  if (any_marker || any_track || any_cloud || any_silhouette) return;
  throw InputError(
      scene.recording.path.string(),
      "nothing to fit: expected markers, tracks, clouds or masks in the frames that are fitted");
}

std::vector<std::string> HandlesUnknownInHeldOutFrames(const Scene& scene) {
  const auto& range = scene.recording.splits.held_out_frames;
  std::vector<std::string> names;
  for (const SceneHandle& handle : scene.handles)
    if (range && range->last > scene.last_fitted_frame && !handle.path.is_known())
      names.push_back(handle.name);
  return names;
}

void RequireSameConfig(const RunFolder& run, const Recording& recording, const FitConfig& config) {
  if (!IsThere(run.ConfigFile())) return;  // it ended before it began
  FitConfig of_run = DefaultConfig(recording);
  ReadConfig(run.ConfigFile(), &of_run);
  ForgetChosenMesh(&of_run);
  // A fit that was given less goes the same way as far as it goes.
  of_run.max_iterations = config.max_iterations;
  of_run.max_simulations = config.max_simulations;
  const std::vector<std::string> differences = ConfigDifferences(of_run, config);
  if (differences.empty()) return;
  throw InputError("--resume",
                   "the options differ from those of the run: " + JoinNames(differences));
}

StepReport WriteResults(const Scene& scene, const FitConfig& config, const FitResult& result,
                        const RunFolder& run) {
  const FreeParameters free(config, scene, MakeParameterTable());
  run.WriteParameters(result);
  StepReport steps;
  run.WriteTrajectory(scene, SimulatePositions(scene, config, free, result.theta,
                                               scene.recording.frame_count - 1, &steps));
  run.WriteSummary(scene, config, result);
  return steps;
}

void WriteFit(const Scene& scene, const FitConfig& config, const FitResult& result,
              const RunFolder& run) {
  LogContact(scene, config, WriteResults(scene, config, result, run), run);
  run.AppendLog("status: " + ToString(result.status));
}

void WriteParametersSoFar(const FreeParameters& free, const Eigen::VectorXd& theta,
                          const RunFolder& run) {
  FitResult so_far;
  so_far.estimates = EstimatesAt(free, theta);
  run.WriteParameters(so_far);
}

FitResult FitWithCheckpoint(const RunFolder& run, const FitCallbacks& callbacks, bool resume,
                            const std::function<FitResult(const FitCallbacks&)>& fit,
                            const std::function<void(const FitResult&)>& write) {
  if (resume) {
    const bool goes_on = run.HasCheckpoint();
    run.AppendLog(goes_on ? "resumed from the checkpoint" : "resumed from the beginning");
    run.RemoveProgress();
  } else {
    run.RemoveCheckpoint();
  }
  EvaluationJournal journal = run.OpenCheckpoint();
  ExpectedTime time;  // not of what the checkpoint has, which goes faster
  FitCallbacks with_run = WithRun(callbacks, run, resume ? nullptr : &time);
  with_run.journal = &journal;
  FitResult result = fit(with_run);
  write(result);
  const bool is_final =
      result.status == FitStatus::kConverged || result.status == FitStatus::kFailed;
  if (is_final) run.RemoveCheckpoint();
  return result;
}

FitOnMesh FitIntoRun(const Scene& scene, const FitConfig& config, const RunFolder& run,
                     const FitCallbacks& callbacks, bool resume) {
  run.WriteConfig(config);
  FitConfig unchecked = config;
  unchecked.check_intersections = false;  // only the result is worth it
  const auto checked = [&](FitConfig chosen) {
    chosen.check_intersections = config.check_intersections;
    return chosen;
  };
  // Who interrupts a long fit does not wait for its last simulations. What a fit left that is done
  // again is further than where it begins.
  const FreeParameters free(config, scene, MakeParameterTable());
  bool stands = resume && run.HasParameters();
  FitCallbacks keeping = callbacks;
  keeping.checkpoint = [&](const FitCheckpoint& best) {
    if (!stands && best.theta.size() == free.size()) WriteParametersSoFar(free, best.theta, run);
  };
  keeping.stands = [&](const Scene& fitted, const FitConfig& chosen, const FitResult& result) {
    stands = true;
    if (&fitted != &scene) run.WriteConfig(checked(chosen));
    WriteResults(fitted, chosen, result, run);
  };
  FitOnMesh fit;
  fit.result = FitWithCheckpoint(
      run, keeping, resume,
      [&](const FitCallbacks& with_run) {
        fit = FitOnChosenMesh(scene, unchecked, with_run);
        return fit.result;
      },
      [&](const FitResult& result) {
        fit.config = checked(fit.config);
        if (fit.scene) run.WriteConfig(fit.config);
        WriteFit(fit.scene ? *fit.scene : scene, fit.config, result, run);
      });
  return fit;
}

int SimulateIntoRun(const Scene& scene, const FitConfig& config, const RunFolder& run,
                    int last_frame, StepReport* steps) {
  const FreeParameters free(config, scene, MakeParameterTable());
  StepReport taken;
  run.WriteConfig(config);
  const std::vector<Eigen::VectorXd> positions =
      SimulatePositions(scene, config, free, free.start(), last_frame, &taken);
  run.WriteTrajectory(scene, positions);
  LogContact(scene, config, taken, run);
  if (steps != nullptr) *steps = taken;
  run.AppendLog(fmt::format("simulated {} frames", positions.size()));
  return static_cast<int>(positions.size());
}

}  // namespace clothfit
