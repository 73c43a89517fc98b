// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How large a study is. What decides its numbers, as one plain struct.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace clothfit {

struct StudyOptions {
  std::vector<std::string> experiments = {"experiment-1", "experiment-2", "experiment-3"};
  // What the study varies, in its own unit; empty: the study's own list for this size.
  std::vector<double> values;

  // recordings
  int frames = 30;     // at 30 Hz
  int generator = 31;  // particles a side of the simulation that makes them; odd
  int picture = 320;   // px, width of the pictures; the height is three quarters of it

  // fits
  int particles = 7;  // a side
  std::vector<std::string> fabric = {"stretch.stiffness", "bending.stiffness", "air_drag.normal"};
  std::string search = "pattern/two-loop";  // optimiser/strategy, where the study has no own
  // Of the whole recording; a fit ends with the pass that reaches as many. Never a time.
  double simulations = 250.0;
  int points = 40;  // markers a frame, and tracks a camera and frame, at most
  int starts = 1;
  unsigned seed = 1;
  bool full = false;
  // The outer pattern search of each fit is done by all workers together, fit after fit, as Kolda
  // 2005 runs it; else each fit by one of them, which is the better use where there are many.
  bool share_search = false;

  // Throws InputError where a value is of no use.
  void Check() const;
};

// The size of the paper's experiments: all frames, pictures and parameters.
StudyOptions FullSize();

nlohmann::json ToJson(const StudyOptions& options);

}  // namespace clothfit
