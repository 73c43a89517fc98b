// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Videos, and folders of pictures, that are put into a recording.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tracking/recording/folder/start.h"

namespace clothfit {

struct NamedVideo {
  std::string camera;
  std::filesystem::path file;  // or a folder of numbered PNGs
};

struct VideoFacts {
  int width = 0;   // px
  int height = 0;  // px
  int frame_count = 0;
  double frame_rate = 0.0;  // Hz, as the container says
};

// Throws InputError on a file that is no video, has no frame that can be read or does not say how
// many there are.
VideoFacts InspectVideo(const std::filesystem::path& file);

struct ImportedVideos {
  int frame_count = 0;      // of the longest
  double frame_rate = 0.0;  // Hz, of all
  std::vector<std::string> notes;
};

// Copies the videos to FOLDER/videos/CAMERA.*, each with its own extension, and never moves one;
// pictures to FOLDER/images/CAMERA/ and backgrounds, PNGs of a video's size, to
// FOLDER/background/CAMERA.*. The smallest number of all folders is frame 0; they say no rate.
//
// Where cameras.yaml is there, cameras and sizes have to agree with it. Where recording.yaml is
// there, its frame rate has to be that of the videos and its frame count no less than theirs, or
// both are set where overwriting is allowed. Otherwise recording.yaml is written, if `start` has
// what videos do not know; a frame rate in `start` goes before that of the containers. Everything
// is checked, and InputError thrown, before anything is written.
ImportedVideos ImportVideos(const std::vector<NamedVideo>& videos, SceneStart start,
                            const std::filesystem::path& folder, Overwrite overwrite,
                            const std::vector<NamedVideo>& backgrounds = {});

}  // namespace clothfit
