// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/run_cloth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "autodiff_sim/terms/air_drag.h"
#include "autodiff_sim/terms/bending.h"
#include "autodiff_sim/terms/gravity.h"
#include "autodiff_sim/terms/ground_contact.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "autodiff_sim/terms/shear.h"
#include "autodiff_sim/terms/spring.h"
#include "fitting/rollout/free_parameters.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

class NamedValues {
 public:
  explicit NamedValues(Eigen::VectorXd values) : values_(std::move(values)) {}
  double operator[](int index) const { return values_[index]; }
  double operator[](const std::string& name) const {
    return values_[RequireParameter(MakeParameterTable(), name)];
  }
  // All of a term, in its order.
  template <class Term>
  std::array<double, Term::kParameters.size()> Of() const {
    std::array<double, Term::kParameters.size()> values;
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = (*this)[FullName<Term>(static_cast<int>(i))];
    return values;
  }

 private:
  Eigen::VectorXd values_;
};

double MeanLength(const std::vector<Spring>& springs) {
  double sum = 0.0;
  for (const Spring& spring : springs) sum += spring.rest_length;
  return springs.empty() ? 0.0 : sum / static_cast<double>(springs.size());
}

std::vector<PinnedParticle> PinsOf(const Scene& scene, const RunMotion& motion) {
  constexpr double kLeastWeight = 1e-6;  // a particle that carries less is not held
  const int last = static_cast<int>(motion.frames.size()) - 1;
  std::vector<PinnedParticle> pins;
  for (const SceneHandle& handle : scene.handles) {
    const double released = handle.released_after * scene.recording.frame_rate;
    const int until =
        std::isinf(released) ? last : std::min(last, static_cast<int>(std::floor(released + 1e-6)));
    for (int k = 0; k < 3; ++k)
      if (std::abs(handle.on_cloth.weights[k]) > kLeastWeight)
        pins.push_back({handle.on_cloth.nodes[k], handle.name, until});
  }
  const auto by_particle = [](const auto& a, const auto& b) { return a.particle < b.particle; };
  std::sort(pins.begin(), pins.end(), by_particle);
  const auto same = [](const auto& a, const auto& b) { return a.particle == b.particle; };
  pins.erase(std::unique(pins.begin(), pins.end(), same), pins.end());
  return pins;
}

bool IsOn(const TermInfo& term, const NamedValues& values) {
  bool can_be_off = false;
  for (const Parameter& parameter : term.parameters) {
    if (!SwitchesOff(parameter)) continue;
    can_be_off = true;
    if (values[term.name + "." + parameter.name] != parameter.off) return true;
  }
  return !can_be_off;
}

// What the other program is not told.
std::vector<std::string> LeftOut(const Scene& scene, const FitConfig& config, const RunCloth& cloth,
                                 const NamedValues& values) {
  std::vector<std::string> left_out;
  std::vector<std::string> terms;
  for (const TermInfo& term : AllTerms()) {
    const bool is_looked_for = term.role == Role::kMayBeMissing || term.role == Role::kVariant ||
                               term.role == Role::kLaw || term.role == Role::kEstimate;
    if (is_looked_for && IsOn(term, values)) terms.push_back(term.name);
  }
  if (!terms.empty()) left_out.push_back("Force terms of the fit: " + JoinNames(terms) + ".");
  if (config.buckling) left_out.emplace_back("That compression is limited by buckling.");
  if (config.self_contact) left_out.emplace_back("Contact of the cloth with itself.");
  for (const ObstacleDescription& obstacle : scene.recording.obstacles)
    left_out.push_back("The obstacle " + obstacle.name + ".");
  for (const PinnedParticle& pin : cloth.pins) {
    if (pin.last_frame + 1 >= static_cast<int>(cloth.motion.frames.size())) continue;
    left_out.push_back(
        fmt::format("That the handle {} lets go after frame {}.", pin.handle, pin.last_frame));
  }
  left_out.erase(std::unique(left_out.begin(), left_out.end()), left_out.end());
  return left_out;
}

ClothMaterial MaterialOf(const RunCloth& cloth, const NamedValues& values) {
  const auto [stretch, stretch_damping] = values.Of<StretchSpring>();
  const auto [shear, shear_damping] = values.Of<Shear>();
  const auto [bending, bending_damping] = values.Of<Bending>();
  const auto [normal, saturation, tangential] = values.Of<AirDrag>();
  return {values[kArealDensity],
          stretch,
          stretch_damping,
          shear,
          shear_damping,
          bending / 4.0,  // terms/bending.h
          bending_damping / 4.0,
          normal,
          LinearDrag(cloth.motion, normal, saturation, tangential)};
}

}  // namespace

double LinearDrag(const RunMotion& motion, double normal, double saturation, double tangential) {
  double taken = 0.0, squares = 0.0;  // W and m^4/s^2, sums over frames and triangles
  for (std::size_t f = 0; f + 1 < motion.frames.size(); ++f) {
    const Eigen::VectorXd v = (motion.frames[f + 1] - motion.frames[f]) * motion.frame_rate;
    const Eigen::VectorXd x = 0.5 * (motion.frames[f + 1] + motion.frames[f]);
    for (const auto& [a, b, c] : motion.mesh.triangles) {
      const Eigen::Vector3d p = x.segment<3>(3 * a);
      const Eigen::Vector3d cross =
          (x.segment<3>(3 * b) - p).cross(Eigen::Vector3d(x.segment<3>(3 * c) - p));
      const double area = 0.5 * cross.norm();
      if (!(area > 0.0)) continue;
      const Eigen::Vector3d mean =
          (v.segment<3>(3 * a) + v.segment<3>(3 * b) + v.segment<3>(3 * c)) / 3.0;
      const double along = mean.dot(cross) / (2.0 * area), square = along * along;
      const double across = std::max(0.0, mean.squaredNorm() - square);
      taken += area * (normal * square * std::abs(along) / (1.0 + saturation * square) +
                       tangential * across);
      squares += area * mean.squaredNorm();
    }
  }
  return squares > 0.0 ? taken / squares : tangential;
}

RunCloth ReadRunCloth(const RunFolder& run) {
  RunCloth cloth;
  cloth.motion = ReadRunMotion(run);
  const Recording recording = ReadRecording(ReadConfigRecording(run.ConfigFile()));
  FitConfig config = DefaultConfig(recording);
  ReadConfig(run.ConfigFile(), &config);
  config.use_silhouettes = false;  // no mask has to be read
  const Scene scene = MakeScene(recording, config);
  const FreeParameters free(config, scene, MakeParameterTable());
  const bool is_fit = std::filesystem::exists(run.path() / "parameters.yaml");
  const Eigen::VectorXd theta = is_fit ? run.ReadParameters(free) : free.start();
  const NamedValues values(free.Values(theta));
  Eigen::VectorXd start;
  free.InitialState(theta, &start, &cloth.velocity);
  cloth.topology = BuildTopology(scene.mesh);
  cloth.spacing = MeanLength(cloth.topology.structural);
  for (const Eigen::Vector2d& uv : scene.mesh.uv)
    cloth.rest.emplace_back(uv.x() * (1.0 - values[kShrinkWarp]),
                            uv.y() * (1.0 - values[kShrinkWeft]), 0.0);
  const auto [gravity] = values.Of<Gravity>();
  cloth.gravity = gravity * recording.gravity;
  cloth.ground_height = recording.ground_height;
  const auto [ground, friction, ground_damping, distance, slip] = values.Of<GroundContact>();
  cloth.ground_friction = friction;
  cloth.ground_distance = distance;
  cloth.pins = PinsOf(scene, cloth.motion);
  cloth.material = MaterialOf(cloth, values);
  cloth.left_out = LeftOut(scene, config, cloth, values);
  return cloth;
}

}  // namespace clothfit
