// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/files/npy_file.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/test_folder.h"

namespace clothfit {
namespace {

TEST(Npy, HasTheHeaderAndTheBytesThatNumPyReads) {
  const std::vector<Eigen::VectorXd> frames = {Eigen::VectorXd::LinSpaced(6, 0.0, 5.0),
                                               Eigen::VectorXd::LinSpaced(6, 6.0, 11.0)};
  const std::string bytes = PointsAsNpy(frames);
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const size_t length =
      static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  const std::string header = bytes.substr(10, length);
  EXPECT_THAT(header,
              testing::HasSubstr("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2, 3), }"));
  EXPECT_EQ(header.back(), '\n');
  ASSERT_EQ(bytes.size(), 10 + length + 12 * sizeof(double));
  for (int i = 0; i < 12; ++i) {
    double value = 0.0;
    std::memcpy(&value, &bytes[10 + length + sizeof(value) * static_cast<size_t>(i)],
                sizeof(value));
    EXPECT_EQ(value, i);
  }
}

// An array without data, of a header that says what it likes.
std::string HeaderOnly(const std::string& shape) {
  const std::string header =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (" + shape + "), }\n";
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header;
}

TEST(Npy, RefusesFramesThatNoBytesStandFor) {
  const TestFolder folder;
  const auto problem = [&](const std::string& bytes) {
    const auto file = folder.Write("a.npy", bytes);
    return InputErrorOf([&] { ReadPointsNpy(file); });
  };
  EXPECT_TRUE(ReadPointsNpy(folder.Write("none.npy", HeaderOnly("0, 0, 3"))).empty());
  EXPECT_THAT(problem(HeaderOnly("999999999, 0, 3")), testing::HasSubstr("a.npy: is damaged"));
  EXPECT_THAT(problem(HeaderOnly("1, 0, 3")), testing::HasSubstr("a.npy: is damaged"));
  std::string longer = HeaderOnly("0, 0, 3");
  longer[9] = 1;  // a header that ends behind the file
  EXPECT_THAT(problem(longer), testing::HasSubstr("a.npy: is damaged"));
}

}  // namespace
}  // namespace clothfit
