// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/picture_writer.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "autodiff_sim/base/error.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

int FourCc(const std::string& container) {
  if (container == "mp4") return cv::VideoWriter::fourcc('m', 'p', '4', 'v');
  if (container == "avi") return cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
  return cv::VideoWriter::fourcc('F', 'F', 'V', '1');
}

}  // namespace

void WritePicture(const cv::Mat& picture, const fs::path& file) {
  MakeFolder(file.parent_path());
  bool is_written = false;
  try {
    is_written = cv::imwrite(file.string(), picture);
  } catch (const cv::Exception&) {
    is_written = false;
  }
  if (!is_written) throw InputError(file.string(), "cannot be written");
}

const std::vector<std::string>& VideoContainers() {
  static const std::vector<std::string> containers = {"mkv", "mp4", "avi"};
  return containers;
}

fs::path FrameFile(const fs::path& folder, const Camera& camera, int frame) {
  return folder / camera.name / fmt::format("{:06}.png", frame);
}

FrameWriter::FrameWriter(const fs::path& recording_folder, const Camera& camera, double frame_rate,
                         const std::string& video)
    : folder_(recording_folder / (video.empty() ? "images" : "videos")), camera_(camera) {
  if (video.empty()) return;
  MakeFolder(folder_);
  const fs::path file = folder_ / (camera.name + "." + video);
  video_ = std::make_unique<cv::VideoWriter>(file.string(), cv::CAP_FFMPEG, FourCc(video),
                                             frame_rate, cv::Size(camera.width, camera.height));
  if (!video_->isOpened()) throw InputError(file.string(), "cannot be written as a video");
}

FrameWriter::~FrameWriter() = default;

void FrameWriter::Write(int frame, const cv::Mat& picture) {
  if (is_video()) {
    video_->write(picture);
  } else {
    WritePicture(picture, FrameFile(folder_, camera_, frame));
  }
}

}  // namespace clothfit
