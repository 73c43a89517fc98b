// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/pictures/picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/residuals/cloud_residuals.h"
#include "fitting/runs/obstacles.h"
#include "tracking/files/output_file.h"
#include "tracking/recording/folder/validation.h"

namespace clothfit {
namespace {

using Positions = std::map<int, Eigen::VectorXd>;  // by frame

const cv::Scalar kWhite(255, 255, 255), kInk(60, 50, 45), kThread(150, 130, 115);
const cv::Scalar kMeasured(30, 30, 30), kMiss(40, 40, 220), kHeld(0, 110, 230);  // BGR
// The two sides of the cloth in full light: blue and orange, apart for every eye.
const cv::Vec3d kFront(214, 160, 96), kBack(96, 170, 240), kObstacle(186, 184, 180);
constexpr int kShift = 4;  // fractional bits of drawn coordinates

// An orthographic view; pixels of a panel.
struct View {
  Eigen::Vector3d right, up, towards;  // unit, `towards` the eye
  Eigen::Vector3d centre;              // m
  double scale;                        // px/m
  cv::Point2d origin;                  // px

  cv::Point2d At(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d d = x - centre;
    return {origin.x + scale * right.dot(d), origin.y - scale * up.dot(d)};
  }
};

cv::Point Fixed(const cv::Point2d& p) {
  return {cvRound(p.x * (1 << kShift)), cvRound(p.y * (1 << kShift))};
}

struct Facet {
  std::array<Eigen::Vector3d, 3> corners;  // m
  bool is_cloth;
};

std::vector<Facet> FacetsOf(const ClothMesh& mesh, const Eigen::VectorXd& x) {
  std::vector<Facet> facets;
  for (const auto& t : mesh.triangles)
    facets.push_back(
        {{x.segment<3>(3 * t[0]), x.segment<3>(3 * t[1]), x.segment<3>(3 * t[2])}, true});
  return facets;
}

// What a panel shows of a facet, m: a sphere, in parts with no side longer than `longest`, so that
// what is nearer is drawn later.
struct Sight {
  Eigen::Vector3d centre;
  double radius, longest;
};

void AddInParts(const Facet& facet, const Sight& sight, std::vector<Facet>* facets) {
  const auto& c = facet.corners;
  int k = 0;  // of the longest side's first corner
  double length = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double side = (c[(i + 1) % 3] - c[i]).norm();
    if (side > length) std::tie(k, length) = std::tuple(i, side);
  }
  // No point of a triangle is as far from a corner as its longest side is long.
  if ((c[0] - sight.centre).norm() > sight.radius + length) return;
  if (length <= sight.longest) {
    facets->push_back(facet);
    return;
  }
  const Eigen::Vector3d &a = c[k], &b = c[(k + 1) % 3], &opposite = c[(k + 2) % 3];
  const Eigen::Vector3d middle = 0.5 * (a + b);
  AddInParts({{a, middle, opposite}, facet.is_cloth}, sight, facets);
  AddInParts({{middle, b, opposite}, facet.is_cloth}, sight, facets);
}

void AddObstacle(const ObstacleSurface& obstacle, int frame, const Sight& sight, const View& view,
                 std::vector<Facet>* facets) {
  const auto last = static_cast<int>(obstacle.positions.size()) - 1;
  const Eigen::VectorXd& x = obstacle.positions[static_cast<std::size_t>(std::min(frame, last))];
  for (std::size_t t = 0; t + 2 < obstacle.triangles.size(); t += 3) {
    Facet facet{{}, false};
    for (std::size_t k = 0; k < 3; ++k)
      facet.corners[k] = x.segment<3>(3 * obstacle.triangles[t + k]);
    const auto& c = facet.corners;
    const bool is_away = (c[1] - c[0]).cross(c[2] - c[0]).dot(view.towards) < 0.0;
    if (!(obstacle.is_cut && is_away)) AddInParts(facet, sight, facets);
  }
}

void DrawFacets(const std::vector<Facet>& facets, const View& view, cv::Mat* image) {
  // Cloth sinks into what gives way: by as much an obstacle is drawn sooner, m.
  constexpr double kSunk = 0.03;
  const auto depth = [&](const Facet& facet) {
    const auto& c = facet.corners;
    return view.towards.dot(c[0] + c[1] + c[2]) / 3.0 - (facet.is_cloth ? 0.0 : kSunk);
  };
  std::vector<const Facet*> order;
  for (const Facet& facet : facets) order.push_back(&facet);
  std::stable_sort(order.begin(), order.end(),
                   [&](const Facet* a, const Facet* b) { return depth(*a) < depth(*b); });
  const Eigen::Vector3d light = (view.towards + view.up + 0.5 * view.right).normalized();
  constexpr double kGrid = 0.85;  // how light the cloth's grid is beside it
  for (const Facet* const facet : order) {
    const auto& c = facet->corners;
    const Eigen::Vector3d normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
    const bool front = normal.dot(view.towards) > 0.0;
    const double shade = 0.6 + 0.4 * std::abs(normal.dot(light));
    const cv::Vec3d colour = shade * (!facet->is_cloth ? kObstacle : front ? kFront : kBack);
    const cv::Scalar fill(colour[0], colour[1], colour[2]);
    std::vector<cv::Point> outline;
    for (const Eigen::Vector3d& corner : c) outline.push_back(Fixed(view.At(corner)));
    cv::fillConvexPoly(*image, outline, fill, cv::LINE_AA, kShift);
    cv::polylines(*image, outline, true, facet->is_cloth ? kGrid * fill : fill, 1, cv::LINE_AA,
                  kShift);
  }
}

// Where hands and other handles hold the cloth, as far as their paths are known.
void DrawHandles(const Scene& scene, int frame, const View& view, cv::Mat* image) {
  for (const SceneHandle& handle : scene.handles) {
    const double time = scene.FrameTime(frame);
    if (!handle.path.is_known() || time > handle.released_after) continue;
    cv::circle(*image, Fixed(view.At(handle.path.At(time))), 5 << kShift, kHeld, cv::FILLED,
               cv::LINE_AA, kShift);
  }
}

void DrawMarkers(const Scene& scene, int frame, const Eigen::VectorXd& x, const View& view,
                 cv::Mat* image, double* rms) {
  double squares = 0.0;
  int count = 0;
  for (const MarkerObservation& marker : scene.markers) {
    if (marker.frame != frame) continue;
    const Eigen::Vector3d simulated = marker.on_cloth.At(x);
    cv::line(*image, Fixed(view.At(simulated)), Fixed(view.At(marker.position)), kMiss, 2,
             cv::LINE_AA, kShift);
    cv::circle(*image, Fixed(view.At(marker.position)), 4 << kShift, kWhite, cv::FILLED,
               cv::LINE_AA, kShift);
    cv::circle(*image, Fixed(view.At(marker.position)), 3 << kShift, kMeasured, cv::FILLED,
               cv::LINE_AA, kShift);
    squares += (simulated - marker.position).squaredNorm();
    ++count;
  }
  *rms = count > 0 ? std::sqrt(squares / count) : std::numeric_limits<double>::quiet_NaN();
}

// Points without names, each with its way to the surface; their root mean square distance, m.
void DrawClouds(const Scene& scene, int frame, const Eigen::VectorXd& x, const View& view,
                cv::Mat* image, double* rms) {
  const CloudResiduals to_surface(scene, 0.0);
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; scene.clouds && i < scene.clouds->observations.size(); ++i) {
    const CloudObservation& cloud = scene.clouds->observations[i];
    if (cloud.frame != frame) continue;
    const std::vector<PointResidual> distances = to_surface.OfPoints(cloud, x);
    for (std::size_t k = 0; k < distances.size(); ++k) {
      const cv::Point at = Fixed(view.At(cloud.points[k]));
      cv::line(*image, Fixed(view.At(distances[k].point.At(x))), at, kMiss, 1, cv::LINE_AA, kShift);
      cv::circle(*image, at, 1 << kShift, kMeasured, cv::FILLED, cv::LINE_AA, kShift);
      squares += distances[k].value * distances[k].value;
    }
    count += distances.size();
  }
  if (count > 0) *rms = std::sqrt(squares / static_cast<double>(count));
}

void Write(const std::string& text, int line, const cv::Scalar& colour, cv::Mat* image) {
  cv::putText(*image, text, {14, 26 + 24 * line}, cv::FONT_HERSHEY_SIMPLEX, 0.55, colour, 1,
              cv::LINE_AA);
}

std::vector<int> ChooseFrames(const Scene& scene, const std::vector<int>& asked) {
  const int last = scene.recording.frame_count - 1;
  for (const int frame : asked) CheckFrame(scene.recording, frame, "--frames");
  if (!asked.empty()) return asked;
  return {last / 8, 3 * last / 8, 5 * last / 8, 7 * last / 8};
}

Positions Simulate(const FittedRun& fitted, const FreeParameters& free,
                   const Eigen::VectorXd& theta, const std::vector<int>& frames) {
  Positions positions;
  const int last = *std::max_element(frames.begin(), frames.end());
  const int reached = SimulateFrames(fitted.scene, fitted.config, free, theta, last,
                                     [&](int frame, const State& state) {
                                       if (std::count(frames.begin(), frames.end(), frame) > 0)
                                         positions[frame] = state.x;
                                     });
  if (reached > last) return positions;
  throw std::runtime_error(
      fmt::format("the simulation fails after frame {}; frame {} is asked for", reached - 1, last));
}

Positions Chosen(const std::vector<Eigen::VectorXd>& motion, const std::vector<int>& frames) {
  Positions positions;
  for (const int frame : frames) {
    if (frame >= static_cast<int>(motion.size()))
      throw std::runtime_error(fmt::format("the baseline ends with frame {}; frame {} is asked for",
                                           motion.size() - 1, frame));
    positions[frame] = motion[static_cast<std::size_t>(frame)];
  }
  return positions;
}

Eigen::Vector3d Centre(const Eigen::VectorXd& x) {
  return Eigen::Map<const Eigen::Matrix3Xd>(x.data(), 3, x.size() / 3).rowwise().mean();
}

struct PictureRow {
  std::string title;
  Positions positions;
  const char* fitted = ", fitted";  // of frames that are; of a recording none is yet
};

cv::Mat DrawPanel(const FittedRun& fitted, const std::vector<ObstacleSurface>& obstacles, int frame,
                  const PictureRow& row, View view, const PictureOptions& options) {
  const Eigen::VectorXd& x = row.positions.at(frame);
  cv::Mat image(options.panel, options.panel, CV_8UC3, kWhite);
  view.origin = {0.5 * options.panel, 0.56 * options.panel};
  std::vector<Facet> facets = FacetsOf(fitted.scene.mesh, x);
  constexpr double kParts = 24.0;  // of a panel, that are drawn as one
  const double width = options.panel / view.scale;
  const Sight sight{view.centre, width, width / kParts};
  for (const ObstacleSurface& obstacle : obstacles)
    AddObstacle(obstacle, frame, sight, view, &facets);
  DrawFacets(facets, view, &image);
  double rms = 0.0, of_clouds = std::numeric_limits<double>::quiet_NaN();
  DrawClouds(fitted.scene, frame, x, view, &image, &of_clouds);
  DrawMarkers(fitted.scene, frame, x, view, &image, &rms);
  DrawHandles(fitted.scene, frame, view, &image);
  if (!std::isfinite(rms)) rms = of_clouds;
  const char* kind = fitted.scene.IsHeldOut(frame)   ? ", held out"
                     : fitted.scene.is_fitted[frame] ? row.fitted
                                                     : "";
  Write(fmt::format("{}: {:.2f} s{}", row.title, fitted.scene.FrameTime(frame), kind), 0, kInk,
        &image);
  if (std::isfinite(rms)) Write(fmt::format("{:.1f} mm rms", 1e3 * rms), 1, kMiss, &image);
  return image;
}

// width: m of a panel.
View MakeView(const PictureOptions& options, double width) {
  View view;
  const double a = options.azimuth, e = options.elevation;
  view.right = Eigen::Vector3d(std::cos(a), std::sin(a), 0.0);
  view.towards =
      Eigen::Vector3d(std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e));
  view.up = view.towards.cross(view.right);
  view.scale = options.panel / width;
  return view;
}

void Beside(const cv::Mat& image, cv::Mat* row) {
  if (row->empty()) {
    *row = image;
  } else {
    cv::hconcat(*row, image, *row);
  }
}

void Below(const cv::Mat& row, cv::Mat* rows) {
  if (rows->empty()) {
    *rows = row;
  } else {
    cv::vconcat(*rows, row, *rows);
  }
}

std::string PictureExtension(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".png" || extension == ".jpg") return extension;
  throw InputError(file.string(), "expected a name that ends in .png or .jpg");
}

void WritePicture(const cv::Mat& image, const std::string& extension,
                  const std::filesystem::path& file, Overwrite overwrite) {
  std::vector<unsigned char> encoded;
  cv::imencode(extension, image, encoded);
  WriteOutputFile(file,
                  std::string_view(reinterpret_cast<const char*>(encoded.data()), encoded.size()),
                  overwrite);
}

// A panel a frame; the last row says where to look. `values`: by which obstacles stand.
void DrawRows(const FittedRun& fitted, const Eigen::VectorXd& values,
              const std::vector<PictureRow>& rows, const PictureOptions& options,
              const std::filesystem::path& file, Overwrite overwrite) {
  std::vector<Eigen::VectorXd> cloth;
  for (const auto& [frame, x] : rows.back().positions) cloth.push_back(x);
  const std::vector<ObstacleSurface> obstacles = ObstacleSurfaces(fitted.scene, values, cloth);
  View view = MakeView(options, fitted.scene.recording.cloth.size.maxCoeff() / 0.68);
  cv::Mat image;
  for (const PictureRow& row : rows) {
    cv::Mat panels;
    for (const int frame : ChooseFrames(fitted.scene, options.frames)) {
      view.centre = Centre(rows.back().positions.at(frame));
      Beside(DrawPanel(fitted, obstacles, frame, row, view, options), &panels);
    }
    Below(panels, &image);
  }
  WritePicture(image, PictureExtension(file), file, overwrite);
}

// Before anything is simulated.
void CheckPictureFile(const std::filesystem::path& file, Overwrite overwrite) {
  CheckMayWrite(file, overwrite);
  PictureExtension(file);
}

}  // namespace

void DrawRun(const FittedRun& fitted, const RunFolder& run, const PictureOptions& options,
             const std::filesystem::path& file, Overwrite overwrite) {
  CheckPictureFile(file, overwrite);
  const std::vector<int> frames = ChooseFrames(fitted.scene, options.frames);
  const FreeParameters free(fitted.config, fitted.scene, MakeParameterTable());
  const Eigen::VectorXd found = run.ReadParameters(free);
  const Positions before = options.before.empty() ? Simulate(fitted, free, free.start(), frames)
                                                  : Chosen(options.before, frames);
  DrawRows(
      fitted, free.Values(found),
      {{options.titles[0], before}, {options.titles[1], Simulate(fitted, free, found, frames)}},
      options, file, overwrite);
}

void DrawRecording(const FittedRun& unfitted, const PictureOptions& options,
                   const std::filesystem::path& file, Overwrite overwrite) {
  CheckPictureFile(file, overwrite);
  const std::vector<int> frames = ChooseFrames(unfitted.scene, options.frames);
  const FreeParameters free(unfitted.config, unfitted.scene, MakeParameterTable());
  DrawRows(unfitted, free.Values(free.start()),
           {{"default", Simulate(unfitted, free, free.start(), frames), ""}}, options, file,
           overwrite);
}

void DrawCloths(const ClothMesh& mesh, const std::vector<std::vector<ClothPanel>>& rows,
                double width, const PictureOptions& options, const std::filesystem::path& file) {
  const std::string extension = PictureExtension(file);
  View view = MakeView(options, width);
  view.origin = {0.5 * options.panel, 0.56 * options.panel};
  cv::Mat all;
  for (const std::vector<ClothPanel>& row : rows) {
    cv::Mat panels;
    for (const ClothPanel& panel : row) {
      cv::Mat image(options.panel, options.panel, CV_8UC3, kWhite);
      view.centre = panel.centre;
      DrawFacets(FacetsOf(mesh, panel.x), view, &image);
      Write(panel.title, 0, kInk, &image);
      Beside(image, &panels);
    }
    Below(panels, &all);
  }
  WritePicture(all, extension, file, Overwrite::kAllow);
}

}  // namespace clothfit
