// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/pictures/images.h"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <zlib.h>

#include "tests/support/test_folder.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using testing::HasSubstr;

constexpr int kWidth = 32;
constexpr int kHeight = 24;

// A recording of one camera with no pictures yet.
Recording EmptyRecording(const TestFolder& folder) {
  Recording recording;
  recording.path = folder.path();
  recording.frame_count = 6;
  Camera camera;
  camera.name = "cam0";
  camera.width = kWidth;
  camera.height = kHeight;
  recording.cameras = {camera};
  recording.files.resize(1);
  return recording;
}

cv::Mat Grey(int value, int width = kWidth) {
  return cv::Mat(kHeight, width, CV_8UC1, cv::Scalar(value));
}

std::string WritePng(const TestFolder& folder, const std::string& name, const cv::Mat& picture) {
  std::string file = (folder.path() / name).string();
  EXPECT_TRUE(cv::imwrite(file, picture));
  return file;
}

TEST(LoadImage, LoadsColoursOfTheFrameAsked) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  recording.files[0].images[2] =
      WritePng(folder, "a.png", cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar(10, 20, 30)));
  const cv::Mat image = LoadImage(recording, 0, 2);
  ASSERT_EQ(image.type(), CV_8UC3);
  EXPECT_EQ(image.at<cv::Vec3b>(5, 5), cv::Vec3b(10, 20, 30));
  EXPECT_TRUE(LoadImage(recording, 0, 1).empty());
  recording.files.clear();
  EXPECT_TRUE(LoadImage(recording, 0, 2).empty());
}

TEST(LoadImage, RefusesWrongSizes) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  recording.files[0].images[0] = WritePng(folder, "a.png", Grey(9, kWidth + 1));
  EXPECT_THAT(InputErrorOf([&] { LoadImage(recording, 0, 0); }),
              HasSubstr("a.png: expected 32 x 24 px as in cameras.yaml, found 33 x 24"));
}

TEST(LoadImage, RefusesDamagedFiles) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  cv::Mat noise(kHeight, kWidth, CV_8UC3);
  cv::randu(noise, 0, 255);
  const std::string whole = ReadTextFile(WritePng(folder, "whole.png", noise));
  for (const double part : {0.0, 0.01, 0.5, 0.9}) {
    const size_t length = static_cast<size_t>(part * static_cast<double>(whole.size()));
    recording.files[0].images[0] = folder.Write("cut.png", whole.substr(0, length));
    EXPECT_THAT(InputErrorOf([&] { LoadImage(recording, 0, 0); }),
                HasSubstr("cut.png: cannot be read as a PNG"))
        << part;
  }
  recording.files[0].images[0] = folder.Write("whole.png", whole);
  EXPECT_NO_THROW(LoadImage(recording, 0, 0));
}

// A PNG whose chunks are as they should be, of pixels that cannot be unpacked.
std::string PngOfNonsense(std::string png) {
  const std::size_t kind = png.find("IDAT"), end = png.size() - 16;  // before the last two sums
  for (std::size_t i = kind + 4; i < end; ++i) png[i] = '\xff';
  const uLong sum =
      crc32(0, reinterpret_cast<const Bytef*>(&png[kind]), static_cast<uInt>(end - kind));
  for (std::size_t i = 0; i < 4; ++i) png[end + i] = static_cast<char>(sum >> (24 - 8 * i));
  return png;
}

TEST(CheckPictures, UnpacksThem) {
  const TestFolder folder;
  const Recording recording = EmptyRecording(folder);
  const std::string png = ReadTextFile(WritePng(folder, "whole.png", Grey(9)));
  const std::string whole = folder.Write("whole.png", png);
  const std::string bad = folder.Write("bad.png", PngOfNonsense(png));
  const auto problem = [&](const std::function<void(CameraFiles*)>& put) {
    Recording with = recording;
    put(&with.files[0]);
    return InputErrorOf([&] { CheckPictures(with); });
  };
  const auto is_bad = HasSubstr("bad.png: cannot be read as a PNG");
  EXPECT_THAT(problem([&](CameraFiles* files) { files->images[0] = bad; }), is_bad);
  EXPECT_THAT(problem([&](CameraFiles* files) { files->background = bad; }), is_bad);
  EXPECT_THAT(problem([&](CameraFiles* files) { files->depth[0] = bad; }), is_bad);
  EXPECT_THAT(problem([&](CameraFiles* files) { files->depth[0] = whole; }),
              HasSubstr("whole.png: expected one channel of 16 bits"));
}

TEST(LoadMask, IsEitherClothOrNot) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  cv::Mat mask = Grey(0);
  mask.at<uchar>(3, 4) = 255;
  mask.at<uchar>(3, 5) = 128;
  mask.at<uchar>(3, 6) = 127;
  recording.files[0].masks[1] = WritePng(folder, "mask.png", mask);
  const cv::Mat loaded = LoadMask(recording, 0, 1);
  ASSERT_EQ(loaded.type(), CV_8UC1);
  EXPECT_EQ(loaded.at<uchar>(3, 4), 255);
  EXPECT_EQ(loaded.at<uchar>(3, 5), 255);
  EXPECT_EQ(cv::countNonZero(loaded), 2);
  EXPECT_TRUE(LoadMask(recording, 0, 0).empty());
}

TEST(LoadMask, MayBeEmptyOfClothButNotDark) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  recording.files[0].masks[0] = WritePng(folder, "black.png", Grey(0));
  EXPECT_EQ(cv::countNonZero(LoadMask(recording, 0, 0)), 0);
  recording.files[0].masks[0] = WritePng(folder, "ones.png", Grey(1));
  EXPECT_THAT(InputErrorOf([&] { LoadMask(recording, 0, 0); }),
              HasSubstr("ones.png: expected 0 = background and 255 = cloth, found at most 1"));
}

// A rectangle from `left` to `right`, px, as a mask of a frame.
void AddRectangle(const TestFolder& folder, int frame, int left, int right, Recording* recording) {
  cv::Mat mask = Grey(0);
  mask(cv::Range(0, mask.rows), cv::Range(left, right)) = 255;
  recording->files[0].masks[frame] = WritePng(folder, std::to_string(frame) + ".png", mask);
}

// Columns of a loaded mask in which there is cloth.
cv::Range ColumnsOf(const cv::Mat& mask) {
  const cv::Rect box = cv::boundingRect(mask);
  return {box.x, box.x + box.width};
}

TEST(LoadMask, IsOfTheSaidMomentWhereItIsKnownThatItWasTakenLater) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  for (int frame = 0; frame < 3; ++frame)  // four pixels a frame to the right
    AddRectangle(folder, frame, 2 + 4 * frame, 14 + 4 * frame, &recording);
  MaskFaults& faults = recording.files[0].mask_faults;
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 1)), cv::Range(6, 18));
  faults.later = 0.5;
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 1)), cv::Range(4, 16));
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 0)), cv::Range(2, 14));  // none before it
  faults.later = -0.25;
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 1)), cv::Range(7, 19));
  faults.later = 1.0;
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 2)), cv::Range(6, 18));
}

TEST(LoadMask, IsAsFatAsItShouldBe) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  AddRectangle(folder, 0, 4, 12, &recording);
  recording.files[0].mask_faults.fat = 2.0;
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 0)), cv::Range(6, 10));
  recording.files[0].mask_faults.fat = -1.0;
  EXPECT_EQ(ColumnsOf(LoadMask(recording, 0, 0)), cv::Range(3, 13));
}

TEST(LoadBackground, LoadsItWhereThereIsOne) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  EXPECT_TRUE(LoadBackground(recording, 0).empty());
  recording.files[0].background = WritePng(folder, "b.png", Grey(77));
  EXPECT_EQ(LoadBackground(recording, 0).at<cv::Vec3b>(0, 0), cv::Vec3b(77, 77, 77));
}

// Frame i of the video is grey with value 40 * (i + 1).
void WriteVideo(const std::string& file, int frame_count) {
  cv::VideoWriter writer(file, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                         30.0, cv::Size(kWidth, kHeight));
  ASSERT_TRUE(writer.isOpened());
  for (int i = 0; i < frame_count; ++i) {
    writer.write(cv::Mat(kHeight, kWidth, CV_8UC3, cv::Scalar::all(40 * (i + 1))));
  }
}

TEST(ImageReader, ReadsAVideoInAnyOrder) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  recording.files[0].video = folder.path() / "cam0.avi";
  WriteVideo(recording.files[0].video->string(), 4);
  ImageReader reader(recording, 0);
  int checked = 0;
  for (const int frame : {0, 1, 3, 2, 0, 2}) {
    const cv::Mat image = reader.Load(frame);
    ASSERT_FALSE(image.empty());
    EXPECT_NEAR(image.at<cv::Vec3b>(5, 5)[0], 40 * (frame + 1), 4);  // JPEG is lossy
    ++checked;
  }
  EXPECT_EQ(checked, 6);
  EXPECT_TRUE(reader.Load(4).empty());  // shorter than the recording
  EXPECT_NEAR(LoadImage(recording, 0, 3).at<cv::Vec3b>(5, 5)[0], 160, 4);
}

TEST(ImageReader, PrefersImagesToAVideo) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  recording.files[0].video = folder.path() / "none.avi";
  recording.files[0].images[0] = WritePng(folder, "a.png", Grey(5));
  EXPECT_EQ(ImageReader(recording, 0).Load(0).at<cv::Vec3b>(0, 0)[0], 5);
  EXPECT_TRUE(ImageReader(recording, 0).Load(1).empty());
}

TEST(ImageReader, RefusesWrongVideos) {
  const TestFolder folder;
  Recording recording = EmptyRecording(folder);
  recording.files[0].video = folder.Write("broken.avi", "no video");
  EXPECT_THAT(InputErrorOf([&] { LoadImage(recording, 0, 0); }),
              HasSubstr("broken.avi: cannot be read as a video"));
  recording.files[0].video = folder.path() / "long.avi";
  WriteVideo(recording.files[0].video->string(), 8);
  EXPECT_THAT(InputErrorOf([&] { LoadImage(recording, 0, 0); }),
              HasSubstr("long.avi: expected at most 6 frames as in recording.yaml, found 8"));
  recording.frame_count = 8;
  recording.cameras[0].width = 31;
  EXPECT_THAT(InputErrorOf([&] { LoadImage(recording, 0, 0); }),
              HasSubstr("expected 31 x 24 px as in cameras.yaml, found 32 x 24"));
}

}  // namespace
}  // namespace clothfit
