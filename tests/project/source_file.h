// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The project's own files, read as text, for tests of rules that every source has to keep.
#pragma once

#include <string>
#include <vector>

namespace clothfit::project {

struct SourceFile {
  std::string path;                // relative to the root of the project, with '/'
  std::vector<std::string> lines;  // without their line ends
};

// Every regular file below these folders of the project, sorted by path. A folder that is not there
// throws std::filesystem::filesystem_error.
std::vector<SourceFile> ReadFolders(const std::string& root,
                                    const std::vector<std::string>& folders);

// Whether the path names a C++ header or source: .h or .cc.
bool IsCpp(const SourceFile& file);

}  // namespace clothfit::project
