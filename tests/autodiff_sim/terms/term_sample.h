// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Samples of any force term: its elements on a small cloth in many shapes, and what acts on them,
// as one vector of numbers: x, v (3 a node each), parameters, areal density, inputs, memory, a,
// positions at the step's start, parameters of other terms.
#pragma once

#include <array>
#include <random>
#include <string>
#include <vector>

#include <ceres/jet.h>

#include "autodiff_sim/contact/contact_pair.h"
#include "autodiff_sim/contact/obstacle_contact.h"
#include "autodiff_sim/term/term.h"
#include "tests/support/scenes.h"

namespace clothfit {

// A cloth in one of several regimes, in its world.
struct TermScene {
  std::string name;
  ClothMesh mesh;
  ClothTopology topology;
  World world;
  StepInputs inputs;
  std::vector<ContactPair> contacts;       // features within 12 mm
  std::vector<ObstacleContact> obstacles;  // the same with a ball, a bar, a box and the ground
  Eigen::VectorXd x, v, a, start;
  double speed;  // m/s, typical of v; a is about as large (m/s^2)
};

// The same for every call: flat, wavy, crumpled and folded cloths; far above the ground, in touch
// with it and beneath it; slow (sticking) and fast (sliding); targets near and far.
std::vector<TermScene> MakeTermScenes();

// The same with cloth that buckles below its mesh.
std::vector<TermScene> MakeBucklingTermScenes();

// The scene turned about the origin and moved: the cloth, the inputs and gravity, not the ground.
TermScene Moved(const TermScene& scene, const Eigen::Matrix3d& rotation,
                const Eigen::Vector3d& shift);

// Takes the ground away.
void RemoveGround(TermScene* scene);

constexpr std::array<double, 2> kSampleShrinkage = {0.01, -0.02};  // along warp and weft
constexpr double kSampleTime = 0.25;                               // s

template <class Term>
struct TermLayout {
  static constexpr int kX = 0;
  static constexpr int kV = 3 * Term::kNodes;
  static constexpr int kParameter = 6 * Term::kNodes;
  static constexpr int kDensity = kParameter + static_cast<int>(Term::kParameters.size());
  static constexpr int kShrinkage = kDensity + 1;
  static constexpr int kInput = kShrinkage + 2;
  static constexpr int kMemory = kInput + Term::kInputs;
  static constexpr int kA = kMemory + Term::kMemory;
  static constexpr int kStart = kA + (Term::kUsesAcceleration ? 3 * Term::kNodes : 0);
  static constexpr int kRead = kStart + (Term::kMemory > 0 ? 3 * Term::kNodes : 0);
  static constexpr int kSize = kRead + static_cast<int>(Term::kReads.size());
  static constexpr int kForces = 3 * Term::kNodes;
  static constexpr int kOutputs = kForces + Term::kMemory;
};

template <class T>
using VectorX = Eigen::Matrix<T, Eigen::Dynamic, 1>;

inline Eigen::VectorXd Numbers(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

// What an element is given, from all its numbers.
template <class Term, class T>
ElementInput<Term, T> MakeElementInput(const VectorX<T>& numbers) {
  using Layout = TermLayout<Term>;
  ElementInput<Term, T> in;
  in.time = kSampleTime;
  in.step = 0.01;
  for (int n = 0; n < Term::kNodes; ++n) {
    for (int k = 0; k < 3; ++k) {
      in.x[n][k] = numbers[Layout::kX + 3 * n + k];
      in.v[n][k] = numbers[Layout::kV + 3 * n + k];
      if constexpr (Term::kUsesAcceleration) in.a[n][k] = numbers[Layout::kA + 3 * n + k];
      if constexpr (Term::kMemory > 0) in.start[n][k] = numbers[Layout::kStart + 3 * n + k];
    }
  }
  for (int i = 0; i < Layout::kDensity - Layout::kParameter; ++i)
    in.parameter[i] = numbers[Layout::kParameter + i];
  in.areal_density = numbers[Layout::kDensity];
  for (int i = 0; i < 2; ++i) in.shrinkage[i] = numbers[Layout::kShrinkage + i];
  for (int i = 0; i < Term::kInputs; ++i) in.input[i] = numbers[Layout::kInput + i];
  for (int i = 0; i < Layout::kSize - Layout::kRead; ++i) in.read[i] = numbers[Layout::kRead + i];
  return in;
}

// All outputs of an element, forces then memory, from all its numbers.
template <class Term, class T>
VectorX<T> EvaluateTerm(const typename Term::Element& element, const VectorX<T>& numbers) {
  using Layout = TermLayout<Term>;
  const ElementInput<Term, T> in = MakeElementInput<Term, T>(numbers);
  ElementOutput<Term, T> out;
  for (Vector3<T>& force : out.force) force = Vector3<T>(T(0.0), T(0.0), T(0.0));
  for (int i = 0; i < Term::kMemory; ++i) out.memory[i] = numbers[Layout::kMemory + i];
  Term::template AddForce<T>(element, in, &out);
  VectorX<T> result(Layout::kOutputs);
  for (int i = 0; i < Layout::kForces; ++i) result[i] = out.force[i / 3][i % 3];
  for (int i = 0; i < Term::kMemory; ++i) result[Layout::kForces + i] = out.memory[i];
  return result;
}

// Column `column` of the Jacobian of EvaluateTerm, by Jets.
template <class Term>
Eigen::VectorXd DifferentiateTerm(const typename Term::Element& element,
                                  const Eigen::VectorXd& numbers, int column) {
  using Jet = ceres::Jet<double, 1>;
  VectorX<Jet> jets(numbers.size());
  for (int i = 0; i < numbers.size(); ++i) jets[i] = Jet(numbers[i]);
  jets[column].v[0] = 1.0;
  const VectorX<Jet> result = EvaluateTerm<Term, Jet>(element, jets);
  Eigen::VectorXd derivative(result.size());
  for (int i = 0; i < result.size(); ++i) derivative[i] = result[i].v[0];
  return derivative;
}

// The initial value of any term's parameter, by its full name.
double InitialValue(const std::string& name);

// The same, but such that what a term adds to another's force is there: grips yield.
double ReadValue(const std::string& name);

// All numbers of an element in a scene, with these parameters and areal density.
template <class Term>
Eigen::VectorXd ElementNumbers(const typename Term::Element& element, const TermScene& scene,
                               const Eigen::VectorXd& parameters) {
  using Layout = TermLayout<Term>;
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(Layout::kSize);
  for (int n = 0; n < Term::kNodes; ++n) {
    numbers.segment<3>(Layout::kX + 3 * n) = scene.x.segment<3>(3 * element.nodes[n]);
    numbers.segment<3>(Layout::kV + 3 * n) = scene.v.segment<3>(3 * element.nodes[n]);
    if constexpr (Term::kUsesAcceleration)
      numbers.segment<3>(Layout::kA + 3 * n) = scene.a.segment<3>(3 * element.nodes[n]);
    if constexpr (Term::kMemory > 0)
      numbers.segment<3>(Layout::kStart + 3 * n) = scene.start.segment<3>(3 * element.nodes[n]);
  }
  numbers.segment(Layout::kParameter, parameters.size()) = parameters;
  numbers[Layout::kDensity] = 0.15;
  for (int i = 0; i < 2; ++i) numbers[Layout::kShrinkage + i] = kSampleShrinkage[i];
  if constexpr (Term::kInputs > 0) {
    for (int i = 0; i < Term::kInputs; ++i) numbers[Layout::kInput + i] = element.input[i];
  }
  for (int i = 0; i < Term::kMemory; ++i) numbers[Layout::kMemory + i] = 0.01 * (i + 1);
  for (std::size_t i = 0; i < Term::kReads.size(); ++i)
    numbers[Layout::kRead + static_cast<int>(i)] = ReadValue(Term::kReads[i]);
  return numbers;
}

template <class Term>
std::vector<typename Term::Element> SceneElements(const TermScene& scene) {
  return Term::Elements(
      {scene.mesh, scene.topology, scene.world, &scene.inputs, &scene.contacts, &scene.obstacles});
}

// A parameter at random: within its bounds, evenly for kLinear, evenly in the logarithm for kLog;
// where it is a place or a time, near the cloth or the sample's time instead.
double RandomParameter(const Parameter& parameter, const TermScene& scene, std::mt19937* random);

template <class Term>
Eigen::VectorXd RandomParameters(const TermScene& scene, std::mt19937* random) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(Term::kParameters.size()));
  for (int i = 0; i < values.size(); ++i)
    values[i] = RandomParameter(Term::kParameters[i], scene, random);
  return values;
}

// Off, but for the parameters that only shape the force, which are at random.
template <class Term>
Eigen::VectorXd OffParameters(const TermScene& scene, std::mt19937* random) {
  Eigen::VectorXd values = RandomParameters<Term>(scene, random);
  for (int i = 0; i < values.size(); ++i) {
    if (SwitchesOff(Term::kParameters[i])) values[i] = Term::kParameters[i].off;
  }
  return values;
}

}  // namespace clothfit
