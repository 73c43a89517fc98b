// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the force of planted effects while the generator runs: where and when it acts.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/step/simulation.h"
#include "fitting/trials/recording.h"

namespace clothfit {

class TrueForceMeter {
 public:
  explicit TrueForceMeter(const Trial& trial);

  // To be called after every step of the generator, for as long as the meter lives.
  std::function<void(const Simulation&, const State& before, const State& after)> Observer();

  ActingForce Result(const ClothMesh& mesh) const;

 private:
  void Add(const Simulation& simulation, const State& before, const State& after);

  std::vector<std::string> switches_;  // full names of what is put at its off value
  double frame_rate_;
  int frame_count_;
  std::optional<ForceMeter> meter_;
};

}  // namespace clothfit
