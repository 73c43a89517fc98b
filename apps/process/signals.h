// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What interrupt.h does, from when on.
#pragma once

namespace clothfit {

// From here on SIGINT and SIGTERM do what interrupt.h says. Another call changes nothing.
void ListenToSignals();

}  // namespace clothfit
