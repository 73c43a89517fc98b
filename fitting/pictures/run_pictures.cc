// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/pictures/run_pictures.h"

#include "autodiff_sim/base/error.h"
#include "tracking/features/tracking_folder.h"

namespace clothfit {

RunPictures FindPictures(const Recording& recording, const std::filesystem::path& asked) {
  if (!asked.empty()) {
    Recording found = ReadRecording(asked);
    if (!HasPictures(found)) throw InputError(asked.string(), "has neither images nor videos");
    return {std::move(found)};
  }
  if (HasPictures(recording)) return {recording};
  const std::optional<std::filesystem::path> origin = OriginOfTracking(recording.path);
  if (!origin) return {};
  try {
    return {ReadRecording(*origin)};
  } catch (const InputError&) {
    return {std::nullopt, true};
  }
}

}  // namespace clothfit
