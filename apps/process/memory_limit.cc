// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/process/memory_limit.h"

#include <algorithm>
#include <cmath>

#include <sys/resource.h>

#include "autodiff_sim/base/sanitized.h"
#include "fitting/runs/workload.h"

namespace clothfit {

void LimitMemory() {
  if (kIsSanitized) return;  // the shadow of all addresses counts as taken
  const double available = AvailableMemory();
  rlimit limit{};
  if (!std::isfinite(available) || getrlimit(RLIMIT_DATA, &limit) != 0) return;
  // Stacks count, before they are used; an eighth more is room for those of threads.
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(1.125 * available));
  setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace clothfit
