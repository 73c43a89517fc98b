// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Where the pictures of a run's cameras are: a run that tracked them itself fits a recording that
// has none.
#pragma once

#include <filesystem>
#include <optional>

#include "tracking/recording/recording.h"

namespace clothfit {

struct RunPictures {
  std::optional<Recording> recording;  // empty where there are none
  bool are_lost = false;               // there were some, but they are no longer where they were
};

// Looks where it is `asked` to (empty: nowhere), in the run's recording, and in the one that was
// tracked for it. Throws InputError where `asked` is no recording with pictures.
RunPictures FindPictures(const Recording& recording, const std::filesystem::path& asked);

}  // namespace clothfit
