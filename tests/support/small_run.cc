// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/small_run.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "fitting/runs/fit_run.h"
#include "tests/support/small_recording.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

Camera MakeCamera(const std::string& name, double side) {
  Camera camera;
  camera.name = name;
  camera.width = 160;
  camera.height = 120;
  camera.fx = camera.fy = 150.0;
  camera.cx = 79.5;
  camera.cy = 59.5;
  // looks along +y, from 1.5 m before the cloth; x stays to the right and the image's y is -z
  camera.camera_from_world_rotation << 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0;
  camera.camera_from_world_translation << side, 0.9, 1.5;
  return camera;
}

// A picture with a white square, and the square as its mask.
void WritePictures(const fs::path& folder, const Camera& camera, int frames) {
  for (const char* kind : {"images", "masks"}) fs::create_directories(folder / kind / camera.name);
  for (int frame = 0; frame < frames; ++frame) {
    cv::Mat mask(camera.height, camera.width, CV_8UC1, cv::Scalar(0));
    cv::rectangle(mask, {50 + frame, 40}, {100, 90}, cv::Scalar(255), cv::FILLED);
    cv::Mat image;
    cv::cvtColor(mask, image, cv::COLOR_GRAY2BGR);
    const std::string name = fmt::format("{:06d}.png", frame);
    cv::imwrite((folder / "masks" / camera.name / name).string(), mask);
    cv::imwrite((folder / "images" / camera.name / name).string(), image);
  }
}

}  // namespace

fs::path MakeSmallRun(const fs::path& folder) {
  SmallRecordingOptions options;
  options.particles = 5;
  options.frames = 12;
  Recording recording = MakeSmallRecording(options);
  recording.cameras = {MakeCamera("front", -0.2), MakeCamera("side", 0.1)};
  WriteRecording(recording, folder / "rec");
  for (const Camera& camera : recording.cameras) {
    WritePictures(folder / "rec", camera, options.frames);
  }
  recording = ReadRecording(folder / "rec");
  FitConfig config = DefaultConfig(recording);
  config.recording = (folder / "rec").string();
  config.use_silhouettes = false;
  config.coarse_resolution = 0;
  config.max_iterations = 3;
  const Scene scene = MakeScene(recording, config);
  const RunFolder run(folder / "run", RunFolder::Existing::kReplace);
  FitIntoRun(scene, config, run, {}, false);
  return run.path();
}

}  // namespace clothfit
