// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that are whole or not there, whatever happens while they are written.
#pragma once

#include <filesystem>
#include <string_view>

namespace clothfit {

// Writes beside the place, flushes to the disk and moves there. Throws InputError with the system's
// reason (disk full, read-only, ...), leaving what was there before.
void WriteWholeFile(const std::filesystem::path& file, std::string_view contents);

// Appends a line. Throws InputError with the system's reason.
void AppendLine(const std::filesystem::path& file, std::string_view line);

}  // namespace clothfit
