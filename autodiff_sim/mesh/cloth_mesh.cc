// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Grids, validation, and the springs and hinges of a mesh.
#include "autodiff_sim/mesh/cloth_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "autodiff_sim/base/error.h"

namespace clothfit {
namespace {

using Edge = std::pair<int, int>;

// The triangles at each undirected edge: the particle opposite to it, in the triangles' order.
std::map<Edge, std::vector<int>> OppositeParticles(const ClothMesh& mesh) {
  std::map<Edge, std::vector<int>> opposite;
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      opposite[std::minmax(a, b)].push_back(t[(k + 2) % 3]);
    }
  }
  return opposite;
}

double EdgeLength(const ClothMesh& mesh, const Edge& edge) {
  return (mesh.uv[edge.second] - mesh.uv[edge.first]).norm();
}

// Of a cell of a grid.
bool IsDiagonal(const ClothMesh& mesh, const Edge& edge) {
  const int nu = mesh.grid[0];
  return edge.first / nu != edge.second / nu && edge.first % nu != edge.second % nu;
}

Hinge MakeHinge(const ClothMesh& mesh, const Edge& edge, const std::vector<int>& opposite) {
  Hinge hinge;
  hinge.width = EdgeLength(mesh, edge);
  double normals = 0.0;  // |N| is twice the triangle's area
  for (const int particle : opposite) {
    normals += 2.0 * std::abs(SignedArea(mesh, {edge.first, edge.second, particle}));
  }
  hinge.shape = hinge.width * hinge.width / normals;
  if (mesh.is_grid()) {
    constexpr double kLongest = 0.6;  // of squares: of a side 1.55 times as long as the other
    const double square = hinge.shape * hinge.shape;
    const double share = IsDiagonal(mesh, edge) ? 2.0 / (3.0 * square)
                                                : 8.0 / (9.0 - 12.0 * std::min(square, kLongest));
    hinge.shape *= share;
    hinge.width *= 0.75 * share;
  }
  // The first wing lies to the left of the edge, so that all hinges bend to the same side.
  const bool first_left = SignedArea(mesh, {edge.first, edge.second, opposite[0]}) > 0.0;
  hinge.nodes = {opposite[first_left ? 0 : 1], opposite[first_left ? 1 : 0], edge.first,
                 edge.second};
  return hinge;
}

// A grid's springs, cell by cell; a side that two cells share collects half a width from each.
void AddGridSprings(const ClothMesh& mesh, ClothTopology* topology) {
  const int nu = mesh.grid[0], nv = mesh.grid[1];
  std::map<Edge, double> width;
  for (int j = 0; j + 1 < nv; ++j) {
    for (int i = 0; i + 1 < nu; ++i) {
      const int a = i + j * nu, b = a + 1, c = a + nu, d = c + 1;
      const double hu = EdgeLength(mesh, {a, b}), hv = EdgeLength(mesh, {a, c});
      width[{a, b}] += 0.5 * hv;
      width[{c, d}] += 0.5 * hv;
      width[{a, c}] += 0.5 * hu;
      width[{b, d}] += 0.5 * hu;
      const double diagonal_weight = (hu * hu + hv * hv) / (2.0 * hu * hv);
      for (const Edge& diagonal : {Edge{a, d}, Edge{b, c}}) {
        const double length = EdgeLength(mesh, diagonal);
        topology->shear.push_back({{diagonal.first, diagonal.second}, length, diagonal_weight});
      }
    }
  }
  for (const auto& [edge, w] : width) {
    const double length = EdgeLength(mesh, edge);
    topology->structural.push_back({{edge.first, edge.second}, length, w / length});
  }
}

void AddMeshSprings(const ClothMesh& mesh, const std::map<Edge, std::vector<int>>& opposite,
                    ClothTopology* topology) {
  for (const auto& [edge, particles] : opposite) {
    const Eigen::Vector2d d = mesh.uv[edge.second] - mesh.uv[edge.first];
    double area = 0.0;
    for (const int p : particles) area += std::abs(SignedArea(mesh, {edge.first, edge.second, p}));
    const double length = d.norm(), weight = area / d.squaredNorm();
    const double sin_2a = 2.0 * d.x() * d.y() / d.squaredNorm(), sin2 = sin_2a * sin_2a;
    constexpr double kNegligible = 1e-12;
    const std::array<int, 2> nodes = {edge.first, edge.second};
    if (1.0 - sin2 > kNegligible) {
      topology->structural.push_back({nodes, length, weight * (1.0 - sin2)});
    }
    // One diagonal a cell stands for the two of a grid's, and shear strain is half felt along it.
    if (sin2 > kNegligible) topology->shear.push_back({nodes, length, 4.0 * weight * sin2});
  }
}

// m, of the lines of a grid along one side, with one through each of these places where it may.
std::vector<double> GridLines(double length, int count, std::vector<double> through) {
  constexpr double kThinnest = 0.4, kAtTheEdge = 1e-9;
  const int cells = count - 1;
  const double even = length / cells;
  std::sort(through.begin(), through.end());
  std::vector<std::pair<int, double>> fixed = {{0, 0.0}};
  for (const double place : through) {
    const bool is_inside = place > kAtTheEdge * length && place < (1.0 - kAtTheEdge) * length;
    if (!is_inside || cells < 2) continue;
    const int line = std::clamp(static_cast<int>(std::lround(place / even)), 1, cells - 1);
    const auto [before, at] = fixed.back();
    if (line > before && place - at >= kThinnest * even * (line - before) &&
        length - place >= kThinnest * even * (cells - line)) {
      fixed.push_back({line, place});
    }
  }
  fixed.push_back({cells, length});
  std::vector<double> lines;
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
    const auto [first, from] = fixed[k];
    const auto [last, to] = fixed[k + 1];
    for (int i = first; i < last; ++i)
      lines.push_back(from + (to - from) * (i - first) / (last - first));
  }
  lines.push_back(length);
  return lines;
}

// At most two triangles an edge, one on each side of it.
void ValidateEdges(const ClothMesh& mesh, const std::string& source) {
  for (const auto& [edge, particles] : OppositeParticles(mesh)) {
    const std::string name =
        "edge " + std::to_string(edge.first + 1) + "-" + std::to_string(edge.second + 1);
    if (particles.size() > 2) {
      throw InputError(source, name + " has " + std::to_string(particles.size()) +
                                   " triangles; expected at most 2");
    }
    if (particles.size() < 2) continue;
    const double first = SignedArea(mesh, {edge.first, edge.second, particles[0]});
    const double second = SignedArea(mesh, {edge.first, edge.second, particles[1]});
    if (first * second > 0.0) {
      throw InputError(source, name +
                                   " has both triangles on the same side in (u, v); expected a "
                                   "cloth that does not cover itself");
    }
  }
}

}  // namespace

double SignedArea(const ClothMesh& mesh, const std::array<int, 3>& t) {
  const Eigen::Vector2d a = mesh.uv[t[1]] - mesh.uv[t[0]];
  const Eigen::Vector2d b = mesh.uv[t[2]] - mesh.uv[t[0]];
  return 0.5 * (a.x() * b.y() - a.y() * b.x());
}

std::vector<RestTriangle> RestTriangles(const ClothMesh& mesh) {
  std::vector<RestTriangle> triangles;
  for (const std::array<int, 3>& nodes : mesh.triangles)
    triangles.push_back({nodes, std::abs(SignedArea(mesh, nodes))});
  return triangles;
}

ClothMesh MakeGrid(const Eigen::Vector2d& size, const std::array<int, 2>& resolution,
                   const std::vector<Eigen::Vector2d>& through) {
  const int nu = resolution[0], nv = resolution[1];
  if (nu < 2 || nv < 2) {
    throw InputError("cloth.resolution", "[" + std::to_string(nu) + ", " + std::to_string(nv) +
                                             "]; expected at least 2 particles along each side");
  }
  if (!size.allFinite() || size.minCoeff() <= 0.0) {
    throw InputError("cloth.size", "[" + std::to_string(size.x()) + ", " +
                                       std::to_string(size.y()) +
                                       "]; expected two lengths above zero, m");
  }
  std::vector<double> through_u, through_v;
  for (const Eigen::Vector2d& point : through) {
    through_u.push_back(point.x());
    through_v.push_back(point.y());
  }
  ClothMesh mesh;
  mesh.grid = resolution;
  const std::vector<double> u = GridLines(size.x(), nu, std::move(through_u));
  for (const double v : GridLines(size.y(), nv, std::move(through_v)))
    for (int i = 0; i < nu; ++i) mesh.uv.emplace_back(u[static_cast<std::size_t>(i)], v);
  for (int j = 0; j + 1 < nv; ++j) {
    for (int i = 0; i + 1 < nu; ++i) {
      const int a = i + j * nu, b = a + 1, c = a + nu, d = c + 1;
      if ((i + j) % 2 == 0) {
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      } else {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({b, d, c});
      }
    }
  }
  return mesh;
}

void ValidateMesh(const ClothMesh& mesh, const std::string& source) {
  if (mesh.triangles.empty()) throw InputError(source, "the mesh has no triangle");
  for (std::size_t i = 0; i < mesh.uv.size(); ++i) {
    if (!mesh.uv[i].allFinite())
      throw InputError(source, "vertex " + std::to_string(i + 1) + ": (u, v) is not finite");
  }
  std::vector<bool> used(mesh.uv.size(), false);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const std::string place = source + ": triangle " + std::to_string(k + 1);
    for (const int node : mesh.triangles[k]) {
      if (node < 0 || node >= mesh.num_particles()) {
        throw InputError(place, "vertex " + std::to_string(node + 1) + " of " +
                                    std::to_string(mesh.num_particles()) +
                                    "; expected a vertex that exists");
      }
      used[node] = true;
    }
    const double area = SignedArea(mesh, mesh.triangles[k]);
    double longest = 0.0;
    for (int i = 0; i < 3; ++i) {
      longest = std::max(longest,
                         EdgeLength(mesh, {mesh.triangles[k][i], mesh.triangles[k][(i + 1) % 3]}));
    }
    constexpr double kThinnest = 1e-6;  // area over the longest side squared
    if (std::abs(area) <= kThinnest * longest * longest) {
      throw InputError(place, "degenerate: area " + std::to_string(area) +
                                  " m^2 in (u, v); expected an area above zero");
    }
    if (area < 0.0) {
      throw InputError(place,
                       "flipped: clockwise in (u, v); expected counter-clockwise like the others");
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i])
      throw InputError(source, "vertex " + std::to_string(i + 1) + " belongs to no triangle");
  }
  ValidateEdges(mesh, source);
}

ClothTopology BuildTopology(const ClothMesh& mesh) {
  ClothTopology topology;
  const std::map<Edge, std::vector<int>> opposite = OppositeParticles(mesh);
  if (mesh.is_grid()) {
    AddGridSprings(mesh, &topology);
  } else {
    AddMeshSprings(mesh, opposite, &topology);
  }
  for (const auto& [edge, particles] : opposite) {
    topology.mean_edge += EdgeLength(mesh, edge) / static_cast<double>(opposite.size());
    if (particles.size() == 2) topology.hinges.push_back(MakeHinge(mesh, edge, particles));
  }
  for (std::vector<Spring>* springs : {&topology.structural, &topology.shear}) {
    for (Spring& spring : *springs) {
      const Eigen::Vector2d d = mesh.uv[spring.nodes[1]] - mesh.uv[spring.nodes[0]];
      spring.warp_share = d.x() * d.x() / d.squaredNorm();
      if (mesh.buckles) spring.buckling_length = spring.rest_length;
    }
  }
  topology.areas.assign(mesh.uv.size(), 0.0);
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (const int node : t) topology.areas[node] += SignedArea(mesh, t) / 3.0;
  }
  return topology;
}

}  // namespace clothfit
