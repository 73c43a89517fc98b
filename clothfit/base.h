// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What every header of the interface uses: small vectors, arrays, the one kind of error.
//
// Units are metres, seconds, kilograms, newtons and pixels. The world is any right-handed frame.
// Nothing here names a type of another library, so a program may be compiled with any options for
// the processor and any version of Eigen.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#define CLOTHFIT_API __attribute__((visibility("default")))

namespace clothfit::v0 {

using Vector2 = std::array<double, 2>;
using Vector3 = std::array<double, 3>;

// An array of numbers of any shape, the last index fastest, as NumPy and PyTorch have it.
struct Array {
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

// Input that cannot be used. what() is one line that names the place (file, key, row), the value
// found there and what was expected. Work that fails otherwise throws std::runtime_error.
class CLOTHFIT_API InputError : public std::runtime_error {
 public:
  explicit InputError(const std::string& line);
  ~InputError() override;
};

// Told while something long is done: the stage in words, and which share of all is done, 0 to 1.
// Called by the thread that called, and by no other.
using Progress = std::function<void(const std::string& stage, double share)>;

// What long work is given: whom to tell, and a flag which, once it is set by any thread, ends the
// work early with what it has so far.
struct Callbacks {
  Progress progress;
  const std::atomic<bool>* stop = nullptr;
};

// Where a folder that is to be written exists already.
enum class Existing {
  kRefuse,   // InputError
  kReplace,  // what clothfit wrote there is replaced; other files stay
  kResume,   // interrupted work is gone on with
};

// "0.1.0".
CLOTHFIT_API std::string Version();

}  // namespace clothfit::v0
