// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Reference: MuJoCo, XML reference, deformable/flex, equality/connect and keyframe.
#include "fitting/export/mjcf.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "autodiff_sim/base/printable.h"
#include "fitting/export/script_text.h"
#include "fitting/files/version.h"

namespace clothfit {
namespace {

// A text within double quotes.
std::string AsXml(const std::string& text) {
  std::string safe;
  for (const char c : Printable(text, text.size() * 8 + 1)) {
    const bool is_markup = std::string("&<>\"'").find(c) != std::string::npos;
    safe += is_markup ? fmt::format("&#{};", static_cast<int>(c)) : std::string(1, c);
  }
  return safe;
}

// A comment must not hold "--".
std::string AsXmlComment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at))
    text.replace(at, 2, "- -");
  return text;
}

std::string Numbers(const Eigen::VectorXd& numbers) {
  std::string text;
  for (Eigen::Index i = 0; i < numbers.size(); ++i)
    text += fmt::format("{}{:.7g}", i == 0 ? "" : " ", numbers[i]);
  return text;
}

std::string HeadComment(const RunCloth& cloth) {
  const ClothMaterial& material = cloth.material;
  return AsXmlComment(fmt::format(
      "\n  The cloth of {}, fitted by clothfit {}. The manual derives each number.\n"
      "  Kept: mass {:.6g} kg/m^2; stretching {:.6g} N/m (young x thickness / 4); bending {:.6g} N "
      "m\n"
      "  (young x thickness^3 / 16); damping of stretching {:.6g} N s/m (damping x stretching).\n"
      "  Not kept, for a flex has no counterpart:\n"
      "  shearing is {:.6g} N/m in the fit, and half the stretching, {:.6g} N/m, here;\n"
      "  damping of shearing and bending, which follow the one damping here;\n"
      "  drag, which joints of a flex may not have: the program that steps the model adds\n"
      "  qfrc_applied = drag x area x velocity, against it. That takes as much energy over the\n"
      "  run's motion as the fit's, which is quadratic along the normal.\n"
      "  Left out:\n{}"
      "  Keys hold the run's motion. A simulation begins with key frame_0 and follows the handles\n"
      "  where a program sets mocap_pos, between the keys' mpos, at each step.\n",
      AsXml(cloth.motion.name), Version(), material.density, material.stretch, material.bending,
      material.stretch_damping, material.shear, 0.5 * material.stretch,
      AsComments(cloth.left_out, "    ")));
}

std::string GroundAsXml(const RunCloth& cloth) {
  if (!cloth.ground_height) return "";
  return fmt::format(
      "    <geom name=\"ground\" type=\"plane\" pos=\"0 0 {:.7g}\" size=\"0 0 0.05\" "
      "friction=\"{:.6g} 0.005 0.0001\"/>\n",
      *cloth.ground_height, cloth.ground_friction);
}

std::string ParticlesAsXml(const RunCloth& cloth) {
  std::string text;
  for (std::size_t i = 0; i < cloth.rest.size(); ++i) {
    const double area = cloth.topology.areas[i], mass = cloth.material.density * area;
    const double inertia = std::max(1e-12, mass * area / 6.0);  // no joint turns it
    text += fmt::format(
        "    <body name=\"p{}\" pos=\"{:.7g} {:.7g} {:.7g}\"><inertial pos=\"0 0 0\" "
        "mass=\"{:.7g}\" diaginertia=\"{:.4g} {:.4g} {:.4g}\"/>",
        i, cloth.rest[i].x(), cloth.rest[i].y(), cloth.rest[i].z(), mass, inertia, inertia,
        inertia);
    for (const char* axis : {"1 0 0", "0 1 0", "0 0 1"})
      text += fmt::format("<joint type=\"slide\" axis=\"{}\"/>", axis);
    text += "</body>\n";
  }
  return text;
}

std::string PinsAsXml(const RunCloth& cloth) {
  std::string text;
  for (std::size_t k = 0; k < cloth.pins.size(); ++k) {
    const Eigen::Vector3d place = cloth.motion.frames[0].segment<3>(3 * cloth.pins[k].particle);
    text += fmt::format(
        "    <!-- held by {} -->\n"
        "    <body name=\"handle{}\" mocap=\"true\" pos=\"{:.7g} {:.7g} {:.7g}\"/>\n",
        AsXmlComment(AsXml(cloth.pins[k].handle)), k, place.x(), place.y(), place.z());
  }
  return text;
}

// Of a grid all diagonals go one way: where a hinge is not its own mirror image, MuJoCo 3.3.8 takes
// its two particles in another order for its stiffness than for its force.
std::string ElementsAsXml(const ClothMesh& mesh) {
  std::string text;
  const auto add = [&text](int a, int b, int c) {
    text += fmt::format("{}{} {} {}", text.empty() ? "" : " ", a, b, c);
  };
  if (!mesh.is_grid()) {
    for (const auto& [a, b, c] : mesh.triangles) add(a, b, c);
    return text;
  }
  const int nu = mesh.grid[0];
  for (int j = 0; j + 1 < mesh.grid[1]; ++j) {
    for (int i = 0; i + 1 < nu; ++i) {
      const int corner = i + j * nu;
      add(corner, corner + 1, corner + nu + 1);
      add(corner, corner + nu + 1, corner + nu);
    }
  }
  return text;
}

// What MuJoCo keeps for the program that steps the model.
std::string NumericsAsXml(const RunCloth& cloth) {
  std::string areas;
  for (const double area : cloth.topology.areas)
    areas += fmt::format("{}{:.7g}", areas.empty() ? "" : " ", area);
  return fmt::format(
      "    <numeric name=\"drag\" data=\"{:.7g}\"/>\n    <numeric name=\"areas\" size=\"{}\" "
      "data=\"{}\"/>\n",
      cloth.material.drag_linear, cloth.topology.areas.size(), areas);
}

std::string FlexAsXml(const RunCloth& cloth, const FlexMaterial& flex) {
  std::string bodies;
  for (std::size_t i = 0; i < cloth.rest.size(); ++i)
    bodies += fmt::format("{}p{}", i == 0 ? "" : " ", i);
  const int collides = cloth.ground_height ? 1 : 0;
  return fmt::format(
      "    <flex name=\"cloth\" dim=\"2\" radius=\"{:.6g}\" rgba=\"0.38 0.56 0.74 1\"\n"
      "          body=\"{}\"\n          element=\"{}\">\n"
      "      <elasticity young=\"{:.7g}\" poisson=\"0\" damping=\"{:.7g}\" thickness=\"{:.7g}\" "
      "elastic2d=\"both\"/>\n"
      "      <contact selfcollide=\"none\" internal=\"false\" contype=\"{}\" conaffinity=\"{}\" "
      "friction=\"{:.6g} 0.005 0.0001\"/>\n"
      "    </flex>\n",
      0.5 * cloth.ground_distance, bodies, ElementsAsXml(cloth.motion.mesh), flex.young,
      flex.damping, flex.thickness, collides, collides, cloth.ground_friction);
}

// The constraint follows its body within a few steps.
std::string EqualityAsXml(const RunCloth& cloth, const FlexMaterial& flex) {
  std::string text;
  for (std::size_t k = 0; k < cloth.pins.size(); ++k)
    text += fmt::format(
        "    <connect body1=\"p{}\" body2=\"handle{}\" anchor=\"0 0 0\" solref=\"{:.6g} 1\" "
        "solimp=\"0.99 0.999 0.001\"/>\n",
        cloth.pins[k].particle, k, 4.0 * flex.timestep);
  return text;
}

std::string KeysAsXml(const RunCloth& cloth) {
  Eigen::VectorXd rest(3 * static_cast<Eigen::Index>(cloth.rest.size()));
  for (std::size_t i = 0; i < cloth.rest.size(); ++i)
    rest.segment<3>(3 * static_cast<Eigen::Index>(i)) = cloth.rest[i];
  std::string text;
  for (std::size_t f = 0; f < cloth.motion.frames.size(); ++f) {
    const Eigen::VectorXd& x = cloth.motion.frames[f];
    Eigen::VectorXd held(3 * static_cast<Eigen::Index>(cloth.pins.size()));
    for (std::size_t k = 0; k < cloth.pins.size(); ++k)
      held.segment<3>(3 * static_cast<Eigen::Index>(k)) = x.segment<3>(3 * cloth.pins[k].particle);
    text += fmt::format("    <key name=\"frame_{}\" time=\"{:.9g}\" qpos=\"{}\"", f,
                        static_cast<double>(f) / cloth.motion.frame_rate, Numbers(x - rest));
    if (f == 0 && cloth.velocity.squaredNorm() > 0.0)
      text += fmt::format(" qvel=\"{}\"", Numbers(cloth.velocity));
    if (held.size() > 0) text += fmt::format(" mpos=\"{}\"", Numbers(held));
    text += "/>\n";
  }
  return text;
}

}  // namespace

FlexMaterial MaterialForMujoco(const ClothMaterial& material, double spacing) {
  FlexMaterial flex;
  constexpr double kLeast = 1e-12;  // m^2: a sheet must have a thickness
  // young t / 4 = K and young t^3 / 16 = B.
  flex.thickness = 2.0 * std::sqrt(std::max(kLeast, material.bending / material.stretch));
  flex.young = 4.0 * material.stretch / flex.thickness;
  flex.damping = material.stretch_damping / material.stretch;
  // Stable where explicit: the stiffest mode of a sheet of cells turns at sqrt(8 K / (rho h^2)),
  // and is damped at 8 c / (rho h^2). Half of either limit.
  const double mass = material.density * spacing * spacing;  // kg, of a particle
  const double elastic = 2.0 / std::sqrt(8.0 * material.stretch / mass);
  const double viscous =
      material.stretch_damping > 0.0 ? 2.0 * mass / (8.0 * material.stretch_damping) : elastic;
  flex.timestep = 0.5 * std::min(elastic, viscous);
  return flex;
}

std::string ClothAsMjcf(const RunCloth& cloth) {
  const FlexMaterial flex = MaterialForMujoco(cloth.material, cloth.spacing);
  const Eigen::Vector3d& g = cloth.gravity;
  const std::string equality = EqualityAsXml(cloth, flex);
  return fmt::format("<mujoco model=\"{}\">\n  <!--{}  -->\n", AsXml(cloth.motion.name),
                     HeadComment(cloth)) +
         fmt::format("  <option timestep=\"{:.6g}\" gravity=\"{:.7g} {:.7g} {:.7g}\"/>\n",
                     flex.timestep, g.x(), g.y(), g.z()) +
         "  <custom>\n" + NumericsAsXml(cloth) + "  </custom>\n" +
         "  <worldbody>\n    <light pos=\"0 0 3\" dir=\"0 0 -1\"/>\n" + GroundAsXml(cloth) +
         ParticlesAsXml(cloth) + PinsAsXml(cloth) + "  </worldbody>\n  <deformable>\n" +
         FlexAsXml(cloth, flex) + "  </deformable>\n" +
         (equality.empty() ? "" : "  <equality>\n" + equality + "  </equality>\n") +
         "  <keyframe>\n" + KeysAsXml(cloth) + "  </keyframe>\n</mujoco>\n";
}

}  // namespace clothfit
