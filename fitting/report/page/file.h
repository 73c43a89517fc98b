// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a page goes.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "tracking/files/output_folder.h"

namespace clothfit {

// In a folder of clothfit's the page is listed, and other commands are kept out as long as this
// lives: it replaces what is listed there alone, and goes with the rest.
class PageFile {
 public:
  // Throws InputError where the page may not be written.
  PageFile(std::filesystem::path file, Overwrite overwrite);

  const std::filesystem::path& path() const { return path_; }
  void Write(std::string_view html);

 private:
  std::filesystem::path path_;
  Overwrite overwrite_;
  std::unique_ptr<OutputFolder> folder_;  // null: none of clothfit's
};

}  // namespace clothfit
