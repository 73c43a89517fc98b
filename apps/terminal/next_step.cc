// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/terminal/next_step.h"

#include "apps/terminal/terminal.h"

namespace clothfit {

void PrintNext(const std::string& text) { Print("next: {}\n", text); }

}  // namespace clothfit
