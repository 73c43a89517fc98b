// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of rollouts with a term of the test's own that remembers, and of a cloth read from a
// file.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "autodiff_sim/mesh/obj_file.h"
#include "autodiff_sim/term/force_batch_impl.h"
#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/rollout.h"
#include "tests/support/scenes.h"

namespace clothfit {
namespace {

// A spring and a dashpot in a row, Maxwell: f = k (e - q), dq/dt = (e - q) / tau, e the extension
// and q what the dashpot has given; backward Euler within the step. The forces scale with the
// density, so that its derivative passes through the memory's term too.
struct MaxwellSpring : TermDefaults {
  static constexpr const char* kName = "maxwell";
  static constexpr const char* kDoc = "springs along the threads that relax";
  static constexpr const char* kReference = "Maxwell 1867";
  static constexpr int kNodes = 2;
  static constexpr int kMemory = 2;  // q (m) and the time (s) at which it was
  static constexpr bool kUsesDensity = true;
  static constexpr bool kInternal = true;
  static constexpr std::array<Parameter, 2> kParameters = {{
      {"stiffness", "N m/kg", "of the spring per areal density", 400.0, 0.0, 1.0, 1e5, Scale::kLog,
       10.0},
      {"relaxation", "s", "time constant tau", 0.1, 0.1, 1e-3, 1e3, Scale::kLog, 10.0},
  }};
  using Element = Spring;
  static std::vector<Element> Elements(const TermContext& context) {
    return context.topology.structural;
  }
  template <class T>
  static void AddForce(const Element& spring, const ElementInput<MaxwellSpring, T>& in,
                       ElementOutput<MaxwellSpring, T>* out) {
    using std::sqrt;
    const Vector3<T> dx = in.x[1] - in.x[0];
    const T length = sqrt(dx.dot(dx));
    const T extension = length - spring.rest_length;
    const T ratio = (in.time - out->memory[1]) / in.parameter[1];
    out->memory[0] = (out->memory[0] + ratio * extension) / (T(1.0) + ratio);
    out->memory[1] = T(in.time);
    const T pull =
        in.parameter[0] * in.areal_density * spring.weight * (extension - out->memory[0]) / length;
    for (int k = 0; k < 3; ++k) {
      out->force[0][k] += pull * dx[k];
      out->force[1][k] -= pull * dx[k];
    }
  }
};

using WithMaxwell = TypeList<Gravity, StretchSpring, MaxwellSpring, Bending, AirDrag>;

GradientCheckOptions VariantOptions() {
  GradientCheckOptions options;
  options.tolerance = 1e-5;
  options.first_step = 5e-3;
  options.sufficient = 0.3;
  return options;
}

Direction Initial(const std::string& name, Eigen::VectorXd Direction::*part, double typical,
                  Eigen::Index size) {
  Direction direction;
  direction.name = name;
  direction.typical = typical;
  (direction.*part).resize(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    (direction.*part)[i] = std::sin(1.7 * static_cast<double>(i * i));
  }
  return direction;
}

Rollout Maxwell(Integrator integrator) {
  const TestScene scene = SwingingCloth(5, 0.3);
  SimulationOptions options;
  options.integrator = integrator;
  options.tolerance = 1e-12;
  Rollout rollout;
  rollout.make = [scene, options]() {
    Simulation simulation =
        Simulation::WithTerms(WithMaxwell{}, scene.mesh, scene.world, scene.handles, options);
    UseSuppleCloth(&simulation);
    return simulation;
  };
  rollout.parameters = rollout.make().parameters();
  rollout.x = scene.x;
  rollout.v = Eigen::VectorXd::Zero(scene.x.size());
  const Drive drive = scene.MakeDrive();
  rollout.inputs = [drive](double time) { return drive(time, false); };
  return rollout;
}

TEST(RolloutDerivative, TermThatRemembers) {
  for (const Integrator integrator : {Integrator::kBdf2, Integrator::kBackwardEuler}) {
    Rollout rollout = Maxwell(integrator);
    rollout.AddParameters(
        {"maxwell.stiffness", "maxwell.relaxation", "cloth.areal_density", "stretch.stiffness"});
    rollout.directions.push_back(Initial("initial v", &Direction::dv, 1e-2, rollout.x.size()));
    ExpectDerivatives(rollout, VariantOptions());
  }
}

// What the dashpot does shows: the memory is carried, and by steps that were halved as well.
TEST(RolloutDerivative, MemoryMatters) {
  Rollout rollout = Maxwell(Integrator::kBdf2);
  const RolloutResult relaxing = RunRollout(rollout, Eigen::VectorXd(0), false);
  rollout.parameters[RequireParameter(rollout.make().model().parameters(), "maxwell.relaxation")] =
      1e3;
  const RolloutResult elastic = RunRollout(rollout, Eigen::VectorXd(0), false);
  ASSERT_TRUE(relaxing.converged && elastic.converged);
  EXPECT_GT((relaxing.values - elastic.values).lpNorm<Eigen::Infinity>(), 1e-2);
}

// An uneven triangle mesh of a square cloth, written as OBJ.
void WriteUnevenCloth(const std::string& path) {
  ClothMesh mesh = MakeGrid({0.3, 0.3}, {6, 6});
  std::mt19937 random(4);
  std::uniform_real_distribution<double> shift(-0.012, 0.012);
  std::ofstream file(path);
  file.precision(17);
  for (int i = 0; i < mesh.num_particles(); ++i) {
    Eigen::Vector2d uv = mesh.uv[i];
    for (int k = 0; k < 2; ++k) {
      const double s = shift(random);
      if (uv[k] > 0.01 && uv[k] < 0.29) uv[k] += s;
    }
    file << "v " << uv.x() << ' ' << uv.y() << " 0.3\nvt " << uv.x() << ' ' << uv.y() << '\n';
  }
  for (const std::array<int, 3>& t : mesh.triangles) {
    file << 'f';
    for (const int node : t) file << ' ' << node + 1 << '/' << node + 1;
    file << '\n';
  }
}

TEST(RolloutDerivative, ClothFromAFileHeldInsideTriangles) {
  const std::string path = ::testing::TempDir() + "clothfit_uneven_cloth.obj";
  WriteUnevenCloth(path);
  const ObjCloth cloth = ReadObj(path);
  std::remove(path.c_str());
  TestScene scene;
  scene.mesh = cloth.mesh;
  scene.handles = LocateOnCloth(scene.mesh, {{0.02, 0.02}, {0.27, 0.04}});
  scene.x.resize(3 * scene.mesh.num_particles());
  for (int i = 0; i < scene.mesh.num_particles(); ++i)
    scene.x.segment<3>(3 * i) = cloth.positions[i];
  const Eigen::Vector3d place0 = scene.handles[0].At(scene.x),
                        place1 = scene.handles[1].At(scene.x);
  SimulationOptions options;
  options.tolerance = 1e-12;
  Rollout rollout;
  rollout.make = [scene, options]() {
    Simulation simulation(scene.mesh, scene.world, scene.handles, options);
    UseSuppleCloth(&simulation);
    return simulation;
  };
  rollout.parameters = rollout.make().parameters();
  rollout.x = scene.x;
  rollout.v = Eigen::VectorXd::Zero(scene.x.size());
  rollout.inputs = [scene, place0, place1](double) {
    StepInputs inputs;
    inputs.handles = {{scene.handles[0], place0}, {scene.handles[1], place1}};
    return inputs;
  };
  rollout.AddParameters({"stretch.stiffness", "shear.stiffness", "bending.stiffness"});
  Direction handle;
  handle.name = "handle 1";
  handle.typical = 0.05;
  handle.inputs = [](double time, const StepInputs& inputs) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(inputs.num_rows());
    d[3] = std::sin(2.0 * time);
    d[5] = time * time;
    return d;
  };
  rollout.directions.push_back(handle);
  rollout.directions.push_back(Initial("initial x", &Direction::dx, 1e-3, rollout.x.size()));
  ExpectDerivatives(rollout, VariantOptions());
}

}  // namespace
}  // namespace clothfit
