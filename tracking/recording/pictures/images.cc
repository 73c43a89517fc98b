// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/pictures/images.h"

#include <array>
#include <cmath>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/pictures/bytes.h"
#include "tracking/recording/pictures/mask_correction.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

const Camera& CameraAt(const Recording& recording, int camera) {
  return recording.cameras.at(static_cast<size_t>(camera));
}

// Null where the recording has no pictures at all.
const CameraFiles* FilesOf(const Recording& recording, int camera) {
  if (recording.files.empty()) return nullptr;
  return &recording.files.at(static_cast<size_t>(camera));
}

constexpr const char* kNoPicture = "cannot be read as a PNG; it is damaged, cut off or none";

void CheckSize(int width, int height, const Camera& camera, const fs::path& file) {
  if (width == camera.width && height == camera.height) return;
  throw InputError(file.string(),
                   fmt::format("expected {} x {} px as in cameras.yaml, found {} x {}",
                               camera.width, camera.height, width, height));
}

// The bytes of a PNG of the camera's size.
std::string ReadPng(const fs::path& file, const Camera& camera) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // of the largest camera, uncompressed
  std::string bytes = ReadInputFile(file, kMostBytes);
  const std::optional<std::array<int, 2>> size = SizeOfPng(bytes);
  if (!size) throw InputError(file.string(), kNoPicture);
  CheckSize((*size)[0], (*size)[1], camera, file);
  return bytes;
}

cv::Mat LoadPicture(const fs::path& file, int flags, const Camera& camera) {
  const std::string bytes = ReadPng(file, camera);
  cv::Mat picture;
  try {
    picture = cv::imdecode(cv::Mat(1, static_cast<int>(bytes.size()), CV_8U,
                                   const_cast<char*>(bytes.data())),  // only read
                           flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception& error) {
    throw InputError(file.string(), "cannot be read as a picture (" + error.err + ")");
  }
  if (picture.empty()) throw InputError(file.string(), kNoPicture);
  return picture;
}

cv::Mat ReadMask(const fs::path& file, const Camera& camera) {
  cv::Mat mask = LoadPicture(file, cv::IMREAD_GRAYSCALE, camera);
  double brightest = 0.0;
  cv::minMaxLoc(mask, nullptr, &brightest);
  constexpr double kThreshold = 127.0;
  if (brightest > 0.0 && brightest <= kThreshold) {  // a mask of 0 and 1 would come out empty
    throw InputError(
        file.string(),
        fmt::format("expected 0 = background and 255 = cloth, found at most {}", brightest));
  }
  cv::threshold(mask, mask, kThreshold, 255.0, cv::THRESH_BINARY);
  return mask;
}

}  // namespace

cv::VideoCapture OpenVideo(const fs::path& file) {
  CheckInputFile(file, std::size_t{1} << 40);  // beyond any disk's: it is not read whole
  std::array<char, 512> begin{};
  std::ifstream(file, std::ios::binary).read(begin.data(), begin.size());
  cv::VideoCapture video;
  if (IsVideoContainer({begin.data(), begin.size()})) {
    try {
      // Not just any backend: some look for cameras on the bus and complain on the terminal.
      if (!video.open(file.string(), cv::CAP_FFMPEG))
        video.open(file.string(), cv::CAP_OPENCV_MJPEG);
    } catch (const cv::Exception&) {  // as one that is not open
    }
  }
  if (!video.isOpened()) throw InputError(file.string(), "cannot be read as a video");
  return video;
}

void CheckPictures(const Recording& recording) {
  const int cameras = static_cast<int>(recording.files.size());
  ParallelFor(cameras, 0, [&](int camera, int /*worker*/) {
    const CameraFiles& files = recording.files[static_cast<size_t>(camera)];
    const Camera& of_camera = CameraAt(recording, camera);
    if (files.background) LoadPicture(*files.background, cv::IMREAD_COLOR, of_camera);
    for (const auto& [frame, file] : files.images) LoadPicture(file, cv::IMREAD_COLOR, of_camera);
    for (const auto& [frame, file] : files.masks) ReadMask(file, of_camera);
    for (const auto& [frame, file] : files.depth) LoadDepthPicture(recording, camera, frame);
    if (!files.images.empty() || !files.video) return;
    ImageReader reader(recording, camera);
    for (int frame = 0; frame < recording.frame_count; ++frame)
      if (reader.Load(frame).empty()) break;
  });
}

cv::Mat LoadImage(const Recording& recording, int camera, int frame) {
  return ImageReader(recording, camera).Load(frame);
}

cv::Mat LoadMask(const Recording& recording, int camera, int frame) {
  const CameraFiles* const files = FilesOf(recording, camera);
  if (files == nullptr || files->masks.count(frame) == 0) return {};
  const auto load = [&](int at) {
    return ReadMask(files->masks.at(at), CameraAt(recording, camera));
  };
  const cv::Mat mask = load(frame);
  const MaskFaults& faults = files->mask_faults;
  if (faults == MaskFaults() || cv::countNonZero(mask) == 0) return mask;
  // A mask that was taken later than said shows a frame's cloth a little before that frame.
  const double moment = frame - faults.later;
  const int before = static_cast<int>(std::floor(moment));
  const bool is_between = files->masks.count(before) > 0 && files->masks.count(before + 1) > 0;
  if (faults.later != 0.0 && is_between) {
    const cv::Mat first = before == frame ? mask : load(before);
    const cv::Mat second = before + 1 == frame ? mask : load(before + 1);
    if (cv::countNonZero(first) > 0 && cv::countNonZero(second) > 0)
      return MaskBetween(first, second, moment - before, faults.fat);
  }
  return MaskBetween(mask, mask, 0.0, faults.fat);
}

cv::Mat LoadDepthPicture(const Recording& recording, int camera, int frame) {
  const CameraFiles* const files = FilesOf(recording, camera);
  if (files == nullptr || files->depth.count(frame) == 0) return {};
  const fs::path& file = files->depth.at(frame);
  cv::Mat depth = LoadPicture(file, cv::IMREAD_UNCHANGED, CameraAt(recording, camera));
  if (depth.type() == CV_16UC1) return depth;
  throw InputError(file.string(), fmt::format("expected one channel of 16 bits, found {} of {}",
                                              depth.channels(), 8 * depth.elemSize1()));
}

cv::Mat LoadBackground(const Recording& recording, int camera) {
  const CameraFiles* const files = FilesOf(recording, camera);
  if (files == nullptr || !files->background) return {};
  return LoadPicture(*files->background, cv::IMREAD_COLOR, CameraAt(recording, camera));
}

ImageReader::ImageReader(const Recording& recording, int camera)
    : recording_(recording), camera_(camera) {}
ImageReader::~ImageReader() = default;
ImageReader::ImageReader(ImageReader&&) noexcept = default;

cv::Mat ImageReader::Load(int frame) {
  const CameraFiles* const files = FilesOf(recording_, camera_);
  if (files == nullptr) return {};
  if (!files->images.empty()) {
    const auto image = files->images.find(frame);
    if (image == files->images.end()) return {};
    return LoadPicture(image->second, cv::IMREAD_COLOR, CameraAt(recording_, camera_));
  }
  return files->video ? LoadFromVideo(frame) : cv::Mat();
}

cv::Mat ImageReader::LoadFromVideo(int frame) {
  const fs::path& file = *FilesOf(recording_, camera_)->video;
  // Seeking is inexact in many containers, so going back means starting anew.
  if (video_ == nullptr || frame < next_frame_) {
    video_ = std::make_unique<cv::VideoCapture>(OpenVideo(file));
    CheckSize(cvRound(video_->get(cv::CAP_PROP_FRAME_WIDTH)),
              cvRound(video_->get(cv::CAP_PROP_FRAME_HEIGHT)), CameraAt(recording_, camera_), file);
    next_frame_ = 0;
  }
  const int count = cvRound(video_->get(cv::CAP_PROP_FRAME_COUNT));
  if (count > recording_.frame_count) {
    throw InputError(file.string(), fmt::format("expected at most {} frames as in recording.yaml, "
                                                "found {}",
                                                recording_.frame_count, count));
  }
  if (frame < 0 || frame >= count) return {};
  for (; next_frame_ < frame; ++next_frame_) video_->grab();
  cv::Mat picture;
  ++next_frame_;
  bool is_read = false;
  try {
    is_read = video_->read(picture);
  } catch (const cv::Exception&) {  // as one that is not read
  }
  if (!is_read || picture.empty()) {
    throw InputError(file.string(), fmt::format("frame {} of {} cannot be read", frame, count));
  }
  CheckSize(picture.cols, picture.rows, CameraAt(recording_, camera_), file);
  return picture;
}

}  // namespace clothfit
