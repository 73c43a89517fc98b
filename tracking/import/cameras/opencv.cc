// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/cameras/opencv.h"

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "autodiff_sim/base/error.h"
#include "tracking/import/cameras/storage_file.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

using RowMajorMatrix3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

// One value of the file, with the key that it was found under.
struct Value {
  std::string place;  // "FILE: key"
  std::vector<double> numbers;

  [[noreturn]] void Fail(const std::string& expected) const {
    throw InputError(place,
                     fmt::format("expected {}, found [{}]", expected, fmt::join(numbers, ", ")));
  }
};

class Calibration {
 public:
  explicit Calibration(const fs::path& file)
      : file_(file.string()), documents_(ReadStorageFile(file)) {}

  // Under the first of these keys that is there.
  std::optional<Value> Find(const std::vector<std::string>& keys) const {
    for (const std::string& key : keys) {
      for (const YAML::Node& document : documents_) {
        const YAML::Node node = document[key];
        const std::string place = file_ + ": " + key;
        if (node.IsDefined()) return Value{place, StorageNumbers(node, place)};
      }
    }
    return std::nullopt;
  }

  Value Require(const std::vector<std::string>& keys) const {
    std::optional<Value> value = Find(keys);
    if (value) return *value;
    throw InputError(file_, fmt::format("key '{}' is missing; expected one of {}", keys.front(),
                                        JoinNames(keys)));
  }

 private:
  std::string file_;
  std::vector<YAML::Node> documents_;
};

void ReadLens(const Calibration& calibration, Camera* camera) {
  const Value matrix =
      calibration.Require({"camera_matrix", "cameraMatrix", "CameraMatrix", "K", "M"});
  const std::vector<double>& k = matrix.numbers;
  if (k.size() != 9 || k[1] != 0.0 || k[3] != 0.0 || k[6] != 0.0 || k[7] != 0.0 || k[8] != 1.0) {
    matrix.Fail("the 3 x 3 numbers fx, 0, cx, 0, fy, cy, 0, 0, 1");
  }
  camera->fx = k[0];
  camera->cx = k[2];
  camera->fy = k[4];
  camera->cy = k[5];
  const std::optional<Value> lens = calibration.Find(
      {"distortion_coefficients", "dist_coeffs", "distCoeffs", "distCoeff", "DistCoeffs", "D"});
  if (!lens) return;
  for (size_t i = 0; i < lens->numbers.size(); ++i) {
    if (i < camera->distortion.size()) {
      camera->distortion.at(i) = lens->numbers[i];
    } else if (lens->numbers[i] != 0.0) {
      lens->Fail("k1, k2, p1, p2, k3 and zeros beyond; calibrate without CALIB_RATIONAL_MODEL");
    }
  }
}

void ReadSize(const Calibration& calibration, const OpencvOptions& options, Camera* camera) {
  std::vector<double> size;
  std::string place = "--image-size";
  if (options.image_size) {
    size = {double(options.image_size->x()), double(options.image_size->y())};
  } else if (const auto list = calibration.Find({"imageSize", "image_size", "ImageSize"})) {
    size = list->numbers;
    place = list->place;
  } else {
    const Value width = calibration.Require({"image_width", "image_Width", "imageWidth", "width"});
    const Value height =
        calibration.Require({"image_height", "image_Height", "imageHeight", "height"});
    size = width.numbers;
    size.insert(size.end(), height.numbers.begin(), height.numbers.end());
    place = width.place;
  }
  constexpr double kMostPixels = 1e6;
  for (const double side : size) {
    if (size.size() == 2 && side >= 1.0 && side <= kMostPixels && side == std::floor(side))
      continue;
    Value{place, size}.Fail("width and height in px");
  }
  if (size.size() != 2) Value{place, size}.Fail("width and height in px");
  camera->width = static_cast<int>(size[0]);
  camera->height = static_cast<int>(size[1]);
}

Eigen::Matrix3d RotationIn(const Value& value) {
  constexpr double kTolerance = 1e-3;
  if (value.numbers.size() == 3) {  // axis times angle
    const Eigen::Vector3d vector(value.numbers.data());
    const double angle = vector.norm();
    if (angle == 0.0) return Eigen::Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
  }
  if (value.numbers.size() != 9) value.Fail("3 x 3 numbers, or a rotation vector of 3");
  const Eigen::Matrix3d matrix = RowMajorMatrix3(value.numbers.data());
  const Eigen::Matrix3d deviation = matrix * matrix.transpose() - Eigen::Matrix3d::Identity();
  if (deviation.cwiseAbs().maxCoeff() > kTolerance || matrix.determinant() < 0.0) {
    value.Fail("a rotation");
  }
  return Eigen::Quaterniond(matrix).normalized().toRotationMatrix();  // rid of rounding
}

void ReadPose(const Calibration& calibration, const OpencvOptions& options, Camera* camera) {
  const Eigen::Matrix3d rotation = RotationIn(
      calibration.Require({"R", "rvec", "rotation_matrix", "rotation_vector", "rotation"}));
  const Value value = calibration.Require({"T", "t", "tvec", "translation_vector", "translation"});
  if (value.numbers.size() != 3) value.Fail("3 numbers");
  const Eigen::Vector3d translation(value.numbers.data());
  camera->camera_from_world_rotation = rotation;
  camera->camera_from_world_translation = translation;
  if (options.camera_to_world) {
    camera->camera_from_world_rotation = rotation.transpose();
    camera->camera_from_world_translation = -(rotation.transpose() * translation);
  }
}

}  // namespace

Camera ReadOpencvCamera(const fs::path& file, const OpencvOptions& options) {
  const Calibration calibration(file);
  Camera camera;
  camera.name = file.stem().string();
  ReadLens(calibration, &camera);
  ReadSize(calibration, options, &camera);
  ReadPose(calibration, options, &camera);
  return camera;
}

}  // namespace clothfit
