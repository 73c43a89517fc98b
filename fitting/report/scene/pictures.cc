// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for a page: as JPEG, smaller, and no more than fit its size.
#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "autodiff_sim/base/parallel.h"
#include "fitting/report/scene/cameras.h"
#include "tracking/recording/pictures/images.h"

namespace clothfit {
namespace {

using Json = ReportBlobs::Json;

cv::Size FittingSize(const cv::Mat& image, int width) {
  if (image.cols <= width) return image.size();
  return {width, std::max(1, cvRound(static_cast<double>(width) * image.rows / image.cols))};
}

std::vector<unsigned char> EncodePicture(const cv::Mat& image, const PictureSize& size) {
  cv::Mat small = image;
  const cv::Size wanted = FittingSize(image, size.width);
  if (wanted != image.size()) cv::resize(image, small, wanted, 0.0, 0.0, cv::INTER_AREA);
  std::vector<unsigned char> bytes;
  cv::imencode(".jpg", small, bytes,
               {cv::IMWRITE_JPEG_QUALITY, size.quality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
  return bytes;
}

// Bytes of one picture of every camera together; a camera without a picture at the frame has none.
std::int64_t BytesOfFrame(const std::vector<cv::Mat>& frame, const PictureSize& size) {
  std::int64_t bytes = 0;
  for (const cv::Mat& image : frame) {
    if (!image.empty()) bytes += static_cast<std::int64_t>(EncodePicture(image, size).size());
  }
  return bytes;
}

struct CameraPictures {
  std::string bytes;
  std::vector<int> frames;
  std::vector<std::size_t> ends;  // in bytes
  cv::Size size;
};

CameraPictures EncodeCamera(const Recording& recording, int camera, const PictureSize& size) {
  CameraPictures pictures;
  ImageReader reader(recording, camera);
  for (int frame = 0; frame < recording.frame_count; frame += size.stride) {
    const cv::Mat image = reader.Load(frame);
    if (image.empty()) continue;
    const std::vector<unsigned char> jpeg = EncodePicture(image, size);
    pictures.bytes.append(jpeg.begin(), jpeg.end());
    pictures.frames.push_back(frame);
    pictures.ends.push_back(pictures.bytes.size());
    pictures.size = FittingSize(image, size.width);
  }
  return pictures;
}

}  // namespace

PictureSize ChoosePictureSize(const Recording& pictures, const PictureSize& wanted,
                              std::int64_t bytes) {
  std::vector<cv::Mat> sample;
  for (int c = 0; c < static_cast<int>(pictures.cameras.size()); ++c) {
    sample.push_back(ImageReader(pictures, c).Load(pictures.frame_count / 2));
  }
  // Of few pictures the size matters more, of many the number: both fall in turn.
  const double scales[] = {1.0, 1.0, 0.8, 0.8, 0.65, 0.65, 0.5};
  const int strides[] = {1, 2, 2, 3, 3, 4, 4};
  PictureSize size = wanted;
  for (std::size_t i = 0; i < std::size(scales); ++i) {
    size.width = std::max(16, static_cast<int>(scales[i] * wanted.width));
    size.stride = strides[i] * wanted.stride;
    const std::int64_t frames = (pictures.frame_count + size.stride - 1) / size.stride;
    const std::int64_t whole = frames * BytesOfFrame(sample, size);
    if (whole <= bytes) return size;
    if (i + 1 == std::size(scales)) {
      size.stride *= static_cast<int>(std::min<std::int64_t>(
          pictures.frame_count, whole / std::max<std::int64_t>(1, bytes) + 1));
    }
  }
  return size;
}

void AddPictures(const Recording& pictures, const PictureSize& size, ReportBlobs* blobs,
                 Json* cameras, std::vector<std::string>* notes) {
  const auto count = static_cast<int>(pictures.cameras.size());
  std::vector<CameraPictures> encoded(pictures.cameras.size());
  ParallelFor(count, 0,
              [&](int camera, int) { encoded[camera] = EncodeCamera(pictures, camera, size); });
  bool is_smaller = false;
  for (Json& json : *cameras) {
    const std::optional<int> camera = FindCamera(pictures, json.at("name"));
    if (!camera || encoded[*camera].frames.empty()) continue;
    CameraPictures& one = encoded[*camera];
    is_smaller = is_smaller || one.size.width < json.at("size")[0];
    json["pictures"] = blobs->AddBytes(std::move(one.bytes));
    json["pictures"]["size"] = {one.size.width, one.size.height};
    json["pictures"]["frames"] = one.frames;
    json["pictures"]["ends"] = one.ends;
  }
  if (is_smaller || size.stride > 1) {
    notes->push_back(fmt::format(
        "To keep this page small its pictures are at most {} px wide{}; the fit used all of them.",
        size.width, size.stride > 1 ? fmt::format(" and one in {} frames", size.stride) : ""));
  }
}

}  // namespace clothfit
