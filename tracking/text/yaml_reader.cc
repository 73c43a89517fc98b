// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/yaml_reader.h"

#include <algorithm>

#include <yaml-cpp/yaml.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/text/text.h"

namespace clothfit {

YamlValue::YamlValue(std::shared_ptr<const YAML::Node> node, std::string file, std::string key)
    : node_(std::move(node)), file_(std::move(file)), key_(std::move(key)) {}

YamlValue YamlValue::Child(const YAML::Node& node, const std::string& key) const {
  return YamlValue(std::make_shared<const YAML::Node>(node), file_, key);
}

YamlValue YamlValue::Load(const std::filesystem::path& file) {
  // What people write is far shorter; nodes take some hundred times the memory of their text.
  constexpr std::size_t kMostYamlBytes = 4 << 20;
  const std::string text = ReadInputFile(file, kMostYamlBytes);
  YAML::Node node;
  try {
    node.reset(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw InputError(file.string() + ": line " + std::to_string(error.mark.line + 1), error.msg);
  }
  YamlValue top(std::make_shared<const YAML::Node>(node), file.string(), "");
  if (!node.IsMap()) top.Fail("expected a map of keys and values, found " + top.Found());
  return top;
}

void YamlValue::AllowKeys(const std::vector<std::string>& keys) const {
  std::vector<std::string> seen;
  for (const auto& [key, value] : Entries()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      value.Fail("unknown key; " + Suggestion(key, keys));
    }
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) value.Fail("appears twice");
    seen.push_back(key);
  }
}

std::optional<YamlValue> YamlValue::Find(const std::string& key) const {
  if (!node_->IsMap()) Fail("expected a map, found " + Found());
  const YAML::Node child = (*node_)[key];
  if (!child.IsDefined()) return std::nullopt;
  return Child(child, key_.empty() ? key : key_ + "." + key);
}

YamlValue YamlValue::Require(const std::string& key) const {
  const std::optional<YamlValue> value = Find(key);
  if (!value) {
    throw InputError(file_ + ": " + (key_.empty() ? key : key_ + "." + key),
                     "required key is missing");
  }
  return *value;
}

bool YamlValue::Has(const std::string& key) const { return Find(key).has_value(); }

double YamlValue::Number() const {
  const std::optional<double> value =
      node_->IsScalar() ? ParseNumber(node_->Scalar()) : std::nullopt;
  if (!value) Fail("expected a finite number, found " + Found());
  return *value;
}

int YamlValue::Integer() const {
  const std::optional<int> value = node_->IsScalar() ? ParseInteger(node_->Scalar()) : std::nullopt;
  if (!value) Fail("expected an integer, found " + Found());
  return *value;
}

std::string YamlValue::Text() const {
  if (!node_->IsScalar() || node_->Scalar().empty()) Fail("expected a text, found " + Found());
  return node_->Scalar();
}

std::vector<double> YamlValue::Numbers(size_t count) const {
  if (!node_->IsSequence() || node_->size() != count) {
    Fail("expected a list of " + std::to_string(count) + " numbers, found " + Found());
  }
  std::vector<double> numbers;
  for (const YamlValue& item : Items()) numbers.push_back(item.Number());
  return numbers;
}

Eigen::Vector2d YamlValue::Vector2() const { return Eigen::Vector2d(Numbers(2).data()); }

Eigen::Vector3d YamlValue::Vector3() const { return Eigen::Vector3d(Numbers(3).data()); }

Eigen::Vector2i YamlValue::IntegerPair() const {
  if (!node_->IsSequence() || node_->size() != 2) {
    Fail("expected a list of 2 integers, found " + Found());
  }
  const std::vector<YamlValue> items = Items();
  return {items[0].Integer(), items[1].Integer()};
}

std::vector<YamlValue> YamlValue::Items() const {
  if (!node_->IsSequence()) Fail("expected a list, found " + Found());
  std::vector<YamlValue> items;
  for (const YAML::Node& item : *node_) {
    items.push_back(Child(item, key_ + "[" + std::to_string(items.size()) + "]"));
  }
  return items;
}

std::vector<std::pair<std::string, YamlValue>> YamlValue::Entries() const {
  if (!node_->IsMap()) Fail("expected a map, found " + Found());
  std::vector<std::pair<std::string, YamlValue>> entries;
  for (const auto& entry : *node_) {
    if (!entry.first.IsScalar()) Fail("expected keys that are plain text");
    const std::string& key = entry.first.Scalar();
    entries.emplace_back(key, Child(entry.second, key_.empty() ? key : key_ + "." + key));
  }
  return entries;
}

bool YamlValue::IsMap() const { return node_->IsMap(); }

void YamlValue::Fail(const std::string& problem) const {
  throw InputError(key_.empty() ? file_ : file_ + ": " + key_, problem);
}

std::string YamlValue::Found() const {
  if (node_->IsMap()) return "a map";
  if (node_->IsSequence()) return "a list of " + std::to_string(node_->size());
  if (node_->IsScalar()) return Quoted(node_->Scalar());
  return "nothing";
}

std::string YamlText(const std::string& text) {
  const bool plain = !text.empty() && !ParseNumber(text) && text != "null" && text != "true" &&
                     text != "false" && std::all_of(text.begin(), text.end(), [](unsigned char c) {
                       return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '/' || c == '.';
                     });
  if (plain && std::isalpha(static_cast<unsigned char>(text.front())) != 0) return text;
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

}  // namespace clothfit
