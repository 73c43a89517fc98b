// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/folder/tables.h"

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/camera/camera_file.h"
#include "tracking/recording/limits.h"
#include "tracking/text/csv.h"

namespace clothfit {
namespace {

// ",x,y" or ",x,y,z", to be put behind other fields.
template <int kSize>
std::string CsvFields(const Eigen::Matrix<double, kSize, 1>& vector) {
  std::string text;
  for (int i = 0; i < kSize; ++i) text += fmt::format(",{}", vector[i]);
  return text;
}

}  // namespace

std::vector<Marker> ReadMarkers(const std::filesystem::path& file, std::vector<int>* lines) {
  std::vector<Marker> markers;
  ReadCsv(file, {"frame", "id", "u", "v", "x", "y", "z"}, [&](const CsvRow& row) {
    const int frame = row.Integer(0);
    const int id = row.Integer(1);
    if (row.IsMissing(4, 3)) return;
    markers.push_back({frame, id, row.Vector2(2), row.Vector3(4)});
    lines->push_back(row.line());
  });
  return markers;
}

std::vector<Track> ReadTracks(const std::filesystem::path& file, const Recording& recording,
                              std::vector<int>* lines) {
  std::vector<Track> tracks;
  ReadCsv(file, {"frame", "camera", "id", "u", "v", "x", "y"}, [&](const CsvRow& row) {
    const int frame = row.Integer(0);
    const std::string name = row.Text(1);
    const std::optional<int> camera = FindCamera(recording, name);
    if (!camera) row.Fail(1, IsNoCamera(name, recording.cameras));
    const int id = row.Integer(2);
    if (row.IsMissing(5, 2)) return;
    tracks.push_back({frame, *camera, id, row.Vector2(3), row.Vector2(5)});
    lines->push_back(row.line());
  });
  return tracks;
}

HandleDescription::Path ReadHandlePath(const std::filesystem::path& file,
                                       const Recording& recording) {
  HandleDescription::Path path(static_cast<size_t>(recording.frame_count));
  std::vector<int> line_of_frame(path.size(), 0);
  ReadCsv(file, {"frame", "x", "y", "z"}, [&](const CsvRow& row) {
    const int frame = row.Integer(0);
    if (frame < 0 || frame >= recording.frame_count) {
      row.Fail(0, fmt::format("{} is outside 0..{}", frame, recording.frame_count - 1));
    }
    const size_t index = static_cast<size_t>(frame);
    if (line_of_frame[index] != 0) {
      row.Fail(0, fmt::format("{} appeared already on line {}", frame, line_of_frame[index]));
    }
    line_of_frame[index] = row.line();
    if (!row.IsMissing(1, 3)) path[index] = row.Vector3(1);
  });
  return path;
}

std::vector<ObstacleDescription::Pose> ReadObstaclePath(const std::filesystem::path& file,
                                                        const Recording& recording) {
  std::vector<ObstacleDescription::Pose> path(static_cast<size_t>(recording.frame_count));
  std::vector<int> line_of_frame(path.size(), 0);
  ReadCsv(file, {"frame", "x", "y", "z", "rx", "ry", "rz"}, [&](const CsvRow& row) {
    const int frame = row.Integer(0);
    if (frame < 0 || frame >= recording.frame_count) {
      row.Fail(0, fmt::format("{} is outside 0..{}", frame, recording.frame_count - 1));
    }
    const size_t index = static_cast<size_t>(frame);
    if (line_of_frame[index] != 0) {
      row.Fail(0, fmt::format("{} appeared already on line {}", frame, line_of_frame[index]));
    }
    line_of_frame[index] = row.line();
    path[index] = {row.Vector3(1), row.Vector3(4)};
  });
  for (size_t frame = 0; frame < path.size(); ++frame) {
    if (line_of_frame[frame] != 0) continue;
    throw InputError(file.string(), fmt::format("no row for frame {}; expected one for each of {}",
                                                frame, path.size()));
  }
  return path;
}

std::vector<PlacedPoint> ReadPlacedPoints(const std::filesystem::path& file) {
  std::vector<PlacedPoint> points;
  ReadCsv(
      file, {"u", "v", "x", "y", "z"},
      [&](const CsvRow& row) {
        points.push_back({row.Vector2(0), row.Vector3(2)});
      },
      kMostPlacedPoints);
  return points;
}

std::string MarkersAsCsv(const std::vector<Marker>& markers) {
  std::string text = "frame,id,u,v,x,y,z\n";
  for (const Marker& marker : markers) {
    text += fmt::format("{},{}{}{}\n", marker.frame, marker.id, CsvFields<2>(marker.uv),
                        CsvFields<3>(marker.position));
  }
  return text;
}

std::string TracksAsCsv(const Recording& recording) {
  std::string text = "frame,camera,id,u,v,x,y\n";
  for (const Track& track : recording.tracks) {
    text += fmt::format("{},{},{}{}{}\n", track.frame,
                        recording.cameras.at(static_cast<size_t>(track.camera)).name, track.id,
                        CsvFields<2>(track.uv), CsvFields<2>(track.pixel));
  }
  return text;
}

std::string HandlePathAsCsv(const HandleDescription::Path& path) {
  std::string text = "frame,x,y,z\n";
  for (size_t frame = 0; frame < path.size(); ++frame) {
    if (path[frame]) text += fmt::format("{}{}\n", frame, CsvFields<3>(*path[frame]));
  }
  return text;
}

std::string ObstaclePathAsCsv(const std::vector<ObstacleDescription::Pose>& path) {
  std::string text = "frame,x,y,z,rx,ry,rz\n";
  for (size_t frame = 0; frame < path.size(); ++frame) {
    text += fmt::format("{}{}{}\n", frame, CsvFields<3>(path[frame].position),
                        CsvFields<3>(path[frame].rotation));
  }
  return text;
}

std::string PlacedPointsAsCsv(const std::vector<PlacedPoint>& points) {
  std::string text = "u,v,x,y,z\n";
  for (const PlacedPoint& point : points) {
    text += fmt::format("{},{}{}\n", point.uv.x(), point.uv.y(), CsvFields<3>(point.position));
  }
  return text;
}

}  // namespace clothfit
