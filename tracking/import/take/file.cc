// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take/file.h"

#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "tracking/camera/world_change.h"
#include "tracking/import/c3d/c3d.h"
#include "tracking/import/markers/rigid_body.h"
#include "tracking/import/tables/formats.h"
#include "tracking/recording/limits.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

TakeInFile ReadTable(const std::filesystem::path& file, std::string text,
                     const TakeFileOptions& options, std::vector<std::string>* notes) {
  const bool is_vicon = IsVicon(text);
  TableLines lines(file, std::move(text));
  MarkerTable table;
  if (lines.BeginsWith("Format Version")) {
    table = ReadMotiveHeader(&lines);
    if (!options.facts.up) notes->emplace_back("y is taken for up, as is Motive's; --up overrides");
  } else if (lines.BeginsWith("PathFileType")) {
    table = ReadTrcHeader(&lines);
  } else if (lines.BeginsWith("NO_OF_FRAMES")) {
    table = ReadQualisysHeader(&lines);
  } else if (is_vicon) {
    table = ReadViconHeader(&lines);
  } else {
    table = ReadPlainHeader(&lines, notes);
  }
  return ReadRows(table, options, &lines, notes);
}

// The options' facts, or else the file's.
TakeFacts Agree(const TakeFacts& found, const TakeFacts& given, const std::filesystem::path& file) {
  TakeFacts facts = given;
  if (!facts.frame_rate) facts.frame_rate = found.frame_rate;
  if (!facts.metres_per_unit) facts.metres_per_unit = found.metres_per_unit;
  if (!facts.up) facts.up = found.up;
  std::vector<std::string> missing;
  if (!facts.frame_rate) missing.emplace_back("--rate (frames a second)");
  if (!facts.metres_per_unit) missing.emplace_back("--unit (m, cm or mm)");
  if (!facts.up) {
    missing.emplace_back(
        "--up (the axis that points up: z is usual of Vicon and Qualisys, y of OpenSim)");
  }
  if (!missing.empty()) {
    throw InputError(file.string(),
                     "does not say all that is needed: expected " + JoinNames(missing));
  }
  const double rate = *facts.frame_rate;
  if (!(rate >= kFrameRate.least && rate <= kFrameRate.most)) {
    throw InputError(file.string(), fmt::format("frame rate: expected {:g} to {:g} Hz, found {}",
                                                kFrameRate.least, kFrameRate.most, rate));
  }
  return facts;
}

void ToWorld(const TakeFacts& facts, std::vector<MarkerPath>* markers) {
  const WorldChange change = TurnUp(*facts.up, *facts.metres_per_unit);
  for (MarkerPath& marker : *markers) {
    for (std::optional<Eigen::Vector3d>& position : marker.positions) {
      if (position) *position = change.scale * (change.world_from_calibration * *position);
    }
  }
}

}  // namespace

MarkerTake ReadTake(const std::filesystem::path& file, const TakeFileOptions& options,
                    std::vector<std::string>* notes) {
  std::string content = ReadInputFile(file);
  TakeInFile found = IsC3d(content) ? ReadC3d(file, content, options, notes)
                                    : ReadTable(file, std::move(content), options, notes);
  const TakeFacts facts = Agree(found.facts, options.facts, file);
  ToWorld(facts, &found.markers);
  ToWorld(facts, &found.expected);
  MarkerTake take;
  take.file = file;
  take.frame_rate = *facts.frame_rate;
  take.markers = std::move(found.markers);
  TakeOutBodies(found.bodies, found.expected, &take);
  if (!take.markers.empty()) return take;
  throw InputError(file.string(), "expected markers of a cloth, found those of rigid bodies alone");
}

}  // namespace clothfit
