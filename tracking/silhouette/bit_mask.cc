// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/silhouette/bit_mask.h"

#include <cmath>

namespace clothfit {
namespace {

int CountBits(std::uint64_t word) { return __builtin_popcountll(word); }

}  // namespace

BitMask::BitMask(const cv::Mat& mask) : BitMask(mask.cols, mask.rows) {
  for (int y = 0; y < height_; ++y) {
    const auto* pixels = mask.ptr<std::uint8_t>(y);
    std::uint64_t* row = Row(y);
    for (int x = 0; x < width_; ++x) {
      if (pixels[x] != 0) row[x >> 6] |= std::uint64_t{1} << (x & 63);
    }
  }
}

bool BitMask::AtPoint(double x, double y) const {
  const double column = std::floor(x + 0.5), row = std::floor(y + 0.5);
  if (!(column >= 0.0 && column < width_ && row >= 0.0 && row < height_)) return false;
  return At(static_cast<int>(column), static_cast<int>(row));
}

void BitMask::SetSpan(int y, int first, int last) {
  std::uint64_t* row = Row(y);
  const int first_word = first >> 6, last_word = last >> 6;
  const std::uint64_t from_first = ~std::uint64_t{0} << (first & 63);
  const std::uint64_t to_last = ~std::uint64_t{0} >> (63 - (last & 63));
  if (first_word == last_word) {
    row[first_word] |= from_first & to_last;
    return;
  }
  row[first_word] |= from_first;
  for (int word = first_word + 1; word < last_word; ++word) row[word] = ~std::uint64_t{0};
  row[last_word] |= to_last;
}

std::int64_t BitMask::Count() const {
  std::int64_t count = 0;
  for (const std::uint64_t word : words_) count += CountBits(word);
  return count;
}

std::int64_t CountDifferences(const BitMask& a, const BitMask& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < a.words_.size(); ++i) count += CountBits(a.words_[i] ^ b.words_[i]);
  return count;
}

cv::Mat BitMask::ToMat() const {
  cv::Mat mask(height_, width_, CV_8UC1);
  for (int y = 0; y < height_; ++y) {
    auto* pixels = mask.ptr<std::uint8_t>(y);
    for (int x = 0; x < width_; ++x) pixels[x] = At(x, y) ? 255 : 0;
  }
  return mask;
}

}  // namespace clothfit
