// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Strict reading of YAML: every key must be expected and every value of the right type; what is not
// raises an InputError that names the file and the full key, such as "cloth.size".
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace YAML {
class Node;
}

namespace clothfit {

// One value of a YAML file, together with its place in it. Cheap to copy.
class YamlValue {
 public:
  // Reads a file whose top is a map. Throws InputError when it is missing or no YAML.
  static YamlValue Load(const std::filesystem::path& file);

  // Throws unless this is a map that has no key but these, each at most once.
  void AllowKeys(const std::vector<std::string>& keys) const;

  YamlValue Require(const std::string& key) const;
  std::optional<YamlValue> Find(const std::string& key) const;  // empty: there is no such key
  bool Has(const std::string& key) const;

  double Number() const;  // finite
  int Integer() const;
  std::string Text() const;
  std::vector<double> Numbers(size_t count) const;  // a list of this many finite numbers
  Eigen::Vector2d Vector2() const;
  Eigen::Vector3d Vector3() const;
  Eigen::Vector2i IntegerPair() const;
  std::vector<YamlValue> Items() const;                            // of a list
  std::vector<std::pair<std::string, YamlValue>> Entries() const;  // of a map, in file order
  bool IsMap() const;

  [[noreturn]] void Fail(const std::string& problem) const;

 private:
  YamlValue(std::shared_ptr<const YAML::Node> node, std::string file, std::string key);
  YamlValue Child(const YAML::Node& node, const std::string& key) const;
  std::string Found() const;  // this value, as an error message puts it

  std::shared_ptr<const YAML::Node> node_;
  std::string file_;
  std::string key_;  // full, empty at the top
};

// The text as a YAML scalar that reads back as the same text, quoted where it has to be.
std::string YamlText(const std::string& text);

}  // namespace clothfit
