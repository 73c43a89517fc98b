// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The trials' second generator: cloth of triangular finite elements that shares no code with
// autodiff_sim, so that trials measure what an error of the equations does to a diagnosis, too.
//
// Membrane: constant strain triangles, of the threads' strains e = |x_u| - 1, |x_v| - 1 and the
// cosine of their angle, linear and Kelvin-Voigt. Bending: the squared Laplacian of the positions,
// by cotangents (Bergou et al. 2006, sec. 4, lumped on the vertices, which on irregular meshes
// stays consistent where sums over hinges do not), free at the sides. Time: symplectic Euler, with
// steps a fraction of what is stable (some 1e-5 s).
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "fitting/trials/finite_elements/laws.h"
#include "fitting/trials/finite_elements/mesh.h"

namespace clothfit {

// A vertex that is held on a path.
struct FemHandle {
  int vertex = 0;
  std::function<Eigen::Vector3d(double time)> path;  // m, world
};

struct FemGround {
  double height;     // m
  double stiffness;  // Pa/m
  double distance;   // m, at which contact begins
  double friction;
  double slip_speed;  // m/s
};

class FemCloth {
 public:
  // positions: 3N, m; the cloth is at rest.
  FemCloth(FemMesh mesh, FemLaws laws, std::vector<FemHandle> handles,
           std::optional<FemGround> ground, Eigen::VectorXd positions);

  double StableStep() const { return stable_step_; }  // s
  void Step(double step);                             // s
  // Forces (3N, N) of these laws less those of others at the present state, inertia of added masses
  // included: what planted effects do.
  Eigen::VectorXd ForceBeyond(const FemLaws& others) const;
  // Of the elastic laws, J.
  double ElasticEnergy() const;
  double KineticEnergy() const;

  const FemMesh& mesh() const { return mesh_; }
  double time() const { return time_; }
  const Eigen::VectorXd& positions() const { return x_; }
  const Eigen::VectorXd& velocities() const { return v_; }
  // 3N, m/s; at rest before.
  void SetVelocities(Eigen::VectorXd velocities) { v_ = std::move(velocities); }
  // 3N, N, of everything but inertia and what holds the handles; of the present state.
  Eigen::VectorXd Forces() const { return ForcesOf(laws_); }

 private:
  struct Triangle {
    std::array<int, 3> nodes;
    std::array<double, 3> du, dv;  // 1/m: x_u = sum du_i x_i
    double area;                   // m^2
    Eigen::Vector2d uv;            // its middle
  };
  struct Tangents {  // of positions, or the rates of velocities
    Eigen::Vector3d x_u = Eigen::Vector3d::Zero(), x_v = Eigen::Vector3d::Zero();
  };
  struct Strain {
    Tangents tangents;
    double warp, weft, shear;
  };
  struct Memory {  // of a triangle
    double relaxing_warp = 0.0, relaxing_weft = 0.0, relaxing_shear = 0.0, friction = 0.0;
    double warp = 0.0, weft = 0.0, shear = 0.0;  // strains last seen
  };

  static Tangents TangentsOf(const Triangle& triangle, const Eigen::VectorXd& x);
  Strain StrainOf(const Triangle& triangle) const;
  Eigen::Vector3d AreaNormal(const Triangle& triangle) const;  // m^2, twice the area long
  Eigen::VectorXd ForcesOf(const FemLaws& laws) const;
  void AddMembranes(const FemLaws& laws, Eigen::VectorXd* force) const;
  void AddPlates(const FemLaws& laws, Eigen::VectorXd* force) const;
  void AddAir(const FemLaws& laws, Eigen::VectorXd* force) const;
  void AddOutside(const FemLaws& laws, Eigen::VectorXd* force) const;
  void AddDiagonalThread(const FemLaws& laws, Eigen::VectorXd* force) const;
  void Remember(double step);
  double LargestStableStep();
  double LargestRate(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& response) const;
  Eigen::Matrix3Xd VertexNormals() const;

  FemMesh mesh_;
  FemLaws laws_;
  std::vector<FemHandle> handles_;
  std::optional<FemGround> ground_;
  std::vector<double> areas_;
  std::vector<Triangle> triangles_;
  std::vector<FemLaplacian> laplacians_;
  std::vector<std::pair<int, std::array<double, 3>>> thread_;  // triangle, weights
  std::vector<Memory> memory_;
  Eigen::VectorXd x_, v_, a_;
  double time_ = 0.0, stable_step_ = 0.0;
};

}  // namespace clothfit
