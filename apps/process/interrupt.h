// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C. What is written is whole or not there (tracking/files/whole_file.h), so that a command
// may end at any moment.
#pragma once

#include <atomic>

namespace clothfit {

// Until StopOnInterrupt a SIGINT or SIGTERM ends the program at once, with kExitInterrupted. This
// holds from the program's start on, before main.

// From now on the first one sets the flag that is returned, to stop and keep what there is. A
// second one, or two seconds, end the program.
const std::atomic<bool>* StopOnInterrupt();

}  // namespace clothfit
