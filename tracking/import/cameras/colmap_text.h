// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines and words of a model that COLMAP wrote as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace clothfit {

struct ColmapLine {
  int number = 0;  // from 1
  std::string_view text;
};

// All lines but comments; empty ones too, for they mean an image without points.
std::vector<ColmapLine> ColmapLines(std::string_view text);

// The words of a line, taken one by one. What is wrong throws InputError with file, line and key.
class ColmapWords {
 public:
  ColmapWords(const std::filesystem::path& file, const ColmapLine& line);

  std::string Text(const char* key);
  double Number(const char* key);
  int Integer(const char* key);
  std::string_view Rest() const;  // what was not taken yet, without blanks around it
  [[noreturn]] void Fail(const std::string& problem) const;

 private:
  std::filesystem::path file_;
  ColmapLine line_;
  std::string_view rest_;
};

}  // namespace clothfit
