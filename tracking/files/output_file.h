// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A single file that a command is told to write.
#pragma once

#include <filesystem>
#include <string_view>

namespace clothfit {

enum class Overwrite { kRefuse, kAllow };
inline Overwrite OverwriteIf(bool force) { return force ? Overwrite::kAllow : Overwrite::kRefuse; }

// Throws InputError where something is there, unless it may be replaced and is a regular file:
// never is a folder, device, pipe or link replaced, nor is anything written through one.
void CheckMayWrite(const std::filesystem::path& file, Overwrite overwrite);

// Checks once more, since much time may have passed, and writes the file, whole or not at all.
void WriteOutputFile(const std::filesystem::path& file, std::string_view contents,
                     Overwrite overwrite);

}  // namespace clothfit
