// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/outliers/swapped_markers.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tracking/recording/warnings/points.h"

namespace clothfit {
namespace {

// Frames without a sighting that is believed, after which a marker begins anew: a course that is
// led on for longer has lost what it was of.
constexpr int kLongestGap = 4;
constexpr double kNearer = 0.5;  // of the distance from its own place
// Times as far from its own place as markers are at that frame, the median: cloth that is thrown
// about leaves the courses of all, and where it is folded others' courses are near.
constexpr double kStandsOut = 4.0;

using Sightings = std::map<int, Eigen::Vector3d>;  // by id, at one frame

// Labels as they are once a swap has been put right.
Sightings Relabelled(const SwappedMarkers& swap, const Sightings& seen) {
  Sightings all = seen;
  for (const int id : swap.ids) all.erase(id);
  for (std::size_t k = 0; k < swap.ids.size(); ++k) {
    const auto own = seen.find(swap.ids[k]);
    if (own != seen.end()) all[swap.ids[(k + 1) % swap.ids.size()]] = own->second;
  }
  return all;
}

// Labels of a frame as they are once all swaps until then have been put right.
Sightings Relabelled(const std::vector<SwappedMarkers>& swaps, int frame, Sightings seen) {
  for (const SwappedMarkers& swap : swaps)
    if (swap.from_frame <= frame) seen = Relabelled(swap, seen);
  return seen;
}

// The course of one marker.
class Course {
 public:
  explicit Course(int frame, const Eigen::Vector3d& position) : frame_(frame), last_(position) {}
  // Where it should be. After one sighting nothing is known of its velocity.
  Eigen::Vector3d At(int frame) const { return last_ + (frame - frame_) * velocity_; }
  bool IsKnown() const { return is_moving_; }
  bool IsLost(int frame) const { return frame - frame_ > kLongestGap; }
  void GoTo(int frame, const Eigen::Vector3d& position) {
    velocity_ = (position - last_) / (frame - frame_);
    frame_ = frame;
    last_ = position;
    is_moving_ = true;
  }

 private:
  int frame_;
  Eigen::Vector3d last_, velocity_ = Eigen::Vector3d::Zero();
  bool is_moving_ = false;
};

// What cloth says of labels: markers are no farther apart than on it.
class ClothOfMarkers {
 public:
  explicit ClothOfMarkers(const Recording& recording) {
    std::map<int, Eigen::Vector2d> uv;
    for (const Marker& m : recording.markers) {
      frames_[m.frame].emplace(m.id, m.position);
      uv.emplace(m.id, m.uv);
    }
    FindNearest(uv);
    slack_ = kDistanceSigmas * recording.noise.marker.value_or(kDefaultMarkerSigma);
  }

  const std::map<int, Sightings>& frames() const { return frames_; }

  // Are the markers of a swap mostly where cloth cannot have them by the labels that they have
  // after `before`, and hardly any once it is undone?
  bool Confirms(const SwappedMarkers& swap, const std::vector<SwappedMarkers>& before) const {
    int seen = 0, wrong = 0, wrong_after = 0;
    for (auto f = frames_.lower_bound(swap.from_frame);
         f != frames_.end() && f->first < swap.from_frame + kFrames; ++f) {
      const Sightings own = Relabelled(before, f->first, f->second);
      const Sightings after = Relabelled(swap, own);
      for (const int id : swap.ids) {
        seen += own.count(id) > 0 ? 1 : 0;
        wrong += IsImpossible(id, own, swap) ? 1 : 0;
        wrong_after += IsImpossible(id, after, swap) ? 1 : 0;
      }
    }
    return 2 * wrong >= seen && 4 * wrong_after <= wrong && wrong > 0;
  }

  // By id, the frame from which on cloth cannot have a marker where most of its next sightings are.
  std::map<int, int> WrongSince(const std::vector<SwappedMarkers>& before) const {
    std::map<int, std::vector<std::pair<int, bool>>> sightings;  // by id: frame, and whether wrong
    for (const auto& [frame, raw] : frames_) {
      const Sightings seen = Relabelled(before, frame, raw);
      for (const auto& [id, position] : seen)
        sightings[id].emplace_back(frame, IsImpossible(id, seen, {}));
    }
    std::map<int, int> since;
    for (const auto& [id, all] : sightings) {
      for (auto first = all.begin(); first != all.end() && since.count(id) == 0; ++first) {
        const auto last = first + std::min<std::ptrdiff_t>(kFrames, all.end() - first);
        const auto wrong = std::count_if(first, last, [](const auto& one) { return one.second; });
        if (first->second && 2 * wrong > last - first && last - first > 1) since[id] = first->first;
      }
    }
    return since;
  }

 private:
  static constexpr int kFrames = 10;  // that are looked at after labels may have changed
  static constexpr double kDistanceSigmas = 6.0;

  // Too far from half of the nearest markers that are seen and have not swapped.
  bool IsImpossible(int id, const Sightings& seen, const SwappedMarkers& swap) const {
    constexpr int kNeighbours = 8;
    const auto own = seen.find(id);
    if (own == seen.end()) return false;
    int looked_at = 0, too_far = 0;
    for (const auto& [on_cloth, other] : nearest_.at(id)) {
      const auto neighbour = seen.find(other);
      if (neighbour == seen.end()) continue;
      if (std::count(swap.ids.begin(), swap.ids.end(), other) > 0) continue;
      const double apart = (neighbour->second - own->second).norm();
      too_far += apart > kUnlikelyStretch * on_cloth + slack_ ? 1 : 0;
      if (++looked_at == kNeighbours) break;
    }
    return 2 * too_far > looked_at;
  }

  void FindNearest(const std::map<int, Eigen::Vector2d>& uv) {
    constexpr std::size_t kMost = 64;  // of which some are hidden
    for (const auto& [id, own] : uv) {
      std::vector<std::pair<double, int>>& others = nearest_[id];
      for (const auto& [other, place] : uv)
        if (other != id) others.emplace_back((place - own).norm(), other);
      const std::size_t count = std::min(kMost, others.size());
      std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count),
                        others.end());
      others.resize(count);
      others.shrink_to_fit();
    }
  }

  std::map<int, Sightings> frames_;
  std::map<int, std::vector<std::pair<double, int>>> nearest_;  // by id: distance (m) and id
  double slack_ = 0.0;                                          // m
};

// Follows all markers from frame to frame. One that is at another's place waits.
class Follower {
 public:
  explicit Follower(const ClothOfMarkers& cloth) : cloth_(cloth) {}
  const std::vector<SwappedMarkers>& found() const { return found_; }

  void Next(int frame, Sightings seen) {
    seen = Relabelled(found_, frame, std::move(seen));
    usual_ = UsualDistance(frame, seen);
    std::map<int, int> places;  // of those that are at another one's, by id
    for (const auto& [id, position] : seen) {
      if (const std::optional<int> other = OthersPlace(frame, id, position)) {
        places[id] = *other;
        waiting_.try_emplace(id, frame);
      }
    }
    // Who has the place of a hidden one shows where that goes.
    for (const auto& [id, place] : places)
      if (seen.count(place) == 0) courses_.at(place).GoTo(frame, seen.at(id));
    AddHidden(frame, seen, &places);
    while (!places.empty()) {
      const std::vector<int> round = RoundOf(places.begin()->first, places);
      if (round.empty()) places.erase(places.begin());
      for (const int id : round) places.erase(id);
      if (round.empty()) continue;
      const SwappedMarkers swap = Swapped(frame, round);
      if (!cloth_.Confirms(swap, found_)) continue;
      found_.push_back(swap);
      seen = Relabelled(swap, seen);
    }
    for (const auto& [id, position] : seen) Follow(frame, id, position);
  }

 private:
  bool IsFollowed(int frame, const Course& course) const {
    return course.IsKnown() && !course.IsLost(frame);
  }

  // From their own places, the median.
  double UsualDistance(int frame, const Sightings& seen) const {
    std::vector<double> distances;
    for (const auto& [id, position] : seen) {
      const auto own = courses_.find(id);
      if (own != courses_.end() && IsFollowed(frame, own->second))
        distances.push_back((own->second.At(frame) - position).norm());
    }
    if (distances.empty()) return 0.0;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
  }

  // The nearest, where its own is much farther away.
  std::optional<int> OthersPlace(int frame, int id, const Eigen::Vector3d& position) const {
    const auto own = courses_.find(id);
    if (own == courses_.end() || !IsFollowed(frame, own->second)) return {};
    const double from_own = (own->second.At(frame) - position).norm();
    if (from_own < kStandsOut * usual_) return {};
    double least = kNearer * from_own;
    std::optional<int> nearest;
    for (const auto& [other, course] : courses_) {
      if (!IsFollowed(frame, course)) continue;
      const double distance = (course.At(frame) - position).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = other;
    }
    return nearest;
  }

  // One that is hidden has the place that is left: that of the marker from which a chain leads to
  // it.
  void AddHidden(int frame, const Sightings& seen, std::map<int, int>* places) const {
    std::set<int> taken;
    for (const auto& [id, place] : *places) taken.insert(place);
    for (const auto& [first, place] : std::map<int, int>(*places)) {
      if (taken.count(first) > 0) continue;
      int last = first;
      std::set<int> chain;
      auto next = places->find(first);
      for (; next != places->end() && chain.insert(last).second; next = places->find(last))
        last = next->second;
      const bool ends = next == places->end();  // or leads into a round that it is no part of
      const bool has_stayed =
          std::all_of(chain.begin(), chain.end(), [&](int id) { return waiting_.at(id) < frame; });
      if (ends && has_stayed && seen.count(last) == 0) places->emplace(last, first);
    }
  }

  // The markers at each other's places in turn that one belongs to; empty where it is in no such
  // round.
  static std::vector<int> RoundOf(int first, const std::map<int, int>& places) {
    std::vector<int> round;
    for (int id = first; round.size() <= places.size();) {
      round.push_back(id);
      const auto next = places.find(id);
      if (next == places.end()) return {};
      id = next->second;
      if (id == first) return round;
    }
    return {};
  }

  SwappedMarkers Swapped(int frame, const std::vector<int>& round) const {
    SwappedMarkers swap{round, frame};
    for (const int id : round) {
      const auto since = waiting_.find(id);
      if (since != waiting_.end()) swap.from_frame = std::min(swap.from_frame, since->second);
    }
    return swap;
  }

  // Where it is not at another one's place any more, or has been for too long.
  void Follow(int frame, int id, const Eigen::Vector3d& position) {
    const auto [course, is_new] = courses_.try_emplace(id, frame, position);
    if (is_new) return;
    if (course->second.IsLost(frame)) {
      course->second = Course(frame, position);
    } else if (OthersPlace(frame, id, position)) {
      return;
    } else {
      course->second.GoTo(frame, position);
    }
    waiting_.erase(id);
  }

  const ClothOfMarkers& cloth_;
  std::vector<SwappedMarkers> found_;
  std::map<int, Course> courses_;
  std::map<int, int> waiting_;  // by id, since which frame
  double usual_ = 0.0;          // m, see UsualDistance
};

}  // namespace

std::vector<SwappedMarkers> FindSwappedMarkers(const Recording& recording) {
  const ClothOfMarkers cloth(recording);
  Follower follower(cloth);
  for (const auto& [frame, seen] : cloth.frames()) follower.Next(frame, seen);
  std::vector<SwappedMarkers> found = follower.found();
  // One that is hidden while labels change comes back where no course leads to.
  std::map<int, int> since = cloth.WrongSince(found);
  for (auto a = since.begin(); a != since.end(); ++a) {
    for (auto b = std::next(a); b != since.end(); ++b) {
      const SwappedMarkers swap{{a->first, b->first}, std::min(a->second, b->second)};
      if (!cloth.Confirms(swap, found)) continue;
      found.push_back(swap);
      since.erase(b);
      break;
    }
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& one, const auto& other) {
    return one.from_frame < other.from_frame;
  });
  return found;
}

void SwapBack(const SwappedMarkers& swap, Recording* recording) {
  std::map<int, Eigen::Vector2d> uv;
  for (const Marker& m : recording->markers) uv[m.id] = m.uv;
  for (Marker& m : recording->markers) {
    const auto own = std::find(swap.ids.begin(), swap.ids.end(), m.id);
    if (m.frame < swap.from_frame || own == swap.ids.end()) continue;
    m.id = std::next(own) == swap.ids.end() ? swap.ids.front() : *std::next(own);
    m.uv = uv.at(m.id);
  }
}

void PutLabelsRight(Recording* recording) {
  for (const SwappedMarkers& swap : FindSwappedMarkers(*recording)) {
    SwapBack(swap, recording);
    recording->put_right.push_back(swap);
  }
}

std::string ToString(const SwappedMarkers& swap) {
  const std::vector<int> but_last(swap.ids.begin(), std::prev(swap.ids.end()));
  return fmt::format("markers {} and {} swapped from frame {} on", fmt::join(but_last, ", "),
                     swap.ids.back(), swap.from_frame);
}

std::string DescribeSwaps(const Recording& recording) {
  std::vector<std::string> all;
  for (const SwappedMarkers& swap : recording.put_right) all.push_back(ToString(swap));
  return fmt::format("{}", fmt::join(all, "; "));
}

}  // namespace clothfit
