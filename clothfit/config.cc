// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/config.h"

#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "autodiff_sim/terms/parameter_table.h"
#include "clothfit/detail/boundary.h"
#include "clothfit/detail/data.h"
#include "fitting/config/keys.h"

namespace clothfit::v0 {
namespace {

std::unique_ptr<ConfigData> Owned(FitConfig config) {
  return std::make_unique<ConfigData>(ConfigData{std::move(config)});
}

FitConfig Defaults(const Recording& recording) {
  FitConfig config = DefaultConfig(recording.data().recording);
  config.recording = recording.folder();
  return config;
}

// A file in memory: YamlValue reads files alone.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& text) : descriptor_(memfd_create("clothfit", 0)) {
    const auto size = static_cast<ssize_t>(text.size());
    if (descriptor_ < 0 || write(descriptor_, text.data(), text.size()) != size)
      throw std::runtime_error("no memory for a file");
  }
  ~MemoryFile() { close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

 private:
  int descriptor_;
};

void ReadKey(const ConfigKey& key, const std::string& yaml, FitConfig* config) {
  const MemoryFile file(fmt::format("{}:\n  {}: {}\n", key.section, key.name, yaml));
  try {
    key.read(YamlValue::Load(file.path()).Require(key.section).Require(key.name), config);
  } catch (const clothfit::InputError& error) {  // whose message begins with the file's name
    throw InputError("set" + std::string(error.what()).substr(file.path().size()));
  }
  const std::string problem = key.problem(*config);
  if (!problem.empty()) throw InputError(fmt::format("set: {}: {}", key.full_name(), problem));
}

// Sets a key by its full name to a value as a config file has it: "strategy.window" to "0.5".
void SetConfigKey(const std::string& full_name, const std::string& yaml, FitConfig* config) {
  std::vector<std::string> names;
  for (const ConfigKey& key : ConfigKeys()) {
    if (key.full_name() == full_name) return ReadKey(key, yaml, config);
    names.push_back(key.full_name());
  }
  throw InputError(fmt::format("set: '{}': {}", full_name, Suggestion(full_name, names)));
}

}  // namespace

Config::Config(std::unique_ptr<ConfigData> data) : data_(std::move(data)) {}
Config::Config(const Recording& recording)
    : data_(AtBoundary([&] { return Owned(Defaults(recording)); })) {}
Config::Config(const Recording& recording, const std::string& file)
    : data_(AtBoundary([&] {
        FitConfig config = Defaults(recording);
        ReadConfig(file, &config);
        config.recording = recording.folder();
        return Owned(std::move(config));
      })) {}
Config::Config(const Config& other) : data_(Owned(other.data_->config)) {}
Config::Config(Config&&) noexcept = default;
Config& Config::operator=(const Config& other) {
  data_ = Owned(other.data_->config);
  return *this;
}
Config& Config::operator=(Config&&) noexcept = default;
Config::~Config() = default;

void Config::Set(const std::string& parameter, double value) {
  AtBoundary(
      [&] { SetParameter("set", fmt::format("{}={:.17g}", parameter, value), &data_->config); });
}

void Config::Free(const std::string& name) {
  AtBoundary([&] { SetFree("free", name, true, &data_->config); });
}

void Config::Fix(const std::string& name) {
  AtBoundary([&] { SetFree("fix", name, false, &data_->config); });
}

void Config::Without(const std::string& term) {
  AtBoundary([&] { SwitchOff("without", term, &data_->config); });
}

double Config::Value(const std::string& parameter) const {
  return AtBoundary([&] {
    RequireParameter(MakeParameterTable(), parameter, "value");
    return data_->config.parameters.at(parameter).value;
  });
}

void Config::SetKey(const std::string& key, const std::string& yaml) {
  AtBoundary([&] { SetConfigKey(key, yaml, &data_->config); });
}

std::vector<Parameter> Config::parameters() const {
  std::vector<Parameter> parameters;
  for (const NamedParameter& named : MakeParameterTable()) {
    const ParameterSetting& setting = data_->config.parameters.at(named.name);
    parameters.push_back({named.name, named.parameter.unit, named.parameter.doc, setting.value,
                          setting.free, setting.lower, setting.upper, named.parameter.off});
  }
  return parameters;
}

std::string Config::Yaml() const { return ConfigToYaml(data_->config); }

}  // namespace clothfit::v0
