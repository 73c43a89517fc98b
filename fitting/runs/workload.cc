// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/workload.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <fmt/format.h>
#include <sys/resource.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/rollout/free_parameters.h"
#include "fitting/rollout/shooting_windows.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr double kNumber = sizeof(double);  // bytes
constexpr double kGigabyte = 1e9;

// kB of a line such as "MemAvailable:   123456 kB"; infinite where there is none.
double MemoryLine(const std::string& name) {
  std::ifstream file("/proc/meminfo");
  for (std::string line; std::getline(file, line);)
    if (StartsWith(line, name + ":")) return std::stod(line.substr(name.size() + 1));
  return std::numeric_limits<double>::infinity();
}

// Of the group of processes that a container or a job of a cluster is.
double GroupMemory() {
  double most = 0.0, now = 0.0;
  std::ifstream limit("/sys/fs/cgroup/memory.max"), used("/sys/fs/cgroup/memory.current");
  if (!(limit >> most) || !(used >> now)) return std::numeric_limits<double>::infinity();
  return most - now;
}

}  // namespace

double AvailableMemory() {
  double most = std::min(1024.0 * MemoryLine("MemAvailable"), GroupMemory());
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    rlimit limit{};
    if (getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
      most = std::min(most, static_cast<double>(limit.rlim_cur));
  }
  return most;
}

Workload WorkOfSimulation(const Scene& scene) {
  Workload work;
  work.num_particles = scene.mesh.num_particles();
  const double frames = scene.recording.frame_count;
  work.steps = frames * scene.steps_per_frame;
  // Blocks of the matrices and their factors, by nested dissection: some 31 n log2 n numbers.
  const double n = work.num_particles;
  const double matrices = 400.0 * n * std::log2(n + 2.0) * kNumber;
  // The trajectory, and once more as the bytes of its file.
  work.bytes = matrices + 2.0 * frames * 3.0 * n * kNumber;
  return work;
}

Workload WorkOfFit(const Scene& scene, const FitConfig& config) {
  Workload work = WorkOfSimulation(scene);
  const FreeParameters free(config, scene, MakeParameterTable());
  work.num_free = free.size();
  const double n = work.num_free, positions = 3.0 * work.num_particles;
  const double frames = scene.last_fitted_frame + 1.0;
  const double cores = NumThreads(0);
  // Derivatives of a state, of its two predecessors, and what solving for them takes.
  constexpr double kStates = 10.0;
  double states = 2.0 * cores;
  double known = 2.0 * frames * scene.steps_per_frame * positions;  // motions kept
  double jacobians = 12.0 * n * n;
  if (FitsWindows(scene, config)) {
    const double length = std::max(2.0, config.window * scene.recording.frame_rate);
    const double windows = std::ceil(frames / length);
    states += windows;
    jacobians += 3.0 * windows * n * n;
  }
  work.bytes += kNumber * (kStates * states * positions * n + known + jacobians);
  work.bytes += cores * 400.0 * work.num_particles * std::log2(work.num_particles + 2.0) * kNumber;
  return work;
}

void CheckAffordable(const Scene& scene, const Workload& work) {
  constexpr double kMostSteps = 1e7;  // hours for one simulation, of which a fit makes hundreds
  const std::string place = scene.recording.path.string();
  if (work.steps > kMostSteps) {
    throw InputError(place, fmt::format("{:.3g} steps to simulate ({} frames, {} steps each); "
                                        "expected at most {:g}: lower frame_count, or raise "
                                        "frame_rate or simulation.max_step",
                                        work.steps, scene.recording.frame_count,
                                        scene.steps_per_frame, kMostSteps));
  }
  const double available = AvailableMemory();
  if (work.bytes <= available) return;
  throw InputError(
      place, fmt::format("takes about {:.3g} GB of memory ({} particles, {} frames, {} "
                         "unknowns), and {:.3g} GB are free; lower cloth.resolution, "
                         "frames, or what is free",
                         work.bytes / kGigabyte, work.num_particles, scene.recording.frame_count,
                         work.num_free, available / kGigabyte));
}

}  // namespace clothfit
