// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/mesh_files.h"

#include <cstdint>

#include <fmt/format.h>

#include "tracking/text/text.h"

namespace clothfit {
namespace {

// Files are read where bytes stand in this machine's order, little-endian.
template <class T>
void Append(T value, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void AppendFloats(const Eigen::VectorXd& x, int particle, std::string* bytes) {
  for (int c = 0; c < 3; ++c) Append(static_cast<float>(x[3 * particle + c]), bytes);
}

}  // namespace

std::string FrameAsObj(const RunMotion& motion, std::size_t frame) {
  const Eigen::VectorXd& x = motion.frames[frame];
  const Eigen::VectorXd normals = ParticleNormals(motion.mesh, x);
  std::string text = fmt::format("# {}, frame {}, m; vt are (u, v), m\n", motion.name, frame);
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    text += fmt::format("v {} {} {}\n", FormatNumber(x[i]), FormatNumber(x[i + 1]),
                        FormatNumber(x[i + 2]));
  }
  for (const Eigen::Vector2d& uv : motion.mesh.uv) {
    text += fmt::format("vt {} {}\n", FormatNumber(uv.x()), FormatNumber(uv.y()));
  }
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    text += fmt::format("vn {:.6f} {:.6f} {:.6f}\n", normals[i], normals[i + 1], normals[i + 2]);
  }
  for (const auto& [a, b, c] : motion.mesh.triangles) {
    text += fmt::format("f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a + 1, b + 1, c + 1);
  }
  return text;
}

std::string FrameAsPly(const RunMotion& motion, std::size_t frame) {
  const Eigen::VectorXd& x = motion.frames[frame];
  const Eigen::VectorXd normals = ParticleNormals(motion.mesh, x);
  std::string bytes =
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment frame {}, m\nelement vertex {}\n",
                  frame, motion.mesh.num_particles());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"}) {
    bytes += fmt::format("property float {}\n", name);
  }
  bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                       motion.mesh.triangles.size());
  for (int i = 0; i < motion.mesh.num_particles(); ++i) {
    AppendFloats(x, i, &bytes);
    AppendFloats(normals, i, &bytes);
    Append(static_cast<float>(motion.mesh.uv[i].x()), &bytes);
    Append(static_cast<float>(motion.mesh.uv[i].y()), &bytes);
  }
  for (const std::array<int, 3>& triangle : motion.mesh.triangles) {
    Append<std::uint8_t>(3, &bytes);
    for (const int node : triangle) Append<std::int32_t>(node, &bytes);
  }
  return bytes;
}

std::string MotionAsCsv(const RunMotion& motion) {
  std::string text = "frame,time,particle,u,v,x,y,z\n";
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    const std::string time = FormatNumber(static_cast<double>(f) / motion.frame_rate);
    for (int i = 0; i < motion.mesh.num_particles(); ++i) {
      const Eigen::Vector3d x = motion.frames[f].segment<3>(3 * i);
      text += fmt::format("{},{},{},{},{},{},{},{}\n", f, time, i,
                          FormatNumber(motion.mesh.uv[i].x()), FormatNumber(motion.mesh.uv[i].y()),
                          FormatNumber(x.x()), FormatNumber(x.y()), FormatNumber(x.z()));
    }
  }
  return text;
}

}  // namespace clothfit
