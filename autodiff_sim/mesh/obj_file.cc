// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Reading OBJ: only what a cloth needs.
#include "autodiff_sim/mesh/obj_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"

namespace clothfit {
namespace {

// Of a million vertices with texture coordinates and faces, beyond what can be simulated.
constexpr std::size_t kMostObjBytes = std::size_t{1} << 28;

class ObjReader {
 public:
  explicit ObjReader(const std::string& path) : path_(path) {}

  ObjCloth Read() {
    ReadLines([this](std::istringstream* words) { ReadFace(words); });
    ValidateMesh(cloth_.mesh, path_);
    return cloth_;
  }

  ObjSurface ReadSurface() {
    ObjSurface surface;
    ReadLines([&](std::istringstream* words) { ReadPlainFace(words, &surface.triangles); });
    if (surface.triangles.empty()) throw InputError(path_, "no f; expected a surface of triangles");
    surface.positions = vertices_;
    return surface;
  }

 private:
  template <class ReadFaceLine>
  void ReadLines(const ReadFaceLine& read_face) {
    std::istringstream file(ReadInputFile(path_, kMostObjBytes));
    for (std::string line; std::getline(file, line);) {
      ++line_number_;
      std::istringstream words(line);
      std::string kind;
      if (!(words >> kind)) continue;
      if (kind == "v") vertices_.push_back(ReadNumbers<3>(&words));
      if (kind == "vt") texture_.push_back(ReadNumbers<2>(&words));
      if (kind == "f") read_face(&words);
    }
  }

  void ReadPlainFace(std::istringstream* words, std::vector<std::array<int, 3>>* triangles) const {
    std::vector<int> corners;
    for (std::string corner; *words >> corner;)
      corners.push_back(Index(corner.substr(0, corner.find('/')), vertices_.size()));
    if (corners.size() < 3) throw InputError(Place(), "a face needs at least 3 corners");
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      triangles->push_back({corners[0], corners[i], corners[i + 1]});
  }

  std::string Place() const { return path_ + ":" + std::to_string(line_number_); }

  template <int kCount>
  Eigen::Matrix<double, kCount, 1> ReadNumbers(std::istringstream* words) const {
    Eigen::Matrix<double, kCount, 1> numbers;
    for (int i = 0; i < kCount; ++i) {
      if (!(*words >> numbers[i]) || !std::isfinite(numbers[i])) {
        throw InputError(Place(), "expected " + std::to_string(kCount) + " finite numbers");
      }
    }
    return numbers;
  }

  // OBJ counts from 1, and back from the end where negative.
  int Index(const std::string& text, std::size_t count) const {
    int index = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, index);
    if (error != std::errc() || rest != end) {
      throw InputError(Place(), "'" + text + "': expected corners written v/vt");
    }
    const int found = index > 0 ? index - 1 : static_cast<int>(count) + index;
    if (index == 0 || found < 0 || found >= static_cast<int>(count)) {
      throw InputError(Place(), "index " + text + ": expected 1 to " + std::to_string(count));
    }
    return found;
  }

  int Particle(const std::string& corner) {
    const std::size_t slash = corner.find('/');
    if (slash == std::string::npos || slash + 1 >= corner.size() || corner[slash + 1] == '/') {
      throw InputError(Place(),
                       "corner '" + corner + "' has no vt; expected v/vt with vt in metres");
    }
    const int v = Index(corner.substr(0, slash), vertices_.size());
    const std::size_t second = std::min(corner.find('/', slash + 1), corner.size());
    const int vt = Index(corner.substr(slash + 1, second - slash - 1), texture_.size());
    const auto [entry, is_new] =
        particles_.emplace(std::make_pair(v, vt), cloth_.mesh.num_particles());
    if (is_new) {
      cloth_.mesh.uv.push_back(texture_[vt]);
      cloth_.positions.push_back(vertices_[v]);
    }
    return entry->second;
  }

  void ReadFace(std::istringstream* words) {
    std::vector<int> corners;
    for (std::string corner; *words >> corner;) corners.push_back(Particle(corner));
    if (corners.size() < 3) throw InputError(Place(), "a face needs at least 3 corners");
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      cloth_.mesh.triangles.push_back({corners[0], corners[i], corners[i + 1]});
    }
  }

  std::string path_;
  int line_number_ = 0;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector2d> texture_;
  std::map<std::pair<int, int>, int> particles_;
  ObjCloth cloth_;
};

}  // namespace

ObjCloth ReadObj(const std::string& path) { return ObjReader(path).Read(); }
ObjSurface ReadObjSurface(const std::string& path) { return ObjReader(path).ReadSurface(); }

}  // namespace clothfit
