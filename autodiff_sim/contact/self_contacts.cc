// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/self_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "autodiff_sim/contact/continuous.h"
#include "autodiff_sim/contact/intersections.h"
#include "autodiff_sim/contact/proximity.h"

namespace clothfit {
namespace {

// The areas that pairs stand for. Put a layer on another one at chance: per area of cloth there are
// 1 / (area of a vertex) vertices of each that find a triangle, and on a mesh of triangles of
// similar size about 7.4 / 3 / (area of an edge) crossings of edges. With these shares vertices and
// edges bear half each.
constexpr double kVertexShare = 0.25, kEdgeShare = 0.2;
// How far the list has to reach, and how far it does where it is made for a motion and where for
// none, and how far the pattern does, in thicknesses.
constexpr double kLeast = 2.0, kReach = 3.0, kStillReach = 4.0, kNear = 5.0;
// Of the clearance, how far it may reach before neighbours crowd it.
constexpr double kClearanceShare = 0.8;
// How many motions as long as the one that a list is made for it reaches over: from the middle of
// the first to the end of the second, by both sides of a pair.
constexpr double kMotions = 3.0;

Eigen::VectorXd FlatPlaces(const std::vector<Eigen::Vector2d>& uv) {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(uv.size()));
  for (std::size_t i = 0; i < uv.size(); ++i)
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) << uv[i], 0.0;
  return x;
}

}  // namespace

SelfContacts::SelfContacts(const ClothMesh& mesh)
    : surface_(mesh),
      uv_(mesh.uv),
      vertex_area_(mesh.uv.size(), 0.0),
      edge_area_(surface_.features().edges.size(), 0.0) {
  const std::vector<std::array<int, 2>>& edges = surface_.features().edges;
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::array<int, 2>& e : edges)
    shortest = std::min(shortest, (uv_[e[1]] - uv_[e[0]]).norm());
  for (const std::array<int, 3>& t : mesh.triangles) {
    const double third = SignedArea(mesh, t) / 3.0;
    for (int k = 0; k < 3; ++k) {
      vertex_area_[t[k]] += third;
      const std::array<int, 2> side = {std::min(t[k], t[(k + 1) % 3]),
                                       std::max(t[k], t[(k + 1) % 3])};
      edge_area_[static_cast<std::size_t>(std::lower_bound(edges.begin(), edges.end(), side) -
                                          edges.begin())] += third;
    }
  }
  rest_clearance_ = shortest;
  for (const Contact& contact : FindProximity(FlatPlaces(uv_), shortest, &surface_))
    rest_clearance_ = std::min(rest_clearance_, contact.distance);
}

double SelfContacts::RestCross(const std::array<int, 4>& nodes) const {
  return (uv_[nodes[1]] - uv_[nodes[0]]).squaredNorm() *
         (uv_[nodes[3]] - uv_[nodes[2]]).squaredNorm();
}

ContactPair SelfContacts::MakeContact(const FeaturePair& pair) const {
  const std::array<int, 4> nodes = PairVertices(pair, surface_.features(), surface_.features());
  if (pair.kind == PairKind::kEdgeEdge) {
    return {pair.kind, nodes, 0.5 * kEdgeShare * (edge_area_[pair.first] + edge_area_[pair.second]),
            kParallelShare * RestCross(nodes)};
  }
  return {pair.kind, nodes, kVertexShare * vertex_area_[pair.first], 0.0};
}

double SelfContacts::Measure(const Eigen::VectorXd& x, bool keep_larger) {
  if (list_x_.size() != x.size()) return std::numeric_limits<double>::infinity();
  moved_.resize(uv_.size(), 0.0);
  double largest = 0.0;
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const double moved = (x.segment<3>(row) - list_x_.segment<3>(row)).norm();
    moved_[i] = keep_larger ? std::max(moved_[i], moved) : moved;
    largest = std::max(largest, moved_[i]);
  }
  return largest;
}

double SelfContacts::Closer(const ContactPair& pair) const {
  const int first = pair.kind == PairKind::kEdgeEdge ? 2 : 1;
  double a = 0.0, b = 0.0;
  for (int i = 0; i < 4; ++i) {
    double& side = i < first ? a : b;
    side = std::max(side, moved_[pair.nodes[i]]);
  }
  return a + b;
}

void SelfContacts::List(const Eigen::VectorXd& x, double reach) {
  reach_ = reach;
  list_.clear();
  for (const Contact& contact : FindProximity(x, reach_, &surface_))
    list_.push_back({contact.pair, MakeContact(contact.pair), contact.distance});
  list_x_ = x;
}

void SelfContacts::Prepare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double thickness) {
  Measure(x0);
  if (2.0 * Measure(x1, true) < reach_ - thickness) return;
  double longest = 0.0;
  for (Eigen::Index i = 0; i < x0.size(); i += 3)
    longest = std::max(longest, (x1.segment<3>(i) - x0.segment<3>(i)).norm());
  const double most = std::max(kLeast * thickness, kClearanceShare * rest_clearance_);
  if (kLeast * thickness + longest <= most)
    List(0.5 * (x0 + x1), std::min(most, kReach * thickness + kMotions * longest));
}

const std::vector<ContactPair>& SelfContacts::Find(const Eigen::VectorXd& x, double thickness) {
  if (found_thickness_ == thickness && found_x_.size() == x.size() && found_x_ == x) return found_;
  if (!(2.0 * Measure(x) < reach_ - thickness)) {
    List(x, std::max(kLeast * thickness,
                     std::min(kStillReach * thickness, kClearanceShare * rest_clearance_)));
    Measure(x);
  }
  found_.clear();
  const PlacedMesh mesh{surface_.features(), x};
  for (const Listed& listed : list_) {
    if (listed.distance - Closer(listed.contact) >= thickness) continue;
    if (MeasureContact(listed.pair, PairPoints(listed.pair, mesh, mesh)).distance < thickness)
      found_.push_back(listed.contact);
  }
  found_x_ = x;
  found_thickness_ = thickness;
  return found_;
}

std::vector<std::array<int, 4>> SelfContacts::FindNear() const {
  std::vector<std::array<int, 4>> pairs;
  const PlacedMesh mesh{surface_.features(), found_x_};
  for (const Listed& listed : list_) {
    if (MeasureContact(listed.pair, PairPoints(listed.pair, mesh, mesh)).distance <
        kNear * found_thickness_)
      pairs.push_back(listed.contact.nodes);
  }
  return pairs;
}

double SelfContacts::FreeShare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                               double thickness) {
  const Approach approach = {0.0, kGapTolerance * thickness, kGapSlack};
  Measure(x0);
  if (!(2.0 * Measure(x1, true) + approach.tolerance < reach_)) {
    return EarliestImpact({x0, x1}, approach, &surface_);
  }
  double until = 1.0;
  const PlacedMesh start{surface_.features(), x0}, end{surface_.features(), x1};
  for (const Listed& listed : list_) {
    if (listed.distance - Closer(listed.contact) > approach.tolerance) continue;
    const std::optional<double> time =
        FirstApproach(listed.pair, PairPoints(listed.pair, start, start),
                      PairPoints(listed.pair, end, end), approach, until);
    if (time) until = std::min(until, *time);
  }
  return until;
}

int SelfContacts::CountIntersections(const Eigen::VectorXd& x) {
  return static_cast<int>(FindIntersections(x, &surface_).size());
}

}  // namespace clothfit
