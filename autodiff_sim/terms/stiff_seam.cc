// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/stiff_seam.h"

#include "autodiff_sim/term/force_batch_impl.h"

namespace clothfit {

template std::unique_ptr<ForceBatch> MakeForceBatch<StiffSeamStretch>(const TermContext&);
template std::unique_ptr<ForceBatch> MakeForceBatch<StiffSeamBending>(const TermContext&);

}  // namespace clothfit
