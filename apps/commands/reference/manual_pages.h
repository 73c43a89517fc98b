// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit manual-pages FOLDER, for packages; it is in no list of commands.
#pragma once

#include <filesystem>

#include <CLI/CLI.hpp>

namespace clothfit {

// Writes a man page a command and bash's completion into a folder like /usr/share, which is made.
// Returns the exit status; throws filesystem_error or InputError where it cannot write.
int WriteManualPages(const CLI::App& root, const std::filesystem::path& folder);

}  // namespace clothfit
