// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A test of what the code should do and does not yet.
#pragma once

#include <iostream>
#include <string>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace clothfit {

// Runs assertions of the right behaviour that are known to fail, and hides their failures. The
// test fails as soon as all of them hold, so that the mark comes off with the fault. What they
// take for granted belongs outside, or they may fail for another reason than the one given.
template <class Statement>
void ExpectKnownFailure(const char* file, int line, const std::string& reason,
                        const Statement& statement) {
  testing::TestPartResultArray results;
  {
    using Reporter = testing::ScopedFakeTestPartResultReporter;
    const Reporter hidden(Reporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    statement();
  }
  for (int i = 0; i < results.size(); ++i) {
    if (!results.GetTestPartResult(i).failed()) continue;
    std::cout << file << ":" << line << ": Known failure: " << reason << "\n";
    return;
  }
  ADD_FAILURE_AT(file, line) << "This holds now, so take EXPECT_KNOWN_FAILURE off it: " << reason;
}

}  // namespace clothfit

// EXPECT_KNOWN_FAILURE("why it fails", EXPECT_EQ(answer, right));
// The statement stands last so that it may have commas.
#define EXPECT_KNOWN_FAILURE(reason, ...) \
  ::clothfit::ExpectKnownFailure(__FILE__, __LINE__, reason, [&] { __VA_ARGS__; })
