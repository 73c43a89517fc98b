// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit, a diagnosis or a simulation is told.
#pragma once

#include <memory>

#include "clothfit/recording.h"

namespace clothfit::v0 {

struct ConfigData;  // of the library

// A physical parameter, by its full name: term.parameter.
struct Parameter {
  std::string name, unit, doc;
  double value = 0.0;  // start of a fit, or what is simulated
  bool free = false;   // estimated by a fit
  double lower = 0.0, upper = 0.0;
  double off = 0.0;  // the value at which its term does nothing
};

class CLOTHFIT_API Config {
 public:
  // The defaults for a recording.
  explicit Config(const Recording& recording);
  // A config file over the defaults, such as the config.yaml of a run. Throws InputError.
  Config(const Recording& recording, const std::string& file);
  Config(const Config&);
  Config(Config&&) noexcept;
  Config& operator=(const Config&);
  Config& operator=(Config&&) noexcept;
  ~Config();

  // All of these throw InputError with the nearest right name where there is no such one, and where
  // the value is out of range. A term's name stands for all of its parameters.
  void Set(const std::string& parameter, double value);
  void Free(const std::string& name);     // to be estimated
  void Fix(const std::string& name);      // held at its value
  void Without(const std::string& term);  // switched off
  double Value(const std::string& parameter) const;
  // A key other than a parameter as config.yaml has it: ("strategy.window", "0.5"),
  // ("cloth.resolution", "[9, 9]").
  void SetKey(const std::string& key, const std::string& yaml);

  std::vector<Parameter> parameters() const;
  std::string Yaml() const;  // all of it, as config.yaml

  explicit Config(std::unique_ptr<ConfigData> data);
  const ConfigData& data() const { return *data_; }

 private:
  std::unique_ptr<ConfigData> data_;
};

}  // namespace clothfit::v0
