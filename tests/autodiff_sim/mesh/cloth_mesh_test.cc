// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Grids and triangle meshes: areas, springs, hinges, and what is refused.
#include "autodiff_sim/mesh/cloth_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

// The text of the InputError that a call throws; empty where it throws none.
std::string Refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

// The same cloth without the knowledge that it is a grid.
ClothMesh AsTriangles(ClothMesh mesh) {
  mesh.grid = {0, 0};
  return mesh;
}

TEST(ClothMesh, GridCoversTheCloth) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {5, 4});
  EXPECT_EQ(mesh.num_particles(), 20);
  EXPECT_EQ(mesh.triangles.size(), 24u);
  EXPECT_EQ(mesh.uv[19], Eigen::Vector2d(0.6, 0.3));
  EXPECT_EQ(mesh.uv[7], Eigen::Vector2d(0.6 * 2 / 4, 0.3 * 1 / 3));
  EXPECT_NO_THROW(ValidateMesh(mesh, "grid"));
}

// The distance of a point (u, v) from the nearest particle, m.
double FromAParticle(const ClothMesh& mesh, const Eigen::Vector2d& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& uv : mesh.uv) least = std::min(least, (uv - point).norm());
  return least;
}

TEST(ClothMesh, GridsGoThroughPoints) {
  const Eigen::Vector2d size(0.8, 0.9);
  const std::vector<Eigen::Vector2d> held = {{0.64, 0.9}, {0.048, 0.9}, {0.31, 0.2}};
  for (int n = 9; n <= 33; ++n) {
    const ClothMesh mesh = MakeGrid(size, {n, n + 2}, held);
    ValidateMesh(mesh, "grid");
    EXPECT_EQ(mesh.num_particles(), n * (n + 2));
    EXPECT_EQ(mesh.uv.back(), size);
    const bool is_too_near = 0.048 < 0.4 * 0.8 / (n - 1);  // to the edge
    for (const Eigen::Vector2d& point : held) {
      if (is_too_near && point.x() < 0.1) continue;
      EXPECT_LT(FromAParticle(mesh, point), 1e-12) << n << ": " << point.transpose();
    }
    double area = 0.0, thinnest = 1.0;
    for (const RestTriangle& triangle : RestTriangles(mesh)) area += triangle.area;
    EXPECT_NEAR(area, size.prod(), 1e-12);
    for (int i = 0; i + 1 < n; ++i)
      thinnest = std::min(thinnest, mesh.uv[i + 1].x() - mesh.uv[i].x());
    EXPECT_GE(thinnest, 0.4 * size.x() / (n - 1) - 1e-12);
  }
}

TEST(ClothMesh, GridsStayEvenWherePointsHaveParticlesOrNoRoom) {
  const ClothMesh even = MakeGrid({0.6, 0.3}, {7, 4});
  EXPECT_EQ(MakeGrid({0.6, 0.3}, {7, 4}, {{0.0, 0.3}, {0.6, 0.0}}).uv, even.uv);  // corners
  EXPECT_EQ(MakeGrid({0.6, 0.3}, {7, 4}, {{0.03, 0.0}}).uv,
            even.uv);  // a cell of 0.3 of the others
  EXPECT_EQ(MakeGrid({0.6, 0.3}, {2, 2}, {{0.3, 0.15}}).uv, MakeGrid({0.6, 0.3}, {2, 2}).uv);
  // Two points of one line: the first has it.
  const ClothMesh one = MakeGrid({0.6, 0.3}, {4, 4}, {{0.29, 0.0}, {0.31, 0.0}});
  EXPECT_LT(FromAParticle(one, {0.29, 0.0}), 1e-12);
  EXPECT_GT(FromAParticle(one, {0.31, 0.0}), 0.01);
}

// What a grid is made of knows no even spacing: a cloth stretched by a share has the energy of an
// even one.
TEST(ClothMesh, UnevenGridsHaveTheSpringsOfEvenOnes) {
  const ClothTopology even = BuildTopology(MakeGrid({0.8, 0.8}, {9, 9}));
  const ClothTopology uneven =
      BuildTopology(MakeGrid({0.8, 0.8}, {9, 9}, {{0.26, 0.8}, {0.63, 0.55}}));
  const auto energy = [](const ClothTopology& topology, double along_warp) {
    double sum = 0.0;  // of a strain of one, over the stiffness
    for (const Spring& spring : topology.structural) {
      const double share =
          along_warp * spring.warp_share + (1.0 - along_warp) * (1.0 - spring.warp_share);
      sum += 0.5 * spring.weight * spring.rest_length * spring.rest_length * share * share;
    }
    return sum;
  };
  for (const double along_warp : {0.0, 1.0})
    EXPECT_NEAR(energy(uneven, along_warp), energy(even, along_warp), 1e-12);
  const auto sum = [](const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
  };
  EXPECT_NEAR(sum(uneven.areas), sum(even.areas), 1e-12);
}

TEST(ClothMesh, GridsNeedTwoParticlesASide) {
  EXPECT_THAT(Refusal([] {
                MakeGrid({1.0, 1.0}, {1, 5});
              }),
              ::testing::StartsWith("cloth.resolution: [1, 5]; expected"));
}

TEST(ClothMesh, GridsNeedASize) {
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, std::nan(""), infinite}) {
    EXPECT_THAT(Refusal([bad] {
                  MakeGrid({1.0, bad}, {3, 3});
                }),
                ::testing::StartsWith("cloth.size: "))
        << bad;
  }
}

TEST(ClothMesh, AreasSumToTheCloths) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {7, 4});
  for (const ClothMesh& m : {mesh, AsTriangles(mesh)}) {
    const ClothTopology topology = BuildTopology(m);
    EXPECT_NEAR(std::accumulate(topology.areas.begin(), topology.areas.end(), 0.0), 0.18, 1e-14);
    for (const double area : topology.areas) EXPECT_GT(area, 0.0);
  }
}

TEST(ClothMesh, GridSpringsHaveTheirWidths) {
  const double hu = 0.1, hv = 0.2;
  const ClothTopology topology = BuildTopology(MakeGrid({2 * hu, 2 * hv}, {3, 3}));
  ASSERT_EQ(topology.structural.size(), 12u);
  ASSERT_EQ(topology.shear.size(), 8u);
  int border = 0;
  for (const Spring& spring : topology.structural) {
    const bool along_u = spring.nodes[1] == spring.nodes[0] + 1;
    EXPECT_NEAR(spring.rest_length, along_u ? hu : hv, 1e-15);
    const double full = along_u ? hv / hu : hu / hv;
    const bool on_border = spring.weight < 0.75 * full;
    EXPECT_NEAR(spring.weight, on_border ? 0.5 * full : full, 1e-14);
    if (on_border) ++border;
  }
  EXPECT_EQ(border, 8);
  for (const Spring& spring : topology.shear) {
    EXPECT_NEAR(spring.rest_length, std::hypot(hu, hv), 1e-15);
    EXPECT_NEAR(spring.weight, (hu * hu + hv * hv) / (2.0 * hu * hv), 1e-14);
  }
}

// Energy per area of a small uniform strain (uu, vv, uv = engineering shear), with stiffness 1 N/m
// of the structural springs and `shear` of the others.
double EnergyPerArea(const ClothMesh& mesh, double uu, double vv, double uv, double shear) {
  const ClothTopology topology = BuildTopology(mesh);
  Eigen::Matrix2d stretch;
  stretch << 1.0 + uu, 0.5 * uv, 0.5 * uv, 1.0 + vv;
  double energy = 0.0;
  const auto add = [&](const std::vector<Spring>& springs, double stiffness) {
    for (const Spring& s : springs) {
      const double length = (stretch * (mesh.uv[s.nodes[1]] - mesh.uv[s.nodes[0]])).norm();
      const double extension = length - s.rest_length;
      energy += 0.5 * stiffness * s.weight * extension * extension;
    }
  };
  add(topology.structural, 1.0);
  add(topology.shear, shear);
  return energy / std::accumulate(topology.areas.begin(), topology.areas.end(), 0.0);
}

// The weights' promise: a cell stretches with the stiffness and shears with the shear modulus of
// the parameters, on any grid, and square cells' triangles do the same.
TEST(ClothMesh, StrainEnergyIsThatOfTheParametersAtAnyResolution) {
  constexpr double kStrain = 1e-5;
  const double unit = 0.5 * kStrain * kStrain;
  int count = 0;
  for (const std::array<int, 2>& n : {std::array<int, 2>{3, 3}, {5, 9}, {17, 17}}) {
    const ClothMesh grid = MakeGrid({0.4, 0.4}, n);
    std::vector<ClothMesh> meshes = {grid};
    if (n[0] == n[1]) meshes.push_back(AsTriangles(grid));
    for (const ClothMesh& mesh : meshes) {
      SCOPED_TRACE(std::to_string(n[0]) + " x " + std::to_string(n[1]));
      // Second order in the strain is 1e-5 of the energy.
      EXPECT_NEAR(EnergyPerArea(mesh, kStrain, 0.0, 0.0, 0.0), unit, 1e-4 * unit);
      EXPECT_NEAR(EnergyPerArea(mesh, 0.0, kStrain, 0.0, 0.0), unit, 1e-4 * unit);
      EXPECT_NEAR(EnergyPerArea(mesh, 0.0, 0.0, kStrain, 0.3), 0.3 * unit, 1e-4 * unit);
      ++count;
    }
  }
  EXPECT_EQ(count, 5);
}

// What cloth_mesh.h says of the shear springs of square cells: they stretch and couple as well.
TEST(ClothMesh, ShearSpringsAddToTheMembrane) {
  constexpr double kStrain = 1e-5, kShear = 0.3;
  const double unit = 0.5 * kStrain * kStrain;
  const ClothMesh mesh = MakeGrid({0.4, 0.4}, {5, 5});
  EXPECT_NEAR(EnergyPerArea(mesh, kStrain, 0.0, 0.0, kShear), (1.0 + kShear) * unit, 1e-4 * unit);
  EXPECT_NEAR(EnergyPerArea(mesh, kStrain, kStrain, 0.0, kShear), (2.0 + 4.0 * kShear) * unit,
              1e-4 * unit);
}

TEST(ClothMesh, OneHingeAnInnerEdge) {
  const ClothMesh mesh = MakeGrid({0.6, 0.3}, {5, 4});
  const ClothTopology topology = BuildTopology(mesh);
  // 3 T = 2 inner + border edges.
  EXPECT_EQ(topology.hinges.size(), (3 * 24 - 2 * (4 + 3)) / 2u);
  for (const Hinge& hinge : topology.hinges) {
    const auto side = [&](int wing) {
      const Eigen::Vector2d a = mesh.uv[hinge.nodes[2]], e = mesh.uv[hinge.nodes[3]] - a;
      const Eigen::Vector2d w = mesh.uv[hinge.nodes[wing]] - a;
      return e.x() * w.y() - e.y() * w.x();
    };
    EXPECT_GT(side(0), 0.0);  // the first wing lies to the left
    EXPECT_LT(side(1), 0.0);
    const double edge = (mesh.uv[hinge.nodes[3]] - mesh.uv[hinge.nodes[2]]).norm();
    // Cells of 0.15 m by 0.1 m.
    const double shape = edge * edge / (side(0) - side(1));
    const bool is_diagonal = edge > 0.16;
    const double share = is_diagonal ? 2.0 / (3.0 * shape * shape)
                                     : 8.0 / (9.0 - 12.0 * std::min(shape * shape, 0.6));
    EXPECT_NEAR(hinge.width, 0.75 * share * edge, 1e-15);
    EXPECT_NEAR(hinge.shape, share * shape, 1e-13);
  }
}

// Two columns: the ends of every other diagonal are neighbours in the list of particles.
TEST(ClothMesh, DiagonalsOfANarrowStripAreDiagonals) {
  const ClothTopology topology = BuildTopology(MakeGrid({0.1, 0.4}, {2, 5}));
  EXPECT_EQ(topology.hinges.size(), 7u);
  for (const Hinge& hinge : topology.hinges)  // sides and diagonals of square cells
    EXPECT_NEAR(hinge.shape, 2.0 / 3.0, 1e-12);
}

TEST(ClothMesh, SpringsKnowNotWhichWayAMeshIsListed) {
  const ClothMesh mesh = AsTriangles(MakeGrid({0.3, 0.3}, {4, 4}));
  ClothMesh turned = mesh;
  for (std::array<int, 3>& t : turned.triangles) t = {t[1], t[2], t[0]};
  std::reverse(turned.triangles.begin(), turned.triangles.end());
  const ClothTopology a = BuildTopology(mesh), b = BuildTopology(turned);
  ASSERT_EQ(a.structural.size(), b.structural.size());
  for (std::size_t i = 0; i < a.structural.size(); ++i) {
    EXPECT_EQ(a.structural[i].nodes, b.structural[i].nodes);
    EXPECT_NEAR(a.structural[i].weight, b.structural[i].weight, 1e-14);
  }
}

// Two triangles over the unit square.
ClothMesh Square() {
  ClothMesh mesh;
  mesh.uv = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::string Validation(const ClothMesh& mesh) {
  return Refusal([&mesh] { ValidateMesh(mesh, "cloth.obj"); });
}

void ExpectOneLine(const std::string& text, const std::string& start) {
  EXPECT_THAT(text, ::testing::StartsWith(start));
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
}

TEST(ClothMesh, RefusesWhatIsNoCloth) {
  EXPECT_EQ(Validation(Square()), "");

  ClothMesh flipped = Square();
  std::swap(flipped.triangles[1][0], flipped.triangles[1][1]);
  ExpectOneLine(Validation(flipped), "cloth.obj: triangle 2: flipped");

  ClothMesh degenerate = Square();
  degenerate.uv[3] = {0.5, 0.5};
  ExpectOneLine(Validation(degenerate), "cloth.obj: triangle 2: degenerate");

  ClothMesh index = Square();
  index.triangles[0][2] = 7;
  ExpectOneLine(Validation(index), "cloth.obj: triangle 1: vertex 8 of 4");
  index.triangles[0][2] = -1;
  ExpectOneLine(Validation(index), "cloth.obj: triangle 1: vertex 0 of 4");

  ClothMesh unused = Square();
  unused.uv.emplace_back(2.0, 2.0);
  ExpectOneLine(Validation(unused), "cloth.obj: vertex 5 belongs to no triangle");

  ClothMesh three = Square();
  three.uv.emplace_back(0.2, 0.9);
  three.triangles.push_back({0, 2, 4});
  ExpectOneLine(Validation(three), "cloth.obj: edge 1-3 has 3 triangles");

  ExpectOneLine(Validation(ClothMesh()), "cloth.obj: the mesh has no triangle");

  ClothMesh twice = Square();
  twice.triangles[0] = {0, 1, 1};
  ExpectOneLine(Validation(twice), "cloth.obj: triangle 1: degenerate");
}

TEST(ClothMesh, RefusesCoordinatesThatAreNoNumbers) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    ClothMesh mesh = Square();
    mesh.uv[2].x() = bad;
    ExpectOneLine(Validation(mesh), "cloth.obj: vertex 3");
  }
}

// Two triangles on the same side of their edge cover the cloth twice.
TEST(ClothMesh, RefusesTrianglesOverEachOther) {
  ClothMesh mesh = Square();
  mesh.uv[3] = {0.9, 0.2};
  mesh.triangles[1] = {0, 3, 2};
  ExpectOneLine(Validation(mesh), "cloth.obj: edge 1-3");
}

}  // namespace
}  // namespace clothfit
