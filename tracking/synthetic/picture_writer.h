// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Writing the pictures of a recording's folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "tracking/camera/camera.h"

namespace cv {
class VideoWriter;
}

namespace clothfit {

// PNG; makes the folder. Throws InputError where it cannot be written.
void WritePicture(const cv::Mat& picture, const std::filesystem::path& file);

// FOLDER/CAMERA/000042.png.
std::filesystem::path FrameFile(const std::filesystem::path& folder, const Camera& camera,
                                int frame);

// mp4 (MPEG-4, loses a little), avi (Motion JPEG, likewise), mkv (FFV1, loses nothing).
const std::vector<std::string>& VideoContainers();

// The frames of one camera, as images/CAMERA/%06d.png or videos/CAMERA.container.
class FrameWriter {
 public:
  // `video`: empty for PNG, else the container. Throws InputError where it cannot be written.
  FrameWriter(const std::filesystem::path& recording_folder, const Camera& camera,
              double frame_rate, const std::string& video);
  ~FrameWriter();

  bool is_video() const { return video_ != nullptr; }
  // 8-bit BGR. A video wants all frames in order, from one thread.
  void Write(int frame, const cv::Mat& picture);

 private:
  std::filesystem::path folder_;
  const Camera& camera_;
  std::unique_ptr<cv::VideoWriter> video_;  // null: PNG
};

}  // namespace clothfit
