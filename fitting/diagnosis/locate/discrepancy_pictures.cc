// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/discrepancy_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "fitting/pictures/line_chart.h"

namespace clothfit {
namespace {

const cv::Scalar kInk(40, 40, 40), kFaint(210, 210, 210), kPatch(60, 60, 230);
const cv::Scalar kBlue(178, 114, 0), kOrange(0, 94, 213);  // Okabe and Ito 2008
constexpr double kText = 0.48;

enum class Align { kLeft, kCentre, kRight };

void Write(const std::string& text, cv::Point at, Align align, cv::Mat* picture,
           double size = kText) {
  int base = 0;
  const cv::Size box = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, size, 1, &base);
  if (align == Align::kCentre) at.x -= box.width / 2;
  if (align == Align::kRight) at.x -= box.width;
  at.y += box.height / 2;
  cv::putText(*picture, text, at, cv::FONT_HERSHEY_SIMPLEX, size, kInk, 1, cv::LINE_AA);
}

// Viridis of 0 to 1, which grows evenly lighter.
cv::Vec3b Colour(double share) {
  static const cv::Mat table = [] {
    cv::Mat grey(1, 256, CV_8U), colours;
    for (int i = 0; i < 256; ++i) grey.at<uchar>(0, i) = static_cast<uchar>(i);
    cv::applyColorMap(grey, colours, cv::COLORMAP_VIRIDIS);
    return colours;
  }();
  return table.at<cv::Vec3b>(0, std::clamp(static_cast<int>(std::lround(255.0 * share)), 0, 255));
}

// A linear axis from `low` to `high` along `length` px.
struct Axis {
  double low, high;
  int begin, length;
  int At(double value) const {
    return begin + static_cast<int>(std::lround((value - low) / (high - low) * length));
  }
};

double Magnitude(const MissingForce& missing, double time, const Eigen::Vector2d& uv) {
  return missing.layout.At(missing.force, time, uv).norm();
}

// A round number at or above the largest node's force.
double TopOfScale(const MissingForce& missing) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < missing.force.size(); i += 3)
    largest = std::max(largest, missing.force.segment<3>(i).norm());
  if (largest <= 0.0) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(largest)));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0}) {
    if (largest <= step * decade * (1.0 + 1e-9)) return step * decade;
  }
  return 10.0 * decade;
}

void DrawScale(const cv::Rect& box, double top, cv::Mat* picture) {
  for (int y = 0; y < box.height; ++y) {
    const cv::Vec3b c = Colour(1.0 - static_cast<double>(y) / (box.height - 1));
    cv::line(*picture, {box.x, box.y + y}, {box.x + box.width, box.y + y},
             cv::Scalar(c[0], c[1], c[2]));
  }
  cv::rectangle(*picture, box, kInk);
  for (const double tick : LinearTicks(0.0, top, 5)) {
    const int y = box.y + box.height - static_cast<int>(std::lround(tick / top * (box.height - 1)));
    cv::line(*picture, {box.x + box.width, y}, {box.x + box.width + 4, y}, kInk);
    Write(fmt::format("{:g}", tick), {box.x + box.width + 8, y}, Align::kLeft, picture);
  }
  Write("N/m^2", {box.x - 4, box.y - 16}, Align::kLeft, picture);
}

struct Panel {
  Axis u, v;  // v upwards
};

// |f| at one time over the cloth.
void DrawPanel(const MissingForce& missing, const Location& location, double time, double top,
               const Panel& panel, bool first, cv::Mat* picture) {
  const cv::Rect box(panel.u.begin, panel.v.begin, panel.u.length, panel.v.length);
  for (int y = 0; y < box.height; ++y) {
    for (int x = 0; x < box.width; ++x) {
      const Eigen::Vector2d uv(
          panel.u.low + (panel.u.high - panel.u.low) * (x + 0.5) / box.width,
          panel.v.high - (panel.v.high - panel.v.low) * (y + 0.5) / box.height);
      picture->at<cv::Vec3b>(box.y + y, box.x + x) = Colour(Magnitude(missing, time, uv) / top);
    }
  }
  const Discrepancy& m = location.discrepancy;
  const double rate = missing.layout.frame_rate;
  const auto up = [&](double v) { return 2 * box.y + box.height - panel.v.At(v); };
  if (time >= m.first_frame / rate - 1e-9 && time <= m.last_frame / rate + 1e-9) {
    cv::rectangle(*picture, {panel.u.At(m.low_uv.x()), up(m.low_uv.y())},
                  {panel.u.At(m.high_uv.x()), up(m.high_uv.y())}, kPatch, 2);
  }
  cv::rectangle(*picture, box, kInk);
  Write(fmt::format("{:.2f} s", time), {box.x + box.width / 2, box.y - 14}, Align::kCentre,
        picture);
  for (const double tick : LinearTicks(panel.u.low, panel.u.high, 3)) {
    const int x = panel.u.At(tick);
    cv::line(*picture, {x, box.y + box.height}, {x, box.y + box.height + 4}, kInk);
    Write(fmt::format("{:g}", tick), {x, box.y + box.height + 16}, Align::kCentre, picture, 0.42);
  }
  Write("u / m", {box.x + box.width / 2, box.y + box.height + 36}, Align::kCentre, picture);
  if (!first) return;
  for (const double tick : LinearTicks(panel.v.low, panel.v.high, 3)) {
    cv::line(*picture, {box.x - 4, up(tick)}, {box.x, up(tick)}, kInk);
    Write(fmt::format("{:g}", tick), {box.x - 8, up(tick)}, Align::kRight, picture, 0.42);
  }
  Write("v / m", {box.x - 8, box.y - 14}, Align::kRight, picture);
}

void DrawLine(const std::vector<double>& values, const Axis& time, const Axis& strength,
              double step, const cv::Scalar& colour, cv::Mat* picture) {
  std::vector<cv::Point> points;
  for (std::size_t i = 0; i < values.size(); ++i) {
    points.emplace_back(time.At(static_cast<double>(i) * step),
                        2 * strength.begin + strength.length - strength.At(values[i]));
  }
  cv::polylines(*picture, points, false, colour, 2, cv::LINE_AA);
}

// Over time: the mean over the cloth and the strongest place.
void DrawCourse(const MissingForce& missing, const Location& location, double top,
                const cv::Rect& box, cv::Mat* picture) {
  const double rate = missing.layout.frame_rate;
  const Axis time = {0.0, missing.last_frame / rate, box.x, box.width};
  const Axis strength = {0.0, top, box.y, box.height};
  cv::Mat shade = picture->clone();
  cv::rectangle(shade, {time.At(location.discrepancy.first_frame / rate), box.y},
                {time.At(location.discrepancy.last_frame / rate), box.y + box.height}, kPatch,
                cv::FILLED);
  cv::addWeighted(shade, 0.15, *picture, 0.85, 0.0, *picture);
  for (const double tick : LinearTicks(0.0, time.high, 9)) {
    cv::line(*picture, {time.At(tick), box.y}, {time.At(tick), box.y + box.height + 4}, kFaint);
    Write(fmt::format("{:g}", tick), {time.At(tick), box.y + box.height + 16}, Align::kCentre,
          picture);
  }
  for (const double tick : LinearTicks(0.0, top, 4)) {
    const int y = 2 * box.y + box.height - strength.At(tick);
    cv::line(*picture, {box.x - 4, y}, {box.x + box.width, y}, kFaint);
    Write(fmt::format("{:g}", tick), {box.x - 8, y}, Align::kRight, picture);
  }
  cv::rectangle(*picture, box, kInk);
  std::vector<double> mean, most;
  constexpr int kPlaces = 12;  // along each side
  for (int f = 0; f <= missing.last_frame; ++f) {
    double sum = 0.0, largest = 0.0;
    for (int i = 0; i < kPlaces * kPlaces; ++i) {
      const Eigen::Vector2d share((i % kPlaces + 0.5) / kPlaces, (i / kPlaces + 0.5) / kPlaces);
      const double f_here = Magnitude(
          missing, f / rate,
          missing.layout.low + share.cwiseProduct(missing.layout.high - missing.layout.low));
      sum += f_here / (kPlaces * kPlaces);
      largest = std::max(largest, f_here);
    }
    mean.push_back(sum);
    most.push_back(largest);
  }
  DrawLine(most, time, strength, 1.0 / rate, kOrange, picture);
  DrawLine(mean, time, strength, 1.0 / rate, kBlue, picture);
  Write("time / s", {box.x + box.width / 2, box.y + box.height + 38}, Align::kCentre, picture);
  Write("N/m^2", {box.x - 8, box.y - 14}, Align::kRight, picture);
  const int right = box.x + box.width + 14;
  cv::line(*picture, {right, box.y + 14}, {right + 22, box.y + 14}, kOrange, 2, cv::LINE_AA);
  Write("strongest place", {right + 28, box.y + 14}, Align::kLeft, picture);
  cv::line(*picture, {right, box.y + 38}, {right + 22, box.y + 38}, kBlue, 2, cv::LINE_AA);
  Write("mean of the cloth", {right + 28, box.y + 38}, Align::kLeft, picture);
  cv::Mat key = (*picture)(cv::Rect(right, box.y + 54, 22, 16));
  key = kPatch * 0.15 + cv::Scalar::all(255 * 0.85);
  Write("located", {right + 28, box.y + 62}, Align::kLeft, picture);
}

// Evenly over the recording, the middle of the located time among them.
std::vector<double> PanelTimes(const MissingForce& missing, const Location& location, int count) {
  const double end = missing.last_frame / missing.layout.frame_rate;
  std::vector<double> times;
  for (int i = 0; i < count; ++i) times.push_back(end * (i + 0.5) / count);
  const double middle = 0.5 * (location.discrepancy.first_frame + location.discrepancy.last_frame) /
                        missing.layout.frame_rate;
  *std::min_element(times.begin(), times.end(), [&](double a, double b) {
    return std::abs(a - middle) < std::abs(b - middle);
  }) = middle;
  return times;
}

}  // namespace

cv::Mat DrawForceMap(const Scene&, const MissingForce& missing, const Location& location) {
  constexpr int kPanels = 6, kWide = 170, kGap = 22, kLeft = 76, kTop = 62, kRight = 200;
  const Eigen::Vector2d low = missing.layout.low, size = missing.layout.high - low;
  const int tall = std::clamp(static_cast<int>(std::lround(kWide * size.y() / size.x())), 60, 340);
  const int width = kLeft + kPanels * (kWide + kGap) + kRight;
  const int course = kTop + tall + 100;
  cv::Mat picture(course + 150 + 60, width, CV_8UC3, cv::Scalar::all(255));
  const double top = TopOfScale(missing);
  Write("Missing force per area over the cloth", {kLeft, 18}, Align::kLeft, &picture, 0.56);
  int left = kLeft;
  for (const double time : PanelTimes(missing, location, kPanels)) {
    const Panel panel = {{low.x(), low.x() + size.x(), left, kWide},
                         {low.y(), low.y() + size.y(), kTop, tall}};
    DrawPanel(missing, location, time, top, panel, left == kLeft, &picture);
    left += kWide + kGap;
  }
  DrawScale({left + 8, kTop, 18, tall}, top, &picture);
  DrawCourse(missing, location, top, {kLeft, course, kPanels * (kWide + kGap) - kGap, 150},
             &picture);
  return picture;
}

namespace {

// A view from afar: right and up are unit vectors in the world.
struct View {
  Eigen::Vector3d right, up, towards;  // towards the viewer
  Eigen::Vector3d centre;              // m, in the picture's middle
  double scale;                        // px/m
  cv::Point middle;
  cv::Point At(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d d = p - centre;
    return {middle.x + static_cast<int>(std::lround(scale * right.dot(d))),
            middle.y - static_cast<int>(std::lround(scale * up.dot(d)))};
  }
};

View LookFrom(double azimuth, double elevation, const Eigen::Vector3d& centre, double scale,
              const cv::Point& middle) {
  View view;
  view.towards = {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                  std::sin(elevation)};
  view.right = Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0);
  view.up = view.towards.cross(view.right);
  view.centre = centre;
  view.scale = scale;
  view.middle = middle;
  return view;
}

void DrawCloth(const Scene& scene, const Eigen::VectorXd& x, const View& view, cv::Mat* picture) {
  std::vector<std::pair<double, std::size_t>> order;  // far ones first
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    const std::array<int, 3>& n = scene.mesh.triangles[t];
    const Eigen::Vector3d sum =
        x.segment<3>(3 * n[0]) + x.segment<3>(3 * n[1]) + x.segment<3>(3 * n[2]);
    order.emplace_back(view.towards.dot(sum), t);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [depth, t] : order) {
    const std::array<int, 3>& n = scene.mesh.triangles[t];
    const std::array<cv::Point, 3> corners = {view.At(x.segment<3>(3 * n[0])),
                                              view.At(x.segment<3>(3 * n[1])),
                                              view.At(x.segment<3>(3 * n[2]))};
    const Eigen::Vector3d normal = TriangleFrame(scene.mesh, n, x).col(0);
    const double light = 225.0 + 25.0 * std::abs(normal.dot(view.towards));
    cv::fillConvexPoly(*picture, corners.data(), 3, cv::Scalar::all(light), cv::LINE_AA);
    for (int k = 0; k < 3; ++k)
      cv::line(*picture, corners[k], corners[(k + 1) % 3], kFaint, 1, cv::LINE_AA);
  }
}

void DrawTriad(const View& view, const cv::Point& at, cv::Mat* picture) {
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d e = Eigen::Vector3d::Unit(axis);
    const Eigen::Vector2d d(view.right.dot(e), -view.up.dot(e));
    if (d.norm() < 0.15) continue;
    const cv::Point tip(at.x + static_cast<int>(36 * d.x()), at.y + static_cast<int>(36 * d.y()));
    cv::arrowedLine(*picture, at, tip, kInk, 1, cv::LINE_AA, 0, 0.2);
    Write(std::string(1, "xyz"[axis]),
          {at.x + static_cast<int>(48 * d.x()), at.y + static_cast<int>(48 * d.y())},
          Align::kCentre, picture);
  }
}

// Frame of the largest force of any node, within the located time.
int PeakFrame(const MissingForce& missing, const Location& location) {
  int peak = location.discrepancy.first_frame;
  double largest = -1.0;
  for (int f = location.discrepancy.first_frame; f <= location.discrepancy.last_frame; ++f) {
    const ForceGrid grid = missing.layout.At(missing.force, f / missing.layout.frame_rate);
    for (const Eigen::Vector3d& force : grid.force) {
      if (force.norm() <= largest) continue;
      largest = force.norm();
      peak = f;
    }
  }
  return peak;
}

void DrawArrows(const Scene& scene, const MissingForce& missing, double time,
                const Eigen::VectorXd& x, double metres_per_force, double top, const View& view,
                cv::Mat* picture) {
  constexpr int kAlong = 8;
  std::vector<Eigen::Vector2d> uv;
  for (int i = 0; i < kAlong * kAlong; ++i) {
    const Eigen::Vector2d share((i % kAlong + 0.5) / kAlong, (i / kAlong + 0.5) / kAlong);
    uv.push_back(missing.layout.low + share.cwiseProduct(missing.layout.high - missing.layout.low));
  }
  const std::vector<SurfacePoint> points = LocateOnCloth(scene.mesh, uv);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d force = TriangleFrame(scene.mesh, points[i].nodes, x) *
                                  missing.layout.At(missing.force, time, uv[i]);
    const Eigen::Vector3d from = points[i].At(x);
    const cv::Point a = view.At(from), b = view.At(from + metres_per_force * force);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const cv::Vec3b c = Colour(0.9 * force.norm() / top);  // the lightest would not show on white
    const cv::Scalar colour(c[0], c[1], c[2]);
    cv::circle(*picture, a, 2, colour, cv::FILLED, cv::LINE_AA);
    if (length > 3.0)
      cv::arrowedLine(*picture, a, b, colour, 2, cv::LINE_AA, 0, std::min(0.4, 8.0 / length));
  }
}

}  // namespace

cv::Mat DrawForceArrows(const Scene& scene, const MissingForce& missing, const Location& location) {
  constexpr int kPanel = 460, kTop = 40, kBottom = 70;
  cv::Mat picture(kTop + kPanel + kBottom, 2 * kPanel, CV_8UC3, cv::Scalar::all(255));
  const int frame = PeakFrame(missing, location);
  const double time = frame / missing.layout.frame_rate, top = TopOfScale(missing);
  const Eigen::VectorXd& x = missing.x[frame];
  const Eigen::Map<const Eigen::Matrix3Xd> points(x.data(), 3, x.size() / 3);
  const Eigen::Vector3d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  const double size = (missing.layout.high - missing.layout.low).norm();
  const double metres_per_force = 0.28 * size / top;
  const double scale = 0.66 * kPanel / std::max((high - low).norm(), 0.5 * size);
  Write(fmt::format("Missing force at its peak, {:.2f} s", time), {16, 18}, Align::kLeft, &picture,
        0.56);
  const std::array<double, 2> azimuths = {0.45, 0.45 + M_PI_2};
  for (int side = 0; side < 2; ++side) {
    const View view = LookFrom(azimuths[side], 0.3, 0.5 * (low + high), scale,
                               {kPanel / 2 + side * kPanel, kTop + kPanel / 2});
    DrawCloth(scene, x, view, &picture);
    for (const SceneHandle& handle : scene.handles) {
      if (time > handle.released_after) continue;
      cv::circle(picture, view.At(handle.on_cloth.At(x)), 6, kInk, cv::FILLED, cv::LINE_AA);
    }
    DrawArrows(scene, missing, time, x, metres_per_force, top, view, &picture);
    DrawTriad(view, {side * kPanel + 60, kTop + kPanel - 20}, &picture);
  }
  const int y = kTop + kPanel + 44, length = static_cast<int>(scale * metres_per_force * 0.5 * top);
  cv::arrowedLine(picture, {16, y}, {16 + length, y}, kInk, 2, cv::LINE_AA, 0,
                  std::min(0.4, 8.0 / std::max(1, length)));
  Write(fmt::format("{:g} N/m^2", 0.5 * top), {26 + length, y}, Align::kLeft, &picture);
  cv::circle(picture, {kPanel, y}, 6, kInk, cv::FILLED, cv::LINE_AA);
  Write("handle", {kPanel + 14, y}, Align::kLeft, &picture);
  return picture;
}

}  // namespace clothfit
