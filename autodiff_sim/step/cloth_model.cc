// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Assembly over all terms.
#include "autodiff_sim/step/cloth_model.h"

#include <utility>

#include "autodiff_sim/contact/contact_clock.h"

namespace clothfit {

StepFormula MakeStepFormula(Integrator integrator, double step, double previous_step) {
  const double w = previous_step > 0.0 ? step / previous_step : 0.0;
  constexpr double kLargestRatio = 2.0 + 1e-9;  // zero-stable up to 1 + sqrt(2)
  if (integrator == Integrator::kBackwardEuler || previous_step <= 0.0 || w > kLargestRatio) {
    return {1.0, 0.0, step};
  }
  const double d = 1.0 + 2.0 * w;
  return {(1.0 + w) * (1.0 + w) / d, -w * w / d, step * (1.0 + w) / d};
}

ClothModel::ClothModel(ClothMesh mesh, const World& world,
                       std::vector<std::unique_ptr<ForceBatch>> (*make_batches)(const TermContext&),
                       const std::vector<SurfacePoint>& handles)
    : mesh_(std::move(mesh)), topology_(BuildTopology(mesh_)), world_(world) {
  FindParts(make_batches({mesh_, topology_, world_, nullptr}));
  std::vector<std::vector<int>> cliques;
  for (const std::array<int, 3>& t : mesh_.triangles) cliques.emplace_back(t.begin(), t.end());
  for (const Part& part : parts_) {
    const std::vector<std::vector<int>> more = part.batch->Cliques();
    cliques.insert(cliques.end(), more.begin(), more.end());
  }
  mesh_pattern_ = MakePattern(mesh_.num_particles(), cliques);
  for (const SurfacePoint& point : handles) handles_.push_back({point, Eigen::Vector3d::Zero()});
  MakePatternWith({});
  if (!world_.obstacles.empty()) FollowObstacles(std::nullopt);
}

void ClothModel::MakePatternWith(const std::vector<std::vector<int>>& contacts) {
  const BlockPattern with_contacts = ExtendPattern(mesh_pattern_, contacts);
  const HandleConstraints handles(handles_);
  pattern_ = ExtendPattern(with_contacts, handles.ExtraCliques(with_contacts));
  for (const Part& part : parts_) part.batch->Bind(&pattern_);
}

void ClothModel::FindParts(std::vector<std::unique_ptr<ForceBatch>> batches) {
  std::vector<TermInfo> infos;
  for (const std::unique_ptr<ForceBatch>& batch : batches) infos.push_back(batch->info());
  parameters_ = MakeParameterTable(infos);
  int first_parameter = kNumClothParameters;
  for (std::unique_ptr<ForceBatch>& batch : batches) {
    Part part = {std::move(batch), first_parameter, memory_size_, {}};
    const TermInfo& info = part.batch->info();
    for (const std::string& name : info.reads)
      part.reads.push_back(FindParameter(parameters_, name));
    first_parameter += static_cast<int>(info.parameters.size());
    memory_size_ += part.batch->memory_size();
    parts_.push_back(std::move(part));
  }
}

void ClothModel::BeginStep(const StepInputs& inputs) {
  const TermContext context = {mesh_, topology_, world_, &inputs};
  for (const Part& part : parts_) {
    part.batch->BeginStep(context);
    if (contacts_ != nullptr || obstacles_ != nullptr)
      part.batch->FollowContacts(context);  // none so far
  }
}

BatchPoint ClothModel::PointOf(const Part& part, const ForcePoint& all) {
  return {all.time,
          all.step,
          all.x.data(),
          all.v.data(),
          all.a.data(),
          all.start.data(),
          all.parameters.data(),
          all.parameters.data() + part.first_parameter,
          part.reads.data(),
          all.memory.data() + part.first_memory};
}

BatchDirections ClothModel::DirectionsOf(const Part& part, const ForceDirections& all) {
  const auto rows = [](const Lanes<kLanes>& lanes) {
    return lanes.size() > 0 ? lanes.data() : nullptr;
  };
  return {rows(all.x),
          rows(all.v),
          rows(all.a),
          all.start->data(),
          all.parameters.data(),
          all.parameters.data() + kLanes * part.first_parameter,
          all.memory->data() + kLanes * part.first_memory,
          rows(all.inputs)};
}

// Whether the term adds nothing: its parameters are off, but for those that only shape its force.
bool ClothModel::IsOff(const Part& part, const Eigen::VectorXd& parameters) {
  const std::vector<Parameter>& own = part.batch->info().parameters;
  bool off = false;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (!SwitchesOff(own[i])) continue;
    if (parameters[part.first_parameter + static_cast<int>(i)] != own[i].off) return false;
    off = true;
  }
  return off;
}

// Whether directions (all parameters x directions) may switch the term on.
template <class Directions>
bool ClothModel::IsSwitchedBy(const Part& part, const Directions& directions) {
  const std::vector<Parameter>& own = part.batch->info().parameters;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const int row = part.first_parameter + static_cast<int>(i);
    if (SwitchesOff(own[i]) && !directions.row(row).isZero(0.0)) return true;
  }
  return false;
}

std::vector<bool> ClothModel::Awake(const Eigen::VectorXd& parameters,
                                    const Eigen::MatrixXd& directions) const {
  std::vector<bool> awake;
  for (const Part& part : parts_)
    awake.push_back(!IsOff(part, parameters) || IsSwitchedBy(part, directions));
  return awake;
}

void ClothModel::Forces(const ForcePoint& all, Eigen::VectorXd* force,
                        Eigen::VectorXd* new_memory) const {
  force->setZero(all.x.size());
  new_memory->resize(all.memory.size());
  for (const Part& part : parts_) {
    if (IsOff(part, all.parameters)) continue;
    double* memory = new_memory->data() + part.first_memory;
    if (part.first_parameter == first_contact_parameter_ ||
        part.first_parameter == first_obstacle_parameter_) {
      const ContactClock clock(&contact_times.response);
      part.batch->AddForces(PointOf(part, all), force->data(), memory);
    } else {
      part.batch->AddForces(PointOf(part, all), force->data(), memory);
    }
  }
}

void ClothModel::UpdateMemoryOfOff(const ForcePoint& all, const std::vector<bool>& awake,
                                   Eigen::VectorXd* new_memory) const {
  Eigen::VectorXd nothing;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    const int size = part.batch->memory_size();
    if (size == 0 || !IsOff(part, all.parameters)) continue;
    if (awake[i]) {
      nothing.setZero(all.x.size());
      part.batch->AddForces(PointOf(part, all), nothing.data(),
                            new_memory->data() + part.first_memory);
    } else {
      new_memory->segment(part.first_memory, size) = all.memory.segment(part.first_memory, size);
    }
  }
}

double Total(const std::vector<NamedEnergy>& energies) {
  double sum = 0.0;
  for (const NamedEnergy& part : energies) sum += part.energy;
  return sum;
}

std::vector<NamedEnergy> ClothModel::Energies(const ForcePoint& all) const {
  double kinetic = 0.0;
  for (int i = 0; i < mesh_.num_particles(); ++i)
    kinetic += 0.5 * topology_.areas[i] * all.v.segment<3>(3 * i).squaredNorm();
  std::vector<NamedEnergy> energies = {{"kinetic", all.parameters[kArealDensity] * kinetic}};
  for (const Part& part : parts_) {
    const std::optional<double> energy = part.batch->Energy(PointOf(part, all));
    if (energy)
      energies.push_back({part.batch->info().name, IsOff(part, all.parameters) ? 0.0 : *energy});
  }
  return energies;
}

void ClothModel::AddMass(double areal_density, BlockSparseMatrix* a) const {
  for (int i = 0; i < mesh_.num_particles(); ++i) {
    double* block = a->block(pattern_.diagonal[i]);
    for (int k = 0; k < 3; ++k)
      block[(BlockSparseMatrix::kRow + 1) * k] += areal_density * topology_.areas[i];
  }
}

bool ClothModel::StepJacobian(const ForcePoint& all, double gamma, BlockSparseMatrix* jacobian,
                              BlockSparseMatrix* without) const {
  const JacobianWeights weights = {-gamma * gamma, -gamma, -1.0};
  jacobian->SetZero();
  AddMass(all.parameters[kArealDensity], jacobian);
  const Part* contact = nullptr;
  for (const Part& part : parts_) {
    if (IsOff(part, all.parameters)) continue;
    if (without != nullptr && part.first_parameter == first_contact_parameter_) {
      contact = &part;
    } else {
      part.batch->AddJacobian(PointOf(part, all), weights, jacobian);
    }
  }
  const bool touches = contact != nullptr && CountContacts()[0] > 0;
  if (touches) {
    const ContactClock clock(&contact_times.response);
    *without = *jacobian;
    contact->batch->AddJacobian(PointOf(*contact, all), weights, jacobian);
  }
  return touches;
}

void ClothModel::Stiffness(const ForcePoint& all, BlockSparseMatrix* stiffness) const {
  stiffness->SetZero();
  for (const Part& part : parts_) {
    if (!IsOff(part, all.parameters))
      part.batch->AddJacobian(PointOf(part, all), {1.0, 0.0, 0.0}, stiffness);
  }
}

void ClothModel::AddForceDerivatives(const ForcePoint& all, const ForceDirections& directions,
                                     const std::vector<bool>& awake, Lanes<kLanes>* force) const {
  Lanes<kLanes> unused(memory_size_, kLanes);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (!awake[i]) continue;
    if (IsOff(part, all.parameters) && !IsSwitchedBy(part, directions.parameters)) continue;
    part.batch->AddDerivatives(PointOf(part, all), DirectionsOf(part, directions), force->data(),
                               unused.data() + kLanes * part.first_memory);
  }
}

void ClothModel::UpdateMemoryDerivatives(const ForcePoint& all, const ForceDirections& directions,
                                         const std::vector<bool>& awake,
                                         Lanes<kLanes>* memory) const {
  Lanes<kLanes> unused;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    if (!awake[i] || part.batch->memory_size() == 0) continue;
    unused.setZero(all.x.size(), kLanes);
    part.batch->AddDerivatives(PointOf(part, all), DirectionsOf(part, directions), unused.data(),
                               memory->data() + kLanes * part.first_memory);
  }
}

}  // namespace clothfit
