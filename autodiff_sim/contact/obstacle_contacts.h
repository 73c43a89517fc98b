// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The contacts of a cloth with the obstacles of its scene and with the ground, followed while both
// move. As in SelfContacts, pairs are kept in a list with a margin.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/collision_surface.h"
#include "autodiff_sim/contact/obstacle_body.h"
#include "autodiff_sim/contact/obstacle_contact.h"

namespace clothfit {

class ObstacleContacts {
 public:
  // ground: its height (m), if it is to be watched too.
  ObstacleContacts(const ClothMesh& mesh,
                   const std::vector<std::shared_ptr<const Obstacle>>& obstacles,
                   std::optional<double> ground);

  // Lets the obstacles, changed so, go from where they are at `start` (s) to where they are at
  // `end`. What is asked below of one place of the cloth is asked of the step's end.
  void BeginStep(double start, double end, const ObstacleChange& change = {});
  bool is_moving() const { return is_moving_; }

  // As in SelfContacts. ground_distance (m): below which the ground counts as in contact.
  void Prepare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double thickness);
  const std::vector<ObstacleContact>& Find(const Eigen::VectorXd& x, double thickness,
                                           double ground_distance);
  // The share of the cloth's straight motion that is free: while the obstacles move through the
  // whole step, or after they have.
  enum class Obstacles { kMoving, kArrived };
  double FreeShare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double thickness,
                   Obstacles obstacles);

  // How many edges meet a triangle, of the cloth and of a mesh, exactly; features of the cloth that
  // are within a ball or a bar; particles that are within a box or not above the ground. At the
  // step's end. `names`, where given, gets one name for each obstacle that has any.
  int CountIntersections(const Eigen::VectorXd& x, std::vector<std::string>* names = nullptr);

  void Forget() { list_x_.resize(0); }

 private:
  struct Body {
    std::shared_ptr<const Obstacle> obstacle;
    std::optional<CollisionSurface<>> surface;  // of a mesh
    double radius;                              // m, 0 of a mesh
    Eigen::VectorXd start, end, velocity;       // of the points, m, m/s
  };
  struct Listed {
    int body;
    FeaturePair pair;
    double gap;  // m, at list_x_
  };
  // Calls visit(pair) for all pairs of the cloth and an obstacle that is no mesh.
  template <class Visit>
  void VisitPairs(const Body& body, const Visit& visit) const;
  double Gap(const Body& body, const FeaturePair& pair, const Eigen::VectorXd& x) const;
  void List(const Eigen::VectorXd& x, double reach);
  // m, how far the particles of the pair are from where they were listed, at most.
  double Moved(const Listed& listed, const Eigen::VectorXd& x) const;
  double FreeShareOf(Body* body, const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                     double thickness, Obstacles obstacles);
  double FreeShareOfList(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1, double thickness);
  double FreeShareOfGround(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                           double thickness) const;
  ObstacleContact MakeContact(const Body& body, const FeaturePair& pair) const;
  int CountIn(Body* body, const Eigen::VectorXd& x);

  CollisionSurface<> surface_;
  std::vector<Eigen::Vector2d> uv_;                              // m
  std::vector<double> vertex_area_, edge_area_, triangle_area_;  // m^2
  std::vector<Body> bodies_;
  std::optional<double> ground_;                     // m
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();  // m, of all bodies
  bool is_moving_ = false;
  std::vector<Listed> list_;
  Eigen::VectorXd list_x_;  // where the list was made; empty where there is none
  double reach_ = 0.0;      // m, of the list
  std::vector<ObstacleContact> found_;
};

}  // namespace clothfit
