// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/project/source_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace clothfit::project {
namespace fs = std::filesystem;

std::vector<SourceFile> ReadFolders(const std::string& root,
                                    const std::vector<std::string>& folders) {
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(root) / folder)) {
      if (!entry.is_regular_file()) continue;
      SourceFile file{entry.path().lexically_relative(root).generic_string(), {}};
      std::ifstream stream(entry.path());
      for (std::string line; std::getline(stream, line);) file.lines.push_back(line);
      files.push_back(std::move(file));
    }
  }
  std::sort(files.begin(), files.end(),
            [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
  return files;
}

bool IsCpp(const SourceFile& file) {
  const std::string extension = fs::path(file.path).extension().string();
  return extension == ".h" || extension == ".cc";
}

}  // namespace clothfit::project
