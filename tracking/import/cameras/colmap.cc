// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/cameras/colmap.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/input_file.h"
#include "tracking/import/cameras/colmap_text.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// Where the parameters of a camera model stand in its row; -1 where it has none such.
struct Model {
  size_t num_parameters;
  int fx, fy, cx, cy, k1, k2, p1, p2, k3;
  std::vector<size_t> zeros;  // coefficients that our lens does not have
};

const std::map<std::string, Model>& Models() {
  static const auto* const models = new std::map<std::string, Model>{
      {"SIMPLE_PINHOLE", {3, 0, 0, 1, 2, -1, -1, -1, -1, -1, {}}},
      {"PINHOLE", {4, 0, 1, 2, 3, -1, -1, -1, -1, -1, {}}},
      {"SIMPLE_RADIAL", {4, 0, 0, 1, 2, 3, -1, -1, -1, -1, {}}},
      {"RADIAL", {5, 0, 0, 1, 2, 3, 4, -1, -1, -1, {}}},
      {"OPENCV", {8, 0, 1, 2, 3, 4, 5, 6, 7, -1, {}}},
      {"FULL_OPENCV", {12, 0, 1, 2, 3, 4, 5, 6, 7, 8, {9, 10, 11}}}};
  return *models;
}

Camera ReadLens(const std::string& name, ColmapWords* words) {
  const auto model = Models().find(name);
  if (model == Models().end()) {
    std::vector<std::string> known;
    for (const auto& [one, parameters] : Models()) known.push_back(one);
    words->Fail(fmt::format("camera model '{}': {}; undistort the images with COLMAP otherwise",
                            name, "expected one of " + JoinNames(known)));
  }
  Camera camera;
  camera.width = words->Integer("WIDTH");
  camera.height = words->Integer("HEIGHT");
  std::vector<double> parameters;
  while (!words->Rest().empty()) parameters.push_back(words->Number("PARAMS"));
  const Model& places = model->second;
  if (parameters.size() != places.num_parameters) {
    words->Fail(fmt::format("PARAMS: expected {} numbers for {}, found {}", places.num_parameters,
                            name, parameters.size()));
  }
  for (const size_t place : places.zeros) {
    if (parameters[place] == 0.0) continue;
    words->Fail(fmt::format("PARAMS: expected k4 = k5 = k6 = 0, found {}", parameters[place]));
  }
  const auto at = [&](int place) {
    return place < 0 ? 0.0 : parameters[static_cast<size_t>(place)];
  };
  camera.fx = at(places.fx);
  camera.fy = at(places.fy);
  camera.cx = at(places.cx) - 0.5;  // their pixels begin half a pixel before ours
  camera.cy = at(places.cy) - 0.5;
  camera.distortion = {at(places.k1), at(places.k2), at(places.p1), at(places.p2), at(places.k3)};
  return camera;
}

std::map<int, Camera> ReadLenses(const fs::path& file) {
  const std::string text = ReadTextFile(file);
  std::map<int, Camera> lenses;
  for (const ColmapLine& line : ColmapLines(text)) {
    if (line.text.empty()) continue;
    ColmapWords words(file, line);
    const int id = words.Integer("CAMERA_ID");
    const std::string model = words.Text("MODEL");
    if (!lenses.emplace(id, ReadLens(model, &words)).second) {
      words.Fail(fmt::format("CAMERA_ID {} appears twice", id));
    }
  }
  return lenses;
}

struct Image {
  fs::path name;
  Camera camera;
};

Image ReadImage(const std::map<int, Camera>& lenses, ColmapWords* words) {
  words->Integer("IMAGE_ID");
  Eigen::Quaterniond rotation;
  rotation.w() = words->Number("QW");
  rotation.x() = words->Number("QX");
  rotation.y() = words->Number("QY");
  rotation.z() = words->Number("QZ");
  constexpr double kTolerance = 1e-3;  // of the length, which rounding changes
  if (std::abs(rotation.norm() - 1.0) > kTolerance) {
    words->Fail(fmt::format("QW QX QY QZ: expected a rotation, of length 1, found length {:.4g}",
                            rotation.norm()));
  }
  Eigen::Vector3d translation;
  translation.x() = words->Number("TX");
  translation.y() = words->Number("TY");
  translation.z() = words->Number("TZ");
  const int lens = words->Integer("CAMERA_ID");
  if (lenses.count(lens) == 0) {
    words->Fail(fmt::format("CAMERA_ID {} is not in cameras.txt", lens));
  }
  Image image{std::string(words->Rest()), lenses.at(lens)};
  if (image.name.empty()) words->Fail("NAME is missing");
  image.camera.camera_from_world_rotation = rotation.normalized().toRotationMatrix();
  image.camera.camera_from_world_translation = translation;
  return image;
}

// Every second line lists the points of the image before it, and may be empty.
std::vector<Image> ReadImages(const fs::path& file, const std::map<int, Camera>& lenses) {
  const std::string text = ReadTextFile(file);
  std::vector<Image> images;
  const std::vector<ColmapLine> lines = ColmapLines(text);
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].text.empty()) continue;
    ColmapWords words(file, lines[i]);
    images.push_back(ReadImage(lenses, &words));
    ++i;
  }
  if (images.empty()) throw InputError(file.string(), "expected images, found none");
  std::sort(images.begin(), images.end(),
            [](const Image& a, const Image& b) { return a.name < b.name; });
  return images;
}

bool GoesByFolder(const std::vector<Image>& images, ColmapNaming naming) {
  if (naming != ColmapNaming::kAutomatic) return naming == ColmapNaming::kFolder;
  std::set<fs::path> folders;
  for (const Image& image : images) folders.insert(image.name.parent_path());
  return folders.size() > 1;
}

// How far apart two poses are, for the user.
std::string Difference(const Camera& a, const Camera& b) {
  const Eigen::Matrix3d turn =
      a.camera_from_world_rotation * b.camera_from_world_rotation.transpose();
  return fmt::format("{:.2g} degrees and {:.2g} units",
                     Eigen::AngleAxisd(turn).angle() * 180.0 / M_PI,
                     (CameraCentre(a) - CameraCentre(b)).norm());
}

}  // namespace

ColmapCameras ReadColmapCameras(const fs::path& folder, ColmapNaming naming) {
  CheckInputFolder(folder);
  if (!fs::exists(folder / "cameras.txt") && fs::exists(folder / "cameras.bin")) {
    throw InputError((folder / "cameras.txt").string(),
                     "no such file; turn the binary model into text with 'colmap model_converter "
                     "--output_type TXT'");
  }
  const std::vector<Image> images =
      ReadImages(folder / "images.txt", ReadLenses(folder / "cameras.txt"));
  const bool by_folder = GoesByFolder(images, naming);
  ColmapCameras result;
  std::map<std::string, std::vector<const Image*>> named;
  for (const Image& image : images) {
    const fs::path name = by_folder ? image.name.parent_path().filename() : image.name.stem();
    named[name.string()].push_back(&image);
  }
  for (const auto& [name, group] : named) {
    if (name.empty()) {
      throw InputError((folder / "images.txt").string(),
                       fmt::format("'{}' lies in no folder that could name its camera",
                                   group.front()->name.string()));
    }
    if (!by_folder && group.size() > 1) {
      throw InputError((folder / "images.txt").string(),
                       fmt::format("'{}' and '{}' would both be camera '{}'; expected names that "
                                   "differ, or cameras by folder",
                                   group[0]->name.string(), group[1]->name.string(), name));
    }
    Camera camera = group.front()->camera;
    camera.name = name;
    result.cameras.push_back(camera);
    if (group.size() == 1) continue;
    result.notes.push_back(fmt::format(
        "{}: the pose of {}, from which that of the last of its {} images differs by {}", name,
        group.front()->name.string(), group.size(),
        Difference(group.front()->camera, group.back()->camera)));
  }
  return result;
}

}  // namespace clothfit
