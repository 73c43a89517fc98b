// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Force terms that a program adds: they move the cloth as the library's own do, with derivatives
// that agree with those and with differences.
#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clothfit/clothfit.h"

namespace {

using testing::HasSubstr;

constexpr double kDensity = 0.15;  // kg/m^2
constexpr double kSide = 0.4;      // m
constexpr int kFrames = 10;

// What the term `gravity` is to a cloth of this density.
struct Weight {
  static constexpr const char* kName = "weight";
  static constexpr const char* kDoc = "gravity once more";
  static constexpr int kParticles = 1;
  static constexpr std::array<clothfit::TermParameter, 1> kParameters = {
      {{"scale", "1", "of gravity", 0.0, 0.0, -2.0, 2.0, clothfit::Scale::kLinear, 1.0}}};
  struct Element {
    std::array<int, 1> particles;
    clothfit::Vector3 force;
  };
  static std::vector<Element> Elements(const clothfit::Cloth& cloth) {
    std::vector<Element> elements;
    for (std::size_t i = 0; i < cloth.areas.size(); ++i) {
      Element element{{static_cast<int>(i)}, {}};
      for (std::size_t k = 0; k < 3; ++k)
        element.force[k] = kDensity * cloth.areas[i] * cloth.gravity[k];
      elements.push_back(element);
    }
    return elements;
  }
  template <class T>
  static void AddForce(const Element& element, const clothfit::ElementState<Weight, T>& state,
                       clothfit::ElementForce<Weight, T>* force) {
    for (std::size_t k = 0; k < 3; ++k) (*force)[0][k] += state.parameter[0] * element.force[k];
  }
};

// Damped springs between the corners of each triangle: their force is of places and velocities, not
// linear in either, and joins particles.
struct Net {
  static constexpr const char* kName = "net";
  static constexpr const char* kDoc = "damped springs";
  static constexpr int kParticles = 2;
  static constexpr std::array<clothfit::TermParameter, 2> kParameters = {
      {{"stiffness", "N/m", "of a spring", 0.0, 0.0, 0.0, 1e3, clothfit::Scale::kLinear, 1.0},
       {"damping", "1/s", "over stiffness", 0.01, 0.01, 1e-5, 1.0, clothfit::Scale::kLog, 2.0}}};
  struct Element {
    std::array<int, 2> particles;
    double length;  // m
  };
  static std::vector<Element> Elements(const clothfit::Cloth& cloth) {
    std::vector<Element> elements;
    for (const std::array<int, 3>& t : cloth.triangles) {
      const clothfit::Vector2& a = cloth.uv[static_cast<std::size_t>(t[0])];
      const clothfit::Vector2& b = cloth.uv[static_cast<std::size_t>(t[1])];
      elements.push_back({{t[0], t[1]}, std::hypot(a[0] - b[0], a[1] - b[1])});
    }
    return elements;
  }
  template <class T>
  static void AddForce(const Element& element, const clothfit::ElementState<Net, T>& state,
                       clothfit::ElementForce<Net, T>* force) {
    using std::sqrt;
    std::array<T, 3> d;
    T squared = 1e-12, rate = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      d[k] = state.x[1][k] - state.x[0][k];
      squared += d[k] * d[k];
      rate += d[k] * (state.v[1][k] - state.v[0][k]);
    }
    const T length = sqrt(squared);
    const T pull = state.parameter[0] *
                   (length - element.length + state.parameter[1] * rate / length) / length;
    for (std::size_t k = 0; k < 3; ++k) {
      (*force)[0][k] += pull * d[k];
      (*force)[1][k] -= pull * d[k];
    }
  }
};

// A cloth that falls from two corners that are held.
clothfit::Recording Falling() {
  clothfit::RecordingParts parts;
  parts.frame_count = kFrames;
  parts.size = {kSide, kSide};
  parts.resolution = {4, 4};
  parts.areal_density = kDensity;
  for (const double u : {0.0, kSide})
    parts.handles.push_back(
        {u == 0.0 ? "a" : "b", {u, 0.0}, std::vector<clothfit::Vector3>(kFrames, {u, 0.0, 0.0})});
  parts.markers = {{0, 0, {0.2, 0.2}, {0.2, 0.2, 0.0}}};
  return clothfit::Recording(parts);
}

clothfit::Config Precise(const clothfit::Recording& recording) {
  clothfit::Config config(recording);
  config.SetKey("simulation.tolerance", "1e-11");
  return config;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  EXPECT_FALSE(a.empty());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

std::vector<double> Column(const clothfit::Array& jacobian, std::size_t column) {
  std::vector<double> values;
  for (std::size_t i = column; i < jacobian.values.size(); i += jacobian.shape[3])
    values.push_back(jacobian.values[i]);
  return values;
}

class AddedTerm : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    clothfit::AddTerm<Weight>();
    clothfit::AddTerm<Net>();
    EXPECT_THROW(clothfit::AddTerm<Weight>(), clothfit::InputError);  // again
    const clothfit::TermParameter no_bounds = {
        "a", "1", "", 0.0, 0.0, 1.0, 1.0, clothfit::Scale::kLinear, 1.0};
    EXPECT_THROW(clothfit::detail::AddPlainTerm({"no_bounds", "", 1, {no_bounds}, {}, nullptr}),
                 clothfit::InputError);
  }
};

TEST_F(AddedTerm, MovesTheClothAsTheLibrarysOwn) {
  const clothfit::Recording recording = Falling();
  clothfit::Simulation simulation(recording, Precise(recording), {"gravity.scale", "weight.scale"});
  const clothfit::Motion own = simulation.Run({1.0, 0.0}, true);
  const clothfit::Motion both = simulation.Run({0.25, 0.75}, true);
  ASSERT_TRUE(own.complete && both.complete);
  EXPECT_EQ(own.jacobian.shape, (std::vector<std::size_t>{kFrames, 16, 3, 2}));
  // m: a thousandth of the mesh's edge, over the tolerance of the steps
  EXPECT_LT(LargestDifference(own.positions.values, both.positions.values), 1e-9);
  EXPECT_LT(LargestDifference(Column(both.jacobian, 0), Column(both.jacobian, 1)), 1e-8);
}

TEST_F(AddedTerm, HasExactDerivatives) {
  const clothfit::Recording recording = Falling();
  clothfit::Simulation simulation(recording, Precise(recording), {"net.stiffness", "net.damping"});
  const std::vector<double> values = {5.0, 0.02};
  const clothfit::Motion motion = simulation.Run(values, true);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double change = 1e-4 * values[i];
    std::vector<double> moved = values;
    moved[i] += change;
    std::vector<double> quotients = simulation.Run(moved).positions.values;
    moved[i] -= 2.0 * change;
    const clothfit::Motion less = simulation.Run(moved);
    double scale = 0.0;
    for (std::size_t k = 0; k < quotients.size(); ++k) {
      quotients[k] = (quotients[k] - less.positions.values[k]) / (2.0 * change);
      scale = std::max(scale, std::abs(quotients[k]));
    }
    ASSERT_GT(scale, 1e-5);
    // The quotient's own error is of the order of 1e-8 of the derivative, and of the tolerance.
    EXPECT_LT(LargestDifference(Column(motion.jacobian, i), quotients), 1e-5 * scale);
  }
}

TEST_F(AddedTerm, IsAParameterLikeAnyOther) {
  const clothfit::Recording recording = Falling();
  clothfit::Config config(recording);
  EXPECT_EQ(config.Value("net.damping"), 0.01);
  config.Set("weight.scale", 0.5);
  EXPECT_THAT(config.Yaml(), HasSubstr("weight.scale: {value: 0.5, free: false"));
  try {
    config.Set("weight.scale", 3.0);
    FAIL();
  } catch (const clothfit::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("weight.scale = 3 1: expected -2 to 2"));
  }
}

TEST_F(AddedTerm, ComesTooLateOnceTheOthersAreKnown) {
  const clothfit::Config asked(Falling());
  EXPECT_THROW(clothfit::detail::AddPlainTerm({"late", "", 1, {}, {}, nullptr}),
               clothfit::InputError);
}

}  // namespace
