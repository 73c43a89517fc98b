// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives of whole rollouts with each term of the catalogue, memory included: switched on, and
// off, where the derivatives are those of switching on.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "autodiff_sim/terms/terms.h"
#include "tests/autodiff_sim/step/rollout.h"
#include "tests/autodiff_sim/terms/catalogue_cases.h"

namespace clothfit {
namespace {

GradientCheckOptions Options() {
  GradientCheckOptions options;
  options.tolerance = 1e-5;
  options.first_step = 2e-3;
  options.sufficient = 0.3;
  return options;
}

std::vector<Parameter> ParametersOf(const std::string& term) {
  for (const TermInfo& info : AllTerms()) {
    if (info.name == term) return info.parameters;
  }
  ADD_FAILURE() << term;
  return {};
}

Rollout MakeCase(const CatalogueCase& one) {
  Rollout rollout = MakeRollout(one.on_ground ? LiftedCloth(5, 0.3) : SwingingCloth(5, 0.3),
                                Precise(Integrator::kBdf2));
  rollout.steps = 60;
  for (const auto& [name, value] : one.on) Set(one.term + "." + name, value, &rollout);
  return rollout;
}

Direction InitialVelocity(const Rollout& rollout) {
  Direction start;
  start.name = "initial v";
  start.typical = 1e-2;
  start.dv.resize(rollout.x.size());
  for (Eigen::Index i = 0; i < start.dv.size(); ++i)
    start.dv[i] = std::sin(1.7 * static_cast<double>(i * i));
  return start;
}

class Catalogue : public ::testing::TestWithParam<CatalogueCase> {};

TEST_P(Catalogue, DerivativesOfARolloutWhenOn) {
  Rollout rollout = MakeCase(GetParam());
  for (const Parameter& parameter : ParametersOf(GetParam().term))
    rollout.AddParameter(GetParam().term + "." + parameter.name);
  // Through the term: of a stiffness or a mass that its force may depend on, and of the start, of
  // which the ground leaves too little for differences.
  rollout.AddParameters({"bending.stiffness", "cloth.areal_density"});
  if (!GetParam().on_ground) rollout.directions.push_back(InitialVelocity(rollout));
  // Friction has a kink wherever an element turns around, and so have the differences.
  const bool has_kinks = GetParam().term.find("friction") != std::string::npos;
  ExpectDerivatives(rollout, Options(), has_kinks ? 1 : 0);
}

TEST_P(Catalogue, DerivativesOfARolloutWhenOff) {
  if (GetParam().term == "grip") GTEST_SKIP() << "has no other side of off, see grip_test";
  Rollout rollout = MakeCase(GetParam());
  for (const Parameter& parameter : ParametersOf(GetParam().term)) {
    if (!SwitchesOff(parameter)) continue;
    const std::string name = GetParam().term + "." + parameter.name;
    Set(name, parameter.off, &rollout);
    rollout.AddParameter(name);
  }
  ExpectDerivatives(rollout, Options());
}

INSTANTIATE_TEST_SUITE_P(Terms, Catalogue, ::testing::ValuesIn(CatalogueCases()),
                         [](const auto& test) { return test.param.term; });

TEST(CatalogueCases, AreThereForAllThatMayBeMissing) {
  for (const TermInfo& term : AllTerms()) {
    if (term.role != Role::kMayBeMissing) continue;
    const auto is_its = [&](const CatalogueCase& one) { return one.term == term.name; };
    EXPECT_EQ(std::count_if(CatalogueCases().begin(), CatalogueCases().end(), is_its), 1)
        << term.name;
  }
}

TEST(CatalogueCases, HaveEveryParameter) {
  ASSERT_FALSE(CatalogueCases().empty());
  for (const CatalogueCase& one : CatalogueCases())
    EXPECT_EQ(one.on.size(), ParametersOf(one.term).size()) << one.term;
}

}  // namespace
}  // namespace clothfit
