// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/trials/finite_elements/laws.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <Eigen/Geometry>

namespace clothfit {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kGravity = 9.81;  // m/s^2

class Values {
 public:
  explicit Values(const FemParameters& values) : values_(values) {}
  double operator()(const std::string& name, double otherwise = 0.0) const {
    asked_terms_.insert(name.substr(0, name.find('.')));
    const auto value = values_.find(name);
    return value == values_.end() ? otherwise : value->second;
  }

  const std::set<std::string>& asked_terms() const { return asked_terms_; }

 private:
  const FemParameters& values_;
  mutable std::set<std::string> asked_terms_;
};

double Bell(double distance, double width) {
  return std::exp(-distance * distance / (2.0 * width * width));
}

// How near a point of the cloth is to the patch of a term.
double InPatch(const Values& p, const std::string& term, const Vector2d& uv) {
  return Bell((uv - Vector2d(p(term + ".u"), p(term + ".v"))).norm(), p(term + ".radius", 0.1));
}

// m; of a point from a term's straight line across the cloth.
double FromLine(const Values& p, const std::string& term, const Vector2d& from_middle) {
  const double angle = p(term + ".angle");
  const Vector2d across(-std::sin(angle), std::cos(angle));
  return across.dot(from_middle) - p(term + ".offset");
}

// By how much a patch and a seam make it stiffer.
double StiffAt(const Values& p, const std::string& what, const Vector2d& uv,
               const Vector2d& middle) {
  const std::string patch = "stiff_patch_" + what, seam = "stiff_seam_" + what;
  double factor = 1.0;
  if (p(patch + ".extra") != 0.0) factor += p(patch + ".extra") * InPatch(p, patch, uv);
  if (p(seam + ".extra") != 0.0) {
    factor += p(seam + ".extra") * Bell(FromLine(p, seam, uv - middle), p(seam + ".width", 0.05));
  }
  return factor;
}

// The direction of down, turned by a term's angles about x and y.
Vector3d Turned(const Values& p, const std::string& term) {
  const Vector3d turn(p(term + ".angle_1"), p(term + ".angle_2"), 0.0);
  const Vector3d down(0.0, 0.0, -1.0);
  const double angle = turn.norm();
  if (angle == 0.0) return down;
  return Eigen::AngleAxisd(angle, Vector3d(turn / angle)) * down;
}

void SetMasses(const Values& p, const FemMesh& mesh, const Vector2d& size, FemLaws* laws) {
  const double density = p("cloth.areal_density");
  const std::vector<double> areas = VertexAreas(mesh);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    laws->mass.push_back(density * areas[i]);
    double extra = 0.0;
    if (p("heavy_patch.share") != 0.0) {
      extra += p("heavy_patch.share") * density * areas[i] * InPatch(p, "heavy_patch", mesh.uv[i]);
    }
    laws->extra_mass.push_back(extra);
  }
  const auto hem = [&](const char* name, int along, double side) {
    const double mass = p(name);  // kg/m
    if (mass == 0.0) return;
    for (const std::array<int, 3>& t : mesh.triangles) {
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        const bool is_on = std::abs(mesh.uv[a][1 - along] - side) < 1e-9 &&
                           std::abs(mesh.uv[b][1 - along] - side) < 1e-9;
        if (!is_on) continue;
        const double half = 0.5 * mass * (mesh.uv[a] - mesh.uv[b]).norm();
        laws->extra_mass[a] += half;
        laws->extra_mass[b] += half;
      }
    }
  };
  hem("hem.low_v", 0, 0.0);
  hem("hem.high_v", 0, size.y());
  hem("hem.low_u", 1, 0.0);
  hem("hem.high_u", 1, size.x());
}

// Depth beyond which a soft surface answers in proportion.
double Push(double depth) {
  constexpr double kSoft = 0.005;  // m
  if (depth <= 0.0) return 0.0;
  return depth < kSoft ? 0.5 * depth * depth / kSoft : depth - 0.5 * kSoft;
}

Vector3d FromBall(const Vector3d& offset, double radius, double stiffness) {
  const double distance = offset.norm();
  if (distance == 0.0) return Vector3d::Zero();
  return stiffness * Push(radius - distance) / distance * offset;
}

Vector3d PlaceOf(const Values& p, const std::string& term, const std::string& end = "") {
  return {p(term + ".x" + end), p(term + ".y" + end), p(term + ".z" + end)};
}

std::vector<FemLaws::Air> AirLaws(const Values& p) {
  std::vector<FemLaws::Air> laws;
  const Vector3d wind = PlaceOf(p, "wind"), gust = PlaceOf(p, "gust");
  if (!wind.isZero(0.0)) {
    laws.emplace_back([wind](const Vector3d&, const Vector2d&, double) { return wind; });
  }
  if (!gust.isZero(0.0)) {
    const double onset = p("gust.onset"), duration = p("gust.duration");
    const double radius = p("gust.radius");
    const Vector2d middle(p("gust.u"), p("gust.v"));
    laws.emplace_back([=](const Vector3d&, const Vector2d& uv, double time) -> Vector3d {
      const double phase = (time - onset) / duration;
      if (phase <= 0.0 || phase >= 1.0) return Vector3d::Zero();
      return 0.5 * (1.0 - std::cos(2.0 * M_PI * phase)) * Bell((uv - middle).norm(), radius) * gust;
    });
  }
  if (p("vortex.speed") != 0.0) {
    const double core = p("vortex.core"), speed = p("vortex.speed");
    const Vector2d axis(p("vortex.x"), p("vortex.y"));
    laws.emplace_back([=](const Vector3d& place, const Vector2d&, double) -> Vector3d {
      const Vector2d r = (place.head<2>() - axis) / core;
      return speed * std::exp(0.5 * (1.0 - r.squaredNorm())) * Vector3d(-r.y(), r.x(), 0.0);
    });
  }
  return laws;
}

std::vector<FemLaws::Outside> ObstacleLaws(const Values& p) {
  std::vector<FemLaws::Outside> laws;
  if (p("obstacle_sphere.stiffness") != 0.0) {
    const Vector3d middle = PlaceOf(p, "obstacle_sphere");
    const double radius = p("obstacle_sphere.radius"), k = p("obstacle_sphere.stiffness");
    laws.emplace_back([=](const Vector3d& place, const Vector3d&) {
      return FromBall(place - middle, radius, k);
    });
  }
  if (p("obstacle_capsule.stiffness") != 0.0) {
    const Vector3d a = PlaceOf(p, "obstacle_capsule", "1");
    const Vector3d axis = PlaceOf(p, "obstacle_capsule", "2") - a;
    const double radius = p("obstacle_capsule.radius"), k = p("obstacle_capsule.stiffness");
    laws.emplace_back([=](const Vector3d& place, const Vector3d&) {
      const double along = std::clamp((place - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
      return FromBall(place - a - along * axis, radius, k);
    });
  }
  if (p("obstacle_plane.stiffness") != 0.0) {
    const Vector3d up = -Turned(p, "obstacle_plane");
    const double height = p("obstacle_plane.height"), k = p("obstacle_plane.stiffness");
    laws.emplace_back([=](const Vector3d& place, const Vector3d&) -> Vector3d {
      return k * Push(height - up.dot(place)) * up;
    });
  }
  return laws;
}

std::vector<FemLaws::Outside> OutsideLaws(const Values& p) {
  std::vector<FemLaws::Outside> laws = ObstacleLaws(p);
  if (p("attractor.stiffness") != 0.0) {
    const Vector3d middle = PlaceOf(p, "attractor");
    const double range = p("attractor.range"), k = p("attractor.stiffness");
    laws.emplace_back([=](const Vector3d& place, const Vector3d&) -> Vector3d {
      const Vector3d offset = place - middle;
      return -k * Bell(offset.norm(), range) * offset;
    });
  }
  if (p("sticky_point.pull") != 0.0) {
    const Vector3d middle = PlaceOf(p, "sticky_point");
    const double range2 = std::pow(p("sticky_point.range"), 2);
    const double pull = p("sticky_point.pull"), viscosity = p("sticky_point.viscosity");
    laws.emplace_back([=](const Vector3d& place, const Vector3d& velocity) -> Vector3d {
      const Vector3d offset = place - middle;
      const double reach = range2 + offset.squaredNorm();
      const double fading = std::pow(range2 / reach, 2);
      return -fading * (pull / std::sqrt(reach) * offset + viscosity * velocity);
    });
  }
  return laws;
}

FemLaws LawsOf(const Values& p, const FemMesh& mesh, const Vector2d& size) {
  FemLaws laws;
  laws.air = AirLaws(p);
  laws.outside = OutsideLaws(p);
  const Vector2d middle = 0.5 * size;
  const double stretch = p("stretch.stiffness"), shear = p("shear.stiffness");
  const double ratio = std::sqrt(p("stretch_orthotropy.ratio", 1.0));
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vector2d at = (mesh.uv[t[0]] + mesh.uv[t[1]] + mesh.uv[t[2]]) / 3.0;
    const double here = stretch * StiffAt(p, "stretch", at, middle);
    laws.membranes.push_back({here * ratio, here / ratio, shear});
  }
  // The fold's k_e is four times a plate's stiffness (Bridson et al. 2003).
  const double plate = 0.25 * p("bending.stiffness");
  for (const FemLaplacian& laplacian : LaplaciansOf(mesh))
    laws.plates.push_back(plate * StiffAt(p, "bending", mesh.uv[laplacian.vertex], middle));
  laws.stretch_viscosity = p("stretch.damping");
  laws.shear_viscosity = p("shear.damping");
  if (plate > 0.0) laws.bending_delay = p("bending.damping") / p("bending.stiffness");
  laws.cubic = p("stretch_stiffening.cubic");
  laws.cubic_onset = p("stretch_stiffening.onset");
  laws.stretch_share = p("stretch_relaxation.share");
  laws.stretch_time = p("stretch_relaxation.time", 1.0);
  laws.shear_share = p("shear_relaxation.share");
  laws.shear_time = p("shear_relaxation.time", 1.0);
  laws.shear_friction = p("shear_friction.stress");
  laws.shear_onset = p("shear_friction.onset", 1.0);
  laws.thread_stiffness = p("diagonal_thread.stiffness");
  laws.thread_gather = p("diagonal_thread.gather");
  laws.thread_piece = size.norm() / kThreadPieces;
  SetMasses(p, mesh, size, &laws);
  laws.added_mass = p("added_mass.normal");
  laws.gravity = kGravity * p("gravity.scale", 1.0) * Turned(p, "gravity_tilt");
  laws.drag_normal = p("air_drag.normal");
  laws.drag_saturation = p("air_drag.saturation");
  laws.drag_tangential = p("air_drag.tangential");
  return laws;
}

}  // namespace

bool FemKnows(const std::string& term) {
  static const std::set<std::string> known = [] {
    const FemParameters nothing;
    const Values values(nothing);
    const Vector2d size(1.0, 1.0);
    LawsOf(values, MakeFemMesh(size, {4, 4}, 1), size);
    return values.asked_terms();
  }();
  return known.count(term) > 0;
}

FemLaws MakeFemLaws(const FemMesh& mesh, const Vector2d& size, const FemParameters& parameters) {
  return LawsOf(Values(parameters), mesh, size);
}

FemParameters WithoutTerms(const FemParameters& parameters, const std::vector<std::string>& terms) {
  FemParameters rest;
  for (const auto& [name, value] : parameters) {
    const std::string term = name.substr(0, name.find('.'));
    if (std::find(terms.begin(), terms.end(), term) == terms.end()) rest[name] = value;
  }
  return rest;
}

}  // namespace clothfit
