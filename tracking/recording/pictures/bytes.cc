// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/pictures/bytes.h"

#include <algorithm>
#include <cstdint>

#include <zlib.h>

namespace clothfit {
namespace {

// Big-endian, at the beginning.
std::uint32_t Number(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(0, 4))
    number = (number << 8U) | static_cast<unsigned char>(byte);
  return number;
}

bool Begins(std::string_view bytes, std::string_view with, std::size_t at = 0) {
  return bytes.size() >= at + with.size() && bytes.substr(at, with.size()) == with;
}

}  // namespace

std::optional<std::array<int, 2>> SizeOfPng(std::string_view bytes) {
  using std::literals::operator""sv;
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n"sv;
  constexpr std::size_t kAround = 12;  // bytes of a chunk beside its data: length, name, checksum
  constexpr std::uint32_t kMostSide = 1U << 30U;
  if (!Begins(bytes, kSignature)) return std::nullopt;
  bytes.remove_prefix(kSignature.size());
  std::optional<std::array<int, 2>> size;
  while (bytes.size() >= kAround) {
    const std::size_t length = Number(bytes);
    if (length > bytes.size() - kAround) return std::nullopt;
    const std::string_view name = bytes.substr(4, 4), data = bytes.substr(8, length);
    const std::string_view sum_of = bytes.substr(4, 4 + length);
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(sum_of.data()), static_cast<uInt>(sum_of.size()));
    if (sum != Number(bytes.substr(8 + length))) return std::nullopt;
    if (!size) {
      if (name != "IHDR" || length < 8) return std::nullopt;
      const std::uint32_t width = Number(data), height = Number(data.substr(4));
      if (std::max(width, height) > kMostSide) return std::nullopt;
      size = {static_cast<int>(width), static_cast<int>(height)};
    }
    if (name == "IEND") return size;
    bytes.remove_prefix(kAround + length);
  }
  return std::nullopt;
}

bool IsVideoContainer(std::string_view bytes) {
  using std::literals::operator""sv;
  constexpr std::string_view kBoxes[] = {"ftyp"sv, "moov"sv, "mdat"sv,
                                         "wide"sv, "free"sv, "skip"sv};
  const bool is_mp4 = std::any_of(std::begin(kBoxes), std::end(kBoxes),
                                  [&](std::string_view box) { return Begins(bytes, box, 4); });
  constexpr std::size_t kPacket = 188;  // bytes of an MPEG transport stream's, each begins with G
  const bool is_transport = Begins(bytes, "G") && Begins(bytes, "G", kPacket);
  constexpr std::string_view kOthers[] = {"\x1a\x45\xdf\xa3"sv,
                                          "\x00\x00\x01\xba"sv,
                                          "\x00\x00\x01\xb3"sv,
                                          "\x30\x26\xb2\x75"sv,
                                          "OggS"sv,
                                          "FLV"sv,
                                          "\xff\xd8\xff"sv};
  return is_mp4 || is_transport || (Begins(bytes, "RIFF") && Begins(bytes, "AVI ", 8)) ||
         std::any_of(std::begin(kOthers), std::end(kOthers),
                     [&](std::string_view begin) { return Begins(bytes, begin); });
}

}  // namespace clothfit
