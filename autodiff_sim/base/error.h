// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one kind of error that bad input raises.
#pragma once

#include <stdexcept>
#include <string>

namespace clothfit {

// Input that cannot be used. Its text is one line that names the place (file, key, row), the value
// found there and what was expected. The command prints that line and exits with status 2.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& place, const std::string& problem)
      : std::runtime_error(place + ": " + problem) {}
};

}  // namespace clothfit
