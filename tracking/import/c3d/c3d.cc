// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/c3d/c3d.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tracking/import/c3d/bytes.h"
#include "tracking/recording/limits.h"

namespace clothfit {
namespace {

// Offsets of what the header tells, in bytes.
constexpr size_t kPoints = 2;
constexpr size_t kAnalog = 4;  // values a frame
constexpr size_t kFirstFrame = 6;
constexpr size_t kLastFrame = 8;
constexpr size_t kScale = 12;
constexpr size_t kDataBlock = 16;
constexpr size_t kRate = 20;

// Where the points stand.
struct PointLayout {
  size_t start = 0;        // of the first frame, in bytes
  size_t frame_bytes = 0;  // of one frame, analog data included
  size_t num_points = 0;
  size_t num_frames = 0;
  double scale = 1.0;  // of integers
  bool is_float = false;
};

size_t Count(double value, const std::string& what, size_t at, const C3dBytes& bytes) {
  if (value >= 1.0 && value <= 1e9 && std::trunc(value) == value) {
    return static_cast<size_t>(value);
  }
  bytes.Fail(at, fmt::format("{}: expected a whole number above 0, found {}", what, value));
}

// Of at most 65535 there is room in POINT:FRAMES; programs write more in two other places.
size_t NumFrames(const C3dParameters& parameters, const C3dBytes& bytes) {
  constexpr double kMostInAWord = 65535.0;
  const double in_header = bytes.Word(kLastFrame) - bytes.Word(kFirstFrame) + 1;
  const double frames = parameters.Number("POINT:FRAMES").value_or(in_header);
  if (const auto more = parameters.Number("POINT:LONG_FRAMES")) {
    return Count(*more, "POINT:LONG_FRAMES", parameters.Place("POINT:LONG_FRAMES"), bytes);
  }
  const std::string first = "TRIAL:ACTUAL_START_FIELD";
  const std::string last = "TRIAL:ACTUAL_END_FIELD";
  const auto number = [&](const std::string& name) {
    return *parameters.Number(name) + 65536.0 * parameters.Number(name, 1).value_or(0.0);
  };
  if (frames == kMostInAWord && parameters.Number(first) && parameters.Number(last)) {
    return Count(number(last) - number(first) + 1.0, last, parameters.Place(last), bytes);
  }
  return Count(frames, "POINT:FRAMES", parameters.Place("POINT:FRAMES"), bytes);
}

PointLayout FindPoints(const C3dParameters& parameters, const C3dBytes& bytes) {
  PointLayout points;
  points.num_points = Count(parameters.Number("POINT:USED").value_or(bytes.Word(kPoints)),
                            "POINT:USED", parameters.Place("POINT:USED"), bytes);
  points.num_frames = NumFrames(parameters, bytes);
  const double scale = parameters.Number("POINT:SCALE").value_or(bytes.Float(kScale));
  if (!std::isfinite(scale) || scale == 0.0) {
    bytes.Fail(parameters.Place("POINT:SCALE"),
               fmt::format("POINT:SCALE: expected a number other than 0, found {}", scale));
  }
  points.is_float = scale < 0.0;
  points.scale = std::abs(scale);
  const size_t bytes_of_value = points.is_float ? 4 : 2;
  points.frame_bytes =
      bytes_of_value * (4 * points.num_points + static_cast<size_t>(bytes.Word(kAnalog)));
  double block = bytes.Word(kDataBlock);
  if (block == 0.0) block = parameters.Number("POINT:DATA_START").value_or(0.0);
  points.start = (Count(block, "block of the data", kDataBlock, bytes) - 1) * kC3dBlock;
  return points;
}

// Frames that the file ends before are an error, or are left out.
void FitFile(const C3dBytes& bytes, bool skip_bad_rows, PointLayout* points,
             std::vector<std::string>* notes) {
  const size_t room = bytes.size() - std::min(points->start, bytes.size());
  const size_t num_there = room / points->frame_bytes;
  if (num_there < points->num_frames) {
    const std::string words =
        fmt::format("expected {} frames of {} points from byte {} on, found {}", points->num_frames,
                    points->num_points, points->start, num_there);
    if (!skip_bad_rows || num_there == 0) bytes.Fail(bytes.size(), "the file ends; " + words);
    notes->push_back(words);
    points->num_frames = num_there;
  }
  if (points->num_frames <= size_t{kMostFrames} &&
      points->num_frames * points->num_points <= kMostPlaces) {
    return;
  }
  bytes.Fail(0, fmt::format("expected at most {} frames, and {} places of points, found {} frames "
                            "of {} points",
                            kMostFrames, kMostPlaces, points->num_frames, points->num_points));
}

std::optional<Eigen::Vector3d> PointAt(size_t at, const PointLayout& points,
                                       const C3dBytes& bytes) {
  Eigen::Vector3d position;
  const size_t step = points.is_float ? 4 : 2;
  for (size_t axis = 0; axis < 3; ++axis) {
    const size_t place = at + axis * step;
    position[static_cast<Eigen::Index>(axis)] =
        points.is_float ? bytes.Float(place) : points.scale * bytes.SignedWord(place);
  }
  // Of the sign: below zero where the point was not seen.
  const size_t place = at + 3 * step;
  const double residual = points.is_float ? bytes.Float(place) : bytes.SignedWord(place);
  if (residual < 0.0 || !position.allFinite()) return std::nullopt;
  return position;
}

// One a point, distinct; empty where it is no marker.
std::vector<std::string> NamesOfPoints(size_t num_points, const C3dParameters& parameters,
                                       std::vector<std::string>* notes) {
  std::set<std::string> computed, seen;
  for (const char* kind : {"ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS"}) {
    const std::string parameter = std::string("POINT:") + kind;
    for (const std::string& name : parameters.Texts(parameter)) computed.insert(name);
  }
  computed.erase("");
  std::vector<std::string> names = parameters.Texts("POINT:LABELS");
  names.resize(num_points);
  size_t num_computed = 0;
  for (size_t i = 0; i < num_points; ++i) {
    std::string& name = names[i];
    if (computed.count(name) > 0) {
      ++num_computed;
      name.clear();
      continue;
    }
    if (name.empty()) name = fmt::format("point {}", i + 1);
    if (!seen.insert(name).second) name += fmt::format(" ({})", i + 1);
    seen.insert(name);
  }
  if (num_computed > 0) {
    notes->push_back(
        fmt::format("{} points are left out that are no places but angles, forces or "
                    "other results of a model",
                    num_computed));
  }
  return names;
}

TakeFacts FactsOf(const C3dParameters& parameters, const C3dBytes& bytes,
                  std::vector<std::string>* notes) {
  TakeFacts facts;
  const double rate = parameters.Number("POINT:RATE").value_or(bytes.Float(kRate));
  if (rate > 0.0 && std::isfinite(rate)) facts.frame_rate = rate;
  const std::vector<std::string> units = parameters.Texts("POINT:UNITS");
  if (!units.empty()) facts.metres_per_unit = MetresPerUnit(units[0]);
  const std::vector<std::string> screen = parameters.Texts("POINT:Y_SCREEN");
  if (screen.empty()) return facts;
  static const std::map<std::string, std::string> kUp = {{"+X", "x"},  {"+Y", "y"},  {"+Z", "z"},
                                                         {"X", "x"},   {"Y", "y"},   {"Z", "z"},
                                                         {"-X", "-x"}, {"-Y", "-y"}, {"-Z", "-z"}};
  const auto up = kUp.find(screen[0]);
  if (up == kUp.end()) return facts;
  facts.up = up->second;
  if (notes != nullptr)
    notes->push_back(
        fmt::format("{} points up, as POINT:Y_SCREEN says; --up overrides", up->second));
  return facts;
}

}  // namespace

bool IsC3d(std::string_view bytes) {
  // Text has no zero byte, and a header of C3D has many.
  return bytes.size() >= kC3dBlock && bytes[0] != 0 && bytes[1] == 0x50 &&
         bytes.substr(0, kC3dBlock).find('\0') != bytes.npos;
}

TakeInFile ReadC3d(const std::filesystem::path& file, std::string_view content,
                   const TakeFileOptions& options, std::vector<std::string>* notes) {
  C3dBytes bytes(file, content);
  const C3dParameters parameters(&bytes);
  PointLayout points = FindPoints(parameters, bytes);
  FitFile(bytes, options.skip_bad_rows, &points, notes);
  TakeInFile take;
  take.facts = FactsOf(parameters, bytes, options.facts.up ? nullptr : notes);
  const std::vector<std::string> names = NamesOfPoints(points.num_points, parameters, notes);
  const size_t bytes_of_point = points.is_float ? 16 : 8;
  for (size_t i = 0; i < points.num_points; ++i) {
    if (names[i].empty()) continue;
    MarkerPath path{names[i], {}};
    path.positions.reserve(points.num_frames);
    for (size_t frame = 0; frame < points.num_frames; ++frame) {
      const size_t at = points.start + frame * points.frame_bytes + i * bytes_of_point;
      path.positions.push_back(PointAt(at, points, bytes));
    }
    take.markers.push_back(std::move(path));
  }
  return take;
}

}  // namespace clothfit
