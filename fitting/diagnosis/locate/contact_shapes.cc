// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/locate/contact_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "autodiff_sim/term/tilted_down.h"
#include "autodiff_sim/terms/obstacle.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/optimise/optimiser.h"

namespace clothfit {
namespace {

// m, either side of a surface: what touches it. The cloth is known no better where nothing of it is
// seen. Deeper inside of an obstacle there is no cloth.
constexpr double kTouching = 0.02;
constexpr int kCells = 8;           // of the grid, along each direction
constexpr int kMostOfAKind = 4;     // shapes
constexpr int kMostTried = 8;       // of a kind, by the simplex
constexpr double kSame = 0.03;      // m, of which two shapes are one
constexpr int kSimplexSteps = 150;  // evaluations of the simplex

enum class Kind { kPlane, kTable, kBall, kBar };

// Planes: normal (of any length), height along it. Tables: a point of the edge, direction. Balls:
// middle, log radius. Bars without ends: a point of the axis, direction (of any length), log
// radius.
struct Shape {
  Kind kind;
  Eigen::VectorXd at;
};

struct Touch {
  Eigen::Vector3d normal;
  double depth;  // m, negative outside
};

// As ObstacleTable has it, of a level edge.
Touch TouchOfTable(const Shape& shape, const DownFrame& frame, const Eigen::Vector3d& place) {
  const Eigen::Vector3d below = shape.at.head<3>() - place;
  const Eigen::Vector3d over =
      std::cos(shape.at[3]) * frame.axis_1 + std::sin(shape.at[3]) * frame.axis_2;
  const double a = -below.dot(frame.down), b = below.dot(over), r = std::hypot(a, b);
  const double depth = a + b - r;
  if (!(r > 0.0)) return {-frame.down, 0.0};
  return {((a / r - 1.0) * frame.down + (1.0 - b / r) * over).normalized(), depth};
}

Touch TouchOf(const Shape& shape, const DownFrame& frame, const Eigen::Vector3d& place) {
  if (shape.kind == Kind::kTable) return TouchOfTable(shape, frame, place);
  if (shape.kind == Kind::kPlane) {
    const Eigen::Vector3d normal = shape.at.head<3>().normalized();
    return {normal, shape.at[3] - normal.dot(place)};
  }
  Eigen::Vector3d offset = place - shape.at.head<3>();
  if (shape.kind == Kind::kBar) {
    const Eigen::Vector3d axis = shape.at.segment<3>(3).normalized();
    offset -= axis * axis.dot(offset);
  }
  const double distance = offset.norm();
  if (!(distance > 0.0)) return {Eigen::Vector3d::Zero(), 0.0};
  return {offset / distance, std::exp(shape.at[shape.at.size() - 1]) - distance};
}

// The middles of the cells of a box.
std::vector<Eigen::Vector3d> PlacesIn(const Eigen::AlignedBox3d& box, int count) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      for (int k = 0; k < count; ++k) {
        const Eigen::Vector3d share = Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5) / count;
        places.push_back(box.min() + share.cwiseProduct(box.sizes()));
      }
    }
  }
  return places;
}

// Towards faces, edges and corners of a cube; of each and its opposite one where `halves`.
std::vector<Eigen::Vector3d> Directions(bool halves) {
  std::vector<Eigen::Vector3d> directions;
  for (int code = 0; code < 27; ++code) {
    const Eigen::Vector3d d(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
    if (code == 13 || (halves && code < 13)) continue;
    directions.push_back(d.normalized());
  }
  return directions;
}

// As TiltedDown has it.
Eigen::Vector2d TiltOf(const DownFrame& frame, const Eigen::Vector3d& direction) {
  const Eigen::Vector3d cross = frame.down.cross(direction);
  const double sine = cross.norm(), angle = std::atan2(sine, frame.down.dot(direction));
  const Eigen::Vector3d axis = sine > 1e-9 ? Eigen::Vector3d(cross / sine) : frame.axis_1;
  return angle * Eigen::Vector2d(axis.dot(frame.axis_1), axis.dot(frame.axis_2));
}

// A term's parameters behind the first, which is the stiffness.
template <class Term, class... Values>
Probe ShapeOf(Values... values) {
  static_assert(sizeof...(Values) + 1 == Term::kParameters.size(), "a value of each parameter");
  Probe probe;
  int index = 0;
  ((probe[FullName<Term>(++index)] = values), ...);
  return probe;
}

Probe CapsuleShape(const Eigen::Vector3d& end_1, const Eigen::Vector3d& end_2, double radius) {
  return ShapeOf<ObstacleCapsule>(end_1.x(), end_1.y(), end_1.z(), end_2.x(), end_2.y(), end_2.z(),
                                  radius);
}

class ContactSearch {
 public:
  ContactSearch(const ClothMesh& mesh, const Eigen::Vector3d& gravity, const MissingForce& missing)
      : frame_(MakeDownFrame(gravity)),
        layout_(missing.layout),
        information_(missing.system.information.selfadjointView<Eigen::Lower>()),
        data_(missing.system.data.col(0)),
        noise_(missing.noise_factor),
        side_((missing.layout.high - missing.layout.low).maxCoeff()) {
    for (const NodeShare& share : NodeShares(mesh, layout_)) AddPieces(mesh, missing, share);
    areas_ = Eigen::VectorXd::Zero(layout_.num_nodes());
    for (const Piece& piece : pieces_)
      if (piece.knot == 0) areas_[piece.node] += piece.area;
  }

  std::vector<ContactShape> Run() const {
    std::vector<ContactShape> found;
    for (const std::vector<Shape>& starts : {Planes(), Tables(), Balls(), Bars()}) {
      for (const Shape& shape : BestOf(starts)) {
        const double score = Score(shape);
        if (score > 0.0) found.push_back(Describe(shape, score));
      }
    }
    std::stable_sort(found.begin(), found.end(), [](const ContactShape& a, const ContactShape& b) {
      return a.score > b.score;
    });
    return found;
  }

 private:
  // A triangle at a knot in time, as far as a node of the layout has a share in it.
  struct Piece {
    int knot, node;
    double area;               // m^2, times the node's weight
    Eigen::Vector3d at;        // m, world
    Eigen::Matrix3d to_cloth;  // world to normal, warp and weft
  };

  void AddPieces(const ClothMesh& mesh, const MissingForce& missing, const NodeShare& share) {
    for (int knot = 0; knot < layout_.num_knots; ++knot) {
      const int frame = std::min(knot * layout_.frames_per_knot, missing.last_frame);
      const Eigen::VectorXd& x = missing.x[static_cast<std::size_t>(frame)];
      Eigen::Vector3d at = Eigen::Vector3d::Zero();
      for (const int node : share.triangle) at += x.segment<3>(3 * node) / 3.0;
      swept_.extend(at);
      const Eigen::Matrix3d to_cloth = TriangleFrame(mesh, share.triangle, x).transpose();
      pieces_.push_back({knot, share.node, share.area, at, to_cloth});
    }
  }

  double Score(const Shape& shape) const {
    Eigen::VectorXd pattern = Eigen::VectorXd::Zero(layout_.size());
    double outside = 0.0, inside = 0.0;
    for (const Piece& piece : pieces_) {
      const Touch touch = TouchOf(shape, frame_, piece.at);
      if (!(touch.depth > -kTouching)) continue;
      const double share = std::min(1.0, (touch.depth + kTouching) / kTouching);
      (touch.depth > kTouching ? inside : outside) += piece.area;
      pattern.segment<3>(layout_.Index(piece.knot, piece.node, 0)) +=
          share * piece.area / areas_[piece.node] * (piece.to_cloth * touch.normal);
    }
    const double along = data_.dot(pattern);
    if (!(along > 0.0) || inside >= outside) return 0.0;
    const double square = pattern.dot(information_ * pattern);
    return (1.0 - inside / outside) * along * along / (square * noise_ * noise_);
  }

  // Of the grid's places along one axis the one next to the middle.
  std::vector<Eigen::Vector3d> MiddlePlaces(const Eigen::Vector3d& axis) const {
    const Eigen::Vector3d cell = swept_.sizes() / kCells;
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector3d& place : PlacesIn(swept_, kCells)) {
      const double off = axis.dot(place - swept_.center());
      if (std::abs(off) <= 0.5 * axis.cwiseAbs().dot(cell)) places.push_back(place);
    }
    return places;
  }

  std::vector<Shape> Planes() const {
    std::vector<Shape> shapes;
    for (const Eigen::Vector3d& normal : Directions(false)) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const Piece& piece : pieces_) {
        low = std::min(low, normal.dot(piece.at));
        high = std::max(high, normal.dot(piece.at));
      }
      for (int i = 0; i < 2 * kCells; ++i) {
        Eigen::VectorXd at(4);
        at << normal, low + (high - low) * (i + 0.5) / (2 * kCells);
        shapes.push_back({Kind::kPlane, at});
      }
    }
    return shapes;
  }

  std::vector<Shape> Tables() const {
    constexpr int kSides = 8;
    std::vector<Shape> shapes;
    for (int i = 0; i < kSides; ++i) {
      const double direction = 2.0 * M_PI * i / kSides;
      const Eigen::Vector3d along =
          std::cos(direction) * frame_.axis_2 - std::sin(direction) * frame_.axis_1;
      for (const Eigen::Vector3d& place : MiddlePlaces(along)) {
        Eigen::VectorXd at(4);
        at << place, direction;
        shapes.push_back({Kind::kTable, at});
      }
    }
    return shapes;
  }

  std::vector<Shape> Balls() const {
    std::vector<Shape> shapes;
    for (const Eigen::Vector3d& middle : PlacesIn(swept_, kCells)) {
      for (const double radius : {0.1, 0.3}) {
        Eigen::VectorXd at(4);
        at << middle, std::log(radius * side_);
        shapes.push_back({Kind::kBall, at});
      }
    }
    return shapes;
  }

  std::vector<Shape> Bars() const {
    std::vector<Shape> shapes;
    for (const Eigen::Vector3d& axis : Directions(true)) {
      for (const Eigen::Vector3d& place : MiddlePlaces(axis)) {
        Eigen::VectorXd at(7);
        at << place, axis, std::log(0.1 * side_);
        shapes.push_back({Kind::kBar, at});
      }
    }
    return shapes;
  }

  // Made better by the simplex, the best first.
  std::vector<Shape> BestOf(const std::vector<Shape>& starts) const {
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < starts.size(); ++i) order.push_back({-Score(starts[i]), i});
    std::stable_sort(order.begin(), order.end());
    const double apart = 2.0 * swept_.sizes().maxCoeff() / kCells;
    std::vector<Shape> tried, best;
    for (const auto& [score, i] : order) {
      const Shape& start = starts[i];
      if (!(score < 0.0) || tried.size() == kMostTried || best.size() == kMostOfAKind) break;
      if (IsNear(tried, start, apart)) continue;
      tried.push_back(start);
      Shape shape = Improve(start);
      if (!IsNear(best, shape, kSame)) best.push_back(std::move(shape));
    }
    std::stable_sort(best.begin(), best.end(),
                     [&](const Shape& a, const Shape& b) { return Score(a) > Score(b); });
    return best;
  }

  static bool IsNear(const std::vector<Shape>& others, const Shape& shape, double distance) {
    return std::any_of(others.begin(), others.end(),
                       [&](const Shape& other) { return (shape.at - other.at).norm() < distance; });
  }

  Shape Improve(const Shape& start) const {
    Objective objective;
    objective.start = start.at;
    const Eigen::Index size = start.at.size();
    objective.lower = Eigen::VectorXd::Constant(size, -std::numeric_limits<double>::infinity());
    objective.upper = -objective.lower;
    objective.step = Eigen::VectorXd::Constant(size, 0.3);
    if (start.kind == Kind::kPlane) {
      objective.step[3] = 0.5 * swept_.sizes().maxCoeff() / kCells;
    } else {
      objective.step.head<3>().setConstant(0.5 * swept_.sizes().maxCoeff() / kCells);
      if (start.kind != Kind::kTable) {
        objective.lower[size - 1] = std::log(0.5 * kTouching);
        objective.upper[size - 1] = std::log(2.0 * side_);
      }
    }
    objective.value = [&](const Eigen::VectorXd& at, int) { return -Score({start.kind, at}); };
    OptimiserOptions options;
    options.budget.evaluations = kSimplexSteps;
    return {start.kind, Minimise("nelder-mead", objective, options).x};
  }

  ContactShape Describe(const Shape& shape, double score) const {
    if (shape.kind == Kind::kPlane) {
      const Eigen::Vector3d normal = shape.at.head<3>().normalized();
      const Eigen::Vector2d tilt = TiltOf(frame_, -normal);
      return {ObstaclePlane::kName, ShapeOf<ObstaclePlane>(shape.at[3], tilt[0], tilt[1]), score};
    }
    const Eigen::Vector3d middle = shape.at.head<3>();
    if (shape.kind == Kind::kTable) {
      const Eigen::Vector3d over =
          std::cos(shape.at[3]) * frame_.axis_1 + std::sin(shape.at[3]) * frame_.axis_2;
      const Eigen::Vector3d half = 0.5 * side_ * over.cross(frame_.down);
      const Eigen::Vector3d first = middle - half, second = middle + half;
      return {ObstacleTable::kName,
              ShapeOf<ObstacleTable>(first.x(), first.y(), first.z(), second.x(), second.y(),
                                     second.z()),
              score};
    }
    const double radius = std::exp(shape.at[shape.at.size() - 1]);
    if (shape.kind == Kind::kBall) {
      return {ObstacleSphere::kName,
              ShapeOf<ObstacleSphere>(middle.x(), middle.y(), middle.z(), radius), score};
    }
    const auto [end_1, end_2] = EndsOf(shape);
    return {ObstacleCapsule::kName, CapsuleShape(end_1, end_2, radius), score};
  }

  // Of the axis, beyond all that touches the bar by half of its extent: where the bar ends beyond
  // the cloth is not seen.
  std::pair<Eigen::Vector3d, Eigen::Vector3d> EndsOf(const Shape& bar) const {
    const Eigen::Vector3d origin = bar.at.head<3>(), axis = bar.at.segment<3>(3).normalized();
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Piece& piece : pieces_) {
      if (!(TouchOf(bar, frame_, piece.at).depth > -kTouching)) continue;
      low = std::min(low, axis.dot(piece.at - origin));
      high = std::max(high, axis.dot(piece.at - origin));
    }
    const double beyond = 0.5 * (high - low);
    return {origin + (low - beyond) * axis, origin + (high + beyond) * axis};
  }

  DownFrame frame_;
  const ForceLayout& layout_;
  Eigen::MatrixXd information_;
  Eigen::VectorXd data_;
  double noise_, side_;
  std::vector<Piece> pieces_;
  Eigen::VectorXd areas_;  // of each node, m^2
  Eigen::AlignedBox3d swept_;
};

}  // namespace

std::vector<Probe> BarsThroughBall(const Probe& ball, const Eigen::Vector3d& gravity,
                                   double reach) {
  constexpr int kDirections = 4;
  const DownFrame frame = MakeDownFrame(gravity);
  const auto of_ball = [&](int index) { return ball.at(FullName<ObstacleSphere>(index)); };
  const Eigen::Vector3d middle(of_ball(1), of_ball(2), of_ball(3));
  const double radius = of_ball(4);
  std::vector<Probe> bars;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = M_PI * i / kDirections;
    const Eigen::Vector3d half =
        reach * (std::cos(angle) * frame.axis_1 + std::sin(angle) * frame.axis_2);
    bars.push_back(CapsuleShape(middle - half, middle + half, radius));
  }
  return bars;
}

std::vector<ContactShape> FindContactShapes(const ClothMesh& mesh, const Eigen::Vector3d& gravity,
                                            const MissingForce& missing) {
  return ContactSearch(mesh, gravity, missing).Run();
}

}  // namespace clothfit
