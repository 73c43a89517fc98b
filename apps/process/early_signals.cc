// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The command listens to signals before main, and before the constructors of other globals. This is
// no part of libclothfit: programs that load it have handlers of their own.
#include "apps/process/signals.h"

namespace {

__attribute__((constructor(101))) void BeginToListen() { clothfit::ListenToSignals(); }

}  // namespace
