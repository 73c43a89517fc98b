// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/page/blobs.h"

#include <utility>

#include "fitting/report/page/packing.h"

namespace clothfit {

ReportBlobs::Json ReportBlobs::AddNumbers(const std::vector<Eigen::VectorXd>& frames,
                                          int components) {
  const Eigen::Index row = frames.empty() ? 0 : frames.front().size();
  std::vector<double> values;
  values.reserve(frames.size() * static_cast<std::size_t>(row));
  for (const Eigen::VectorXd& frame : frames) {
    values.insert(values.end(), frame.data(), frame.data() + frame.size());
  }
  const Quantised quantised = Quantise(values, components);
  Json block = AddBytes(PackRows(quantised.values, static_cast<std::size_t>(row)));
  block["type"] = "u16";
  block["shape"] = {frames.size(), row / components, components};
  block["lower"] = quantised.lower;
  block["upper"] = quantised.upper;
  return block;
}

ReportBlobs::Json ReportBlobs::AddList(const std::vector<double>& values, int components) {
  const Quantised quantised = Quantise(values, components);
  const auto row = static_cast<std::size_t>(components);
  Json block = AddBytes(PackRows(quantised.values, row));
  block["type"] = "u16";
  block["shape"] = {values.size() / row, components};
  block["lower"] = quantised.lower;
  block["upper"] = quantised.upper;
  return block;
}

ReportBlobs::Json ReportBlobs::AddIntegers(const std::vector<std::int32_t>& values,
                                           int components) {
  const auto row = static_cast<std::size_t>(components);
  Json block = AddBytes(PackRows(values, row));
  block["type"] = "i32";
  block["shape"] = {values.size() / row, components};
  return block;
}

ReportBlobs::Json ReportBlobs::AddBytes(std::string bytes) {
  Json block = {{"blob", blobs_.size()}, {"type", "bytes"}, {"shape", {bytes.size()}}};
  blobs_.push_back(std::move(bytes));
  return block;
}

std::size_t ReportBlobs::num_characters() const {
  std::size_t characters = 0;
  for (const std::string& blob : blobs_) characters += (blob.size() + 2) / 3 * 4;
  return characters;
}

}  // namespace clothfit
