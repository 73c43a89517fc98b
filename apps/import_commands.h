// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The subcommands of clothfit import.
#pragma once

#include <filesystem>
#include <string>

#include "apps/commands.h"

namespace clothfit {

void AddImportColmap(CLI::App* import, Action* action);
void AddImportOpencv(CLI::App* import, Action* action);
void AddImportVideo(CLI::App* import, Action* action);

// Throws InputError where the file exists and may not be replaced.
void CheckNotThere(const std::filesystem::path& file, bool force);

// "take" for "runs/take" and "runs/take/".
std::string NameOfFolder(const std::filesystem::path& folder);

}  // namespace clothfit
