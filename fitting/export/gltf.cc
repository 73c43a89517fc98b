// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Reference: Khronos, glTF 2.0 specification, sections 3.6 (accessors), 3.7.2.2 (morph targets),
// 3.11 (animations) and 4.4 (GLB).
#include "fitting/export/gltf.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <nlohmann/json.hpp>

#include "fitting/files/version.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedInt = 5125;            // component types
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;  // targets of buffer views

// The one binary chunk, and what the JSON says of its parts.
struct Buffer {
  std::string bytes;
  Json views = Json::array(), accessors = Json::array();

  template <class T>
  int Add(const std::vector<T>& values, int component, const char* type, int width, int target) {
    Json view = {
        {"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", sizeof(T) * values.size()}};
    if (target != 0) view["target"] = target;
    views.push_back(view);
    accessors.push_back({{"bufferView", views.size() - 1},
                         {"componentType", component},
                         {"count", values.size() / static_cast<std::size_t>(width)},
                         {"type", type}});
    AddRange(values, width);
    bytes.append(reinterpret_cast<const char*>(values.data()), sizeof(T) * values.size());
    return static_cast<int>(accessors.size()) - 1;
  }

 private:
  template <class T>
  void AddRange(const std::vector<T>& values, int width) {
    std::vector<T> lower(values.begin(), values.begin() + width), upper = lower;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t c = i % static_cast<std::size_t>(width);
      lower[c] = std::min(lower[c], values[i]);
      upper[c] = std::max(upper[c], values[i]);
    }
    accessors.back()["min"] = lower;
    accessors.back()["max"] = upper;
  }
};

// 3N numbers with y upwards.
std::vector<float> YUp(const Eigen::VectorXd& x) {
  std::vector<float> turned;
  for (Eigen::Index i = 0; i < x.size(); i += 3) {
    turned.insert(turned.end(), {static_cast<float>(x[i]), static_cast<float>(x[i + 2]),
                                 static_cast<float>(-x[i + 1])});
  }
  return turned;
}

std::vector<float> TextureCoordinates(const ClothMesh& mesh) {
  Eigen::Vector2d size = Eigen::Vector2d::Constant(1e-9);
  for (const Eigen::Vector2d& uv : mesh.uv) size = size.cwiseMax(uv);
  std::vector<float> coordinates;
  for (const Eigen::Vector2d& uv : mesh.uv) {
    coordinates.push_back(static_cast<float>(uv.x() / size.x()));
    coordinates.push_back(static_cast<float>(1.0 - uv.y() / size.y()));  // v runs down in glTF
  }
  return coordinates;
}

int AddIndices(const ClothMesh& mesh, Buffer* buffer) {
  std::vector<std::uint32_t> indices;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int node : triangle) indices.push_back(static_cast<std::uint32_t>(node));
  }
  return buffer->Add(indices, kUnsignedInt, "SCALAR", 1, kElementBuffer);
}

// Offsets from frame 0 to each later frame.
Json AddTargets(const RunMotion& motion, Buffer* buffer) {
  const Eigen::VectorXd normals = ParticleNormals(motion.mesh, motion.frames[0]);
  Json targets = Json::array();
  for (std::size_t f = 1; f < motion.frames.size(); ++f) {
    const Eigen::VectorXd turned = ParticleNormals(motion.mesh, motion.frames[f]) - normals;
    const int place =
        buffer->Add(YUp(motion.frames[f] - motion.frames[0]), kFloat, "VEC3", 3, kArrayBuffer);
    const int normal = buffer->Add(YUp(turned), kFloat, "VEC3", 3, kArrayBuffer);
    targets.push_back({{"POSITION", place}, {"NORMAL", normal}});
  }
  return targets;
}

// At the time of frame f the weight of target f - 1 is 1, all others 0; linear between.
Json AddAnimation(const RunMotion& motion, Buffer* buffer) {
  const std::size_t frames = motion.frames.size();
  std::vector<float> times, weights(frames * (frames - 1), 0.0F);
  for (std::size_t f = 0; f < frames; ++f) {
    times.push_back(static_cast<float>(static_cast<double>(f) / motion.frame_rate));
    if (f > 0) weights[f * (frames - 1) + f - 1] = 1.0F;
  }
  const int input = buffer->Add(times, kFloat, "SCALAR", 1, 0);
  const int output = buffer->Add(weights, kFloat, "SCALAR", 1, 0);
  const Json sampler = {{"input", input}, {"interpolation", "LINEAR"}, {"output", output}};
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  return {{"name", "motion"},
          {"samplers", Json::array({sampler})},
          {"channels", Json::array({channel})}};
}

// One primitive, with a target a frame after the first.
Json AddMesh(const RunMotion& motion, Buffer* buffer) {
  const Eigen::VectorXd& first = motion.frames.at(0);
  const Eigen::VectorXd normals = ParticleNormals(motion.mesh, first);
  Json primitive;
  primitive["attributes"] = {{"POSITION", buffer->Add(YUp(first), kFloat, "VEC3", 3, kArrayBuffer)},
                             {"NORMAL", buffer->Add(YUp(normals), kFloat, "VEC3", 3, kArrayBuffer)},
                             {"TEXCOORD_0", buffer->Add(TextureCoordinates(motion.mesh), kFloat,
                                                        "VEC2", 2, kArrayBuffer)}};
  primitive["indices"] = AddIndices(motion.mesh, buffer);
  primitive["material"] = 0;
  const std::size_t targets = motion.frames.size() - 1;
  if (targets > 0) primitive["targets"] = AddTargets(motion, buffer);
  Json mesh = {{"name", motion.name}, {"primitives", Json::array({primitive})}};
  if (targets > 0) mesh["weights"] = std::vector<double>(targets, 0.0);
  return mesh;
}

Json Material() {
  return {{"name", "cloth"},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {0.38, 0.56, 0.74, 1.0}},
            {"metallicFactor", 0.0},
            {"roughnessFactor", 0.85}}}};
}

void AppendWord(std::size_t value, std::string* bytes) {
  const auto word = static_cast<std::uint32_t>(value);
  bytes->append(reinterpret_cast<const char*>(&word), sizeof(word));
}

std::string Glb(std::string json, std::string binary) {
  json.append((4 - json.size() % 4) % 4, ' ');
  binary.append((4 - binary.size() % 4) % 4, '\0');
  constexpr std::size_t kHeaders = 12 + 8 + 8;
  std::string bytes = "glTF";
  AppendWord(2, &bytes);
  AppendWord(kHeaders + json.size() + binary.size(), &bytes);
  AppendWord(json.size(), &bytes);
  bytes += "JSON" + json;
  AppendWord(binary.size(), &bytes);
  bytes += std::string("BIN\0", 4) + binary;
  return bytes;
}

}  // namespace

std::string MotionAsGlb(const RunMotion& motion) {
  Buffer buffer;
  const Json mesh = AddMesh(motion, &buffer);
  const Json scene = {{"nodes", Json::array({0})}};
  const Json node = {{"name", motion.name}, {"mesh", 0}};
  Json gltf;
  gltf["asset"] = {{"version", "2.0"}, {"generator", "clothfit " + Version()}};
  gltf["scene"] = 0;
  gltf["scenes"] = Json::array({scene});
  gltf["nodes"] = Json::array({node});
  gltf["meshes"] = Json::array({mesh});
  gltf["materials"] = Json::array({Material()});
  if (motion.frames.size() > 1) {
    gltf["animations"] = Json::array({AddAnimation(motion, &buffer)});
  }
  gltf["accessors"] = buffer.accessors;
  gltf["bufferViews"] = buffer.views;
  const Json only = {{"byteLength", buffer.bytes.size()}};
  gltf["buffers"] = Json::array({only});
  return Glb(gltf.dump(), buffer.bytes);
}

}  // namespace clothfit
