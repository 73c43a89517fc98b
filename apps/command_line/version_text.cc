// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line/version_text.h"

#include <thread>
#include <utility>
#include <vector>

#include <CGAL/version.h>
#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <ceres/version.h>
#include <cholmod.h>
#if __has_include(<embree4/rtcore_config.h>)
#include <embree4/rtcore_config.h>
#else
#include <embree3/rtcore_config.h>
#endif
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <nlopt.h>
#include <opencv2/core/utility.hpp>
#include <sys/utsname.h>
#include <zlib.h>

#include "fitting/files/version.h"

extern "C" const char* openblas_get_config(void);

namespace clothfit {
namespace {

// "3.4.0"
std::string Dotted(int major, int minor, int patch) {
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::string NLoptVersion() {
  int major = 0, minor = 0, patch = 0;
  nlopt_version(&major, &minor, &patch);
  return Dotted(major, minor, patch);
}

std::string Compiler() {
#ifdef __clang__
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

std::string InstructionSet() {
  const std::string set = CLOTHFIT_INSTRUCTION_SET;
  return set.empty() ? "the compiler's own" : set;
}

// By name, all that the program is linked with or made of.
std::vector<std::pair<const char*, std::string>> Libraries() {
  return {{"CGAL", CGAL_VERSION_STR},
          {"Ceres", CERES_VERSION_STRING},
          {"CHOLMOD", Dotted(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION) +
                          " of SuiteSparse " +
                          Dotted(SUITESPARSE_MAIN_VERSION, SUITESPARSE_SUB_VERSION,
                                 SUITESPARSE_SUBSUB_VERSION)},
          {"CLI11", CLI11_VERSION},
          {"Eigen", Dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"Embree", RTC_VERSION_STRING},
          {"fmt", Dotted(FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
          {"nlohmann-json", Dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                   NLOHMANN_JSON_VERSION_PATCH)},
          {"NLopt", NLoptVersion()},
          {"OpenBLAS", openblas_get_config()},
          {"OpenCV", cv::getVersionString()},
          {"yaml-cpp", CLOTHFIT_YAML_CPP_VERSION},
          {"zlib", zlibVersion()}};
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
  std::string text = VersionLine() + "\n";
  const auto add = [&text](const std::string& name, const std::string& value) {
    text += fmt::format("{:<16}{}\n", name, value);
  };
  add("compiler", fmt::format("{}, C++ {}", Compiler(), __cplusplus));
  add("instruction set", InstructionSet());
  for (const auto& [name, version] : Libraries()) add(name, version);
  add("machine", Machine());
  return text +
         "Reports of bugs: the command and all that it printed, this text, log.txt, config.yaml "
         "and summary.json of the run, and the recording or what 'clothfit check' says of it; see "
         "docs/get-it.md.";
}

}  // namespace clothfit
