// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How good tracking is, against the truth of a synthetic recording.
#pragma once

#include <string>
#include <vector>

#include "tracking/features/track_recording.h"
#include "tracking/recording/surface/truth_surface.h"

namespace clothfit {

// A track further off than this, and a marker, counts as an outlier.
inline constexpr double kTrackOutlier = 5.0;    // px
inline constexpr double kMarkerOutlier = 0.03;  // m

// Quantiles of errors.
struct ErrorSummary {
  std::size_t count = 0;
  double median = 0.0, quantile95 = 0.0;
  double outliers = 0.0;  // share beyond the outlier's limit
};

struct TrackingEvaluation {
  ErrorSummary tracks;   // px
  ErrorSummary markers;  // m
  // Intersection over union with truth/masks, over all pictures and the worst picture; 0 where
  // there are no true masks.
  double silhouette_iou = 0.0, worst_silhouette_iou = 0.0;
  std::size_t num_silhouettes = 0;
  // Live tracks over all cameras, and markers, frame by frame.
  std::vector<int> tracks_in_frame, markers_in_frame;
};

// `masks`: the folder in which silhouettes stand as in a recording; truth is the recording's own.
TrackingEvaluation EvaluateTracking(const Recording& recording, const TruthSurface& truth,
                                    const std::vector<Track>& tracks,
                                    const std::vector<Marker>& markers,
                                    const std::filesystem::path& masks);

ErrorSummary Summarise(std::vector<double> errors, double outlier);

// The table's header and a row of it.
std::string TrackingTableHeader();
std::string TrackingTableRow(const std::string& name, const TrackingEvaluation& evaluation);

}  // namespace clothfit
