// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The one table of the options of a synthetic recording: the config file and the command line both
// go by it.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tracking/synthetic/recording.h"

namespace clothfit {

struct SyntheticKey {
  enum class Kind {
    kFlag,    // one value, true or false; on the command line the option's name alone
    kValues,  // `count` values
    kList,    // any number; on the command line the option is repeated
    kMap,     // likewise, of NAME=VALUE
  };

  std::string name;    // in the config file
  std::string option;  // on the command line
  Kind kind = Kind::kValues;
  int count = 1;
  std::string type;  // of its values, for the help
  std::string doc;
  std::string group;  // for the help
  // Sets the option; tells what is wrong with the words, nothing where they are right.
  std::function<std::string(const std::vector<std::string>& words, SyntheticOptions* options)> set;
  std::function<std::vector<std::string>(const SyntheticOptions& options)> words;
};

const std::vector<SyntheticKey>& SyntheticKeys();

// What a config file or a command line says, by the keys' names; `place` is for messages.
struct SyntheticSetting {
  std::string place;
  std::vector<std::string> words;
};
using SyntheticSettings = std::map<std::string, SyntheticSetting>;

// A YAML file of such keys and `preset`. Throws InputError with file, key, value and what was
// expected; an unknown key is answered with the nearest right one.
SyntheticSettings ReadSyntheticConfig(const std::filesystem::path& file);

// The preset that the settings name; without one ImageOptions where they ask for images, else the
// defaults. Over it the settings. Throws InputError as above.
SyntheticOptions MakeSyntheticOptions(const SyntheticSettings& settings);

// All keys as a config file that reads back the same.
std::string SyntheticConfigAsYaml(const SyntheticOptions& options);

}  // namespace clothfit
