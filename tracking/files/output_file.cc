// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/files/output_file.h"

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tracking/files/whole_file.h"

namespace clothfit {

namespace fs = std::filesystem;

void CheckMayWrite(const fs::path& file, Overwrite overwrite) {
  std::error_code error;
  const fs::path folder = file.parent_path();
  if (!folder.empty()) CheckInputFolder(folder);
  const fs::file_status status = fs::symlink_status(file, error);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() == fs::file_type::none)
    throw InputError(file.string(), "cannot be looked at: " + error.message());
  if (fs::is_directory(status)) throw InputError(file.string(), "is a folder; expected a file");
  if (overwrite == Overwrite::kRefuse && fs::is_regular_file(status))
    throw InputError(file.string(), "exists already; --force replaces it");
  if (!fs::is_regular_file(status))
    throw InputError(file.string(),
                     "is a link, device or pipe, which is never replaced; expected "
                     "a new file");
}

void WriteOutputFile(const fs::path& file, std::string_view contents, Overwrite overwrite) {
  CheckMayWrite(file, overwrite);
  WriteWholeFile(file, contents);
}

}  // namespace clothfit
