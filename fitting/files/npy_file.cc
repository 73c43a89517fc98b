// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/files/npy_file.h"

#include <cstring>
#include <regex>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr size_t kPreamble = 10;  // magic, version and the header's length

// `shape`: of what stands in the header's brackets, its groups are the numbers of frames and
// points.
std::vector<Eigen::VectorXd> ReadNpy(const std::filesystem::path& file, const std::string& shape,
                                     int components) {
  const std::string bytes = ReadTextFile(file);
  const auto byte = [&](size_t i) { return static_cast<unsigned char>(bytes[i]); };
  std::smatch match;
  size_t begin = 0, frames = 0, row = 0;
  if (bytes.size() > kPreamble && StartsWith(bytes, "\x93NUMPY\x01")) {
    begin = kPreamble + byte(8) + 256u * byte(9);
    const std::string header = bytes.substr(kPreamble, begin - kPreamble);
    const bool is_plain = header.find("'<f8'") != std::string::npos &&
                          header.find("'fortran_order': False") != std::string::npos;
    if (is_plain && std::regex_search(header, match, std::regex("\\(" + shape + "\\)"))) {
      frames = std::stoul(match[1]);
      row = static_cast<size_t>(components) * std::stoul(match[2]);
    }
  }
  // Frames of no points would need no bytes, however many there are said to be.
  const bool is_possible = !match.empty() && begin <= bytes.size() &&
                           frames <= std::size_t{kMostFrames} && (row > 0 || frames == 0);
  if (!is_possible || bytes.size() - begin != frames * row * sizeof(double)) {
    throw InputError(file.string(), fmt::format("is damaged; expected an .npy file of doubles, "
                                                "frames x points{}",
                                                components == 3 ? " x 3" : ""));
  }
  std::vector<Eigen::VectorXd> result(frames, Eigen::VectorXd(static_cast<Eigen::Index>(row)));
  for (size_t f = 0; f < frames; ++f) {
    std::memcpy(result[f].data(), &bytes[begin + f * row * sizeof(double)], row * sizeof(double));
  }
  return result;
}

}  // namespace

std::string PointsAsNpy(const std::vector<Eigen::VectorXd>& frames) {
  const Eigen::Index numbers = frames.empty() ? 0 : frames.front().size();
  std::string header =
      fmt::format("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}, {}, 3), }}",
                  frames.size(), numbers / 3);
  constexpr size_t kAlignment = 64;  // of the data's beginning
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

std::vector<Eigen::VectorXd> ReadPointsNpy(const std::filesystem::path& file) {
  return ReadNpy(file, "([0-9]{1,9}), ([0-9]{1,9}), 3", 3);
}

std::vector<Eigen::VectorXd> ReadScalarsNpy(const std::filesystem::path& file) {
  return ReadNpy(file, "([0-9]{1,9}), ([0-9]{1,9})", 1);
}

}  // namespace clothfit
