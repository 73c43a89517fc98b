// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of names and the nearest right one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace clothfit {

// Number of characters to insert, delete, replace or swap with their neighbour to turn a into b
// (optimal string alignment).
int EditDistance(std::string_view a, std::string_view b);

// "did you mean 'size'?" when one of the names is near, otherwise "expected one of size, ...".
std::string Suggestion(std::string_view wrong, const std::vector<std::string>& right_names);

// Of things that have a name, in their order.
template <class Thing>
std::vector<std::string> NamesOf(const std::vector<Thing>& things) {
  std::vector<std::string> names;
  for (const Thing& one : things) names.push_back(one.name);
  return names;
}

bool IsAmong(const std::vector<std::string>& names, std::string_view name);

// "a, b, c"; before the last name stands `last`, unless that is empty.
std::string JoinNames(const std::vector<std::string>& names, std::string_view between = ", ",
                      std::string_view last = "");

}  // namespace clothfit
