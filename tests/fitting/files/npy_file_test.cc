// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/files/npy_file.h"

#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace clothfit
