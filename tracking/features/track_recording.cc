// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/features/track_recording.h"

#include <algorithm>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/pictures/images.h"

namespace clothfit {
namespace {

using FeaturePlaces = std::vector<std::optional<Eigen::Vector2d>>;

// One camera's part of the work. Its calls come frame by frame, from one thread at a time.
class CameraTracker {
 public:
  CameraTracker(const Recording& recording, int camera, const TrackingOptions& options,
                const ClothCoordinates& cloth)
      : recording_(recording),
        camera_(camera),
        options_(options),
        cloth_(cloth),
        reader_(recording, camera),
        points_(options.points) {
    const cv::Mat background = LoadBackground(recording, camera);
    if (!background.empty()) extractor_.emplace(background, options.silhouette);
  }

  void Look(int frame, const TrackingCallbacks& callbacks) {
    picture_ = {frame, camera_, 0.0, 0, 0};
    features_ = {};
    places_.clear();
    seen_.clear();
    const cv::Mat image = reader_.Load(frame);
    if (image.empty()) return;
    const cv::Mat mask = FindMask(image, frame, callbacks);
    const Camera& camera = recording_.cameras[camera_];
    if (options_.find_points) {
      if (frame == 0) {
        seen_ = points_.Start(image, mask, camera, cloth_);
        has_started_ = true;
      } else if (has_started_) {
        seen_ = points_.Advance(image, mask);
      }
    }
    if (options_.find_markers) {
      features_ = DetectFeatures(image, mask, options_.features);
      if (frame == 0) {
        for (const Eigen::Vector2d& pixel : features_.pixels)
          places_.push_back(cloth_.At(camera, pixel));
      }
    }
    picture_.num_features = features_.size();
    picture_.num_points = static_cast<int>(seen_.size());
  }

  const TrackedPicture& picture() const { return picture_; }
  const Features& features() const { return features_; }
  const FeaturePlaces& places() const { return places_; }
  const std::vector<TrackedPoint>& seen() const { return seen_; }
  const std::map<std::string, int>& counts() const { return points_.counts(); }

 private:
  cv::Mat FindMask(const cv::Mat& image, int frame, const TrackingCallbacks& callbacks) {
    cv::Mat mask = LoadMask(recording_, camera_, frame);
    if (!mask.empty()) {
      picture_.mask_quality = 1.0;
      return mask;
    }
    if (!options_.find_masks || !extractor_) return {};
    const Silhouette silhouette = extractor_->Extract(image);
    picture_.mask_quality = silhouette.quality;
    if (callbacks.on_silhouette) callbacks.on_silhouette(camera_, frame, silhouette);
    return silhouette.mask;
  }

  const Recording& recording_;
  int camera_;
  const TrackingOptions& options_;
  const ClothCoordinates& cloth_;
  ImageReader reader_;
  PointTracker points_;
  std::optional<SilhouetteExtractor> extractor_;
  bool has_started_ = false;
  // of the frame that was looked at last
  TrackedPicture picture_;
  Features features_;
  FeaturePlaces places_;
  std::vector<TrackedPoint> seen_;
};

class Run {
 public:
  Run(const Recording& recording, const TrackingOptions& options)
      : recording_(recording),
        options_(options),
        cloth_(PlaceCloth(recording)),
        markers_(recording.cameras, recording.frame_rate, options.markers) {
    for (int c = 0; c < static_cast<int>(recording.cameras.size()); ++c)
      cameras_.push_back(std::make_unique<CameraTracker>(recording, c, options, cloth_));
  }

  void Look(int frame, const TrackingCallbacks& callbacks) {
    ParallelFor(static_cast<int>(cameras_.size()), NumThreads(options_.num_threads),
                [&](int c, int) { cameras_[c]->Look(frame, callbacks); });
    for (const auto& camera : cameras_) {
      result_.pictures.push_back(camera->picture());
      for (const TrackedPoint& p : camera->seen())
        result_.tracks.push_back({frame, camera->picture().camera, p.id, p.uv, p.pixel});
    }
    if (options_.find_markers) FindMarkers(frame);
    ++result_.num_frames;
  }

  TrackingResult Result() {
    for (const auto& camera : cameras_) {
      for (const auto& [what, count] : camera->counts()) result_.point_counts[what] += count;
    }
    result_.marker_counts = markers_.counts();
    return std::move(result_);
  }

 private:
  void FindMarkers(int frame) {
    std::vector<Features> views;
    std::vector<FeaturePlaces> places;
    for (const auto& camera : cameras_) {
      // Markers of a camera that is held out would tell the fit what it saw.
      const bool is_used = !IsHeldOutCamera(recording_, camera->picture().camera);
      views.push_back(is_used ? camera->features() : Features());
      places.push_back(is_used ? camera->places() : FeaturePlaces());
    }
    const std::vector<TrackedMarker> found =
        frame == 0 ? markers_.Start(views, places) : markers_.Advance(views);
    for (const TrackedMarker& m : found) result_.markers.push_back({frame, m.id, m.uv, m.position});
  }

  const Recording& recording_;
  const TrackingOptions& options_;
  ClothCoordinates cloth_;
  MarkerTracker markers_;
  std::vector<std::unique_ptr<CameraTracker>> cameras_;
  TrackingResult result_;
};

}  // namespace

void TrackingOptions::Check(const std::string& place) const {
  const auto expect = [&](bool is_right, const std::string& what) {
    if (!is_right) throw InputError(place, what);
  };
  expect(points.max_points >= 1, fmt::format("{} points; expected 1 or more", points.max_points));
  expect(points.window >= 5 && points.window % 2 == 1,
         fmt::format("window of {} px; expected an odd number from 5 on", points.window));
  expect(features.max_features >= 1,
         fmt::format("{} features; expected 1 or more", features.max_features));
  expect(num_threads >= 0, fmt::format("{} threads; expected 0 or more", num_threads));
}

TrackingResult TrackRecording(const Recording& recording, const TrackingOptions& options,
                              const TrackingCallbacks& callbacks) {
  options.Check("tracking");
  if (!HasPictures(recording))
    throw InputError(recording.path.string(), "has neither images nor videos to track in");
  Run run(recording, options);
  for (int frame = 0; frame < recording.frame_count; ++frame) {
    if (callbacks.stop != nullptr && *callbacks.stop) break;
    run.Look(frame, callbacks);
    if (callbacks.on_frame) callbacks.on_frame(frame + 1);
  }
  return run.Result();
}

Recording WithObservations(const Recording& recording, const TrackingResult& result) {
  constexpr double kGuessedMarkerSigma = 0.004;  // m
  Recording with = recording;
  with.files.clear();
  with.tracks = result.tracks;
  with.markers = result.markers;
  if (!with.noise.marker && !with.markers.empty()) with.noise.marker = kGuessedMarkerSigma;
  return with;
}

std::string PicturesAsCsv(const Recording& recording, const TrackingResult& result) {
  std::string text = "frame,camera,mask_quality,features,points\n";
  for (const TrackedPicture& p : result.pictures) {
    text += fmt::format("{},{},{:.4f},{},{}\n", p.frame, recording.cameras[p.camera].name,
                        p.mask_quality, p.num_features, p.num_points);
  }
  return text;
}

std::string FiltersAsCsv(const TrackingResult& result) {
  std::string text = "tracker,what,count\n";
  for (const auto& [what, count] : result.point_counts)
    text += fmt::format("2d,{},{}\n", what, count);
  for (const auto& [what, count] : result.marker_counts)
    text += fmt::format("3d,{},{}\n", what, count);
  return text;
}

}  // namespace clothfit
