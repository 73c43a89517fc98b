// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// C3D files as their specification has them, of all processors, and broken ones.
// Reference: The C3D File Format, A Technical User Guide (Motion Lab Systems 2021; c3d.org).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tracking/import/c3d/bytes.h"
#include "tracking/import/markers/marker_take.h"

namespace clothfit {

// What stands in a file. Parameters by "GROUP:NAME" take the place of those that follow from the
// take, or come in addition.
struct C3dFile {
  C3dProcessor processor = C3dProcessor::kIntel;
  double scale = -1.0;  // below zero: points are floats
  int num_analog = 0;   // values of analog data a frame
  std::map<std::string, std::vector<float>> numbers;
  std::map<std::string, std::vector<int>> words;  // of 16 bits
  std::map<std::string, std::vector<std::string>> texts;
  std::vector<std::string> left_out;  // parameters that are not written

  // The take's places, which are written as they are; lost markers have a residual of -1.
  std::string Bytes(const MarkerTake& take) const;
};

}  // namespace clothfit
