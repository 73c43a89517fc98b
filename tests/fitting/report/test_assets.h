// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands for the script and the style of a page, whatever they are.
#pragma once

#include "fitting/report/report.h"

namespace clothfit {

constexpr ReportAssets kTestAssets{"/* script */", "/* style */"};

}  // namespace clothfit
