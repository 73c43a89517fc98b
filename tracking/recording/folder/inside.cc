// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/folder/inside.h"

#include <system_error>

#include "autodiff_sim/base/error.h"

namespace clothfit {

namespace fs = std::filesystem;

void CheckLiesInside(const fs::path& recording_folder, const fs::path& file) {
  std::error_code error;
  const fs::path folder = fs::canonical(recording_folder, error);
  const fs::path target = error ? fs::path() : fs::weakly_canonical(file, error);
  if (error) throw InputError(file.string(), "cannot be read: " + error.message());
  const fs::path relative = target.lexically_relative(folder);
  if (!relative.empty() && *relative.begin() != ".." && *relative.begin() != "truth") return;
  throw InputError(file.string(), "leads to " + target.string() +
                                      "; expected a file inside the recording and not in truth/");
}

void CheckLinkLiesInside(const fs::path& recording_folder, const fs::path& file) {
  std::error_code ignored;
  if (fs::is_symlink(fs::symlink_status(file, ignored))) CheckLiesInside(recording_folder, file);
}

}  // namespace clothfit
