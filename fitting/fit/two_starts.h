// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fit, and where it leaves more than noise a second one from another material.
#pragma once

#include <vector>

#include "fitting/fit/joint_fit.h"

namespace clothfit {

// RunJointFit with its misfit. Where markers and tracks are beyond their limit, and a damping is
// free, the fit begins again with a tenth of each free damping, and the lower cost is kept: cloth
// that is damped too strongly has valleys of its own. The result counts the work of both and says
// whether they agree. Where the fit is long and the machine has a core to spare the second runs
// beside the first, and is stopped if it is not asked for; the result is the same. It tells of no
// progress then, and keeps no checkpoints in any case. Before it, callbacks.stands has the first
// fit, of several recordings with the scene and config of the first of them.
FitResult FitFromTwoStarts(const std::vector<NamedScene>& scenes, const FitCallbacks& callbacks);

}  // namespace clothfit
