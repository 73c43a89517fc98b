// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/camera/camera_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "autodiff_sim/base/names.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

using RowMajorMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

void ReadIntrinsics(const YamlValue& value, Camera* camera) {
  const std::vector<double> k = value.Numbers(9);
  // Skew is refused rather than dropped: OpenCV's model has none.
  if (k[1] != 0.0 || k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0) {
    value.Fail(
        fmt::format("expected [fx, 0, cx, 0, fy, cy, 0, 0, 1], found [{}]", fmt::join(k, ", ")));
  }
  camera->fx = k[0];
  camera->cx = k[2];
  camera->fy = k[4];
  camera->cy = k[5];
}

Camera ReadCamera(const YamlValue& value) {
  value.AllowKeys({"name", "size", "K", "distortion", "R", "t"});
  Camera camera;
  camera.name = value.Require("name").Text();
  const Eigen::Vector2i size = value.Require("size").IntegerPair();
  camera.width = size.x();
  camera.height = size.y();
  ReadIntrinsics(value.Require("K"), &camera);
  if (const std::optional<YamlValue> distortion = value.Find("distortion")) {
    const std::vector<double> coefficients = distortion->Numbers(camera.distortion.size());
    std::copy(coefficients.begin(), coefficients.end(), camera.distortion.begin());
  }
  camera.camera_from_world_rotation = RowMajorMatrix3(value.Require("R").Numbers(9).data());
  camera.camera_from_world_translation = value.Require("t").Vector3();
  return camera;
}

}  // namespace

std::vector<Camera> ReadCameras(const std::filesystem::path& file) {
  const YamlValue top = YamlValue::Load(file);
  top.AllowKeys({"cameras"});
  std::vector<Camera> cameras;
  for (const YamlValue& value : top.Require("cameras").Items()) {
    cameras.push_back(ReadCamera(value));
  }
  return cameras;
}

std::string CamerasAsYaml(const std::vector<Camera>& cameras) {
  std::string text = "cameras:\n";
  for (const Camera& camera : cameras) {
    const RowMajorMatrix3 rotation = camera.camera_from_world_rotation;
    const Eigen::Vector3d& translation = camera.camera_from_world_translation;
    text += fmt::format("  - name: {}\n", YamlText(camera.name));
    text += fmt::format("    size: [{}, {}]\n", camera.width, camera.height);
    text += fmt::format("    K: [{}, 0, {}, 0, {}, {}, 0, 0, 1]\n", camera.fx, camera.cx, camera.fy,
                        camera.cy);
    if (camera.distortion != std::array<double, 5>{}) {
      text += fmt::format("    distortion: [{}]\n", fmt::join(camera.distortion, ", "));
    }
    text += fmt::format("    R: [{}]\n",
                        fmt::join(rotation.data(), rotation.data() + rotation.size(), ", "));
    text +=
        fmt::format("    t: [{}]\n", fmt::join(translation.data(), translation.data() + 3, ", "));
  }
  return text;
}

std::string IsNoCamera(const std::string& name, const std::vector<Camera>& cameras) {
  return Quoted(name) + " is no camera of cameras.yaml; " + Suggestion(name, NamesOf(cameras));
}

}  // namespace clothfit
