// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The run of a short fit to a small recording that has two cameras with pictures and masks.
#pragma once

#include <filesystem>

namespace clothfit {

// Writes `folder`/rec and `folder`/run and returns the run's folder.
std::filesystem::path MakeSmallRun(const std::filesystem::path& folder);

}  // namespace clothfit
