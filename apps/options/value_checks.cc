// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/options/value_checks.h"

#include <algorithm>

#include <fmt/format.h>

#include "tracking/text/text.h"

namespace clothfit {

CLI::Validator WholeNumber(int least, int most) {
  const auto problem = [least, most](const std::string& text) -> std::string {
    const std::optional<int> value = ParseInteger(text);
    if (value && *value >= least && *value <= most) return "";
    return fmt::format("{}; expected a whole number from {} to {}", text, least, most);
  };
  return CLI::Validator(problem, "");
}

CLI::Validator NumberAboveZero() {
  const auto problem = [](const std::string& text) -> std::string {
    const std::optional<double> value = ParseNumber(text);
    return value && *value > 0.0 ? "" : text + "; expected a number above 0";
  };
  return CLI::Validator(problem, "");
}

CLI::Validator OneOf(const std::vector<std::string>& names) {
  const auto problem = [names](const std::string& text) -> std::string {
    const bool is_right = std::find(names.begin(), names.end(), text) != names.end();
    return is_right ? "" : text + "; " + Suggestion(text, names);
  };
  return CLI::Validator(problem, "");
}

}  // namespace clothfit
