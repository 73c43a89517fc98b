// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// sensitivity FOLDER    simulates the cloth of a recording and tells how far each of three
// parameters moves it, by exact derivatives and by simulating twice
#include <cmath>
#include <cstdio>

#include <clothfit/clothfit.h>

namespace {

// Root mean square of every stride-th number.
double Rms(const std::vector<double>& numbers, std::size_t first, std::size_t stride) {
  double sum = 0.0;
  for (std::size_t i = first; i < numbers.size(); i += stride) sum += numbers[i] * numbers[i];
  return std::sqrt(sum * static_cast<double>(stride) / static_cast<double>(numbers.size()));
}

// The same of the central difference quotient.
double RmsQuotient(clothfit::Simulation* simulation, std::vector<double> values, std::size_t which,
                   double change) {
  values[which] += change;
  const clothfit::Motion more = simulation->Run(values);
  values[which] -= 2.0 * change;
  const clothfit::Motion less = simulation->Run(values);
  std::vector<double> quotients;
  for (std::size_t i = 0; i < more.positions.values.size(); ++i)
    quotients.push_back((more.positions.values[i] - less.positions.values[i]) / (2.0 * change));
  return Rms(quotients, 0, 1);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "sensitivity: expected the folder of a recording\n");
    return 2;
  }
  try {
    const clothfit::Recording recording = clothfit::Recording::Read(argv[1]);
    clothfit::Config config(recording);
    config.SetKey("cloth.resolution", "[7, 7]");
    config.SetKey("simulation.tolerance", "1e-10");  // differences need it
    config.Set("wind.y", 0.5);                       // m/s
    clothfit::Simulation simulation(recording, config,
                                    {"gravity.scale", "air_drag.normal", "wind.y"}, 20);
    const std::vector<double> values = simulation.start();
    const clothfit::Motion motion = simulation.Run(values, true);
    bool agree = motion.complete;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double exact = Rms(motion.jacobian.values, i, values.size());
      const double differences = RmsQuotient(&simulation, values, i, 1e-4);
      std::printf("%-16s %.6g m a unit, by differences %.6g\n", simulation.parameters()[i].c_str(),
                  exact, differences);
      agree = agree && std::abs(exact - differences) <= 1e-4 * exact;
    }
    return agree ? 0 : 1;
  } catch (const clothfit::InputError& error) {
    std::fprintf(stderr, "sensitivity: %s\n", error.what());
    return 2;
  }
}
