// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Folders of numbered pictures, as programs write that take a video apart.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "tracking/files/output_folder.h"

namespace clothfit {

struct PictureFolder {
  std::map<int, std::filesystem::path> pictures;  // by the number at the end of their names
  int width = 0;                                  // px, of all
  int height = 0;                                 // px

  int first() const { return pictures.begin()->first; }
  int last() const { return pictures.rbegin()->first; }
};

// Width and height (px) of a PNG. Throws InputError where the file is none, damaged or too large.
std::array<int, 2> InspectPng(const std::filesystem::path& file);

// Looks at every PNG in the folder, such as 000001.png or left_17.png, and passes over all else.
// Throws InputError where there is none, one has no number or that of another, is damaged or of
// another size.
PictureFolder InspectPictures(const std::filesystem::path& folder);

// images/CAMERA/000000.png and so on, of the number `first`, with the pictures to copy there.
std::map<std::string, std::filesystem::path> PlacesOfPictures(const PictureFolder& folder,
                                                              const std::string& camera, int first);

// One file, or of the same bytes.
bool IsSameFile(const std::filesystem::path& copy, const std::filesystem::path& file);

// Copies the file to this place in the recording, whole or not at all; `name` is listed already.
void CopyInto(const std::filesystem::path& file, const std::string& name,
              const OutputFolder& recording);

// Copies all to their places. Pictures of the camera that an earlier import wrote and this one does
// not are removed.
void CopyPictures(const std::string& camera, const PictureFolder& folder, int first,
                  OutputFolder* output);

}  // namespace clothfit
