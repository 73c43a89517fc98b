// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one way to a file that somebody gave. Every problem is an InputError with the system's
// reason. A pipe, a socket or a device is refused unread: it may have no end, or none yet.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace clothfit {

// Bytes of a file that is read whole. Tables of an hour of motion capture (50 markers, 240 Hz) have
// this many; more would take memory several times over.
inline constexpr std::size_t kMostBytes = std::size_t{1} << 31;

// Whether a path leads to anything. Throws where that cannot be told: in a folder that may not be
// entered, by links in a circle.
bool IsThere(const std::filesystem::path& path);

// Throws unless the path leads to a regular file that may be read, of at most so many bytes. For
// libraries that open it themselves.
void CheckInputFile(const std::filesystem::path& file, std::size_t most_bytes = kMostBytes);
void CheckInputFolder(const std::filesystem::path& folder);

std::string ReadInputFile(const std::filesystem::path& file, std::size_t most_bytes = kMostBytes);

// What the folder holds, in order of name, without names that begin with a dot.
std::vector<std::filesystem::path> ListInputFolder(const std::filesystem::path& folder);

}  // namespace clothfit
