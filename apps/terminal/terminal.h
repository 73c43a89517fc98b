// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The standard error, where clothfit alone speaks. libpng, OpenCV, FFmpeg, glog and others write
// lines of their own to it, whole pages for a damaged file. And how to print what is partly a
// stranger's: names, notes, logs.
#pragma once

#include <cstdio>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace clothfit {

// First in the program: from here on what others write to the standard error is kept aside. It is
// shown where the program aborts, and else forgotten.
void TakeTerminal();

// Where clothfit writes its own lines: the standard error as it was.
std::FILE* Terminal();

// Each line of the text as Printable; those of results, on the standard output, at any length.
void PrintLines(std::FILE* stream, std::string_view text);

// As fmt::print, by PrintLines.
template <class... Args>
void Print(std::FILE* stream, fmt::format_string<Args...> format, Args&&... args) {
  PrintLines(stream, fmt::format(format, std::forward<Args>(args)...));
}
template <class... Args>
void Print(fmt::format_string<Args...> format, Args&&... args) {
  Print(stdout, format, std::forward<Args>(args)...);
}

}  // namespace clothfit
