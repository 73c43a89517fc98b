// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A fit's result as it is kept on disk: CBOR, which keeps every double as it is, infinite ones too.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fitting/fit/fit.h"

namespace clothfit {

std::string FitAsBytes(FitResult result);

// Empty where they are damaged or of another version.
std::optional<FitResult> FitFromBytes(std::string_view bytes);

}  // namespace clothfit
