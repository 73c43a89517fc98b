// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The simulation by itself: positions, and their exact derivatives.
#pragma once

#include <map>
#include <memory>

#include "clothfit/config.h"

namespace clothfit::v0 {

struct SimulationData;  // of the library

// One simulation from frame 0 on, driven by the handles alone. Where it breaks down, the frames
// before are there and no others.
struct Motion {
  Array positions;  // frames x particles x 3, m, world
  // d position / d value, frames x particles x 3 x values, m per the value's unit; exact, by the
  // implicit function theorem. Empty unless it was asked for.
  Array jacobian;
  bool complete = false;  // the last frame was reached
};

// A cloth ready to be simulated again and again with other values.
class CLOTHFIT_API Simulation {
 public:
  // `parameters`: the full names of those that are given to Run, in this order; all others have
  // the config's values. frame_count: 0 as the recording has. Throws InputError.
  Simulation(const Recording& recording, const Config& config,
             const std::vector<std::string>& parameters, int frame_count = 0);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  const std::vector<std::string>& parameters() const;
  std::vector<double> start() const;  // the config's values of these
  int frame_count() const;
  int num_particles() const;
  const Array& uv() const;  // particles x 2, m, on the cloth
  const std::vector<std::array<int, 3>>& triangles() const;

  // One value a parameter, in its unit. Throws InputError where it is none that the parameter may
  // have. `stop`, once set, ends it at the next frame.
  Motion Run(const std::vector<double>& values, bool with_jacobian = false,
             const std::atomic<bool>* stop = nullptr);

 private:
  std::unique_ptr<SimulationData> data_;
};

}  // namespace clothfit::v0
