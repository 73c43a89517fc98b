// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/pictures/single_file.h"

#include <vector>

#include "tracking/import/pictures/folder.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// The camera's files there, relative to the recording.
std::vector<std::string> SinglesThere(const std::string& folder, const std::string& camera,
                                      const OutputFolder& recording) {
  std::vector<std::string> names;
  if (!fs::is_directory(recording.path() / folder)) return names;
  for (const fs::directory_entry& entry : fs::directory_iterator(recording.path() / folder)) {
    if (entry.path().stem() != camera) continue;
    names.push_back(folder + "/" + entry.path().filename().string());
  }
  return names;
}

}  // namespace

void CheckMayCopySingle(const fs::path& file, const std::string& folder, const std::string& camera,
                        const OutputFolder& recording) {
  for (const std::string& name : SinglesThere(folder, camera, recording)) {
    if (!IsSameFile(recording.path() / name, file)) recording.CheckMayWrite(name);
  }
}

void CopySingle(const fs::path& file, const std::string& folder, const std::string& camera,
                OutputFolder* recording) {
  const std::string name = folder + "/" + camera + file.extension().string();
  if (IsSameFile(recording->path() / name, file)) return;
  recording->Add({name});
  CopyInto(file, name, *recording);
  for (const std::string& there : SinglesThere(folder, camera, *recording)) {
    if (there != name) recording->Remove({there});
  }
}

}  // namespace clothfit
