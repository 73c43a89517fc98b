// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// own_term    adds a force term, simulates a cloth with it, and finds its amount again by a fit
#include <cmath>
#include <cstdio>

#include <clothfit/clothfit.h>

namespace {

// A fan below the cloth: a force per area upwards, which is weaker the higher the cloth is,
//   f = pressure exp(-z / reach) e_z.
struct Fan {
  static constexpr const char* kName = "fan";
  static constexpr const char* kDoc = "air from a fan in the plane z = 0";
  static constexpr int kParticles = 1;
  static constexpr std::array<clothfit::TermParameter, 2> kParameters = {{
      {"pressure", "Pa", "at z = 0", 0.0, 0.0, -100.0, 100.0, clothfit::Scale::kLinear, 1.0},
      {"reach", "m", "height at which it has fallen to 37 %", 0.5, 0.5, 0.05, 10.0,
       clothfit::Scale::kLog, 2.0},
  }};

  struct Element {
    std::array<int, kParticles> particles;
    double area;  // m^2
  };

  static std::vector<Element> Elements(const clothfit::Cloth& cloth) {
    std::vector<Element> elements;
    for (std::size_t i = 0; i < cloth.areas.size(); ++i)
      elements.push_back({{static_cast<int>(i)}, cloth.areas[i]});
    return elements;
  }

  template <class T>
  static void AddForce(const Element& element, const clothfit::ElementState<Fan, T>& state,
                       clothfit::ElementForce<Fan, T>* force) {
    using std::exp;
    const T& height = state.x[0][2];
    (*force)[0][2] += state.parameter[0] * element.area * exp(-height / state.parameter[1]);
  }
};

// A cloth of 0.4 m, held at two corners, that falls from lying flat; as yet nobody has seen it.
clothfit::RecordingParts Hanging() {
  clothfit::RecordingParts parts;
  parts.frame_rate = 30.0;
  parts.frame_count = 20;
  parts.size = {0.4, 0.4};
  parts.resolution = {5, 5};
  parts.areal_density = 0.15;
  parts.origin = {0.0, 0.0, 0.6};
  for (const double u : {0.0, 0.4})
    parts.handles.push_back(
        {u == 0.0 ? "left" : "right", {u, 0.0}, std::vector<clothfit::Vector3>(20, {u, 0.0, 0.6})});
  parts.markers = {{0, 0, {0.2, 0.2}, {0.2, 0.2, 0.6}}};
  parts.marker_sigma = 0.001;
  return parts;
}

// The same, with a marker at each particle of a simulated motion.
clothfit::Recording Observed(const clothfit::Motion& motion, const clothfit::Array& uv) {
  clothfit::RecordingParts parts = Hanging();
  parts.markers.clear();
  const double* x = motion.positions.values.data();
  for (int frame = 0; frame < parts.frame_count; ++frame) {
    for (std::size_t i = 0; i < uv.shape[0]; ++i, x += 3)
      parts.markers.push_back({frame,
                               static_cast<int>(i),
                               {uv.values[2 * i], uv.values[2 * i + 1]},
                               {x[0], x[1], x[2]}});
  }
  return clothfit::Recording(parts);
}

}  // namespace

int main() {
  constexpr double kPressure = 1.2;  // Pa; the cloth weighs 1.5 N/m^2
  try {
    clothfit::AddTerm<Fan>();
    const clothfit::Recording planned{Hanging()};
    clothfit::Simulation simulation(planned, clothfit::Config(planned), {"fan.pressure"});
    const clothfit::Recording recording = Observed(simulation.Run({kPressure}), simulation.uv());

    clothfit::Config config(recording);
    for (const clothfit::Parameter& p : config.parameters()) config.Fix(p.name);
    config.Free("fan.pressure");
    const clothfit::Run run = clothfit::Fit(recording, config);
    const double found = run.Value("fan.pressure");
    std::printf("fan.pressure: %.4f Pa, was %.4f Pa\n", found, kPressure);
    return std::abs(found - kPressure) < 0.01 ? 0 : 1;
  } catch (const clothfit::InputError& error) {
    std::fprintf(stderr, "own_term: %s\n", error.what());
    return 2;
  }
}
