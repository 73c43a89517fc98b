// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// How far the outline of the simulated cloth is from the measured one, on the cloth.
#include <map>
#include <memory>

#include <opencv2/imgproc.hpp>

#include "autodiff_sim/base/parallel.h"
#include "fitting/report/fields/scalar_field.h"
#include "fitting/report/fields/spread_values.h"
#include "tracking/silhouette/outline.h"
#include "tracking/silhouette/raster.h"

namespace clothfit {
namespace {

constexpr double kRim = 2.0;     // px from the picture's edge, where the picture cuts both outlines
constexpr int kLeastRounds = 3;  // of spreading, so that an outline is seen as a band

// Distance (px) of each pixel from the outline of a mask.
cv::Mat DistanceFromOutline(const BitMask& mask) {
  const cv::Mat inside = mask.ToMat();
  cv::Mat eroded, distance;
  cv::erode(inside, eroded, cv::Mat(), {-1, -1}, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(255 - (inside - eroded), distance, cv::DIST_L2, cv::DIST_MASK_5);
  return distance;
}

// The rasters of the cameras that have masks.
std::map<int, std::unique_ptr<SilhouetteRaster>> RastersOf(const ReportScene& report) {
  std::map<int, std::unique_ptr<SilhouetteRaster>> rasters;
  for (const SilhouetteObservation& seen : report.silhouettes->observations) {
    std::unique_ptr<SilhouetteRaster>& raster = rasters[seen.camera];
    if (raster != nullptr) continue;
    raster = std::make_unique<SilhouetteRaster>(report.scene().recording.cameras[seen.camera],
                                                report.scene().mesh.triangles);
  }
  return rasters;
}

// Adds the pieces of one camera's simulated outline, each with its distance in m: px times depth
// over focal length.
void AddOutline(const SilhouetteRaster& raster, const std::vector<MeshEdge>& edges,
                const SilhouetteObservation& seen, const Eigen::VectorXd& x, SpreadValues* spread) {
  if (seen.mask.Count() == 0) return;  // the cloth is out of sight: nothing to be near
  const Camera& camera = raster.camera();
  BitMask covered;
  raster.Draw(x, &covered);
  const cv::Mat distance = DistanceFromOutline(seen.mask);
  for (const OutlinePiece& piece : FindOutline(camera, edges, raster.triangles(), x, covered)) {
    const Eigen::Vector2d pixel = 0.5 * (piece.pixels[0] + piece.pixels[1]);
    const bool is_within = pixel.x() >= kRim && pixel.y() >= kRim &&
                           pixel.x() <= camera.width - 1 - kRim &&
                           pixel.y() <= camera.height - 1 - kRim;
    if (!is_within) continue;
    const double share = 0.5 * (piece.shares[0] + piece.shares[1]);
    const double depth = 0.5 * (piece.depths[0] + piece.depths[1]);
    const double off = distance.at<float>(cvRound(pixel.y()), cvRound(pixel.x()));
    spread->Add(static_cast<std::size_t>(seen.frame),
                {{piece.nodes[0], piece.nodes[1], piece.nodes[0]}, {1.0 - share, share, 0.0}},
                off * 2.0 * depth / (camera.fx + camera.fy));
  }
}

}  // namespace

std::vector<ScalarField> OutlineField(const ReportScene& report) {
  if (report.silhouettes == nullptr || report.silhouettes->observations.empty()) return {};
  const auto rasters = RastersOf(report);
  const std::vector<MeshEdge> edges = FindEdges(report.scene().mesh.triangles);
  const std::vector<SilhouetteObservation>& all = report.silhouettes->observations;
  ScalarField field{"outline", "Distance from the measured outline", "m", false, {}};
  for (const Motion& motion : report.motions) {
    const auto frames = static_cast<int>(motion.positions.size());
    SpreadValues spread(report.scene().mesh, motion.positions.size(), kLeastRounds);
    ParallelFor(frames, 0, [&](int frame, int) {
      for (const SilhouetteObservation& seen : all) {
        if (seen.frame != frame) continue;
        AddOutline(*rasters.at(seen.camera), edges, seen, motion.positions[frame], &spread);
      }
    });
    field.values[motion.name] = spread.Values();
  }
  return {field};
}

}  // namespace clothfit
