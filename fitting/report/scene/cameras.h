// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Cameras of a report, the outlines measured in them, and their pictures as small as need be.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fitting/report/page/blobs.h"
#include "fitting/report/scene/scene.h"

namespace clothfit {

struct PictureSize {
  int width = 480;   // px at most
  int quality = 70;  // of JPEG, 0 to 100
  int stride = 1;    // every n-th frame
};

// The first size of a falling series, none wider than `wanted`, whose pictures of all cameras and
// frames come to no more than `bytes`, as one picture of each camera tells.
PictureSize ChoosePictureSize(const Recording& pictures, const PictureSize& wanted,
                              std::int64_t bytes);

// One JSON object a camera of the run's recording: its lens and place, and its measured outlines.
ReportBlobs::Json CamerasAsJson(const ReportScene& report, ReportBlobs* blobs);

// Adds the pictures to the cameras of the same name; says on the page what was left out.
void AddPictures(const Recording& pictures, const PictureSize& size, ReportBlobs* blobs,
                 ReportBlobs::Json* cameras, std::vector<std::string>* notes);

}  // namespace clothfit
