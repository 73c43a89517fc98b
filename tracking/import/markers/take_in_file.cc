// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/markers/take_in_file.h"

#include <algorithm>
#include <cctype>
#include <map>

namespace clothfit {

std::optional<double> MetresPerUnit(const std::string& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static const std::map<std::string, double> kMetres = {{"m", 1.0},
                                                        {"meter", 1.0},
                                                        {"meters", 1.0},
                                                        {"metres", 1.0},
                                                        {"cm", 1e-2},
                                                        {"centimeters", 1e-2},
                                                        {"centimetres", 1e-2},
                                                        {"mm", 1e-3},
                                                        {"millimeters", 1e-3},
                                                        {"millimetres", 1e-3}};
  const auto found = kMetres.find(lower);
  return found == kMetres.end() ? std::nullopt : std::optional<double>(found->second);
}

}  // namespace clothfit
