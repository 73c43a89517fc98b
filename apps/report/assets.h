// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of the report's page that `make report-assets` made, inside the command.
#pragma once

#include "fitting/report/page/html.h"

namespace clothfit {

ReportAssets PageAssets();

}  // namespace clothfit
