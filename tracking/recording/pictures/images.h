// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The pictures of a recording, loaded one at a time when they are asked for.
//
// Every function returns an empty cv::Mat where the recording has no such picture, and throws
// InputError where there is one that cannot be read or has not the size of its camera.
#pragma once

#include <memory>

#include <opencv2/core/mat.hpp>

#include "tracking/recording/recording.h"

namespace cv {
class VideoCapture;
}

namespace clothfit {

// 8-bit BGR picture of a camera (index) at a frame, from images/ or else from videos/. For many
// frames of a video in a row ImageReader is much faster.
cv::Mat LoadImage(const Recording& recording, int camera, int frame);

// 8-bit, one channel: 255 where the cloth is, 0 elsewhere (values between are rounded). What is
// known to be wrong with the camera's masks is put right; the clock only where the masks around
// that moment are there and show cloth.
cv::Mat LoadMask(const Recording& recording, int camera, int frame);

// 16-bit, one channel, in units of the recording's depth_scales; 0 where nothing is known.
cv::Mat LoadDepthPicture(const Recording& recording, int camera, int frame);

// 8-bit BGR picture of the empty scene.
cv::Mat LoadBackground(const Recording& recording, int camera);

// Reads all pictures, masks and videos once, as tracking and fits do afterwards. Throws InputError
// for the first that is damaged or of another size than its camera's.
void CheckPictures(const Recording& recording);

// Throws InputError unless the file is a video in a container that holds its pictures itself.
cv::VideoCapture OpenVideo(const std::filesystem::path& file);

// Loads the pictures of one camera and keeps its video open in between. The recording must outlive
// it. Throws InputError when a video has more frames than the recording.
class ImageReader {
 public:
  ImageReader(const Recording& recording, int camera);
  ~ImageReader();
  ImageReader(ImageReader&&) noexcept;

  cv::Mat Load(int frame);

 private:
  cv::Mat LoadFromVideo(int frame);

  const Recording& recording_;
  int camera_;
  std::unique_ptr<cv::VideoCapture> video_;  // null until needed, or where there are images
  int next_frame_ = 0;                       // that the video would deliver
};

}  // namespace clothfit
