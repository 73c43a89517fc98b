// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/motive_file.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <random>

#include <fmt/format.h>

namespace clothfit {
namespace {

constexpr int kFrames = 60;
constexpr double kCurvature = 4.0;  // 1/m

// A sheet bent round a cylinder whose axis is perpendicular to `angle` in (u, v).
Eigen::Vector3d OnCylinder(const Eigen::Vector2d& uv, double angle) {
  const Eigen::Vector2d across(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d along(-across.y(), across.x());
  const double arc = kCurvature * uv.dot(across);
  const Eigen::Vector2d flat = std::sin(arc) / kCurvature * across + uv.dot(along) * along;
  return {flat.x(), flat.y(), 1.0 + (1.0 - std::cos(arc)) / kCurvature};
}

}  // namespace

MarkerTake BentSheetTake(const std::vector<Eigen::Vector2d>& uv, double noise) {
  std::mt19937 random(5);
  std::normal_distribution<double> gaussian(0.0, 1.0);
  MarkerTake take;
  take.file = "take.csv";
  take.frame_rate = 120.0;
  for (size_t i = 0; i < uv.size(); ++i) {
    MarkerPath path{fmt::format("m{}", i), {}};
    for (int frame = 0; frame < kFrames; ++frame) {
      Eigen::Vector3d position = OnCylinder(uv[i], M_PI * frame / kFrames);
      for (int axis = 0; axis < 3; ++axis) position[axis] += noise * gaussian(random);
      path.positions.emplace_back(position);
    }
    take.markers.push_back(path);
  }
  return take;
}

std::string MotiveCsv(const MarkerTake& take, const std::string& units, double metres_per_unit) {
  std::string types, names, ids, quantities, axes;
  for (const MarkerPath& marker : take.markers) {
    for (const char* axis : {"X", "Y", "Z"}) {
      types += ",Marker";
      names += "," + marker.name;
      ids += ",\"ID-" + marker.name + "\"";
      quantities += ",Position";
      axes += std::string(",") + axis;
    }
  }
  std::string text = fmt::format(
      "Format Version,1.23,Take Name,test,Take Notes,,Capture Frame Rate,{0:.6f},"
      "Export Frame Rate,{0:.6f},Total Exported Frames,{1},Rotation Type,Quaternion,"
      "Length Units,{2},Coordinate Space,Global\r\n\r\n,Type{3}\r\n,Name{4}\r\n,ID{5}\r\n,{6}\r\n"
      "Frame,Time (Seconds){7}\r\n",
      take.frame_rate, take.num_frames(), units, types, names, ids, quantities, axes);
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    text += fmt::format("{},{:.6f}", frame, double(frame) / take.frame_rate);
    for (const MarkerPath& marker : take.markers) {
      if (!marker.positions[frame]) {
        text += ",,,";
        continue;
      }
      const Eigen::Vector3d p = *marker.positions[frame] / metres_per_unit;
      text += fmt::format(",{},{},{}", p.x(), p.z(), -p.y());
    }
    text += "\r\n";
  }
  return text;
}

MarkerTake TakeOfRecording(const Recording& recording) {
  MarkerTake take;
  take.file = recording.path;
  take.frame_rate = recording.frame_rate;
  for (const HandleDescription& handle : recording.handles) {
    take.markers.push_back({handle.name, *handle.path});
  }
  std::map<int, HandleDescription::Path> paths;
  for (const Marker& marker : recording.markers) {
    HandleDescription::Path& path = paths[marker.id];
    path.resize(static_cast<size_t>(recording.frame_count));
    path[static_cast<size_t>(marker.frame)] = marker.position;
  }
  for (const auto& [id, path] : paths) take.markers.push_back({fmt::format("m{}", id), path});
  return take;
}

double LayoutDifference(const std::vector<Eigen::Vector2d>& a,
                        const std::vector<Eigen::Vector2d>& b, bool mirror) {
  using Complex = std::complex<double>;
  const auto centred = [](const std::vector<Eigen::Vector2d>& uv, double sign) {
    std::vector<Complex> points;
    Complex mean;
    for (const Eigen::Vector2d& point : uv) {
      points.emplace_back(point.x(), sign * point.y());
      mean += points.back() / double(uv.size());
    }
    for (Complex& point : points) point -= mean;
    return points;
  };
  const std::vector<Complex> p = centred(a, mirror ? -1.0 : 1.0);
  const std::vector<Complex> q = centred(b, 1.0);
  Complex turn;
  for (size_t i = 0; i < p.size(); ++i) turn += q.at(i) * std::conj(p[i]);
  turn /= std::abs(turn);
  double largest = 0.0;
  for (size_t i = 0; i < p.size(); ++i) largest = std::max(largest, std::abs(turn * p[i] - q[i]));
  return largest;
}

}  // namespace clothfit
