// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/report/scene/cameras.h"

#include <opencv2/imgproc.hpp>

#include "autodiff_sim/base/parallel.h"
#include "tracking/recording/pictures/images.h"

namespace clothfit {
namespace {

using Json = ReportBlobs::Json;

Json CameraAsJson(const Recording& recording, int index) {
  const Camera& camera = recording.cameras[index];
  Json json;
  json["name"] = camera.name;
  json["size"] = {camera.width, camera.height};
  json["focal"] = {camera.fx, camera.fy};
  json["centre"] = {camera.cx, camera.cy};
  json["distortion"] = camera.distortion;
  json["rotation"] = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      json["rotation"].push_back(camera.camera_from_world_rotation(row, column));
    }
  }
  const Eigen::Vector3d& t = camera.camera_from_world_translation;
  json["translation"] = {t.x(), t.y(), t.z()};
  json["held_out"] = IsHeldOutCamera(recording, index);
  return json;
}

// The outlines of one camera's masks as polygons.
struct Outlines {
  std::vector<std::int32_t> corners;   // x, y in px
  std::vector<std::int32_t> polygons;  // frame, number of corners
};

void AddOutlines(int frame, const cv::Mat& mask, Outlines* outlines) {
  constexpr double kSlack = 0.75;  // px, by which a polygon may miss the outline
  constexpr std::size_t kFewest = 3;
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(mask, contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (const std::vector<cv::Point>& contour : contours) {
    std::vector<cv::Point> polygon;
    cv::approxPolyDP(contour, polygon, kSlack, true);
    if (polygon.size() < kFewest) continue;
    outlines->polygons.insert(outlines->polygons.end(),
                              {frame, static_cast<std::int32_t>(polygon.size())});
    for (const cv::Point& corner : polygon) {
      outlines->corners.insert(outlines->corners.end(), {corner.x, corner.y});
    }
  }
}

std::vector<Outlines> FindAllOutlines(const Recording& recording) {
  std::vector<Outlines> found(recording.cameras.size());
  ParallelFor(static_cast<int>(recording.files.size()), 0, [&](int camera, int) {
    for (const auto& [frame, file] : recording.files[camera].masks) {
      AddOutlines(frame, LoadMask(recording, camera, frame), &found[camera]);
    }
  });
  return found;
}

Json OutlinesAsJson(const Outlines& outlines, ReportBlobs* blobs) {
  if (outlines.polygons.empty()) return nullptr;
  return {{"corners", blobs->AddIntegers(outlines.corners, 2)},
          {"polygons", blobs->AddIntegers(outlines.polygons, 2)}};
}

}  // namespace

Json CamerasAsJson(const ReportScene& report, ReportBlobs* blobs) {
  const Recording& recording = report.scene().recording;
  const std::vector<Outlines> outlines = FindAllOutlines(recording);
  Json cameras = Json::array();
  for (int c = 0; c < static_cast<int>(recording.cameras.size()); ++c) {
    cameras.push_back(CameraAsJson(recording, c));
    cameras.back()["outlines"] = OutlinesAsJson(outlines[c], blobs);
    cameras.back()["pictures"] = nullptr;
  }
  return cameras;
}

}  // namespace clothfit
