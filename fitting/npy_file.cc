// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/npy_file.h"

#include <fmt/format.h>

namespace clothfit {

std::string PointsAsNpy(const std::vector<Eigen::VectorXd>& frames) {
  const Eigen::Index numbers = frames.empty() ? 0 : frames.front().size();
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}, 3), }}",
                  frames.size(), numbers / 3);
  // Magic, version and the header's length take 10 bytes; the data begin at a multiple of 64.
  constexpr size_t kPreamble = 10, kAlignment = 64;
  const size_t unpadded = kPreamble + header.size() + 1;
  header.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
  header += '\n';

  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += static_cast<char>(header.size() & 0xff);
  bytes += static_cast<char>(header.size() >> 8);
  bytes += header;
  for (const Eigen::VectorXd& frame : frames) {
    bytes.append(reinterpret_cast<const char*>(frame.data()),
                 sizeof(double) * static_cast<size_t>(frame.size()));
  }
  return bytes;
}

}  // namespace clothfit
