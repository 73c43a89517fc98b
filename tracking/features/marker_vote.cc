// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Which markers contradict the others.
#include <algorithm>
#include <utility>

#include "tracking/features/marker_tracker.h"

namespace clothfit {
namespace {

// Is the distance of two markers longer than the cloth between them can be?
bool IsTooFar(const TrackedMarker& a, const TrackedMarker& b, const MarkerTrackerOptions& options) {
  const double world = (a.position - b.position).norm();
  const double cloth = (a.uv - b.uv).norm();
  return world > (1.0 + options.max_stretch) * cloth + options.distance_tolerance;
}

// The vote among the nearest on the cloth, for what is off by little: far away it would go
// unnoticed.
void VoteAmongNeighbours(const std::vector<TrackedMarker>& markers,
                         const MarkerTrackerOptions& options, std::vector<bool>* stays) {
  const int n = static_cast<int>(markers.size());
  const int num_neighbours = std::min(options.num_neighbours, n - 1);
  if (num_neighbours < 1) return;
  struct Neighbour {
    int index;
    bool too_far;
  };
  std::vector<std::vector<Neighbour>> neighbours(n);
  std::vector<std::pair<double, int>> nearest;
  for (int i = 0; i < n; ++i) {
    nearest.clear();
    for (int j = 0; j < n; ++j) {
      if (j != i) nearest.emplace_back((markers[i].uv - markers[j].uv).squaredNorm(), j);
    }
    std::nth_element(nearest.begin(), nearest.begin() + (num_neighbours - 1), nearest.end());
    for (int k = 0; k < num_neighbours; ++k) {
      const int j = nearest[k].second;
      neighbours[i].push_back({j, IsTooFar(markers[i], markers[j], options)});
    }
  }
  for (;;) {
    int worst = -1;
    double worst_share = options.max_neighbour_violations;
    for (int i = 0; i < n; ++i) {
      if (!(*stays)[i]) continue;
      int votes = 0, left = 0;
      for (const Neighbour& other : neighbours[i]) {
        if (!(*stays)[other.index]) continue;
        ++left;
        votes += other.too_far ? 1 : 0;
      }
      const double share = left > 0 ? static_cast<double>(votes) / left : 0.0;
      if (share > worst_share) {
        worst_share = share;
        worst = i;
      }
    }
    if (worst < 0) return;
    (*stays)[worst] = false;
  }
}

}  // namespace

std::vector<bool> VoteOnDistances(const std::vector<TrackedMarker>& markers,
                                  const MarkerTrackerOptions& options) {
  const std::size_t n = markers.size();
  std::vector<bool> stays(n, true);
  std::vector<std::vector<bool>> violates(n, std::vector<bool>(n, false));
  std::vector<int> votes(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!IsTooFar(markers[i], markers[j], options)) continue;
      violates[i][j] = violates[j][i] = true;
      ++votes[i];
      ++votes[j];
    }
  }
  for (std::size_t left = n; left > 1; --left) {
    const auto worst = std::max_element(votes.begin(), votes.end()) - votes.begin();
    if (votes[worst] <= options.max_violations * static_cast<double>(left - 1)) break;
    stays[worst] = false;
    votes[worst] = 0;
    for (std::size_t j = 0; j < n; ++j) {
      if (violates[worst][j] && stays[j]) --votes[j];
    }
  }
  VoteAmongNeighbours(markers, options, &stays);
  return stays;
}

}  // namespace clothfit
