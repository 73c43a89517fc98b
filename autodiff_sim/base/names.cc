// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/base/names.h"

#include <algorithm>

namespace clothfit {

bool IsAmong(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

int EditDistance(std::string_view a, std::string_view b) {
  const size_t width = b.size() + 1;
  std::vector<int> table((a.size() + 1) * width);
  for (size_t i = 0; i <= a.size(); ++i) {
    for (size_t j = 0; j <= b.size(); ++j) {
      int& distance = table[i * width + j];
      if (i == 0 || j == 0) {
        distance = static_cast<int>(i + j);
        continue;
      }
      const int replaced = table[(i - 1) * width + j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      distance = std::min({table[(i - 1) * width + j] + 1, table[i * width + j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) distance = std::min(distance, table[(i - 2) * width + j - 2] + 1);
    }
  }
  return table.back();
}

std::string Suggestion(std::string_view wrong, const std::vector<std::string>& right_names) {
  const std::string* nearest = nullptr;
  constexpr std::size_t kLongest =
      200;  // of a name; beyond, likeness is none, and costs its square
  if (wrong.size() > kLongest) return "expected one of " + JoinNames(right_names);
  int nearest_distance = std::max(1, static_cast<int>(wrong.size()) / 2);  // farther is no likeness
  for (const std::string& name : right_names) {
    const int distance = EditDistance(wrong, name);
    if (distance < nearest_distance || (distance == nearest_distance && nearest == nullptr)) {
      nearest = &name;
      nearest_distance = distance;
    }
  }
  if (nearest != nullptr) return "did you mean '" + *nearest + "'?";
  return "expected one of " + JoinNames(right_names);
}

std::string JoinNames(const std::vector<std::string>& names, std::string_view between,
                      std::string_view last) {
  std::string joined;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) joined += i + 1 == names.size() && !last.empty() ? last : between;
    joined += names[i];
  }
  return joined;
}

}  // namespace clothfit
