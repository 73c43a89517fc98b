// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/simulation.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "clothfit/detail/boundary.h"
#include "clothfit/detail/data.h"
#include "fitting/rollout/window_simulator.h"
#include "fitting/runs/fit_run.h"

namespace clothfit::v0 {
namespace {

// Of a config, these parameters alone are free, and each is moved by adding: so the free vector
// has their values in their units.
FitConfig WithFree(FitConfig config, const std::vector<std::string>& parameters) {
  config.use_silhouettes = false;  // nothing is compared with them here
  config.initial_order = -1;
  for (auto& [name, setting] : config.parameters) setting.free = false;
  for (const std::string& name : parameters) {
    RequireParameter(MakeParameterTable(), name);
    ParameterSetting& setting = config.parameters.at(name);
    if (setting.free) throw InputError("parameters: '" + name + "' appears twice");
    setting.free = true;
    setting.scale = clothfit::Scale::kLinear;
  }
  config.Check("config");
  return config;
}

Scene SceneOf(const clothfit::Recording& recording, const FitConfig& config) {
  Scene scene = MakeScene(recording, config);
  CheckSimulable(scene);
  CheckContact(scene, config);
  return scene;
}

int EntryOf(const FreeParameters& free, const std::string& name) {
  const auto found = std::find_if(free.entries().begin(), free.entries().end(),
                                  [&](const FreeEntry& entry) { return entry.name == name; });
  return static_cast<int>(found - free.entries().begin());
}

}  // namespace

struct SimulationData {
  SimulationData(const clothfit::Recording& recording, const FitConfig& given,
                 std::vector<std::string> parameter_names, int frames)
      : names(std::move(parameter_names)),
        config(WithFree(given, names)),
        scene(SceneOf(recording, config)),
        free(config, scene, MakeParameterTable()),
        simulator(scene, config, free, false, &stop),
        frame_count(frames > 0 ? frames : recording.frame_count),
        uv(ToRows(scene.mesh.uv, 2)) {
    for (const std::string& name : names) entries.push_back(EntryOf(free, name));
    std::vector<int> held;  // of handles' paths
    for (int i = 0; i < free.size(); ++i)
      if (free.entries()[static_cast<std::size_t>(i)].kind == FreeEntry::Kind::kHandle)
        held.push_back(i);
    simulator.Hold(held);
  }

  Eigen::VectorXd ThetaOf(const std::vector<double>& values) const {
    if (values.size() != names.size())
      throw InputError(fmt::format("values: expected {}, one a parameter, found {}", names.size(),
                                   values.size()));
    Eigen::VectorXd theta = free.start();
    FitConfig checked = config;
    for (std::size_t i = 0; i < names.size(); ++i) {
      SetParameter("values", fmt::format("{}={:.17g}", names[i], values[i]), &checked);
      theta[entries[i]] = values[i];
    }
    return theta;
  }

  // Appends 3N x values of one frame.
  void AddJacobian(const Sensitivity& sensitivity, std::vector<double>* values) const {
    const Eigen::MatrixXd dx = sensitivity.x();
    for (Eigen::Index row = 0; row < dx.rows(); ++row)
      for (const int entry : entries) values->push_back(dx(row, entry));
  }

  std::vector<std::string> names;
  FitConfig config;
  Scene scene;
  FreeParameters free;
  std::atomic<bool> stop{false};
  WindowSimulator simulator;
  int frame_count;
  Array uv;
  std::vector<int> entries;  // of the free vector, one a parameter
};

Simulation::Simulation(const Recording& recording, const Config& config,
                       const std::vector<std::string>& parameters, int frame_count)
    : data_(AtBoundary([&] {
        return std::make_unique<SimulationData>(recording.data().recording, config.data().config,
                                                parameters, frame_count);
      })) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

const std::vector<std::string>& Simulation::parameters() const { return data_->names; }
int Simulation::frame_count() const { return data_->frame_count; }
int Simulation::num_particles() const { return data_->scene.mesh.num_particles(); }
const Array& Simulation::uv() const { return data_->uv; }
const std::vector<std::array<int, 3>>& Simulation::triangles() const {
  return data_->scene.mesh.triangles;
}

std::vector<double> Simulation::start() const {
  std::vector<double> values;
  for (const int entry : data_->entries) values.push_back(data_->free.start()[entry]);
  return values;
}

Motion Simulation::Run(const std::vector<double>& values, bool with_jacobian,
                       const std::atomic<bool>* stop) {
  return AtBoundary([&] {
    const Eigen::VectorXd theta = data_->ThetaOf(values);
    Motion motion;
    std::size_t frames = 0;
    const auto observe = [&](int, const State& state, const Sensitivity* sensitivity) {
      ++frames;
      motion.positions.values.insert(motion.positions.values.end(), state.x.data(),
                                     state.x.data() + state.x.size());
      if (sensitivity != nullptr) data_->AddJacobian(*sensitivity, &motion.jacobian.values);
      data_->stop = stop != nullptr && *stop;
    };
    data_->stop = false;
    WindowSimulator& simulator = data_->simulator;
    motion.complete = simulator.Run(simulator.FirstStart(theta), theta, data_->frame_count - 1,
                                    with_jacobian, observe) == WindowSimulator::Outcome::kComplete;
    const auto particles = static_cast<std::size_t>(num_particles());
    motion.positions.shape = {frames, particles, 3};
    if (with_jacobian) motion.jacobian.shape = {frames, particles, 3, values.size()};
    return motion;
  });
}

}  // namespace clothfit::v0
