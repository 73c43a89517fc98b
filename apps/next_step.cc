// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/next_step.h"

#include <fmt/format.h>

namespace clothfit {

void PrintNext(const std::string& text) { fmt::print("next: {}\n", text); }

}  // namespace clothfit
