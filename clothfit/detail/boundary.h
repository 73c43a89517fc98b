// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What happens wherever a program enters the library.
#pragma once

#include <string>

#include "autodiff_sim/base/error.h"
#include "clothfit/base.h"

namespace clothfit::v0 {

// While one of these lives, OpenBLAS and OpenCV use one thread each, since clothfit has threads of
// its own; afterwards as many as the program had set.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;
};

// The line without what is advice for the command line.
std::string WithoutOptions(const std::string& line);

// Does the work, and throws what the library calls bad input as what the interface calls so.
template <class Work>
auto AtBoundary(const Work& work) {
  const OneThread guard;
  try {
    return work();
  } catch (const clothfit::InputError& error) {
    throw InputError(WithoutOptions(error.what()));
  }
}

}  // namespace clothfit::v0
