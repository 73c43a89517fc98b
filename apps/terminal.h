// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The standard error, where clothfit alone speaks. libpng, OpenCV, FFmpeg, glog and others write
// lines of their own to it, whole pages for a damaged file.
#pragma once

#include <cstdio>

namespace clothfit {

// First in the program: from here on what others write to the standard error is kept aside. It is
// shown where the program aborts, and else forgotten.
void TakeTerminal();

// Where clothfit writes its own lines: the standard error as it was.
std::FILE* Terminal();

}  // namespace clothfit
