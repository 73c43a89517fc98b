// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace clothfit {

// Tells once how long a long fit takes in all.
class ExpectedTime {
 public:
  // A line, at the first call by which so much is done that it is no guess, where the whole takes a
  // minute or more; else empty. `fraction` of the fit took these seconds.
  std::string Tell(double fraction, double seconds);

 private:
  bool is_told_ = false;
};

}  // namespace clothfit
