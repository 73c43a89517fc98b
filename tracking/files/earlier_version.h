// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Folders of version 0.1.0, which kept no manifest.
#pragma once

#include <filesystem>
#include <optional>

#include "tracking/files/manifest.h"

namespace clothfit {

// Known by what the files hold that this version began each kind of folder with, since others give
// their names, too; listed is what has the names that it gave. Recordings only where it simulated
// or tracked them: one that it imported looks as one made by hand does. Nothing where the folder is
// none of these.
std::optional<Manifest> FilesOfEarlierVersion(const std::filesystem::path& folder);

}  // namespace clothfit
