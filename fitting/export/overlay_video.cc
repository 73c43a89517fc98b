// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/overlay_video.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "autodiff_sim/base/error.h"
#include "fitting/pictures/run_pictures.h"
#include "tracking/files/whole_file.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/silhouette/raster.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

const cv::Scalar kSimulated(255, 193, 63), kDark(20, 16, 12);  // BGR

int CameraIndex(const Recording& recording, const std::string& name) {
  if (recording.cameras.empty()) throw InputError(recording.path.string(), "has no camera");
  if (name.empty()) return 0;
  if (const std::optional<int> camera = FindCamera(recording, name)) return *camera;
  throw InputError("--camera", "'" + name + "': " + Suggestion(name, NamesOf(recording.cameras)));
}

// The outline twice, bright on dark, so that it shows on any ground.
void DrawOutline(const SilhouetteRaster& raster, const Eigen::VectorXd& x, cv::Mat* image) {
  BitMask mask(raster.camera().width, raster.camera().height);
  raster.Draw(x, &mask);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask.ToMat(), contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  cv::drawContours(*image, contours, -1, kDark, 4, cv::LINE_AA);
  cv::drawContours(*image, contours, -1, kSimulated, 2, cv::LINE_AA);
}

std::string VideoExtension(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension != ".mp4" && extension != ".avi") {
    throw InputError(file.string(), "expected a name that ends in .mp4 or .avi");
  }
  return extension;
}

// `place`: what an error names.
cv::VideoWriter OpenVideo(const fs::path& file, const fs::path& place, double rate,
                          const Camera& camera) {
  const std::string extension = place.extension().string();
  const int codec = extension == ".mp4" ? cv::VideoWriter::fourcc('m', 'p', '4', 'v')
                                        : cv::VideoWriter::fourcc('M', 'J', 'P', 'G');
  cv::VideoWriter video;
  const bool is_open =
      video.open(file.string(), codec, rate, cv::Size(camera.width, camera.height));
  if (!is_open) throw InputError(place.string(), "cannot be written");
  return video;
}

}  // namespace

void WriteOverlayVideo(const RunFolder& run, const RunMotion& motion, const OverlayOptions& options,
                       const fs::path& file, Overwrite overwrite) {
  const Recording fitted = ReadRecording(ReadConfigRecording(run.ConfigFile()));
  const std::optional<Recording> pictures = FindPictures(fitted, options.pictures).recording;
  if (!pictures) {
    throw InputError(run.path().string(),
                     "its recording has no pictures; expected some, or --pictures RECORDING");
  }
  const int index = CameraIndex(*pictures, options.camera);
  const Camera& camera = pictures->cameras[index];
  const SilhouetteRaster raster(camera, motion.mesh.triangles);
  ImageReader reader(*pictures, index);
  PartFile part(file, VideoExtension(file));
  cv::VideoWriter video = OpenVideo(part.path(), file, motion.frame_rate, camera);
  int written = 0;
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    cv::Mat image = reader.Load(static_cast<int>(f)).clone();
    if (image.empty()) continue;
    DrawOutline(raster, motion.frames[f], &image);
    video.write(image);
    ++written;
  }
  if (written == 0) throw InputError("--camera", "camera " + camera.name + " has no picture");
  video.release();
  CheckMayWrite(file, overwrite);
  part.MoveToPlace();
}

}  // namespace clothfit
