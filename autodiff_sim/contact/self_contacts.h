// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The contacts of a cloth with itself, followed while it moves. All pairs within a reach that is
// wider than the contact are kept in a list (Verlet 1967) and looked for anew only when particles
// have moved so far that others might have come closer.
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/collision_surface.h"
#include "autodiff_sim/contact/contact_pair.h"

namespace clothfit {

class SelfContacts {
 public:
  explicit SelfContacts(const ClothMesh& mesh);

  // m, the smallest distance in the flat cloth of features that have no vertex in common.
  double rest_clearance() const { return rest_clearance_; }

  // Looks for pairs around the straight motion from x0 to x1 (3N, m) in one go, so that what is
  // asked below of places near it needs no search of its own. Changes no answer.
  void Prepare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double thickness);

  // The pairs that are closer than `thickness` (m) at x (3N, m), in an order that does not depend
  // on what was asked before.
  const std::vector<ContactPair>& Find(const Eigen::VectorXd& x, double thickness);
  // The same with a margin, for x as in the last Find(): what may soon be in contact.
  std::vector<std::array<int, 4>> FindNear() const;

  // The largest share, up to 1, of the straight motion from x0 to x1 (3N, m) along which nothing
  // meets, for a start where nothing does. Gaps shrink to no less than a fifth. `thickness` as in
  // the last Find().
  double FreeShare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double thickness);

  // Edges and triangles that meet at x (3N, m), exactly.
  int CountIntersections(const Eigen::VectorXd& x);

  // Forgets what was found, so that what follows does not depend on it.
  void Forget() { list_.clear(), list_x_.resize(0), found_x_.resize(0); }

 private:
  struct Listed {
    FeaturePair pair;
    ContactPair contact;
    double distance;  // m, at list_x_
  };
  void List(const Eigen::VectorXd& x, double reach);
  ContactPair MakeContact(const FeaturePair& pair) const;
  // Sets moved_ to each particle's distance (m) from its place in list_x_, or to the larger one of
  // that and what it was. Returns the largest, infinity where there is no list.
  double Measure(const Eigen::VectorXd& x, bool keep_larger = false);
  // m, a bound on how much closer a pair may be than it is in the list, after Measure().
  double Closer(const ContactPair& pair) const;
  double RestCross(const std::array<int, 4>& nodes) const;

  CollisionSurface<> surface_;
  std::vector<Eigen::Vector2d> uv_;              // m
  std::vector<double> vertex_area_, edge_area_;  // m^2
  double rest_clearance_ = 0.0;
  std::vector<Listed> list_;
  Eigen::VectorXd list_x_;     // where the list was made; empty where there is none
  double reach_ = 0.0;         // m, of the list
  std::vector<double> moved_;  // m
  std::vector<ContactPair> found_;
  Eigen::VectorXd found_x_;
  double found_thickness_ = 0.0;
};

}  // namespace clothfit
