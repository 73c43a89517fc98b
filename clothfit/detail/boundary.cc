// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/detail/boundary.h"

#include <algorithm>
#include <mutex>

#include <opencv2/core/utility.hpp>

#include "fitting/files/version.h"

extern "C" void openblas_set_num_threads(int num_threads);
extern "C" int openblas_get_num_threads(void);

namespace clothfit::v0 {
namespace {

struct ThreadSettings {
  std::mutex mutex;
  int inside = 0;
  int of_blas = 1, of_opencv = 1;  // as they were before anyone was inside
};

ThreadSettings& TheSettings() {
  static ThreadSettings settings;
  return settings;
}

}  // namespace

OneThread::OneThread() {
  ThreadSettings& settings = TheSettings();
  const std::lock_guard<std::mutex> lock(settings.mutex);
  if (settings.inside++ > 0) return;
  settings.of_blas = openblas_get_num_threads();
  settings.of_opencv = cv::getNumThreads();
  openblas_set_num_threads(1);
  cv::setNumThreads(1);
}

OneThread::~OneThread() {
  ThreadSettings& settings = TheSettings();
  const std::lock_guard<std::mutex> lock(settings.mutex);
  if (--settings.inside > 0) return;
  openblas_set_num_threads(settings.of_blas);
  cv::setNumThreads(settings.of_opencv);
}

std::string WithoutOptions(const std::string& line) {
  return line.substr(0, std::min(line.find("; --"), line.find(", --")));
}

InputError::InputError(const std::string& line) : std::runtime_error(line) {}
InputError::~InputError() = default;

std::string Version() { return clothfit::Version(); }

}  // namespace clothfit::v0
