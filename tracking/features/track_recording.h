// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// From pictures to observations: silhouettes, points in each view, and markers in space.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tracking/features/features.h"
#include "tracking/features/marker_tracker.h"
#include "tracking/features/point_tracker.h"
#include "tracking/recording/recording.h"
#include "tracking/silhouette/silhouette.h"

namespace clothfit {

struct TrackingOptions {
  bool find_masks = true;  // where the recording brings none
  bool find_points = true;
  bool find_markers = true;
  SilhouetteOptions silhouette;
  PointTrackerOptions points;
  FeatureOptions features;
  MarkerTrackerOptions markers;
  int num_threads = 0;  // 0: as many as the machine runs at once; no influence on the result

  // Throws InputError, naming `place` and the option, where a value is of no use.
  void Check(const std::string& place) const;
};

// What one picture gave.
struct TrackedPicture {
  int frame = 0;
  int camera = 0;             // index
  double mask_quality = 0.0;  // see Silhouette; 1 for a mask that the recording brought
  int num_features = 0;       // SIFT
  int num_points = 0;         // live
};

struct TrackingResult {
  std::vector<Track> tracks;                               // by frame, then camera, then id
  std::vector<Marker> markers;                             // by frame, then id
  std::vector<TrackedPicture> pictures;                    // by frame, then camera
  std::map<std::string, int> point_counts, marker_counts;  // what the filters did, see the trackers
  int num_frames = 0;  // that were looked at: fewer when stopped
};

struct TrackingCallbacks {
  // A silhouette that was found. Called from any thread, for one camera and frame at a time.
  std::function<void(int camera, int frame, const Silhouette&)> on_silhouette;
  std::function<void(int frames_done)> on_frame;
  const std::atomic<bool>* stop = nullptr;  // set from outside to end early
};

// Goes through the pictures frame by frame; each is read once, and no more than one a camera is
// held. A picture that is not there is passed over: its camera gives nothing in that frame. A
// camera without a picture of frame 0, where the cloth's place is known, gives silhouettes only,
// and one without background and masks is searched for features wherever the cloth lay at first.
// Throws InputError where there are no pictures at all or one cannot be read.
TrackingResult TrackRecording(const Recording& recording, const TrackingOptions& options,
                              const TrackingCallbacks& callbacks = {});

// The recording with these observations in place of pictures, ready for WriteRecording; the
// markers' sigma is guessed where none is known.
Recording WithObservations(const Recording& recording, const TrackingResult& result);

// pictures.csv and filters.csv: what each picture gave and what each filter threw out.
std::string PicturesAsCsv(const Recording& recording, const TrackingResult& result);
std::string FiltersAsCsv(const TrackingResult& result);

}  // namespace clothfit
