// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace clothfit {

// Lets this program take no more memory than is free now: beyond, it ends with "out of memory", and
// the system does not come to end it, or others.
void LimitMemory();

}  // namespace clothfit
