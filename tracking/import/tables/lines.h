// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The lines of a table that a program of motion capture wrote, as fields.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "tracking/text/text.h"

namespace clothfit {

// Reads a text file line by line. Fields may be quoted; blanks around them are left out.
class TableLines {
 public:
  TableLines(std::filesystem::path file, std::string text);
  TableLines(const TableLines&) = delete;
  TableLines& operator=(const TableLines&) = delete;

  // Fields end at this character from the next line on: a comma, unless set.
  void set_separator(char separator) { separator_ = separator; }
  char separator() const { return separator_; }
  // The first of tab, semicolon and comma that is in the next line that is not empty.
  char LikelySeparator() const;

  // The fields of the next line that is not empty; false at the end. A line of blanks and
  // separators alone is empty.
  bool Next(std::vector<std::string>* fields);
  // As Next, but throws at the end. `expected`: what the line is, for the message.
  void Require(const std::string& expected, std::vector<std::string>* fields);
  // Whether an empty line, or the end, comes next.
  bool IsEmptyNext() const;
  // Whether the rest begins with this text.
  bool BeginsWith(std::string_view start) const { return StartsWith(rest_, start); }

  const std::filesystem::path& file() const { return file_; }
  int number() const { return number_; }  // of the line last read, from 1
  // An InputError at the line last read, at another, and at one of its fields, counted from 0.
  [[noreturn]] void Fail(const std::string& problem) const { FailAt(number_, problem); }
  [[noreturn]] void FailAt(int line, const std::string& problem) const;
  [[noreturn]] void Fail(size_t column, const std::string& problem) const;

 private:
  std::string_view NextLine() const;
  bool IsEmpty(std::string_view line) const;

  std::filesystem::path file_;
  std::string text_;
  std::string_view rest_;
  char separator_ = ',';
  int number_ = 0;
};

}  // namespace clothfit
