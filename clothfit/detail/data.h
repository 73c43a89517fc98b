// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands behind the classes of the interface.
#pragma once

#include <filesystem>
#include <memory>

#include "clothfit/run.h"
#include "fitting/config/config.h"
#include "fitting/report/records/run_record.h"
#include "fitting/report/verdict/page_verdict.h"
#include "fitting/runs/prediction.h"
#include "tracking/files/output_folder.h"
#include "tracking/recording/recording.h"

namespace clothfit::v0 {

struct RecordingData {
  clothfit::Recording recording;
};

struct ConfigData {
  FitConfig config;
};

// A folder that is removed with the last who needs it; the path is empty where there is none.
struct PassingFolder {
  PassingFolder();
  ~PassingFolder();
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  std::filesystem::path path;
};

struct RunData {
  std::filesystem::path folder;
  RunRecord record;
  PageVerdict verdict;
  FittedRun fitted;
  Array trajectory, uv;
  std::shared_ptr<const PassingFolder> passing;  // of the folder, or null
};

inline clothfit::Existing ToInternal(Existing existing) {
  return ExistingIf(existing == Existing::kReplace, existing == Existing::kResume);
}

inline Overwrite ToOverwrite(Existing existing) {
  return OverwriteIf(existing == Existing::kReplace);
}

template <class Vector>
std::array<double, Vector::RowsAtCompileTime> ToArray(const Vector& vector) {
  std::array<double, Vector::RowsAtCompileTime> values;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = vector[static_cast<int>(i)];
  return values;
}
inline Eigen::Vector2d ToEigen(const Vector2& v) { return {v[0], v[1]}; }
inline Eigen::Vector3d ToEigen(const Vector3& v) { return {v[0], v[1], v[2]}; }

// Rows x width, of vectors of that width.
template <class Vectors>
Array ToRows(const Vectors& vectors, std::size_t width) {
  Array array;
  array.shape = {vectors.size(), width};
  array.values.reserve(vectors.size() * width);
  for (const auto& vector : vectors)
    for (std::size_t k = 0; k < width; ++k) array.values.push_back(vector[static_cast<int>(k)]);
  return array;
}

// Frames x particles x 3, of frames of 3N numbers.
Array ToFrames(const std::vector<Eigen::VectorXd>& frames, int num_particles);

}  // namespace clothfit::v0
