// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a simulation or a fit will take, told before it begins.
#pragma once

#include "fitting/config/config.h"
#include "fitting/scene/scene.h"

namespace clothfit {

struct Workload {
  double bytes = 0.0;  // of memory at most, beside the recording itself
  double steps = 0.0;  // of one simulation of the whole recording
  int num_particles = 0, num_free = 0;
};

Workload WorkOfSimulation(const Scene& scene);
Workload WorkOfFit(const Scene& scene, const FitConfig& config);

// Throws InputError where it takes more memory than is free, or more steps than anybody waits for,
// with what to lower.
void CheckAffordable(const Scene& scene, const Workload& work);

// Bytes that this process may still take: the least of the system's free memory and of the limits
// that it was started under.
double AvailableMemory();

}  // namespace clothfit
