// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Every reader of files that a stranger may have written.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clothfit {

struct FuzzedReader {
  const char* name;  // of its folder of seeds
  // Throws InputError where it cannot use the file. Anything else that is thrown is a fault.
  void (*read)(const std::string& bytes);
};
const std::vector<FuzzedReader>& FuzzedReaders();

// Where they write what they read: of this process, in memory where the system has such a place.
// Whoever reads removes it.
const std::filesystem::path& FuzzFolder();

}  // namespace clothfit
