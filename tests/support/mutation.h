// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Files broken at random, the same way for the same seed.
#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace clothfit {

// Breaks the text of a file in one of some thirty ways: lines that are gone, repeated or exchanged,
// numbers that are extreme or none, other encodings, control characters, cuts, flipped bits, deep
// nesting, long fields. `how` gets the way's name.
std::string MutateText(std::string text, std::mt19937* random, std::string* how);

// Puts something else in the file's place: nothing, a folder, a pipe, a socket, links to a device,
// out of the folder, in a circle or to nothing, a file of 100 GB that takes no room.
void ReplaceFile(const std::filesystem::path& file, std::mt19937* random, std::string* how);

}  // namespace clothfit
