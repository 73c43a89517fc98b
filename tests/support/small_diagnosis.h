// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The folder of a diagnosis as 'clothfit diagnose' writes it, without diagnosing anything: what a
// report reads.
#pragma once

#include <filesystem>

namespace clothfit {

// Makes the small run's recording and writes `folder`/diagnosis, in which wind is named, gust
// cannot be told from it, and a force is missing in the first 9 frames. Returns its folder.
std::filesystem::path MakeSmallDiagnosis(const std::filesystem::path& folder);

}  // namespace clothfit
