// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace clothfit {

enum ExitStatus : int {
  kExitSuccess = 0,
  kExitFailure = 1,        // the input is right, but the work failed
  kExitBadInput = 2,       // an InputError, or a command line that cannot be understood
  kExitInterrupted = 130,  // as a shell reports SIGINT
};

}  // namespace clothfit
