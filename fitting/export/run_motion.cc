// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/run_motion.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/files/npy_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

fs::path RequireFile(const RunFolder& run, const char* name) {
  fs::path file = run.path() / name;
  if (fs::exists(file)) return file;
  throw InputError(file.string(), "is missing; expected the run of a fit or a simulation");
}

}  // namespace

RunMotion ReadRunMotion(const RunFolder& run) {
  RunMotion motion;
  motion.frames = ReadPointsNpy(RequireFile(run, "trajectory.npy"));
  const fs::path config_file = RequireFile(run, "config.yaml");
  const Recording recording = ReadRecording(ReadConfigRecording(config_file));
  FitConfig config = DefaultConfig(recording);
  ReadConfig(config_file, &config);
  config.use_silhouettes = false;  // for the mesh no mask has to be read
  motion.mesh = MakeScene(recording, config).mesh;
  motion.name = recording.name;
  motion.frame_rate = recording.frame_rate;
  const Eigen::Index particles = motion.frames.empty() ? 0 : motion.frames[0].size() / 3;
  if (particles == motion.mesh.num_particles()) return motion;
  throw InputError((run.path() / "trajectory.npy").string(),
                   fmt::format("has {} particles; expected {}: was the recording changed since?",
                               particles, motion.mesh.num_particles()));
}

Eigen::VectorXd ParticleNormals(const ClothMesh& mesh, const Eigen::VectorXd& x) {
  Eigen::VectorXd normals = Eigen::VectorXd::Zero(x.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d p = x.segment<3>(3 * a), q = x.segment<3>(3 * b), r = x.segment<3>(3 * c);
    const Eigen::Vector3d normal = (q - p).cross(r - p);
    for (const int node : {a, b, c}) normals.segment<3>(3 * node) += normal;
  }
  for (Eigen::Index i = 0; i < normals.size(); i += 3) {
    const double length = normals.segment<3>(i).norm();
    if (length > 0.0) {
      normals.segment<3>(i) /= length;
    } else {
      normals.segment<3>(i) = Eigen::Vector3d::UnitZ();  // folded flat onto itself
    }
  }
  return normals;
}

}  // namespace clothfit
