// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/synthetic/pictures.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/surface/cloth_surface.h"
#include "tracking/synthetic/picture_writer.h"
#include "tracking/synthetic/renderer.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using Eigen::Vector3d;

// The room around the whole motion.
Room RoomAround(const Recording& recording, const SyntheticSurface& surface) {
  Vector3d low = surface.positions.front().head<3>(), high = low;
  for (const Eigen::VectorXd& x : surface.positions) {
    for (Eigen::Index i = 0; i < x.size(); i += 3) {
      low = low.cwiseMin(x.segment<3>(i));
      high = high.cwiseMax(x.segment<3>(i));
    }
  }
  const double floor = FloorHeight(recording.ground_height, low.z(), recording.cloth.size);
  return MakeRoom({0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()), floor},
                  RoomScale(recording.cloth.size));
}

// What all cameras have in common.
struct Studio {
  const SyntheticPictureOptions& options;
  std::uint64_t seed;
  const Recording& recording;
  const SyntheticSurface& surface;
  Room room;
  ClothLook cloth;
  PlaneTexture floor;
  Sensor sensor;
};

Sensor SensorOf(const SyntheticPictureOptions& options) {
  Sensor sensor;
  sensor.noise = options.noise;
  sensor.shot_noise = options.shot_noise;
  return sensor;
}

constexpr int kBackgroundPictures = 16;  // that a background is the mean of

// One stream of noise a picture; frame -1 is the background.
std::uint64_t Stream(const Studio& studio, int camera, int frame) {
  const int pictures = studio.recording.frame_count + 1;
  return 1000 + static_cast<std::uint64_t>(camera) * static_cast<std::uint64_t>(pictures) +
         static_cast<std::uint64_t>(frame + 1);
}

// What reaches the camera at a frame: the mean over the exposure, whose middle is the frame's time.
cv::Mat Brightness(const Studio& studio, const Renderer& renderer, int frame, ClothSurface* cloth) {
  const SyntheticPictureOptions& options = studio.options;
  const double time = frame / studio.recording.frame_rate;
  if (options.exposure <= 0.0) {
    cloth->MoveTo(studio.surface.At(time));
    return renderer.Render(*cloth);
  }
  cv::Mat sum;
  for (int k = 0; k < options.exposure_samples; ++k) {
    const double share = (k + 0.5) / options.exposure_samples - 0.5;
    cloth->MoveTo(studio.surface.At(time + share * options.exposure));
    const cv::Mat one = renderer.Render(*cloth);
    if (sum.empty()) {
      sum = one;
    } else {
      sum += one;
    }
  }
  cloth->MoveTo(studio.surface.At(time));
  return cv::Mat(sum / options.exposure_samples);
}

void WriteCamera(const Studio& studio, int camera, const fs::path& folder,
                 const std::function<void()>& count_picture) {
  const SyntheticPictureOptions& options = studio.options;
  const Camera& one = studio.recording.cameras[static_cast<std::size_t>(camera)];
  const int num_threads = NumThreads(options.threads);
  const Renderer renderer(one, studio.room, studio.cloth, studio.floor, options.samples,
                          num_threads);
  const Sensor calm = Averaged(studio.sensor, kBackgroundPictures);
  WritePicture(Expose(renderer.empty(), calm, 1.0, studio.seed, Stream(studio, camera, -1)),
               folder / "background" / (one.name + ".png"));
  std::vector<ClothSurface> cloths;
  for (int i = 0; i < num_threads; ++i) cloths.emplace_back(studio.surface.mesh);
  FrameWriter writer(folder, one, studio.recording.frame_rate, options.video);
  // Some at a time: a video takes them in order.
  const int at_a_time = 4 * num_threads, frame_count = studio.recording.frame_count;
  for (int first = 0; first < frame_count; first += at_a_time) {
    const int count = std::min(at_a_time, frame_count - first);
    std::vector<cv::Mat> pictures(static_cast<std::size_t>(count));
    ParallelFor(count, num_threads, [&](int i, int worker) {
      const int frame = first + i;
      ClothSurface& cloth = cloths[static_cast<std::size_t>(worker)];
      const cv::Mat brightness = Brightness(studio, renderer, frame, &cloth);
      const double gain = LightGain(frame / studio.recording.frame_rate, options.light_drift);
      cv::Mat& picture = pictures[static_cast<std::size_t>(i)];
      picture = Expose(brightness, studio.sensor, gain, studio.seed, Stream(studio, camera, frame));
      if (!writer.is_video()) writer.Write(frame, picture);
      WritePicture(renderer.Mask(cloth), FrameFile(folder / "truth" / "masks", one, frame));
      count_picture();
    });
    for (int i = 0; i < count && writer.is_video(); ++i)
      writer.Write(first + i, pictures[static_cast<std::size_t>(i)]);
  }
}

}  // namespace

void SyntheticPictureOptions::Check(const Expect& expect) const {
  const auto within = [](double value, double most) { return value >= 0.0 && value <= most; };
  expect(size.minCoeff() >= 16 && size.maxCoeff() <= 8192, "picture_size", "16 to 8192 px");
  expect(within(specular, 10.0), "specular", "a share from 0 to 10");
  expect(samples >= 1 && samples <= 16, "samples", "1 to 16 along x and y");
  expect(within(noise, 255.0), "sensor_noise", "0 to 255 grey levels");
  expect(within(shot_noise, 255.0), "shot_noise", "0 to 255 grey levels");
  expect(within(light_drift, 0.9), "light_drift", "a share from 0 to 0.9");
  expect(within(exposure, 1.0), "exposure", "0 to 1 s");
  expect(exposure_samples >= 1 && exposure_samples <= 1000, "exposure_samples", "1 to 1000");
  expect(threads >= 0 && threads <= 1024, "threads", "0 to 1024");
  const std::vector<std::string>& containers = VideoContainers();
  const bool is_container =
      std::find(containers.begin(), containers.end(), video) != containers.end();
  expect(video.empty() || is_container, "video", JoinNames(containers) + " or none");
}

Eigen::VectorXd SyntheticSurface::At(double time) const {
  const double place = std::clamp(time / interval, 0.0, static_cast<double>(positions.size() - 1));
  const std::size_t before = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(before);
  // Rounding must not make a frame a mixture.
  constexpr double kSame = 1e-6;
  if (rest < kSame) return positions[before];
  if (rest > 1.0 - kSame) return positions[before + 1];
  return (1.0 - rest) * positions[before] + rest * positions[before + 1];
}

std::vector<std::string> SyntheticPictureFiles(const SyntheticPictureOptions& options,
                                               const Recording& recording) {
  std::vector<std::string> files;
  for (const Camera& camera : recording.cameras) {
    files.push_back("background/" + camera.name + ".png");
    if (!options.video.empty()) files.push_back("videos/" + camera.name + "." + options.video);
    for (int frame = 0; frame < recording.frame_count; ++frame) {
      files.push_back(FrameFile("truth/masks", camera, frame).string());
      if (options.video.empty()) files.push_back(FrameFile("images", camera, frame).string());
    }
  }
  return files;
}

void WriteSyntheticPictures(const SyntheticPictureOptions& options, std::uint64_t seed,
                            const Recording& recording, const SyntheticSurface& surface,
                            const fs::path& folder, const SyntheticProgress& progress) {
  const Studio studio{
      options,
      seed,
      recording,
      surface,
      RoomAround(recording, surface),
      {MakeClothTexture(options.pattern, recording.cloth.size, seed), options.specular},
      MakeFloorTexture(),
      SensorOf(options)};
  const int num_cameras = static_cast<int>(recording.cameras.size());
  std::mutex mutex;
  int done = 0;
  for (int camera = 0; camera < num_cameras; ++camera) {
    const std::string& name = recording.cameras[static_cast<std::size_t>(camera)].name;
    WriteCamera(studio, camera, folder, [&] {
      const std::lock_guard<std::mutex> lock(mutex);
      ++done;
      if (progress)
        progress(static_cast<double>(done) / (num_cameras * recording.frame_count), name);
    });
  }
}

}  // namespace clothfit
