// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C: the first one asks to stop and keep what there is, the second ends the program at once.
#pragma once

#include <atomic>

namespace clothfit {

// From now on SIGINT and SIGTERM set the flag that is returned.
const std::atomic<bool>* StopOnInterrupt();

}  // namespace clothfit
