// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The equation of one implicit step, whose unknown is the velocity at its end:
//   r(v) = M (v - v_hat) - gamma f(x_hat + gamma v, v, (v - v_hat) / gamma) = 0,
// with x_hat, v_hat and gamma from backward Euler (x_hat = x_n, gamma = h) or from BDF2 with the
// ratio w = h / previous h (Hairer, Norsett and Wanner 1993, III.5):
//   x_hat = (1 + w)^2 / (1 + 2 w) x_n - w^2 / (1 + 2 w) x_(n-1),  gamma = h (1 + w) / (1 + 2 w).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "autodiff_sim/contact/obstacle_contacts.h"
#include "autodiff_sim/contact/self_contacts.h"
#include "autodiff_sim/linear/block_sparse_matrix.h"
#include "autodiff_sim/step/handle_constraints.h"
#include "autodiff_sim/step/state.h"
#include "autodiff_sim/term/force_batch.h"
#include "autodiff_sim/terms/parameter_table.h"

namespace clothfit {

enum class Integrator { kBackwardEuler, kBdf2 };

// One formula for positions and velocities: y_hat = now * y_n + before * y_(n-1).
struct StepFormula {
  double now = 1.0, before = 0.0, gamma = 0.0;
};
// Backward Euler where there is no step before, or where this one is more than twice as long.
StepFormula MakeStepFormula(Integrator integrator, double step, double previous_step);

// Everything that the forces depend on but the inputs.
struct ForcePoint {
  double time;                        // s, at the end of the step
  double step;                        // s, its length
  const Eigen::VectorXd& x;           // 3N, m
  const Eigen::VectorXd& v;           // 3N, m/s
  const Eigen::VectorXd& a;           // 3N, m/s^2
  const Eigen::VectorXd& start;       // 3N, m, the positions when the step began
  const Eigen::VectorXd& parameters;  // all of them, see parameter_table.h
  const Eigen::VectorXd& memory;      // at the start of the step
};

// A part of the cloth's energy.
struct NamedEnergy {
  std::string name;  // kinetic, or the term's
  double energy;     // J; of gravity, nothing at the world's origin
};
double Total(const std::vector<NamedEnergy>& energies);

// kLanes directions in which all of that may move, a row for each number; empty where nothing does.
struct ForceDirections {
  Lanes<kLanes> x, v, a, parameters;
  const Lanes<kLanes>* start = nullptr;
  const Lanes<kLanes>* memory = nullptr;  // at the start of the step
  Lanes<kLanes> inputs;                   // rows of StepInputs::directions
};

// The cloth as the solver sees it: its forces and masses.
class ClothModel {
 public:
  // Finds pattern and elements. `handles` are all points that may ever be held.
  ClothModel(ClothMesh mesh, const World& world,
             std::vector<std::unique_ptr<ForceBatch>> (*make_batches)(const TermContext&),
             const std::vector<SurfacePoint>& handles);

  const ClothMesh& mesh() const { return mesh_; }
  const ClothTopology& topology() const { return topology_; }
  const World& world() const { return world_; }
  const BlockPattern& pattern() const { return pattern_; }
  const std::vector<NamedParameter>& parameters() const { return parameters_; }
  int memory_size() const { return memory_size_; }
  std::size_t num_terms() const { return parts_.size(); }

  void BeginStep(const StepInputs& inputs);

  // Contacts of the cloth with itself, and with the ground beyond the term of that name. There are
  // none until they are asked for; that throws InputError where no term answers them. Those with
  // the world's obstacles are there always.
  void EnableSelfContact();
  bool has_self_contacts() const { return contacts_ != nullptr; }
  // Whether contacts are followed and their force is not off: with itself, with obstacles, any.
  bool HasSelfContact(const Eigen::VectorXd& parameters) const;
  bool HasObstacles(const Eigen::VectorXd& parameters) const;
  bool HasContact(const Eigen::VectorXd& parameters) const {
    return HasSelfContact(parameters) || HasObstacles(parameters);
  }
  double ContactThickness(const Eigen::VectorXd& parameters) const;  // m, of self-contact
  // m, the largest that the mesh is coarse enough for; infinite without self-contact.
  double LargestThickness() const;
  // Lets the obstacles go from where they are at `start` (s) to where they are at `end`.
  void BeginContactStep(double start, double end, const Eigen::VectorXd& parameters);
  // By how much the obstacles stand elsewhere than the world says; needs HasObstacles().
  ObstacleChange ChangeOfObstacles(const Eigen::VectorXd& parameters) const;
  bool ObstaclesMove() const { return obstacles_ != nullptr && obstacles_->is_moving(); }
  // Makes ready for a motion of the cloth about from x0 to x1 (3N, m).
  void PrepareContacts(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                       const Eigen::VectorXd& parameters);
  // The share of the straight motion from x0 to x1 along which nothing meets.
  double FreeShare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                   const Eigen::VectorXd& parameters, ObstacleContacts::Obstacles obstacles);
  // Whether nothing meets at x at that time (s).
  bool IsClear(const Eigen::VectorXd& x, double time, const Eigen::VectorXd& parameters);
  // Lets the contact terms' elements be the features in contact at x (3N, m), for what is
  // evaluated next.
  void FollowContacts(const Eigen::VectorXd& x, const Eigen::VectorXd& parameters);
  // How many there are: with itself, with obstacles.
  std::array<int, 2> CountContacts() const;
  // Whether the pattern has blocks for all contacts; if so, tells the terms where they are.
  bool BindContacts();
  // Adds what makes the Jacobian of self-contact definite and most of it: the barrier's curvature
  // along the offsets, and the friction's resistance. To precondition with, where the exact one,
  // with what the barrier does to a turning pair, is indefinite.
  void AddContactStiffness(const ForcePoint& point, double gamma, BlockSparseMatrix* matrix) const;
  // Makes the pattern anew, in its place, with these contacts and those that are near: of matrices
  // and factors that were made for it, nothing may be used any more.
  void RebuildPattern();
  // Without any contact.
  void ResetPattern();

  // The terms that act, or that some direction (all parameters x directions) may switch on. The
  // others are at their off values, add exactly nothing and cost nothing.
  std::vector<bool> Awake(const Eigen::VectorXd& parameters,
                          const Eigen::MatrixXd& directions) const;

  // The forces (N) at a point, 3N; `new_memory` gets the memory there of the terms that act.
  void Forces(const ForcePoint& point, Eigen::VectorXd* force, Eigen::VectorXd* new_memory) const;
  // The same of the terms that are off: those that are awake go on remembering, the others keep
  // what they have.
  void UpdateMemoryOfOff(const ForcePoint& point, const std::vector<bool>& awake,
                         Eigen::VectorXd* new_memory) const;
  // The kinetic energy, and that of each term that has one; nothing in those that are off.
  std::vector<NamedEnergy> Energies(const ForcePoint& point) const;
  // jacobian = M - gamma (df/dv + gamma df/dx + 1/gamma df/da). Where the cloth is in contact with
  // itself, `without` (may be null) gets the same without the term of that; else it is left alone.
  // Returns whether it is.
  bool StepJacobian(const ForcePoint& point, double gamma, BlockSparseMatrix* jacobian,
                    BlockSparseMatrix* without = nullptr) const;
  // stiffness = df/dx.
  void Stiffness(const ForcePoint& point, BlockSparseMatrix* stiffness) const;
  // Adds the forces' derivatives along kLanes directions, 3N x kLanes. `awake` as found above for
  // all directions together.
  void AddForceDerivatives(const ForcePoint& point, const ForceDirections& directions,
                           const std::vector<bool>& awake, Lanes<kLanes>* force) const;
  // Moves the derivatives of the memory to the end of the step; `memory` may be that of the
  // directions, and terms that are not awake leave it as it is.
  void UpdateMemoryDerivatives(const ForcePoint& point, const ForceDirections& directions,
                               const std::vector<bool>& awake, Lanes<kLanes>* memory) const;

 private:
  // A term's elements, and where its numbers stand among all.
  struct Part {
    std::unique_ptr<ForceBatch> batch;
    int first_parameter, first_memory;
    std::vector<int> reads;
  };
  static BatchPoint PointOf(const Part& part, const ForcePoint& all);
  static BatchDirections DirectionsOf(const Part& part, const ForceDirections& all);
  static bool IsOff(const Part& part, const Eigen::VectorXd& parameters);
  template <class Directions>
  static bool IsSwitchedBy(const Part& part, const Directions& directions);
  void FindParts(std::vector<std::unique_ptr<ForceBatch>> batches);
  void AddMass(double areal_density, BlockSparseMatrix* a) const;
  void MakePatternWith(const std::vector<std::vector<int>>& contacts);
  void FollowObstacles(std::optional<double> ground);

  ClothMesh mesh_;
  ClothTopology topology_;
  World world_;
  std::vector<Part> parts_;
  std::vector<NamedParameter> parameters_;
  BlockPattern mesh_pattern_;          // of triangles and terms, contacts excepted
  std::vector<HandleTarget> handles_;  // all that may ever be held, at no place in particular
  BlockPattern pattern_;
  std::unique_ptr<SelfContacts> contacts_;
  std::unique_ptr<ObstacleContacts> obstacles_;
  const std::vector<ContactPair>* found_contacts_ = nullptr;
  const std::vector<ObstacleContact>* found_obstacles_ = nullptr;
  int first_contact_parameter_ = -1, first_obstacle_parameter_ = -1, ground_distance_ = -1;
  int memory_size_ = 0;
};

}  // namespace clothfit
