// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The model's contacts: which there are, and where they lie in the pattern.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/contact/contact_clock.h"
#include "autodiff_sim/step/cloth_model.h"
#include "autodiff_sim/terms/barrier.h"
#include "autodiff_sim/terms/obstacle_contact.h"
#include "autodiff_sim/terms/self_contact.h"

namespace clothfit {
namespace {

// Where a term's first parameter is among all; -1 where the simulation lacks the term.
template <class Term>
int FirstParameter(const std::vector<NamedParameter>& parameters) {
  return FindParameter(parameters, FullName<Term>());
}

}  // namespace

void ClothModel::EnableSelfContact() {
  first_contact_parameter_ = FirstParameter<SelfContact>(parameters_);
  if (first_contact_parameter_ < 0)
    throw InputError("self_contact",
                     "no term of the simulation has the parameter contact.stiffness");
  contacts_ = std::make_unique<SelfContacts>(mesh_);
  ground_distance_ = FindParameter(parameters_, ObstacleBarrier::kReads[0]);  // the ground's
  const bool has_barrier =
      ground_distance_ >= 0 && FirstParameter<ObstacleBarrier>(parameters_) >= 0;
  if (world_.ground_height && has_barrier) FollowObstacles(world_.ground_height);
}

void ClothModel::FollowObstacles(std::optional<double> ground) {
  first_obstacle_parameter_ = FirstParameter<ObstacleBarrier>(parameters_);
  if (first_obstacle_parameter_ < 0)
    throw InputError("obstacles", "no term of the simulation has the parameter obstacle.stiffness");
  obstacles_ = std::make_unique<ObstacleContacts>(mesh_, world_.obstacles, ground);
}

bool ClothModel::HasSelfContact(const Eigen::VectorXd& parameters) const {
  return contacts_ != nullptr && parameters[first_contact_parameter_ + SelfContact::kStiffness] !=
                                     SelfContact::kParameters[SelfContact::kStiffness].off;
}

bool ClothModel::HasObstacles(const Eigen::VectorXd& parameters) const {
  return obstacles_ != nullptr &&
         parameters[first_obstacle_parameter_ + ObstacleBarrier::kStiffness] !=
             ObstacleBarrier::kParameters[ObstacleBarrier::kStiffness].off;
}

double ClothModel::ContactThickness(const Eigen::VectorXd& parameters) const {
  return parameters[first_contact_parameter_ + SelfContact::kThickness];
}

double ClothModel::LargestThickness() const {
  return contacts_ != nullptr ? 0.5 * contacts_->rest_clearance()
                              : std::numeric_limits<double>::infinity();
}

ObstacleChange ClothModel::ChangeOfObstacles(const Eigen::VectorXd& parameters) const {
  return ObstacleBarrier::Change(parameters, first_obstacle_parameter_);
}

void ClothModel::BeginContactStep(double start, double end, const Eigen::VectorXd& parameters) {
  if (obstacles_ != nullptr) obstacles_->BeginStep(start, end, ChangeOfObstacles(parameters));
}

void ClothModel::PrepareContacts(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                                 const Eigen::VectorXd& parameters) {
  const ContactClock clock(&contact_times.detection);
  if (HasSelfContact(parameters)) contacts_->Prepare(x0, x1, ContactThickness(parameters));
  if (HasObstacles(parameters)) {
    obstacles_->Prepare(x0, x1,
                        parameters[first_obstacle_parameter_ + ObstacleBarrier::kThickness]);
  }
}

double ClothModel::FreeShare(const Eigen::VectorXd& x0, const Eigen::VectorXd& x1,
                             const Eigen::VectorXd& parameters,
                             ObstacleContacts::Obstacles obstacles) {
  const ContactClock clock(&contact_times.detection);
  double share = 1.0;
  if (HasSelfContact(parameters))
    share = contacts_->FreeShare(x0, x1, ContactThickness(parameters));
  if (HasObstacles(parameters)) {
    const double thickness = parameters[first_obstacle_parameter_ + ObstacleBarrier::kThickness];
    share = std::min(share, obstacles_->FreeShare(x0, x1, thickness, obstacles));
  }
  return share;
}

bool ClothModel::IsClear(const Eigen::VectorXd& x, double time, const Eigen::VectorXd& parameters) {
  if (!x.allFinite()) return false;
  if (HasSelfContact(parameters) && contacts_->CountIntersections(x) > 0) return false;
  if (!HasObstacles(parameters)) return true;
  BeginContactStep(time, time, parameters);
  return obstacles_->CountIntersections(x) == 0;
}

void ClothModel::FollowContacts(const Eigen::VectorXd& x, const Eigen::VectorXd& parameters) {
  const ContactClock clock(&contact_times.detection);
  found_contacts_ = nullptr;
  found_obstacles_ = nullptr;
  if (HasSelfContact(parameters))
    found_contacts_ = &contacts_->Find(x, ContactThickness(parameters));
  if (HasObstacles(parameters)) {
    const double ground = ground_distance_ < 0 ? 0.0 : parameters[ground_distance_];
    found_obstacles_ =
        &obstacles_->Find(x, parameters[first_obstacle_parameter_ + ObstacleBarrier::kThickness],
                          ObstacleBarrier::kGroundShare * ground);
  }
  const TermContext context = {mesh_,   topology_,       world_,
                               nullptr, found_contacts_, found_obstacles_};
  for (const Part& part : parts_) part.batch->FollowContacts(context);
}

std::array<int, 2> ClothModel::CountContacts() const {
  return {found_contacts_ == nullptr ? 0 : static_cast<int>(found_contacts_->size()),
          found_obstacles_ == nullptr ? 0 : static_cast<int>(found_obstacles_->size())};
}

bool ClothModel::BindContacts() {
  for (int i = 0; i < CountContacts()[0]; ++i) {
    const ContactPair& pair = (*found_contacts_)[static_cast<std::size_t>(i)];
    for (const int a : pair.nodes) {
      for (const int b : pair.nodes) {
        if (a < b && pattern_.Find(a, b) < 0) return false;
      }
    }
  }
  for (const Part& part : parts_) {
    const std::string& name = part.batch->info().name;
    if (name == SelfContact::kName || name == ObstacleBarrier::kName) part.batch->Bind(&pattern_);
  }
  return true;
}

void ClothModel::AddContactStiffness(const ForcePoint& point, double gamma,
                                     BlockSparseMatrix* matrix) const {
  const ContactClock clock(&contact_times.response);
  const double* parameter = &point.parameters[first_contact_parameter_];
  const double thickness = parameter[SelfContact::kThickness];
  const double slip = parameter[SelfContact::kSlipSpeed];
  for (const ContactPair& pair : *found_contacts_) {
    FourPoints x, v;
    for (int i = 0; i < 4; ++i) {
      x[i] = point.x.segment<3>(3 * pair.nodes[i]);
      v[i] = point.v.segment<3>(3 * pair.nodes[i]);
    }
    const ClosestOffset<double> closest = FindClosestOffset<double>(pair.kind, x, x);
    const double gap = closest.offset.norm(), s = gap / thickness;
    if (!(s < 1.0)) continue;
    double push = parameter[SelfContact::kStiffness] * pair.area;
    if (pair.kind == PairKind::kEdgeEdge) push *= Fading(x, pair.parallel);
    const std::array<double, 4>& w = closest.weights;
    const Eigen::Vector3d normal = closest.offset / gap;
    const Eigen::Vector3d relative = v[0] * w[0] + v[1] * w[1] + v[2] * w[2] + v[3] * w[3];
    const Eigen::Vector3d sliding = relative - normal * normal.dot(relative);
    const double along = gamma * gamma * push * BarrierCurvature(s) / thickness;
    const double across = gamma * parameter[SelfContact::kFriction] * push *
                          BarrierSlope<double>(s) / std::hypot(sliding.norm(), slip);
    const Eigen::Matrix3d nn = normal * normal.transpose();
    Eigen::Matrix<double, 3, BlockSparseMatrix::kRow, Eigen::RowMajor> block;
    block << along * nn + across * (Eigen::Matrix3d::Identity() - nn), Eigen::Vector3d::Zero();
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < 4; ++b) {
        double* target = matrix->block(pattern_.Find(pair.nodes[a], pair.nodes[b]));
        for (Eigen::Index k = 0; k < block.size(); ++k) target[k] += w[a] * w[b] * block.data()[k];
      }
    }
  }
}

void ClothModel::RebuildPattern() {
  std::vector<std::vector<int>> cliques;
  for (const std::array<int, 4>& pair : contacts_->FindNear())
    cliques.emplace_back(pair.begin(), pair.end());
  MakePatternWith(cliques);
}

void ClothModel::ResetPattern() {
  if (obstacles_ != nullptr) obstacles_->Forget();
  if (contacts_ == nullptr) return;
  contacts_->Forget();
  MakePatternWith({});
}

}  // namespace clothfit
