// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/version_text.h"

#include <thread>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <ceres/version.h>
#include <fmt/format.h>
#include <nlopt.h>
#include <opencv2/core/utility.hpp>
#include <sys/utsname.h>

#include "fitting/files/version.h"

extern "C" const char* openblas_get_config(void);

namespace clothfit {
namespace {

std::string NLoptVersion() {
  int major = 0, minor = 0, bugfix = 0;
  nlopt_version(&major, &minor, &bugfix);
  return fmt::format("{}.{}.{}", major, minor, bugfix);
}

std::string Machine() {
  utsname name{};
  if (uname(&name) != 0) return "unknown";
  return fmt::format("{} {}, {}, {} threads", name.sysname, name.release, name.machine,
                     std::thread::hardware_concurrency());
}

}  // namespace

std::string VersionLine() {
  const std::string instruction_set = CLOTHFIT_INSTRUCTION_SET;
  return "clothfit " + Version() + (instruction_set.empty() ? "" : " (" + instruction_set + ")");
}

std::string VersionDetails() {
  return fmt::format(
      "{}\n"
      "compiler   {}, C++ {}\n"
      "Ceres      {}\n"
      "CLI11      {}\n"
      "Eigen      {}.{}.{}\n"
      "NLopt      {}\n"
      "OpenBLAS   {}\n"
      "OpenCV     {}\n"
      "machine    {}\n"
      "Reports of bugs: this text, the command, what it printed, and the run's log.txt and "
      "config.yaml; see docs/get-it.md.",
      VersionLine(), __VERSION__, __cplusplus, CERES_VERSION_STRING, CLI11_VERSION,
      EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, NLoptVersion(),
      openblas_get_config(), cv::getVersionString(), Machine());
}

}  // namespace clothfit
