// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings made for one test: a folder that vanishes, and files of a recording that is right in
// everything, to be spoilt in one place.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {

// A new empty folder, removed with everything in it at the end of its scope.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path Write(const std::string& file, const std::string& text) const;

 private:
  std::filesystem::path path_;
};

// Contents by file name, relative to the recording's folder.
using TestFiles = std::map<std::string, std::string>;

// Uses every key and every file of the format but videos and truth. Pictures are empty files.
TestFiles CompleteRecordingFiles();

void WriteFiles(const TestFiles& files, const TestFolder& folder);

// The text of the InputError that the call throws; a failure when it throws none.
std::string InputErrorOf(const std::function<void()>& call);

}  // namespace clothfit
