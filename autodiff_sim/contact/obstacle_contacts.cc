// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/obstacle_contacts.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/contact/contact_pair.h"
#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/intersections.h"
#include "autodiff_sim/contact/obstacle_shapes.h"
#include "autodiff_sim/contact/proximity.h"

namespace clothfit {
namespace {

// The areas that pairs stand for, in areas of the cloth's feature. On a plane of a mesh the
// particles bear all; its edges and corners come on top. A ball is borne by the triangles. A bar is
// borne by particles and edges, half each; its ends by triangles on top.
constexpr double kObstacleEdgeShare = 0.2, kBarShare = 0.5, kEndShare = 0.5;
// How far the list of pairs reaches beyond the thickness, in thicknesses.
constexpr double kMargin = 1.0;

double LongestMotion(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1) {
  double longest = 0.0;
  for (Eigen::Index i = 0; i < x0.size(); i += 3)
    longest = std::max(longest, (x1.segment<3>(i) - x0.segment<3>(i)).norm());
  return longest;
}

// Where the cloth's points stand among a pair's four, and how many they are.
int FirstOfCloth(PairKind kind) { return kind == PairKind::kTriangleVertex ? 1 : 0; }
int CountOfCloth(PairKind kind) {
  return kind == PairKind::kEdgeEdge ? 2 : kind == PairKind::kTriangleVertex ? 3 : 1;
}

}  // namespace

ObstacleContacts::ObstacleContacts(const ClothMesh& mesh,
                                   const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                                   std::optional<double> ground)
    : surface_(mesh),
      uv_(mesh.uv),
      vertex_area_(mesh.uv.size(), 0.0),
      edge_area_(surface_.features().edges.size(), 0.0),
      ground_(ground) {
  const std::vector<std::array<int, 2>>& edges = surface_.features().edges;
  for (const std::array<int, 3>& t : mesh.triangles) {
    triangle_area_.push_back(SignedArea(mesh, t));
    const double third = triangle_area_.back() / 3.0;
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(t[k], t[(k + 1) % 3]);
      vertex_area_[t[k]] += third;
      edge_area_[static_cast<std::size_t>(
          std::lower_bound(edges.begin(), edges.end(), std::array<int, 2>{a, b}) -
          edges.begin())] += third;
    }
  }
  for (const std::shared_ptr<const Obstacle>& obstacle : obstacles) {
    Body body{obstacle, std::nullopt, obstacle->radius, {}, {}, {}};
    if (obstacle->IsMesh()) body.surface.emplace(obstacle->features.triangles, obstacle->points);
    bodies_.push_back(std::move(body));
  }
  BeginStep(0.0, 0.0);
}

void ObstacleContacts::BeginStep(double start, double end, const ObstacleChange& change) {
  bool has_moved = false;
  is_moving_ = false;
  shift_ = change.shift;
  for (Body& body : bodies_) {
    const Obstacle& obstacle = *body.obstacle;
    const auto place = [&](double time) {
      RigidPose pose = obstacle.PoseAt(time);
      pose.origin_in_world += shift_;
      return PlaceInWorld(pose, obstacle.points);
    };
    const Eigen::VectorXd arrived = place(end);
    const double radius = GrownRadius(obstacle.radius, change.growth);
    body.start = place(start);
    has_moved = has_moved || body.end.size() == 0 || body.end != arrived || body.radius != radius;
    body.radius = radius;
    is_moving_ = is_moving_ || body.start != arrived;
    body.end = arrived;
    body.velocity = (body.end - body.start) / (end > start ? end - start : 1.0);
  }
  if (has_moved) Forget();
}

template <class Visit>
void ObstacleContacts::VisitPairs(const Body& body, const Visit& visit) const {
  const MeshFeatures &cloth = surface_.features(), &own = body.obstacle->features;
  for (int t = 0; t < static_cast<int>(own.triangles.size()); ++t) {
    for (int i = 0; i < static_cast<int>(uv_.size()); ++i)
      visit(FeaturePair{PairKind::kVertexTriangle, i, t});
  }
  for (int i = 0; i < static_cast<int>(body.end.size()) / 3; ++i) {
    for (int t = 0; t < static_cast<int>(cloth.triangles.size()); ++t)
      visit(FeaturePair{PairKind::kTriangleVertex, t, i});
  }
  for (int e = 0; e < static_cast<int>(own.edges.size()); ++e) {
    for (int c = 0; c < static_cast<int>(cloth.edges.size()); ++c)
      visit(FeaturePair{PairKind::kEdgeEdge, c, e});
  }
}

double ObstacleContacts::Gap(const Body& body, const FeaturePair& pair,
                             const Eigen::VectorXd& x) const {
  FourPoints points = PairPoints(pair, PlacedMesh{surface_.features(), x},
                                 PlacedMesh{body.obstacle->features, body.end});
  return MeasureContact(pair, points).distance - body.radius;
}

void ObstacleContacts::List(const Eigen::VectorXd& x, double reach) {
  reach_ = reach;
  list_.clear();
  for (int b = 0; b < static_cast<int>(bodies_.size()); ++b) {
    Body& body = bodies_[b];
    if (body.surface) {
      for (const Contact& contact : FindProximity(x, body.end, reach, &surface_, &*body.surface))
        list_.push_back({b, contact.pair, contact.distance});
      continue;
    }
    VisitPairs(body, [&](const FeaturePair& pair) {
      const double gap = Gap(body, pair, x);
      if (gap < reach) list_.push_back({b, pair, gap});
    });
  }
  list_x_ = x;
}

double ObstacleContacts::Moved(const Listed& listed, const Eigen::VectorXd& x) const {
  const std::array<int, 4> nodes =
      PairVertices(listed.pair, surface_.features(), bodies_[listed.body].obstacle->features);
  const int first = FirstOfCloth(listed.pair.kind);
  double moved = 0.0;
  for (int i = first; i < first + CountOfCloth(listed.pair.kind); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(nodes[i]);
    moved = std::max(moved, (x.segment<3>(row) - list_x_.segment<3>(row)).norm());
  }
  return moved;
}

void ObstacleContacts::Prepare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                               double thickness) {
  if (bodies_.empty()) return;
  const bool covered =
      list_x_.size() > 0 &&
      std::max(LongestMotion(list_x_, x0), LongestMotion(list_x_, x1)) < reach_ - thickness;
  if (!covered) List(0.5 * (x0 + x1), (1.0 + kMargin) * thickness + LongestMotion(x0, x1));
}

const std::vector<ObstacleContact>& ObstacleContacts::Find(const Eigen::VectorXd& x,
                                                           double thickness,
                                                           double ground_distance) {
  if (!bodies_.empty() &&
      (list_x_.size() == 0 || !(LongestMotion(list_x_, x) < reach_ - thickness))) {
    List(x, (1.0 + kMargin) * thickness);
  }
  found_.clear();
  for (const Listed& listed : list_) {
    if (bodies_.empty() || listed.gap - Moved(listed, x) >= thickness) continue;
    const Body& body = bodies_[listed.body];
    if (Gap(body, listed.pair, x) < thickness) found_.push_back(MakeContact(body, listed.pair));
  }
  for (int i = 0; ground_ && i < static_cast<int>(uv_.size()); ++i) {
    if (!(x[3 * i + 2] - *ground_ < ground_distance)) continue;
    const Eigen::Vector3d foot(0.0, 0.0, *ground_), still = Eigen::Vector3d::Zero();
    found_.push_back({PairKind::kVertexTriangle,
                      {i, i, i},
                      0,
                      1,
                      {still, foot, foot, foot},
                      {still, still, still, still},
                      0.0,
                      vertex_area_[i],
                      0.0,
                      true});
  }
  return found_;
}

ObstacleContact ObstacleContacts::MakeContact(const Body& body, const FeaturePair& pair) const {
  const MeshFeatures &cloth = surface_.features(), &own = body.obstacle->features;
  const std::array<int, 4> all = PairVertices(pair, cloth, own);
  const int first = FirstOfCloth(pair.kind), count = CountOfCloth(pair.kind);
  ObstacleContact contact{pair.kind, {},  first, count, {}, {}, body.obstacle->radius,
                          0.0,       0.0, false};
  for (int i = 0; i < 3; ++i) contact.nodes[i] = all[first + (i < count ? i : 0)];
  for (int i = 0; i < 4; ++i) {
    const bool of_cloth = i >= first && i < first + count;
    contact.points[i] = contact.velocities[i] = Eigen::Vector3d::Zero();
    if (of_cloth) continue;
    contact.points[i] = body.end.segment<3>(3 * all[i]) - shift_;
    contact.velocities[i] = body.velocity.segment<3>(3 * all[i]);
  }
  const bool is_mesh = body.obstacle->IsMesh(), is_bar = !is_mesh && !own.edges.empty();
  if (pair.kind == PairKind::kVertexTriangle) {
    contact.area = (is_bar ? kBarShare : 1.0) * vertex_area_[pair.first];
  } else if (pair.kind == PairKind::kTriangleVertex) {
    const double share = is_mesh ? kObstacleEdgeShare : is_bar ? kEndShare : 1.0;
    contact.area = share * triangle_area_[pair.first];
  } else {
    contact.area = (is_bar ? kBarShare : kObstacleEdgeShare) * edge_area_[pair.first];
    contact.parallel = kParallelShare * (uv_[all[1]] - uv_[all[0]]).squaredNorm() *
                       (contact.points[3] - contact.points[2]).squaredNorm();
  }
  return contact;
}

double ObstacleContacts::FreeShareOf(Body* body, const Eigen::VectorXd& x0,
                                     const Eigen::VectorXd& x1, double thickness,
                                     Obstacles obstacles) {
  const Eigen::VectorXd& begin = obstacles == Obstacles::kMoving ? body->start : body->end;
  const Approach approach = {body->radius, kGapTolerance * thickness, kGapSlack};
  if (body->surface) {
    return EarliestImpact({x0, x1}, {begin, body->end}, approach, &surface_, &*body->surface);
  }
  const PlacedMesh cloth0{surface_.features(), x0}, cloth1{surface_.features(), x1};
  const PlacedMesh body0{body->obstacle->features, begin},
      body1{body->obstacle->features, body->end};
  double until = 1.0;
  VisitPairs(*body, [&](const FeaturePair& pair) {
    const std::optional<double> time = FirstApproach(
        pair, PairPoints(pair, cloth0, body0), PairPoints(pair, cloth1, body1), approach, until);
    if (time) until = std::min(until, *time);
  });
  return until;
}

double ObstacleContacts::FreeShareOfList(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                                         double thickness) {
  const PlacedMesh cloth0{surface_.features(), x0}, cloth1{surface_.features(), x1};
  double until = 1.0;
  for (const Listed& listed : list_) {
    const Body& body = bodies_[listed.body];
    const Approach approach = {body.radius, kGapTolerance * thickness, kGapSlack};
    if (listed.gap - std::max(Moved(listed, x0), Moved(listed, x1)) > approach.tolerance) continue;
    const PlacedMesh there{body.obstacle->features, body.end};
    const std::optional<double> time =
        FirstApproach(listed.pair, PairPoints(listed.pair, cloth0, there),
                      PairPoints(listed.pair, cloth1, there), approach, until);
    if (time) until = std::min(until, *time);
  }
  return until;
}

double ObstacleContacts::FreeShareOfGround(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                                           double thickness) const {
  double until = 1.0;
  for (Eigen::Index i = 2; ground_ && i < x0.size(); i += 3) {
    const double before = x0[i] - *ground_, after = x1[i] - *ground_;
    if (!(before > 0.0)) return 0.0;
    const double met = std::min(kGapTolerance * thickness, kGapSlack * before);
    if (after <= met && after < before) until = std::min(until, (before - met) / (before - after));
  }
  return until;
}

double ObstacleContacts::FreeShare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                                   double thickness, Obstacles obstacles) {
  double until = FreeShareOfGround(x0, x1, thickness);
  const bool still = obstacles == Obstacles::kArrived || !is_moving_;
  const bool listed =
      still && list_x_.size() > 0 &&
      std::max(LongestMotion(list_x_, x0), LongestMotion(list_x_, x1)) + kGapTolerance * thickness <
          reach_;
  if (listed) return std::min(until, FreeShareOfList(x0, x1, thickness));
  for (Body& body : bodies_)
    until = std::min(until, FreeShareOf(&body, x0, x1, thickness, obstacles));
  return until;
}

int ObstacleContacts::CountIn(Body* body, const Eigen::VectorXd& x) {
  int count = 0;
  if (!body->surface) {
    VisitPairs(*body, [&](const FeaturePair& pair) { count += Gap(*body, pair, x) <= 0.0; });
    return count;
  }
  const ObstacleIntersections found = FindIntersections(x, body->end, &surface_, &*body->surface);
  count = static_cast<int>(found.cloth_edges.size() + found.obstacle_edges.size());
  const Eigen::Vector3d& half = body->obstacle->half_sides;
  if (count > 0 || half.isZero(0.0)) return count;
  // All of it inside, where no surfaces meet. Corner 0 and its neighbours 1, 2, 4 span the box.
  const Eigen::Vector3d corner = body->end.head<3>();
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    bool inside = true;
    for (const int neighbour : {1, 2, 4}) {
      const Eigen::Vector3d side = body->end.segment<3>(3 * neighbour) - corner;
      const double along = side.dot(x.segment<3>(i) - corner) / side.squaredNorm();
      inside = inside && along >= 0.0 && along <= 1.0;
    }
    count += inside;
  }
  return count;
}

int ObstacleContacts::CountIntersections(const Eigen::VectorXd& x,
                                         std::vector<std::string>* names) {
  int all = 0;
  const auto add = [&](int count, const std::string& name) {
    all += count;
    if (count > 0 && names != nullptr) names->push_back(name);
  };
  for (Body& body : bodies_) add(CountIn(&body, x), body.obstacle->name);
  int below = 0;
  for (Eigen::Index i = 2; ground_ && i < x.size(); i += 3) below += !(x[i] > *ground_);
  add(below, "ground");
  return all;
}

}  // namespace clothfit
