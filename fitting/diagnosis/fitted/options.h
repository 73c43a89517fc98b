// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a diagnosis is asked for.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace clothfit {

struct Diagnosis;

// Where in the pipeline a part of the answer comes from can be switched off to see what it is
// worth.
struct DiagnosisOptions {
  // Terms that are not looked for, whatever the recording has.
  std::vector<std::string> excluded;
  int max_effects = 3;  // that are added one after the other
  int max_models = 5;   // physical candidates that are fitted, each time
  // Particles along a side of the mesh that decisions fall on, at most. Finer meshes take longer
  // and have less discretisation error, which looks like a draught.
  int finest_side = 31;
  int num_nulls = 400;            // residuals drawn of the re-simulated null
  double false_discovery = 0.05;  // expected share of false ones among those short-listed
  double least_share = 0.1;  // of the unexplained residual; below it a candidate is no explanation
  double held_out_share =
      1.0 / 3.0;  // of the frames, at the end, where the recording holds none out
  std::uint64_t seed = 1;
  // Ablations.
  bool project = true;  // candidates compete after the baseline and the faults took their part
  bool simulate_null = true;  // false: chi-squared tables
  bool nudge = true;          // false: the force is located along the free motion
  std::function<void(const std::string& stage, double fraction)> progress;
  std::function<void(const std::string&)> log;
  // Called after each effect with what an interrupted diagnosis would answer.
  std::function<void(const Diagnosis&)> so_far;
  const std::atomic<bool>* stop = nullptr;
  // Where finished fits are kept, see fit_runner.h; empty: nowhere.
  std::filesystem::path kept_fits;
};

}  // namespace clothfit
