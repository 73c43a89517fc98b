// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/warnings/silhouette.h"

#include <algorithm>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/recording/surface/initial_placement.h"
#include "tracking/recording/warnings/placement.h"
#include "tracking/silhouette/raster.h"
#include "tracking/silhouette/silhouette.h"

namespace clothfit {
namespace {

constexpr double kTrusted = 0.8;  // of Silhouette::quality

// 255 where the camera saw the cloth at first; empty where it is not known, or not seen soon.
cv::Mat FirstMask(const Recording& recording, int camera) {
  const CameraFiles& files = recording.files[static_cast<size_t>(camera)];
  if (!files.masks.empty()) {
    const int frame = files.masks.begin()->first;
    return frame > kFirstSeenWithin * recording.frame_rate ? cv::Mat()
                                                           : LoadMask(recording, camera, frame);
  }
  const cv::Mat background = LoadBackground(recording, camera);
  if (background.empty()) return {};
  const cv::Mat image = LoadImage(recording, camera, 0);
  if (image.empty()) return {};
  const Silhouette silhouette = SilhouetteExtractor(background).Extract(image);
  return silhouette.quality < kTrusted ? cv::Mat() : silhouette.mask;
}

// With all that is no farther (px) from it.
cv::Mat Grown(const cv::Mat& mask, double by) {
  cv::Mat distance;
  cv::distanceTransform(255 - mask, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance <= by;
}

double OverlapOf(const cv::Mat& mask, const BitMask& start) {
  if (start.Count() == 0) return 0.0;
  const cv::Rect box = cv::boundingRect(mask);
  const double margin = kPlacementTolerance * std::max(box.width, box.height);
  const cv::Mat seen = Grown(mask, margin), placed = Grown(start.ToMat(), margin);
  return static_cast<double>(cv::countNonZero(seen & placed)) / cv::countNonZero(seen | placed);
}

}  // namespace

std::vector<StartOverlap> OverlapsAtStart(const Recording& recording) {
  const auto cameras = static_cast<int>(recording.files.size());
  std::vector<cv::Mat> masks(recording.files.size());
  ParallelFor(cameras, NumThreads(0), [&](int camera, int) {
    try {
      masks[static_cast<size_t>(camera)] = FirstMask(recording, camera);
    } catch (const InputError&) {     // as one that is not there
    } catch (const cv::Exception&) {  // likewise: of a single pixel there is no silhouette
    }
  });
  std::vector<StartOverlap> overlaps;
  for (int camera = 0; camera < cameras; ++camera) {
    const cv::Mat& mask = masks[static_cast<size_t>(camera)];
    if (!mask.empty() && cv::countNonZero(mask) > 0) overlaps.push_back({camera, 0.0});
  }
  if (overlaps.empty()) return overlaps;
  const PlacedCloth cloth = PlaceCloth(recording);
  ParallelFor(static_cast<int>(overlaps.size()), NumThreads(0), [&](int i, int) {
    StartOverlap& overlap = overlaps[static_cast<size_t>(i)];
    const auto camera = static_cast<size_t>(overlap.camera);
    BitMask start;
    SilhouetteRaster(recording.cameras[camera], cloth.mesh.triangles).Draw(cloth.x, &start);
    overlap.share = OverlapOf(masks[camera], start);
  });
  return overlaps;
}

void WarnOfSilhouettes(const Recording& recording, std::vector<std::string>* warnings) {
  const std::vector<StartOverlap> overlaps = OverlapsAtStart(recording);
  const auto misplaced =
      std::count_if(overlaps.begin(), overlaps.end(),
                    [](const StartOverlap& overlap) { return overlap.share < kLeastOverlap; });
  if (static_cast<double>(misplaced) <= kMisplacedShare * static_cast<double>(overlaps.size()))
    return;
  const auto worst = std::min_element(
      overlaps.begin(), overlaps.end(),
      [](const StartOverlap& a, const StartOverlap& b) { return a.share < b.share; });
  warnings->push_back(fmt::format(
      "in {} of {} cameras the cloth does not start where its silhouette is (worst in {}: {:.0f} % "
      "overlap): check cloth.initial, its origin and axes or its corners, and cameras.yaml; "
      "'clothfit report' shows both",
      misplaced, overlaps.size(), recording.cameras[static_cast<size_t>(worst->camera)].name,
      100.0 * worst->share));
}

}  // namespace clothfit
