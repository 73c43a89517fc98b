// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/export/export.h"

#include <fmt/format.h>

#include "fitting/export/blender.h"
#include "fitting/export/gltf.h"
#include "fitting/export/mesh_files.h"
#include "fitting/export/mjcf.h"
#include "fitting/export/newton.h"
#include "fitting/export/point_cache.h"
#include "fitting/export/usd.h"
#include "fitting/files/npy_file.h"
#include "tracking/files/output_folder.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// A cloth to be simulated there, rather than the motion.
bool IsOfCloth(const std::string& format) {
  return format == "mjcf" || format == "newton" || format == "blender";
}

std::string ClothAsFile(const RunCloth& cloth, const std::string& format) {
  if (format == "mjcf") return ClothAsMjcf(cloth);
  return format == "newton" ? ClothAsNewtonScript(cloth) : ClothAsBlenderScript(cloth);
}

std::string AsOneFile(const RunMotion& motion, const std::string& format) {
  if (format == "gltf") return MotionAsGlb(motion);
  if (format == "usda") return MotionAsUsda(motion);
  if (format == "pc2") return MotionAsPc2(motion);
  if (format == "mdd") return MotionAsMdd(motion);
  if (format == "csv") return MotionAsCsv(motion);
  return PointsAsNpy(motion.frames);
}

void WriteSequence(const RunMotion& motion, const std::string& format, const fs::path& folder,
                   Overwrite overwrite) {
  OutputFolder output(folder, FolderKind::kExport, "export", ExistingIf(overwrite));
  std::vector<std::string> names;
  for (std::size_t f = 0; f < motion.frames.size(); ++f)
    names.push_back(fmt::format("{:06d}.{}", f, format));
  output.Begin(names);
  for (std::size_t f = 0; f < motion.frames.size(); ++f)
    WriteWholeFile(folder / names[f],
                   format == "obj" ? FrameAsObj(motion, f) : FrameAsPly(motion, f));
}

}  // namespace

const std::vector<ExportFormat>& ExportFormats() {
  static const std::vector<ExportFormat> kFormats = {
      {"gltf", ".glb", false, "binary glTF 2.0, animated, a morph target a frame; m, y is up"},
      {"usda", ".usda", false, "Universal Scene Description as text, animated; m, z is up"},
      {"pc2", ".pc2", false, "point cache (float32, m) for the run's mesh.obj"},
      {"mdd", ".mdd", false, "point cache of LightWave (big-endian, with times) for mesh.obj"},
      {"obj", ".obj", true, "Wavefront OBJ with normals and (u, v), m; a file a frame"},
      {"ply", ".ply", true, "binary PLY with normals and (u, v), m; a file a frame"},
      {"csv", ".csv", false, "table: frame, time (s), particle, u, v, x, y, z (m)"},
      {"npy", ".npy", false, "NumPy array, float64, frames x particles x 3, m"},
      {"video", ".mp4", false, "pictures of a camera with the simulated outline"},
      {"mjcf", ".xml", false, "the cloth as a flex of MuJoCo, to be simulated there"},
      {"newton", ".py", false, "the cloth as a script for Newton and Warp"},
      {"blender", ".py", false, "the cloth as a script for Blender, with its cloth modifier"}};
  return kFormats;
}

int ExportRun(const RunFolder& run, const std::string& format, const OverlayOptions& overlay,
              const fs::path& output, Overwrite overwrite) {
  const bool is_sequence = format == "obj" || format == "ply";
  if (!is_sequence) CheckMayWrite(output, overwrite);
  if (IsOfCloth(format)) {
    const RunCloth cloth = ReadRunCloth(run);
    WriteOutputFile(output, ClothAsFile(cloth, format), overwrite);
    return static_cast<int>(cloth.motion.frames.size());
  }
  const RunMotion motion = ReadRunMotion(run);
  if (is_sequence) {
    WriteSequence(motion, format, output, overwrite);
  } else if (format == "video") {
    WriteOverlayVideo(run, motion, overlay, output, overwrite);
  } else {
    WriteOutputFile(output, AsOneFile(motion, format), overwrite);
  }
  return static_cast<int>(motion.frames.size());
}

}  // namespace clothfit
