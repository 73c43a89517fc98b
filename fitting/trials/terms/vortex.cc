// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/terms/vortex.h"

#include "autodiff_sim/term/force_batch_impl.h"

namespace clothfit {

template std::unique_ptr<ForceBatch> MakeForceBatch<Vortex>(const TermContext&);

}  // namespace clothfit
