// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/contact/proximity.h"

#include <algorithm>
#include <cassert>

#include "autodiff_sim/contact/candidates.h"

namespace clothfit {
namespace {

void SortByPair(std::vector<Contact>* contacts) {
  std::sort(contacts->begin(), contacts->end(),
            [](const Contact& a, const Contact& b) { return a.pair < b.pair; });
}

}  // namespace

Contact MeasureContact(const FeaturePair& pair, const FourPoints& points) {
  if (pair.kind == PairKind::kEdgeEdge) {
    const EdgeEdgeClosest closest = ClosestEdgeEdge(points);
    const auto [s, t] = closest.along;
    return {pair, {1.0 - s, s, t - 1.0, -t}, closest.distance, closest.cross_squared};
  }
  const VertexTriangleClosest closest = ClosestVertexTriangle(points);
  const auto [a, b, c] = closest.weights;
  return {pair, {1.0, -a, -b, -c}, closest.distance, 0.0};
}

template <int Planes>
std::vector<Contact> FindProximity(const Eigen::VectorXd& x, double distance,
                                   CollisionSurface<Planes>* surface) {
  assert(distance > 0.0);
  surface->Refit(x, 0.5 * distance);
  const PlacedMesh mesh{surface->features(), x};
  std::vector<Contact> contacts;
  VisitCandidates(*surface, [&](const FeaturePair& pair) {
    const Contact contact = MeasureContact(pair, PairPoints(pair, mesh, mesh));
    if (contact.distance < distance) contacts.push_back(contact);
  });
  SortByPair(&contacts);
  return contacts;
}

template <int Planes>
std::vector<Contact> FindProximity(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                   double distance, CollisionSurface<Planes>* cloth,
                                   CollisionSurface<Planes>* obstacle) {
  assert(distance > 0.0);
  cloth->Refit(x, 0.5 * distance);
  obstacle->Refit(y, 0.5 * distance);
  const PlacedMesh a{cloth->features(), x}, b{obstacle->features(), y};
  std::vector<Contact> contacts;
  VisitCandidates(*cloth, *obstacle, [&](const FeaturePair& pair) {
    const Contact contact = MeasureContact(pair, PairPoints(pair, a, b));
    if (contact.distance < distance) contacts.push_back(contact);
  });
  SortByPair(&contacts);
  return contacts;
}

#define CLOTHFIT_INSTANTIATE(PLANES)                                                          \
  template std::vector<Contact> FindProximity(const Eigen::VectorXd&, double,                 \
                                              CollisionSurface<PLANES>*);                     \
  template std::vector<Contact> FindProximity(const Eigen::VectorXd&, const Eigen::VectorXd&, \
                                              double, CollisionSurface<PLANES>*,              \
                                              CollisionSurface<PLANES>*)
CLOTHFIT_INSTANTIATE(6);
CLOTHFIT_INSTANTIATE(14);
CLOTHFIT_INSTANTIATE(18);
CLOTHFIT_INSTANTIATE(26);
#undef CLOTHFIT_INSTANTIATE

}  // namespace clothfit
