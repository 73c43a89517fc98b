// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/gust.h"

#include "autodiff_sim/term/force_batch_impl.h"

namespace clothfit {

template std::unique_ptr<ForceBatch> MakeForceBatch<Gust>(const TermContext&);

}  // namespace clothfit
