// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

namespace clothfit {

// Width and height (px) of a PNG whose chunks are all there and have their checksums; nothing where
// the bytes are none or are damaged. So a decoder sees nothing larger than was asked about.
std::optional<std::array<int, 2>> SizeOfPng(std::string_view bytes);

// Whether bytes begin as those of a container of videos do: MP4 and QuickTime, Matroska and WebM,
// AVI, MPEG, ASF, Ogg, FLV, or JPEG pictures one after the other. Lists of other files, which
// FFmpeg follows too, are none.
bool IsVideoContainer(std::string_view bytes);

}  // namespace clothfit
