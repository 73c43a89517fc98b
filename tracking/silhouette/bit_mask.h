// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A binary picture, one bit a pixel: silhouettes of a whole recording fit into memory, and their
// differences are counted 64 pixels at a time.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace clothfit {

class BitMask {
 public:
  BitMask() = default;
  BitMask(int width, int height)
      : width_(width),
        height_(height),
        row_words_((width + 63) / 64),
        words_(static_cast<std::size_t>(row_words_) * height, 0) {}
  // Pixels of an 8-bit mask that are not 0.
  explicit BitMask(const cv::Mat& mask);

  int width() const { return width_; }
  int height() const { return height_; }

  bool At(int x, int y) const { return (Row(y)[x >> 6] >> (x & 63)) & 1; }
  // The pixel that this point (px) lies in; false outside the picture.
  bool AtPoint(double x, double y) const;
  // Sets the pixels first..last of a row, which must lie in the picture.
  void SetSpan(int y, int first, int last);
  void Clear() { words_.assign(words_.size(), 0); }

  // Pixels that are set.
  std::int64_t Count() const;
  // Pixels that are set in one of two masks of the same size only.
  friend std::int64_t CountDifferences(const BitMask& a, const BitMask& b);

  // 8-bit, 0 and 255.
  cv::Mat ToMat() const;
  // Row after row, each filled up with 0 to whole words.
  const std::vector<std::uint64_t>& words() const { return words_; }

 private:
  const std::uint64_t* Row(int y) const {
    return words_.data() + static_cast<std::size_t>(y) * row_words_;
  }
  std::uint64_t* Row(int y) { return words_.data() + static_cast<std::size_t>(y) * row_words_; }

  int width_ = 0, height_ = 0, row_words_ = 0;
  std::vector<std::uint64_t> words_;  // bits behind a row's end are 0
};

}  // namespace clothfit
