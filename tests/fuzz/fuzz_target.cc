// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// One reader for libFuzzer, by the environment's CLOTHFIT_READER. What is thrown besides InputError
// ends the program, as a crash does.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "autodiff_sim/base/error.h"
#include "tests/fuzz/readers.h"

namespace clothfit {
namespace {

const FuzzedReader& TheReader() {
  const char* const name = std::getenv("CLOTHFIT_READER");
  const std::vector<FuzzedReader>& readers = FuzzedReaders();
  const auto found = std::find_if(readers.begin(), readers.end(), [&](const FuzzedReader& reader) {
    return name != nullptr && std::string(reader.name) == name;
  });
  if (found != readers.end()) return *found;
  for (const FuzzedReader& reader : readers) std::puts(reader.name);
  std::exit(2);
}

}  // namespace
}  // namespace clothfit

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  clothfit::TheReader();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const clothfit::FuzzedReader& reader = clothfit::TheReader();
  try {
    reader.read(std::string(reinterpret_cast<const char*>(data), size));
  } catch (const clothfit::InputError&) {
  }
  return 0;
}
