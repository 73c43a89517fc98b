// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which recordings a fit of several is of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace clothfit {

// A recording of a fit of several.
struct ListedRecording {
  std::string name;  // of its run, recordings/NAME
  std::filesystem::path path;
  bool is_held_out = false;
};

// The folders' own names; one that comes again gets a number. Throws InputError where a folder is
// named twice.
std::vector<ListedRecording> ListRecordings(const std::vector<std::string>& fitted,
                                            const std::vector<std::string>& held_out);
// recordings.yaml in the folder of such a fit. Reading throws InputError where it is no such
// folder.
void WriteRecordingList(const std::vector<ListedRecording>& recordings,
                        const std::filesystem::path& folder);
std::vector<ListedRecording> ReadRecordingList(const std::filesystem::path& folder);

}  // namespace clothfit
