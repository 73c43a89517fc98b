// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "autodiff_sim/scenes/cloth_scene.h"

#include <algorithm>
#include <cmath>

#include "autodiff_sim/terms/air_drag.h"
#include "autodiff_sim/terms/bending.h"
#include "autodiff_sim/terms/gravity.h"
#include "autodiff_sim/terms/ground_contact.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "autodiff_sim/terms/shear.h"
#include "autodiff_sim/terms/spring.h"

namespace clothfit {

Drive ClothScene::MakeDrive() const {
  return [points = handles, path = path](double time, bool) {
    StepInputs inputs;
    if (points.empty()) return inputs;
    const std::vector<Eigen::Vector3d> places = path(time);
    for (std::size_t i = 0; i < points.size(); ++i)
      inputs.handles.push_back({points[i], places[i]});
    return inputs;
  };
}

Drive FreeDrive() {
  return [](double, bool) { return StepInputs(); };
}

void UseSuppleCloth(Simulation* simulation) {
  const auto values = ValuesOf<Gravity, StretchSpring, Shear, Bending, AirDrag, GroundContact>(
      {1.0}, {200.0, 0.2}, {20.0, 0.1}, {1e-4, 1e-5}, {1.0, 0.0, 0.02},
      {1e5, 0.4, 0.0, 0.002, 0.005});
  Eigen::VectorXd parameters = simulation->parameters();
  parameters[kArealDensity] = 0.15;
  for (const auto& [name, value] : values) {
    const int index = FindParameter(simulation->model().parameters(), name);
    if (index >= 0) parameters[index] = value;
  }
  simulation->SetParameters(parameters);
}

Eigen::VectorXd LayFlat(const std::vector<Eigen::Vector2d>& uv, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& along, const Eigen::Vector3d& across) {
  Eigen::VectorXd x(3 * static_cast<Eigen::Index>(uv.size()));
  for (std::size_t i = 0; i < uv.size(); ++i) {
    x.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        origin + uv[i].x() * along + uv[i].y() * across;
  }
  return x;
}

Eigen::VectorXd LayFlat(const ClothMesh& mesh, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& along, const Eigen::Vector3d& across) {
  return LayFlat(mesh.uv, origin, along, across);
}

ClothScene LiftedCloth(int n, double side) {
  ClothScene scene;
  scene.mesh = MakeGrid({side, side}, {n, n});
  scene.world.ground_height = 0.0;
  const Eigen::Vector3d origin(0.0, 0.0, 0.0017);  // where the ground about bears the weight
  scene.x = LayFlat(scene.mesh, origin, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY());
  scene.handles = LocateOnCloth(scene.mesh, {{0.0, 0.0}});
  scene.path = [origin, side](double time) {
    const double s = 0.5 * (1.0 - std::cos(M_PI * std::min(time, 1.0)));  // 0 to 1 in one second
    const Eigen::Vector3d lifted(0.4 * side, 0.4 * side, 0.5 * side);
    return std::vector<Eigen::Vector3d>{origin + s * lifted};
  };
  return scene;
}

}  // namespace clothfit
