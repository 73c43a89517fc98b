// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit found, as parameters.yaml.
#include <cmath>

#include <fmt/format.h>

#include "fitting/runs/run_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

constexpr const char* kParameters = "parameters.yaml";

// .inf and .nan are YAML's own.
std::string YamlNumber(double value) {
  if (std::isnan(value)) return ".nan";
  if (std::isinf(value)) return value > 0.0 ? ".inf" : "-.inf";
  return FormatNumber(value);
}

std::string EstimateAsYaml(const ParameterEstimate& estimate) {
  std::string text =
      fmt::format("{}: {{value: {}, unit: {}, free: {}", YamlText(estimate.name),
                  YamlNumber(estimate.value), YamlText(estimate.unit), estimate.free);
  if (estimate.free) {
    text += fmt::format(", interval: [{}, {}], determined: {}, at_bound: {}",
                        YamlNumber(estimate.lower95), YamlNumber(estimate.upper95),
                        estimate.determined, estimate.at_bound);
  }
  return text + "}\n";
}

}  // namespace

void RunFolder::WriteParameters(const FitResult& result) const {
  std::string text =
      "# What the fit found. interval: 95 %. determined: by the data, rather than by the prior.\n";
  for (const ParameterEstimate& estimate : result.estimates) text += EstimateAsYaml(estimate);
  WriteWholeFile(path_ / kParameters, text);
}

bool RunFolder::HasParameters() const { return IsThere(path_ / kParameters); }

Eigen::VectorXd RunFolder::ReadParameters(const FreeParameters& free) const {
  const YamlValue top = YamlValue::Load(path_ / kParameters);
  Eigen::VectorXd theta = free.start();
  for (int i = 0; i < free.size(); ++i) {
    const FreeEntry& entry = free.entries()[static_cast<size_t>(i)];
    const YamlValue yaml = top.Require(entry.name).Require("value");
    const double value = yaml.Number();
    if (entry.is_log && !(value > 0.0)) yaml.Fail("expected a number above 0");
    theta[i] = entry.is_log ? std::log(value) : value;
  }
  return theta;
}

}  // namespace clothfit
