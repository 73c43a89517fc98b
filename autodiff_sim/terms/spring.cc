// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/spring.h"

#include "autodiff_sim/term/force_batch_impl.h"

namespace clothfit {

template std::unique_ptr<ForceBatch> MakeForceBatch<StretchSpring>(const TermContext&);
template std::unique_ptr<ForceBatch> MakeForceBatch<ShearSpring>(const TermContext&);

}  // namespace clothfit
