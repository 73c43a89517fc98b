// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one table of a config's keys other than the parameters: reading, writing, checking and
// comparing all go by it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fitting/config/config.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {

struct ConfigKey {
  std::string section, name;  // in the file: section.name
  std::string doc;            // with the unit and the meaning of zero
  std::function<void(const YamlValue& value, FitConfig* config)> read;
  std::function<std::string(const FitConfig& config)> write;  // the value as YAML
  // What was expected; empty where the value is right.
  std::function<std::string(const FitConfig& config)> problem;

  std::string full_name() const { return section + "." + name; }
};

// In the order in which they are written; the keys of a section stand together.
const std::vector<ConfigKey>& ConfigKeys();

}  // namespace clothfit
