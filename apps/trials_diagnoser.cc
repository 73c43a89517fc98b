// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/trials_diagnoser.h"

namespace clothfit {

Diagnoser DiagnoserToMeasure() { return Diagnose; }

}  // namespace clothfit
