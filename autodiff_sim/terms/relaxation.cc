// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/terms/relaxation.h"

#include "autodiff_sim/term/force_batch_impl.h"

namespace clothfit {

template std::unique_ptr<ForceBatch> MakeForceBatch<StretchRelaxation>(const TermContext&);
template std::unique_ptr<ForceBatch> MakeForceBatch<ShearRelaxation>(const TermContext&);
template std::unique_ptr<ForceBatch> MakeForceBatch<BendingRelaxation>(const TermContext&);

}  // namespace clothfit
