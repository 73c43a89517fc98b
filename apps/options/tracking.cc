// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/options/tracking.h"

#include <map>

#include <fmt/format.h>

#include "apps/options/config.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/progress_display.h"
#include "tracking/features/tracking_folder.h"

namespace clothfit {
namespace {

void AddSwitch(CLI::App* command, const std::string& name, bool* filter, const std::string& text) {
  command->add_flag_callback(
      "--no-" + name, [filter] { *filter = false; }, text);
}

// Sets one of the named values; the help lists the names, and which stands there now.
template <class Value>
void AddChoice(CLI::App* command, const std::string& name,
               const std::map<std::string, Value>& choices, Value* value, const std::string& doc) {
  std::string all, now;
  for (const auto& [text, one] : choices) {
    all += (all.empty() ? "" : "|") + text;
    if (one == *value) now = text;
  }
  command->add_option(name, *value, doc)
      ->transform(CLI::Transformer(choices))
      ->option_text(all)
      ->default_str(now);
}

void AddPointOptions(CLI::App* command, PointTrackerOptions* points) {
  command->add_option("--max-points", points->max_points, "points followed in each view")
      ->type_name("N")
      ->capture_default_str();
  command->add_option("--window", points->window, "side of what is compared, px, odd")
      ->type_name("PX")
      ->capture_default_str();
  AddSwitch(command, "backward-check", &points->check_backward,
            "2D: do not ask that forward and backward flow agree");
  AddSwitch(command, "move-check", &points->check_move, "2D: let points leap");
  AddSwitch(command, "neighbour-check", &points->check_neighbours,
            "2D: let points move otherwise than their neighbours");
  AddSwitch(command, "reference-check", &points->check_reference,
            "2D: do not compare with the first frame");
  AddSwitch(command, "redetection", &points->redetect, "2D: do not look for lost points again");
}

void AddMarkerOptions(CLI::App* command, MarkerTrackerOptions* markers) {
  AddChoice<Reidentification>(
      command, "--reidentify",
      {{"reference", Reidentification::kReference}, {"tracking", Reidentification::kTracking}},
      &markers->reidentification,
      "3D: find features again by their look in the first frame "
      "(reference) or where they were seen last (tracking)");
  AddChoice<MarkerPlace>(command, "--marker-place",
                         {{"closest-points", MarkerPlace::kClosestPoints},
                          {"reprojection", MarkerPlace::kReprojection}},
                         &markers->place,
                         "3D: mean of the rays' closest points, or least reprojection error");
  AddSwitch(command, "image-move-filter", &markers->check_image_move,
            "3D: no limit to a feature's move between frames");
  AddSwitch(command, "world-move-filter", &markers->check_world_move,
            "3D: no limit to a marker's move between frames");
  AddSwitch(command, "reprojection-filter", &markers->check_reprojection,
            "3D: keep rays that miss the marker");
  AddSwitch(command, "distance-filter", &markers->check_distances, "3D: no vote on distances");
  command
      ->add_option("--max-stretch", markers->max_stretch,
                   "3D: share by which markers may be further apart than on the cloth")
      ->type_name("SHARE")
      ->capture_default_str();
}

}  // namespace

void AddTrackingOptions(CLI::App* command, TrackingOptions* options) {
  BeginGroup(command, "What is found");
  AddSwitch(command, "masks", &options->find_masks, "do not extract silhouettes");
  AddSwitch(command, "tracks", &options->find_points, "do not follow points in the views");
  AddSwitch(command, "markers", &options->find_markers, "do not make markers in space");
  BeginGroup(command, "Points in each view");
  AddPointOptions(command, &options->points);
  BeginGroup(command, "Markers in space");
  AddMarkerOptions(command, &options->markers);
  BeginGroup(command, "Options");
  command
      ->add_option("--threads", options->num_threads,
                   "cameras at the same time, 0: all cores; no influence on the result")
      ->type_name("N")
      ->capture_default_str();
}

TrackingResult TrackWithDisplay(const Recording& recording, const TrackingOptions& options,
                                const std::filesystem::path& folder, Overwrite overwrite,
                                bool quiet) {
  ProgressDisplay display;
  TrackingCallbacks callbacks;
  callbacks.stop = StopOnInterrupt();
  if (!quiet) {
    callbacks.on_frame = [&](int done) {
      display.Show("tracking", fmt::format("frame {} of {}", done, recording.frame_count),
                   static_cast<double>(done) / recording.frame_count);
    };
  }
  TrackingResult result = TrackIntoFolder(recording, options, folder, overwrite, callbacks);
  display.Finish();
  return result;
}

std::string DescribeTracking(const Recording& recording, const TrackingResult& result) {
  const int frames = std::max(1, result.num_frames);
  double quality = 0.0;
  for (const TrackedPicture& p : result.pictures) quality += p.mask_quality;
  std::string text = fmt::format(
      "{} frames, {} cameras: {} tracks ({:.0f} a frame), {} markers ({:.0f} a frame), mask "
      "quality {:.3f}",
      result.num_frames, recording.cameras.size(), result.tracks.size(),
      static_cast<double>(result.tracks.size()) / frames, result.markers.size(),
      static_cast<double>(result.markers.size()) / frames,
      quality / static_cast<double>(std::max<std::size_t>(1, result.pictures.size())));
  const auto add = [&text](const std::string& title, const std::map<std::string, int>& counts) {
    if (counts.empty()) return;
    text += "\n" + title;
    for (const auto& [what, count] : counts) text += fmt::format("  {} {}", what, count);
  };
  add("points lost and found: ", result.point_counts);
  add("markers, thrown out:   ", result.marker_counts);
  return text;
}

}  // namespace clothfit
