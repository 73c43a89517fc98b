// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// A config as a YAML file.
#include <fmt/format.h>

#include "autodiff_sim/terms/parameter_table.h"
#include "fitting/config/config.h"
#include "fitting/config/keys.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

constexpr const char* kConfigFormat = "clothfit-config/1";

// The numbers of a parameter's setting, by key.
struct SettingKey {
  const char* name;
  double ParameterSetting::*member;
};
constexpr SettingKey kSettingKeys[] = {{"value", &ParameterSetting::value},
                                       {"lower", &ParameterSetting::lower},
                                       {"upper", &ParameterSetting::upper},
                                       {"prior", &ParameterSetting::prior},
                                       {"prior_sigma", &ParameterSetting::prior_sigma}};

bool ReadBool(const YamlValue& value) {
  const std::string text = value.Text();
  if (text != "true" && text != "false") value.Fail("'" + text + "': expected true or false");
  return text == "true";
}

void ReadSetting(const YamlValue& value, ParameterSetting* setting) {
  if (!value.IsMap()) {  // a number alone is the value
    setting->value = value.Number();
    return;
  }
  std::vector<std::string> allowed = {"free"};
  allowed.emplace_back("shared");
  for (const SettingKey& key : kSettingKeys) allowed.emplace_back(key.name);
  value.AllowKeys(allowed);
  for (const SettingKey& key : kSettingKeys) {
    if (const auto number = value.Find(key.name)) setting->*key.member = number->Number();
  }
  if (const auto free = value.Find("free")) setting->free = ReadBool(*free);
  if (const auto shared = value.Find("shared")) setting->shared = ReadBool(*shared);
}

void ReadParameterSettings(const YamlValue& parameters, FitConfig* config) {
  parameters.AllowKeys(NamesOf(MakeParameterTable()));
  for (const auto& [name, value] : parameters.Entries()) {
    ReadSetting(value, &config->parameters[name]);
  }
}

std::vector<std::string> Sections() {
  std::vector<std::string> sections;
  for (const ConfigKey& key : ConfigKeys()) {
    if (sections.empty() || sections.back() != key.section) sections.push_back(key.section);
  }
  return sections;
}

void ReadSection(const YamlValue& section, const std::string& name, FitConfig* config) {
  std::vector<std::string> names;
  for (const ConfigKey& key : ConfigKeys()) {
    if (key.section == name) names.push_back(key.name);
  }
  section.AllowKeys(names);
  for (const ConfigKey& key : ConfigKeys()) {
    if (key.section != name) continue;
    if (const auto value = section.Find(key.name)) key.read(*value, config);
  }
}

YamlValue LoadConfig(const fs::path& file) {
  const YamlValue top = YamlValue::Load(file);
  std::vector<std::string> allowed = Sections();
  allowed.insert(allowed.end(), {"format", "recording", "parameters"});
  top.AllowKeys(allowed);
  if (const auto format = top.Find("format")) {
    if (format->Text() != kConfigFormat) format->Fail(std::string("expected ") + kConfigFormat);
  }
  return top;
}

std::string SettingAsYaml(const ParameterSetting& setting) {
  return fmt::format("{{value: {}, free: {}, lower: {}, upper: {}, prior: {}, prior_sigma: {}{}}}",
                     FormatNumber(setting.value), setting.free, FormatNumber(setting.lower),
                     FormatNumber(setting.upper), FormatNumber(setting.prior),
                     FormatNumber(setting.prior_sigma),
                     setting.shared ? fmt::format(", shared: {}", *setting.shared) : "");
}

std::string ParametersAsYaml(const FitConfig& config) {
  std::string text =
      "# value: where the fit starts, or stays where it is not free. prior_sigma: one sigma of\n"
      "# the prior, a factor where the scale is log, an amount where it is linear.\n"
      "parameters:\n";
  for (const NamedParameter& named : MakeParameterTable()) {
    const auto found = config.parameters.find(named.name);
    if (found == config.parameters.end()) continue;
    const char* const scale = named.parameter.scale == Scale::kLog ? "log" : "linear";
    text += fmt::format("  # {}, {}: {}\n  {}: {}\n", named.parameter.unit, scale,
                        named.parameter.doc, named.name, SettingAsYaml(found->second));
  }
  return text;
}

}  // namespace

void ReadConfig(const fs::path& file, FitConfig* config) {
  const YamlValue top = LoadConfig(file);
  if (top.Has("recording")) config->recording = ReadConfigRecording(file);
  if (const auto parameters = top.Find("parameters")) ReadParameterSettings(*parameters, config);
  for (const std::string& name : Sections()) {
    if (const auto section = top.Find(name)) ReadSection(*section, name, config);
  }
  config->Check(file.string());
}

std::string ReadConfigRecording(const fs::path& file) {
  const auto value = LoadConfig(file).Find("recording");
  if (!value) return "";
  return (file.parent_path() / value->Text()).lexically_normal().string();
}

std::string ConfigToYaml(const FitConfig& config) {
  std::string text =
      fmt::format("# What decides a fit: clothfit fit --config FILE\nformat: {}\n", kConfigFormat);
  if (!config.recording.empty()) {
    text += fmt::format("# a relative path starts at this file's folder\nrecording: {}\n",
                        YamlText(config.recording));
  }
  std::string section;
  for (const ConfigKey& key : ConfigKeys()) {
    if (key.section != section) text += fmt::format("\n{}:\n", key.section);
    section = key.section;
    text += fmt::format("  {}: {}  # {}\n", key.name, key.write(config), key.doc);
  }
  return text + "\n" + ParametersAsYaml(config);
}

std::vector<ConfigDifference> CompareConfigs(const FitConfig& config, const FitConfig& other) {
  std::vector<ConfigDifference> differences;
  const auto compare = [&](const std::string& key, const std::string& doc, const std::string& a,
                           const std::string& b) {
    if (a != b) differences.push_back({key, doc, a, b});
  };
  compare("recording", "the folder", config.recording, other.recording);
  for (const ConfigKey& key : ConfigKeys())
    compare(key.full_name(), key.doc, key.write(config), key.write(other));
  for (const NamedParameter& named : MakeParameterTable()) {
    const auto a = config.parameters.find(named.name), b = other.parameters.find(named.name);
    if (a == config.parameters.end() || b == other.parameters.end()) continue;
    const std::string place = "parameters." + named.name + ".";
    const std::string doc = named.parameter.doc;
    compare(place + "free", doc, fmt::to_string(a->second.free), fmt::to_string(b->second.free));
    for (const SettingKey& key : kSettingKeys)
      compare(place + key.name, doc, FormatNumber(a->second.*key.member),
              FormatNumber(b->second.*key.member));
  }
  return differences;
}

std::vector<std::string> ConfigDifferences(const FitConfig& config, const FitConfig& other) {
  std::vector<std::string> differences;
  const auto compare = [&](const std::string& name, const std::string& a, const std::string& b) {
    if (a != b) differences.push_back(fmt::format("{} ({}, not {})", name, a, b));
  };
  compare("recording", config.recording, other.recording);
  for (const ConfigKey& key : ConfigKeys()) {
    compare(key.full_name(), key.write(config), key.write(other));
  }
  for (const auto& [name, setting] : config.parameters) {
    const auto found = other.parameters.find(name);
    compare("parameters." + name, SettingAsYaml(setting),
            found == other.parameters.end() ? "missing" : SettingAsYaml(found->second));
  }
  return differences;
}

}  // namespace clothfit
