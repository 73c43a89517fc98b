// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Points of the cloth in space, from the features that several cameras see: Hasler 2007, sec. 4.
//
// In the first frame, features of different views that lie at the same place of the cloth become
// one marker. In later frames each view looks for its own features again; the rays of those found
// give the marker's place. Filters throw out what cannot be.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "tracking/camera/camera.h"
#include "tracking/camera/triangulation.h"
#include "tracking/features/features.h"

namespace clothfit {

// How a feature is found again.
enum class Reidentification {
  kReference,  // by its descriptor in the first frame
  kTracking,   // by its descriptor where it was seen last
};
enum class MarkerPlace {
  kClosestPoints,  // the paper's mean of closest points
  kReprojection,   // what most cameras agree on, with the least reprojection error
};

struct MarkerTrackerOptions {
  // the first frame
  double max_uv_distance = 0.006;               // m on the cloth between views of one marker
  double max_view_descriptor_distance = 400.0;  // between views
  double min_marker_distance = 0.005;           // m on the cloth between markers
  // finding again
  Reidentification reidentification = Reidentification::kReference;
  MarkerPlace place = MarkerPlace::kReprojection;
  double max_descriptor_distance = 280.0;
  double max_ratio = 0.85;  // of the best to the second-best descriptor distance
  // What the last frame did not have comes back if no other feature anywhere near looks alike, or
  // if so many cameras agree.
  int min_cameras_after_loss = 3;
  // filters
  bool check_image_move = true;
  double max_image_move = 6.0;  // px a frame, from where the marker's motion leads one to expect it
  bool check_world_move = true;
  double max_world_speed = 0.7;  // m/s, likewise
  bool check_reprojection = true;
  TriangulationOptions triangulation;
  bool check_distances = true;
  double max_stretch = 0.05;          // share by which cloth may be longer than at rest
  double distance_tolerance = 0.008;  // m, two markers' errors
  double max_violations = 0.05;       // share of distances that a marker may violate
  int num_neighbours = 16;            // nearest on the cloth, that vote on their own
  double max_neighbour_violations = 0.1;
};

struct TrackedMarker {
  int id = 0;
  Eigen::Vector2d uv;        // m, on the cloth
  Eigen::Vector3d position;  // m, world
  int num_cameras = 0;
};

class MarkerTracker {
 public:
  MarkerTracker(std::vector<Camera> cameras, double frame_rate,
                const MarkerTrackerOptions& options = {});

  // Makes the markers of the first frame. `views`: one a camera; `uv`: of each feature, where it is
  // known.
  std::vector<TrackedMarker> Start(
      const std::vector<Features>& views,
      const std::vector<std::vector<std::optional<Eigen::Vector2d>>>& uv);

  // The markers found in the next frame.
  std::vector<TrackedMarker> Advance(const std::vector<Features>& views);

  // What was thrown out, by which filter: "image move" and "reprojection" count features, "world
  // move", "distances" and "ambiguous" (found again, by too little) markers, "views differ" views
  // of the first frame. "no feature" counts views that found none, those of "image move" among
  // them.
  const std::map<std::string, int>& counts() const { return counts_; }

 private:
  struct View {
    int camera;
    cv::Mat reference, last;  // descriptors
    Eigen::Vector2d pixel;    // px, where it was seen last
    int frame = 0;            // when
  };
  struct TrackState {
    Eigen::Vector2d uv;
    std::vector<View> views;
    std::optional<Eigen::Vector3d> position;             // m, where it was last
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  // m a frame, then
    int frame = 0;                                       // when
    bool has_double = false;  // in the first frame, anywhere: then its look says little

    // Where it should be now if it moves on as it did, for a while.
    Eigen::Vector3d Expected(int now) const;
  };

  struct Match {
    std::optional<int> feature;
    bool is_distinct = false;  // nothing like it anywhere near; not looked for from frame to frame
  };
  Match FindAgain(const View& view, const TrackState& marker, const Features& features);
  // Whether some other feature of the picture looks like the view's.
  bool HasDouble(const Features& features, const View& view) const;
  // The feature within `radius` (px) of `centre` whose descriptor is nearest, if it is near enough
  // and no other is about as near.
  std::optional<int> MostAlike(const Features& features, const cv::Mat& descriptor,
                               const Eigen::Vector2d& centre, double radius) const;
  std::vector<Sighting> Sight(TrackState* marker, const std::vector<Features>& views,
                              std::vector<int>* features, int* num_distinct);
  std::optional<TrackedMarker> Place(int id, const std::vector<Sighting>& sightings);

  std::vector<Camera> cameras_;
  double frame_rate_;
  MarkerTrackerOptions options_;
  std::vector<TrackState> markers_;
  int frame_ = 0;
  std::map<std::string, int> counts_;
};

// The vote on distances (Hasler 2007, sec. 4): two markers cannot be further apart in the world
// than on the cloth by more than the stretch allowed. The marker with the largest share of violated
// distances goes, until none has more than max_violations; then likewise among nearest neighbours
// on the cloth, where small errors show: a marker that is off by one repeat of a pattern
// contradicts half of its neighbours and few of those far away. Returns which stay.
std::vector<bool> VoteOnDistances(const std::vector<TrackedMarker>& markers,
                                  const MarkerTrackerOptions& options);

}  // namespace clothfit
