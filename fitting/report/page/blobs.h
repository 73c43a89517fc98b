// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The large arrays of a report. Its JSON names them by blocks: {"blob": 3, "type": "u16", "shape":
// [50, 441, 3], "lower": [...], "upper": [...]}. docs/report-internals.md has the schema.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace clothfit {

class ReportBlobs {
 public:
  using Json = nlohmann::ordered_json;

  // Each of these returns the block. `frames`: equally long, items of `components` numbers.
  Json AddNumbers(const std::vector<Eigen::VectorXd>& frames, int components);
  // A list of items; without differences between frames.
  Json AddList(const std::vector<double>& values, int components);
  Json AddIntegers(const std::vector<std::int32_t>& values, int components);
  Json AddBytes(std::string bytes);

  const std::vector<std::string>& blobs() const { return blobs_; }
  // Of all blobs together, as base64.
  std::size_t num_characters() const;

 private:
  std::vector<std::string> blobs_;
};

}  // namespace clothfit
