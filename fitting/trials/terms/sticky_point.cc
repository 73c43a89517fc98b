// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/terms/sticky_point.h"

#include "autodiff_sim/term/force_batch_impl.h"

namespace clothfit {

template std::unique_ptr<ForceBatch> MakeForceBatch<StickyPoint>(const TermContext&);

}  // namespace clothfit
