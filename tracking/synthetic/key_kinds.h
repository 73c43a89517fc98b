// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What the keys of a synthetic recording have in common: those that set a number, several numbers,
// a flag or one of several names. `member` finds what they set. For synthetic_keys.cc.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tracking/synthetic/keys.h"
#include "tracking/text/text.h"

namespace clothfit::synthetic_key_kinds {

using Words = std::vector<std::string>;

inline std::string Parse(const std::string& word, double* value) {
  const std::optional<double> number = ParseNumber(word);
  if (!number) return "'" + word + "': expected a number";
  *value = *number;
  return "";
}

inline std::string Parse(const std::string& word, int* value) {
  const std::optional<int> number = ParseInteger(word);
  if (!number) return "'" + word + "': expected an integer";
  *value = *number;
  return "";
}

inline std::string Parse(const std::string& word, std::uint64_t* value) {
  int number = 0;
  if (Parse(word, &number).empty() && number >= 0) {
    *value = static_cast<std::uint64_t>(number);
    return "";
  }
  return "'" + word + "': expected an integer of 0 or more";
}

inline std::string Format(double value) { return FormatNumber(value); }
inline std::string Format(int value) { return std::to_string(value); }
inline std::string Format(std::uint64_t value) { return std::to_string(value); }

inline SyntheticKey BareKey(std::string name, std::string type, std::string doc) {
  SyntheticKey key;
  key.option = "--" + name;
  std::replace(key.option.begin(), key.option.end(), '_', '-');
  key.name = std::move(name);
  key.type = std::move(type);
  key.doc = std::move(doc);
  return key;
}

template <class T>
SyntheticKey NumberKey(std::string name, std::string type, std::string doc,
                       T& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), std::move(type), std::move(doc));
  key.set = [member](const Words& words, SyntheticOptions* options) {
    return Parse(words[0], &member(*options));
  };
  key.words = [member](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    return Words{Format(member(copy))};
  };
  return key;
}

// Several numbers, in an Eigen vector or an array.
template <class Vector>
SyntheticKey VectorKey(std::string name, std::string type, std::string doc, int count,
                       Vector& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), std::move(type), std::move(doc));
  key.count = count;
  key.set = [member](const Words& words, SyntheticOptions* options) {
    auto* const values = member(*options).data();
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::string problem = Parse(words[i], &values[i]);
      if (!problem.empty()) return problem;
    }
    return std::string();
  };
  key.words = [member, count](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    Words words;
    for (int i = 0; i < count; ++i) words.push_back(Format(member(copy).data()[i]));
    return words;
  };
  return key;
}

inline SyntheticKey FlagKey(std::string name, std::string doc, bool& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), "true|false", std::move(doc));
  key.kind = SyntheticKey::Kind::kFlag;
  key.set = [member](const Words& words, SyntheticOptions* options) {
    if (words[0] != "true" && words[0] != "false")
      return "'" + words[0] + "': expected true or false";
    member(*options) = words[0] == "true";
    return std::string();
  };
  key.words = [member](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    return Words{member(copy) ? "true" : "false"};
  };
  return key;
}

// One of several names.
template <class T>
SyntheticKey NameKey(std::string name, const Words& names, const std::string& doc,
                     T (*parse)(const std::string& place, const std::string& name),
                     T& (*member)(SyntheticOptions&)) {
  SyntheticKey key = BareKey(std::move(name), "NAME", doc + "; " + JoinNames(names));
  key.set = [names, parse, member](const Words& words, SyntheticOptions* options) {
    if (std::find(names.begin(), names.end(), words[0]) == names.end())
      return "'" + words[0] + "': " + Suggestion(words[0], names);
    member(*options) = parse("", words[0]);
    return std::string();
  };
  key.words = [member](const SyntheticOptions& options) {
    SyntheticOptions copy = options;
    return Words{ToString(member(copy))};
  };
  return key;
}

}  // namespace clothfit::synthetic_key_kinds
