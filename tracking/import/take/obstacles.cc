// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/take/obstacles.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "tracking/import/markers/marker_layout.h"
#include "tracking/import/markers/rigid_body.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Values = std::map<std::string, double>;  // m, by key

struct Choice {
  std::string shape;  // empty: none was chosen
  Values values;
};

const std::map<std::string, std::vector<std::string>> kShapes = {
    {"none", {}}, {"capsule", {"radius", "length"}}, {"box", {"thickness", "margin", "below"}}};

constexpr const char* kObstacleOption = "--obstacle";

[[noreturn]] void FailAt(const std::string& choice, const std::string& problem) {
  throw InputError(kObstacleOption, fmt::format("'{}': {}", choice, problem));
}

// "radius=0.025"
void ParseValue(const std::string& text, const std::string& choice,
                const std::vector<std::string>& keys, Values* values) {
  const size_t equals = text.find('=');
  const std::string key = text.substr(0, equals);
  if (std::count(keys.begin(), keys.end(), key) == 0) {
    FailAt(choice, fmt::format("expected {}, found '{}'", JoinNames(keys), key));
  }
  const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
  const std::optional<double> value = ParseNumber(number);
  if (!value || *value < 0.0 || (*value == 0.0 && key != "margin" && key != "below")) {
    FailAt(choice, fmt::format("{}: expected metres above 0, found '{}'", key, number));
  }
  (*values)[key] = *value;
}

// "capsule:radius=0.025,length=0.8"
Choice ParseShape(const std::string& text, const std::string& choice) {
  Choice result;
  const size_t colon = text.find(':');
  result.shape = text.substr(0, colon);
  const auto keys = kShapes.find(result.shape);
  if (keys == kShapes.end()) {
    FailAt(choice, fmt::format("expected capsule, box or none, found '{}'", result.shape));
  }
  std::string rest = colon == std::string::npos ? "" : text.substr(colon + 1);
  while (!rest.empty()) {
    const size_t comma = std::min(rest.find(','), rest.size());
    ParseValue(rest.substr(0, comma), choice, keys->second, &result.values);
    rest.erase(0, comma + 1);
  }
  return result;
}

std::map<std::string, Choice> ParseChoices(const MarkerTake& take,
                                           const std::vector<std::string>& choices) {
  const std::vector<std::string> bodies = NamesOf(take.bodies);
  std::map<std::string, Choice> result;
  for (const std::string& choice : choices) {
    const size_t equals = choice.find('=');
    const std::string name = choice.substr(0, equals);
    if (std::count(bodies.begin(), bodies.end(), name) == 0) {
      FailAt(choice, fmt::format("{} has no rigid body '{}'{}", take.file.string(), name,
                                 bodies.empty() ? "" : "; " + Suggestion(name, bodies)));
    }
    if (equals == std::string::npos) FailAt(choice, "expected NAME=capsule, NAME=box or NAME=none");
    if (!result.emplace(name, ParseShape(choice.substr(equals + 1), choice)).second) {
      FailAt(choice, "expected one shape for '" + name + "', found two");
    }
  }
  return result;
}

// A right-handed frame along the markers' extents, the longest first, and the box around them.
struct Extent {
  Eigen::Matrix3d axes;                              // columns, world
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m, world
  Eigen::Vector3d size = Eigen::Vector3d::Zero();    // m
};

Eigen::Matrix3d PrincipalAxes(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points) mean += point / double(points.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points) {
    moments += (point - mean) * (point - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);  // ascending
  Eigen::Matrix3d axes;
  axes.col(2) = solver.eigenvectors().col(0);
  if (axes(2, 2) < 0.0) axes.col(2) = -axes.col(2);  // up, where the markers lie
  axes.col(0) = solver.eigenvectors().col(2);
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

// Along the sides of the smallest rectangle around the markers in the plane that fits them best.
Extent ExtentOf(const std::vector<Eigen::Vector3d>& points) {
  Extent extent{PrincipalAxes(points), {}, {}};
  std::vector<Eigen::Vector2d> flat;
  for (const Eigen::Vector3d& point : points) {
    flat.push_back((extent.axes.transpose() * point).head<2>());
  }
  const Eigen::Vector2d side = SideOfSmallestRectangle(flat);
  extent.axes.col(0) = (extent.axes.leftCols<2>() * side).eval();
  extent.axes.col(1) = extent.axes.col(2).cross(extent.axes.col(0));
  Eigen::Array3d lower = Eigen::Array3d::Constant(1e300);
  Eigen::Array3d upper = -lower;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Array3d local = extent.axes.transpose() * point;
    lower = lower.min(local);
    upper = upper.max(local);
  }
  extent.centre = extent.axes * (0.5 * (lower + upper)).matrix();
  extent.size = upper - lower;
  if (extent.size.x() >= extent.size.y()) return extent;
  std::swap(extent.size.x(), extent.size.y());
  const Eigen::Vector3d longer = extent.axes.col(1);
  extent.axes.col(1) = -extent.axes.col(0);
  extent.axes.col(0) = longer;
  return extent;
}

double ValueOr(const Values& values, const char* key, double otherwise) {
  const auto found = values.find(key);
  return found == values.end() ? otherwise : found->second;
}

// The obstacle's own frame while it rests, and its shape.
struct Solid {
  std::variant<BallShape, BarShape, BoxShape, MeshShape> shape;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::string text;
};

// Measured lengths are rounded to a hundredth of a millimetre.
double Rounded(double metres) { return std::round(1e5 * metres) / 1e5; }

constexpr double kSlender = 6.0;  // length over width, and width over thickness

Solid MakeBar(const Extent& extent, const Values& values) {
  Solid solid;
  // Markers stand on its surface, on all sides or on one: half of their width is its radius.
  const double radius = ValueOr(values, "radius", 0.5 * Rounded(extent.size.tail<2>().maxCoeff()));
  const double length = ValueOr(values, "length", Rounded(extent.size.x()));
  solid.shape = BarShape{radius, length};
  solid.pose.linear() << extent.axes.col(1), extent.axes.col(2), extent.axes.col(0);
  solid.pose.translation() = extent.centre;
  solid.text = fmt::format("a bar of radius {:.1f} mm and length {:.3f} m", 1e3 * radius, length);
  return solid;
}

// A cloth that hangs over the edge of a table does not come beneath it: no marker of 15 real takes
// ever did, but simulated cloth is caught there. What moves is a board that is carried.
Solid MakeBox(const Extent& extent, const Values& values, bool rests) {
  constexpr double kBoard = 0.02;  // m, of a table's top
  constexpr double kBelow = 0.5;   // m, deeper than cloth hangs over an edge
  const bool is_flat = extent.size.z() * kSlender < extent.size.y();
  const double margin = ValueOr(values, "margin", 0.0);
  const double thickness =
      ValueOr(values, "thickness", is_flat ? kBoard : Rounded(extent.size.z()));
  Solid solid;
  const Eigen::Vector3d size(Rounded(extent.size.x()) + 2 * margin,
                             Rounded(extent.size.y()) + 2 * margin, thickness);
  const double below = ValueOr(values, "below", is_flat && rests ? kBelow : 0.0);
  solid.shape = BoxShape{size, below};
  solid.pose.linear() = extent.axes;
  solid.pose.translation() = extent.centre;
  if (is_flat) solid.pose.translation() -= 0.5 * thickness * extent.axes.col(2);
  solid.text = fmt::format("a box of {:.3f} x {:.3f} x {:.3f} m{}", size.x(), size.y(), size.z(),
                           is_flat ? ", its top at the markers" : "");
  if (below > 0.0)
    solid.text += fmt::format(", closed for {:.2g} m below, where no cloth comes", below);
  return solid;
}

ObstacleDescription MakeObstacle(const RigidBody& body, const Choice& choice,
                                 std::vector<std::string>* notes) {
  const RigidMotion motion = FindRigidMotion(body);
  const Extent extent = ExtentOf(motion.reference);
  const bool is_slender = kSlender * extent.size.y() < extent.size.x();
  const std::string shape = choice.shape.empty() ? (is_slender ? "capsule" : "box") : choice.shape;
  const Solid solid = shape == "capsule" ? MakeBar(extent, choice.values)
                                         : MakeBox(extent, choice.values, motion.path.size() == 1);
  ObstacleDescription obstacle{body.name, solid.shape, {}};
  for (const Eigen::Isometry3d& moved : motion.path) {
    const Eigen::Isometry3d pose = moved * solid.pose;
    const Eigen::AngleAxisd rotation(pose.linear());
    obstacle.path.push_back({pose.translation(), rotation.angle() * rotation.axis()});
  }
  const Eigen::Vector3d& at = obstacle.path.front().position;
  notes->push_back(fmt::format(
      "obstacle {}: {}, {} at ({:.3f}, {:.3f}, {:.3f}) m, by {} markers{}; --obstacle says "
      "otherwise",
      body.name, solid.text, obstacle.path.size() == 1 ? "at rest" : "first", at.x(), at.y(),
      at.z(), motion.reference.size(),
      motion.num_lost == 0 ? "" : fmt::format(" (lost in {} frames)", motion.num_lost)));
  return obstacle;
}

}  // namespace

std::vector<ObstacleDescription> MakeObstacles(const MarkerTake& take,
                                               const std::vector<std::string>& choices,
                                               std::vector<std::string>* notes) {
  std::map<std::string, Choice> chosen = ParseChoices(take, choices);
  std::vector<ObstacleDescription> obstacles;
  for (const RigidBody& body : take.bodies) {
    const Choice& choice = chosen[body.name];
    if (choice.shape == "none") continue;
    if (body.markers.size() >= 3) {
      obstacles.push_back(MakeObstacle(body, choice, notes));
    } else if (choice.shape.empty()) {
      notes->push_back(
          fmt::format("rigid body {}: no obstacle, since it has {} markers where three "
                      "say how it is turned",
                      body.name, body.markers.size()));
    } else {
      throw InputError(kObstacleOption,
                       fmt::format("{}: expected three markers of '{}' or more, found {}",
                                   take.file.string(), body.name, body.markers.size()));
    }
  }
  return obstacles;
}

}  // namespace clothfit
