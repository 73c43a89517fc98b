// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Fit after fit in one process takes no more memory than the first ones.
#include <cstdlib>

#include <gtest/gtest.h>
#include <malloc.h>

#include "fitting/fit/search.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

// Bytes that are in use, whatever the allocator keeps for later.
double UsedMemory() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

// CLOTHFIT_FITS=1000 for a soak.
TEST(Memory, DoesNotGrowFromFitToFit) {
  if (UsedMemory() == 0.0)
    GTEST_SKIP() << "the address sanitizer's allocator tells nothing, and finds leaks itself";
  const char* const given = std::getenv("CLOTHFIT_FITS");
  const int fits = given != nullptr ? std::atoi(given) : 100;
  SmallRecordingOptions options;
  options.particles = 3;
  options.frames = 4;
  const Recording recording = MakeSmallRecording(options);
  FitConfig config = DefaultConfig(recording);
  config.max_iterations = 2;
  const Scene scene = MakeScene(recording, config);
  constexpr int kFirst = 10;  // threads and tables that are made once
  double after_first = 0.0;
  for (int i = 0; i < fits; ++i) {
    FitByStrategy(scene, config);
    if (i + 1 == kFirst) after_first = UsedMemory();
  }
  ASSERT_GT(after_first, 0.0);
  // One leaked state of these nine particles a fit would be 1000 bytes each; what the allocator
  // keeps for threads is some 10 000 in all.
  EXPECT_LT(UsedMemory() - after_first, 200.0 * fits);
}

}  // namespace
}  // namespace clothfit
