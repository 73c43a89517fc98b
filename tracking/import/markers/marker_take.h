// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A take of optical motion capture, whatever file it was read from.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "autodiff_sim/base/names.h"
#include "tracking/recording/recording.h"

namespace clothfit {

struct MarkerPath {
  std::string name;
  HandleDescription::Path positions;  // m, world with z up; one entry a frame, empty where lost
};

// Markers that sit on one rigid thing, such as a bar. None of them is the cloth's.
struct RigidBody {
  std::string name;
  std::vector<MarkerPath> markers;  // may be none
};

struct MarkerTake {
  std::filesystem::path file;       // for messages
  double frame_rate = 0.0;          // Hz
  std::vector<MarkerPath> markers;  // at least one; distinct names
  std::vector<RigidBody> bodies;    // all paths, theirs too, are equally long

  size_t num_frames() const { return markers.empty() ? 0 : markers.front().positions.size(); }
};

// (u, v) in metres by the marker's name.
using LayoutByName = std::map<std::string, Eigen::Vector2d>;

// Reads a table with the columns name,u,v.
LayoutByName ReadLayout(const std::filesystem::path& file);
std::string LayoutAsCsv(const std::vector<std::string>& names,
                        const std::vector<Eigen::Vector2d>& uv);

inline std::vector<std::string> NamesOf(const MarkerTake& take) { return NamesOf(take.markers); }

// Index of the marker; throws InputError where there is none of that name. `option` named it.
size_t MarkerNamed(const MarkerTake& take, const std::string& name, const std::string& option);

// Takes out the markers of these names. Throws InputError where there is none of a name.
void RemoveIgnored(const std::vector<std::string>& ignored, MarkerTake* take);

// Takes out the markers seen in less than this share of the frames (such as reflections) that are
// not among those kept. Throws InputError when fewer than four stay. `notes` gets a sentence for
// the user on what was done.
void RemoveRare(double least_seen, const std::vector<std::string>& kept, MarkerTake* take,
                std::vector<std::string>* notes);

// Lets the take begin at the first frame that has every marker of the cloth. Throws InputError when
// none has.
void TrimStart(MarkerTake* take, std::vector<std::string>* notes);

// Leaves every so manieth frame, the first among them, and says so in the frame rate.
void ThinFrames(int every, MarkerTake* take);

// Standard deviation (m) of one coordinate from one frame to the next, as a median over all second
// differences: motion that is smooth over three frames does not count. Empty where no marker is
// seen in three frames in a row.
std::optional<double> MarkerJitter(const std::vector<MarkerPath>& markers);

}  // namespace clothfit
