// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Assembly over all terms.
#include "autodiff_sim/cloth_model.h"

#include <utility>

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
  batches_ = make_batches({mesh_, topology_, world_, nullptr});
  std::vector<TermInfo> infos;
  std::vector<std::vector<int>> cliques;
  for (const std::array<int, 3>& t : mesh_.triangles) cliques.emplace_back(t.begin(), t.end());
  for (const std::unique_ptr<ForceBatch>& batch : batches_) {
    infos.push_back(batch->info());
    const std::vector<std::vector<int>> more = batch->Cliques();
    cliques.insert(cliques.end(), more.begin(), more.end());
    memory_size_ += batch->memory_size();
  }
  parameters_ = MakeParameterTable(infos);
  mesh_pattern_ = MakePattern(mesh_.num_particles(), cliques);
  for (const SurfacePoint& point : handles) handles_.push_back({point, Eigen::Vector3d::Zero()});
  MakePatternWith({});
}

void ClothModel::MakePatternWith(const std::vector<std::vector<int>>& contacts) {
  const BlockPattern with_contacts = ExtendPattern(mesh_pattern_, contacts);
  const HandleConstraints handles(handles_);
  pattern_ = ExtendPattern(with_contacts, handles.ExtraCliques(with_contacts));
  for (const std::unique_ptr<ForceBatch>& batch : batches_) batch->Bind(&pattern_);
}

void ClothModel::BeginStep(const StepInputs& inputs) {
  const TermContext context = {mesh_, topology_, world_, &inputs};
  for (const std::unique_ptr<ForceBatch>& batch : batches_) {
    batch->BeginStep(context);
    if (contacts_ != nullptr) batch->FollowContacts(context);  // none so far
  }
}

// Calls function(batch, point, first parameter, first memory, is off) for every term.
template <class Function>
void ClothModel::ForEachBatch(const ForcePoint& all, const Function& function) const {
  int first_parameter = kNumClothParameters, first_memory = 0;
  for (const std::unique_ptr<ForceBatch>& batch : batches_) {
    const std::vector<Parameter>& own = batch->info().parameters;
    bool off = batch->memory_size() == 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
      off = off && all.parameters[first_parameter + static_cast<int>(i)] == own[i].off;
    }
    const double* parameters = all.parameters.data();
    const BatchPoint point = {all.time,
                              all.x.data(),
                              all.v.data(),
                              all.a.data(),
                              parameters,
                              parameters + first_parameter,
                              all.memory.data() + first_memory};
    function(*batch, point, first_parameter, first_memory, off && !own.empty());
    first_parameter += static_cast<int>(own.size());
    first_memory += batch->memory_size();
  }
}

void ClothModel::Forces(const ForcePoint& all, Eigen::VectorXd* force,
                        Eigen::VectorXd* new_memory) const {
  force->setZero(all.x.size());
  new_memory->resize(all.memory.size());
  ForEachBatch(
      all, [&](const ForceBatch& batch, const BatchPoint& point, int, int first_memory, bool off) {
        if (!off) batch.AddForces(point, force->data(), new_memory->data() + first_memory);
      });
}

void ClothModel::AddMass(double areal_density, BlockSparseMatrix* a) const {
  for (int i = 0; i < mesh_.num_particles(); ++i) {
    double* block = a->block(pattern_.diagonal[i]);
    for (int k = 0; k < 3; ++k) block[4 * k] += areal_density * topology_.areas[i];
  }
}

void ClothModel::StepJacobian(const ForcePoint& all, double gamma,
                              BlockSparseMatrix* jacobian) const {
  jacobian->SetZero();
  AddMass(all.parameters[kArealDensity], jacobian);
  ForEachBatch(all, [&](const ForceBatch& batch, const BatchPoint& point, int, int, bool off) {
    if (!off) batch.AddStepJacobian(point, gamma, jacobian);
  });
}

void ClothModel::AddForceDerivatives(const ForcePoint& all, const ForceDirections& directions,
                                     Lanes<kLanes>* force, Lanes<kLanes>* new_memory) const {
  new_memory->resize(all.memory.size(), kLanes);
  const auto row = [](const Lanes<kLanes>& lanes, int i) { return lanes.data() + kLanes * i; };
  ForEachBatch(all, [&](const ForceBatch& batch, const BatchPoint& point, int first_parameter,
                        int first_memory, bool off) {
    const int count = static_cast<int>(batch.info().parameters.size());
    if (off && directions.parameters.middleRows(first_parameter, count).isZero(0.0)) return;
    const BatchDirections own = {directions.x.data(),
                                 directions.v.data(),
                                 directions.a.data(),
                                 row(directions.parameters, 0),
                                 row(directions.parameters, first_parameter),
                                 row(directions.memory, first_memory),
                                 directions.inputs.size() > 0 ? directions.inputs.data() : nullptr};
    batch.AddDerivatives(point, own, force->data(), new_memory->data() + kLanes * first_memory);
  });
}

}  // namespace clothfit
