// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which pictures a recording's folder holds: images/, masks/, depth/, background/ and videos/; and
// which clouds.
#pragma once

#include <filesystem>
#include <vector>

#include "tracking/recording/recording.h"

namespace clothfit {

// The folders above that exist in the recording's folder and are not empty.
std::vector<std::string> PictureFolders(const std::filesystem::path& recording_folder);

// Lists the pictures of every camera without opening any. Throws InputError on a camera that
// cameras.yaml does not know, a name that is none of the format's, or a frame outside the
// recording. Names that start with a dot are passed over.
std::vector<CameraFiles> ListPictures(const Recording& recording);

// clouds/000000.ply, .pcd or .csv, by frame; likewise, and one a frame.
std::map<int, std::filesystem::path> ListClouds(const Recording& recording);

}  // namespace clothfit
