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
  // Points of the outer pattern search of a fit that are evaluated at a time, by as many threads as
  // there are; it decides the course. One is the better use of a machine where fits are many.
  int under_way = 1;

  // Throws InputError where a value is of no use.
  void Check() const;
};

// About the size of the paper's experiments. Hasler 2007 has seven cameras (sec. 5, 6.3), as the
// presets do, a frame 410 (Fig. 7) and a cloth of 900 particles (Fig. 1); it does not tell the
// frames and particles of its fits.
StudyOptions FullSize();

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(StudyOptions, experiments, values, frames, generator, picture,
                                   particles, fabric, search, simulations, points, starts, seed,
                                   full, under_way)

}  // namespace clothfit
