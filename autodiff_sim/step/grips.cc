// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/step/grips.h"

#include <algorithm>

#include "autodiff_sim/terms/grip.h"

namespace clothfit {
namespace {

constexpr int kSlipParameters = static_cast<int>(GripSlip::kParameters.size());
constexpr int kSlipAmounts = 3;  // x, y and z come first

std::vector<HeldElement> Held(const ClothModel& model, const StepInputs& inputs) {
  return HeldElements({model.mesh(), model.topology(), model.world(), &inputs});
}

void MakeRoom(Eigen::Index num_directions, StepInputs* inputs) {
  if (inputs->directions.cols() == 0)
    inputs->directions.setZero(inputs->num_rows(), num_directions);
}

}  // namespace

Grips::Grips(const ClothModel& model)
    : compliance_(FindParameter(model.parameters(), FullName<Grip>())),
      slip_(FindParameter(model.parameters(), FullName<GripSlip>())) {}

bool Grips::AreRigid(const Eigen::VectorXd& parameters) const {
  return compliance_ < 0 || parameters[compliance_] < kRigidCompliance;
}

void Grips::ApplySlip(const ClothModel& model, const Eigen::VectorXd& parameters, double time,
                      const Eigen::MatrixXd* parameter_directions, StepInputs* inputs) const {
  if (slip_ < 0 || inputs->handles.empty()) return;
  const auto own = parameters.segment<kSlipParameters>(slip_);
  const bool moves = parameter_directions != nullptr &&
                     !parameter_directions->middleRows<kSlipParameters>(slip_).isZero(0.0);
  if (own.head<kSlipAmounts>().isZero(0.0) && !moves) return;
  using Jet = ceres::Jet<double, kSlipParameters>;
  std::array<Jet, kSlipParameters> p;
  for (int i = 0; i < kSlipParameters; ++i) p[i] = Jet(own[i], i);
  const std::vector<HeldElement> elements = Held(model, *inputs);
  if (moves) MakeRoom(parameter_directions->cols(), inputs);
  for (std::size_t h = 0; h < elements.size(); ++h) {
    const Vector3<Jet> slip = GripSlip::Displacement<Jet>(elements[h].uv, time, p);
    for (int k = 0; k < 3; ++k) {
      inputs->handles[h].position[k] += slip[k].a;
      if (!moves) continue;
      inputs->directions.row(elements[h].first_input + k) +=
          slip[k].v.transpose() * parameter_directions->middleRows<kSlipParameters>(slip_);
    }
  }
}

void Grips::Yield(const Eigen::VectorXd& handle_forces, const Eigen::MatrixXd& parameter_directions,
                  StepInputs* inputs) const {
  if (compliance_ < 0 || parameter_directions.row(compliance_).isZero(0.0)) return;
  MakeRoom(parameter_directions.cols(), inputs);
  Eigen::Index row = 0;
  for (const HandleTarget& handle : inputs->handles) {
    const SurfacePoint& point = handle.on_cloth;
    const auto largest = std::max_element(point.weights.begin(), point.weights.end());
    const int node = point.nodes[static_cast<std::size_t>(largest - point.weights.begin())];
    const Eigen::Vector3d force = handle_forces.segment<3>(3 * node) / *largest;
    inputs->directions.middleRows<3>(row) -= force * parameter_directions.row(compliance_);
    row += 3;
  }
}

Eigen::VectorXd Grips::Forces(const ClothModel& model, const Eigen::VectorXd& parameters,
                              double time, const StepInputs& inputs,
                              const Eigen::VectorXd& x) const {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(x.size());
  std::array<double, kSlipParameters> p = {};
  for (int i = 0; slip_ >= 0 && i < kSlipParameters; ++i) p[i] = parameters[slip_ + i];
  for (const HeldElement& held : Held(model, inputs)) {
    Eigen::Vector3d offset = Eigen::Map<const Eigen::Vector3d>(held.input.data());
    if (slip_ >= 0) offset += GripSlip::Displacement<double>(held.uv, time, p);
    for (std::size_t i = 0; i < 3; ++i) offset -= held.weights[i] * x.segment<3>(3 * held.nodes[i]);
    for (std::size_t i = 0; i < 3; ++i)
      forces.segment<3>(3 * held.nodes[i]) += held.weights[i] / parameters[compliance_] * offset;
  }
  return forces;
}

}  // namespace clothfit
