// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/usd.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clothfit {
namespace {

// "(1, 2, 3), (4, 5, 6)", of 3N numbers; USD keeps floats.
std::string Tuples(const Eigen::VectorXd& x) {
  std::string text;
  for (Eigen::Index i = 0; i < x.size(); i += 3)
    text += fmt::format("{}({:.7g}, {:.7g}, {:.7g})", i == 0 ? "" : ", ", x[i], x[i + 1], x[i + 2]);
  return text;
}

// A sample a frame of what `of` makes of its positions.
template <class Of>
std::string UsdSamples(const RunMotion& motion, const Of& of) {
  std::string text = "{\n";
  for (std::size_t f = 0; f < motion.frames.size(); ++f)
    text += fmt::format("            {}: [{}],\n", f, Tuples(of(motion.frames[f])));
  return text + "        }\n";
}

std::string UsdTopology(const ClothMesh& mesh) {
  const std::vector<int> counts(mesh.triangles.size(), 3);
  std::vector<int> corners;
  for (const std::array<int, 3>& t : mesh.triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  return fmt::format(
      "        int[] faceVertexCounts = [{}]\n"
      "        int[] faceVertexIndices = [{}]\n",
      fmt::join(counts, ", "), fmt::join(corners, ", "));
}

std::string UsdTextureCoordinates(const ClothMesh& mesh) {
  std::string text;
  for (const Eigen::Vector2d& uv : mesh.uv)
    text += fmt::format("{}({:.7g}, {:.7g})", text.empty() ? "" : ", ", uv.x(), uv.y());
  return fmt::format("        texCoord2f[] primvars:st = [{}] (interpolation = \"vertex\")\n",
                     text);
}

}  // namespace

std::string MotionAsUsda(const RunMotion& motion) {
  const std::size_t last = motion.frames.empty() ? 0 : motion.frames.size() - 1;
  return fmt::format(
             "#usda 1.0\n"
             "(\n"
             "    defaultPrim = \"Cloth\"\n"
             "    metersPerUnit = 1\n"
             "    upAxis = \"Z\"\n"
             "    startTimeCode = 0\n"
             "    endTimeCode = {}\n"
             "    timeCodesPerSecond = {}\n"
             "    framesPerSecond = {}\n"
             ")\n\n"
             "def Xform \"Cloth\"\n"
             "{{\n"
             "    def Mesh \"Mesh\"\n"
             "    {{\n"
             "        uniform bool doubleSided = 1\n"
             "        uniform token subdivisionScheme = \"none\"\n",
             last, motion.frame_rate, motion.frame_rate) +
         UsdTopology(motion.mesh) + UsdTextureCoordinates(motion.mesh) +
         "        point3f[] points.timeSamples = " +
         UsdSamples(motion, [](const Eigen::VectorXd& x) { return x; }) +
         "        normal3f[] normals.timeSamples = " +
         UsdSamples(motion,
                    [&](const Eigen::VectorXd& x) { return ParticleNormals(motion.mesh, x); }) +
         "    }\n}\n";
}

}  // namespace clothfit
