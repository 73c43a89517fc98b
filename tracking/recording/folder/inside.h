// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace clothfit {

// Throws InputError where the file, once its links are followed, lies outside of the recording's
// folder or in its truth/: a recording from a stranger must not read what else is on this machine.
void CheckLiesInside(const std::filesystem::path& recording_folder,
                     const std::filesystem::path& file);

// The same for one that is a link itself; nothing else is followed.
void CheckLinkLiesInside(const std::filesystem::path& recording_folder,
                         const std::filesystem::path& file);

}  // namespace clothfit
