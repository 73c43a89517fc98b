// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The options of a synthetic recording from a config file, and from all that was said together.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "autodiff_sim/base/error.h"
#include "tracking/synthetic/keys.h"
#include "tracking/synthetic/presets.h"
#include "tracking/text/text.h"
#include "tracking/text/yaml_reader.h"

namespace clothfit {
namespace {

using Words = std::vector<std::string>;
using Kind = SyntheticKey::Kind;

constexpr const char* kPreset = "preset";

Words WordsOf(const SyntheticKey& key, const YamlValue& value) {
  Words words;
  if (key.kind == Kind::kMap) {
    for (const auto& [name, number] : value.Entries())
      words.push_back(name + "=" + FormatNumber(number.Number()));
    return words;
  }
  if (key.kind == Kind::kFlag || (key.kind == Kind::kValues && key.count == 1))
    return {value.Text()};
  for (const YamlValue& item : value.Items()) words.push_back(item.Text());
  if (key.kind == Kind::kValues && static_cast<int>(words.size()) != key.count)
    value.Fail(fmt::format("expected a list of {} numbers, found {}", key.count, words.size()));
  return words;
}

bool AsksForImages(const SyntheticSettings& settings) {
  const auto images = settings.find("images");
  return images != settings.end() && images->second.words == Words{"true"};
}

}  // namespace

SyntheticSettings ReadSyntheticConfig(const std::filesystem::path& file) {
  const YamlValue top = YamlValue::Load(file);
  Words names = {kPreset};
  for (const SyntheticKey& key : SyntheticKeys()) names.push_back(key.name);
  top.AllowKeys(names);
  SyntheticSettings settings;
  if (const auto preset = top.Find(kPreset))
    settings[kPreset] = {file.string() + ": " + kPreset, {preset->Text()}};
  for (const SyntheticKey& key : SyntheticKeys()) {
    if (const auto value = top.Find(key.name))
      settings[key.name] = {file.string() + ": " + key.name, WordsOf(key, *value)};
  }
  return settings;
}

SyntheticOptions MakeSyntheticOptions(const SyntheticSettings& settings) {
  SyntheticOptions options;
  const auto preset = settings.find(kPreset);
  if (preset != settings.end()) {
    options = PresetOptions(preset->second.place, preset->second.words.at(0));
  } else if (AsksForImages(settings)) {
    options = ImageOptions();
  }
  for (const SyntheticKey& key : SyntheticKeys()) {
    const auto setting = settings.find(key.name);
    if (setting == settings.end()) continue;
    const std::string problem = key.set(setting->second.words, &options);
    if (!problem.empty()) throw InputError(setting->second.place, problem);
  }
  return options;
}

std::string SyntheticConfigAsYaml(const SyntheticOptions& options) {
  std::string text;
  for (const SyntheticKey& key : SyntheticKeys()) {
    const Words words = key.words(options);
    if (key.kind == Kind::kMap) {
      text += key.name + (words.empty() ? ": {}\n" : ":\n");
      for (const std::string& word : words) {
        const std::size_t equals = word.find('=');
        text += fmt::format("  {}: {}\n", word.substr(0, equals), word.substr(equals + 1));
      }
    } else if (key.kind == Kind::kList || key.count > 1) {
      text += fmt::format("{}: [{}]\n", key.name, fmt::join(words, ", "));
    } else {
      text += fmt::format("{}: {}\n", key.name, words[0]);
    }
  }
  return text;
}

}  // namespace clothfit
