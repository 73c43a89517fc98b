// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cctype>
#include <cstdlib>

#include <fmt/format.h>

#include "tracking/import/c3d/bytes.h"

namespace clothfit {
namespace {

std::string Upper(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

C3dProcessor ProcessorAt(size_t at, const C3dBytes& bytes) {
  const int code = bytes.Byte(at);
  if (code >= int(C3dProcessor::kIntel) && code <= int(C3dProcessor::kMips)) {
    return static_cast<C3dProcessor>(code);
  }
  bytes.Fail(
      at, fmt::format("expected a processor, 84 (Intel), 85 (DEC) or 86 (MIPS), found {}", code));
}

int SignedByte(size_t at, const C3dBytes& bytes) {
  const int byte = bytes.Byte(at);
  return byte < 0x80 ? byte : byte - 0x100;
}

// Of groups by their number, and of parameters with the number of their group. Each is a name, and
// how far it is from there to the next.
struct Entry {
  int group = 0;  // below zero: it is the group of that number
  std::string name;
  size_t content = 0;  // offset of what follows
  size_t next = 0;     // offset of the next entry; zero: it is the last one
};

Entry ReadEntry(size_t at, size_t name_length, const C3dBytes& bytes) {
  Entry entry;
  entry.group = SignedByte(at + 1, bytes);
  entry.name = Upper(bytes.Text(at + 2, name_length));
  const size_t pointer = at + 2 + name_length;
  const auto distance = static_cast<size_t>(bytes.Word(pointer));
  entry.content = pointer + 2;
  entry.next = distance == 0 ? 0 : pointer + distance;
  return entry;
}

}  // namespace

C3dParameters::C3dParameters(C3dBytes* bytes) : bytes_(*bytes) {
  // Never the first, which is the header; DART says so, and means the one after it.
  const size_t block = std::max<size_t>(static_cast<size_t>(bytes->Byte(0)), 2);
  const size_t start = (block - 1) * kC3dBlock;
  bytes->set_processor(ProcessorAt(start + 3, *bytes));
  // No more blocks than a byte counts; some programs write zero.
  const int num_blocks = bytes->Byte(start + 2) == 0 ? 255 : bytes->Byte(start + 2);
  const size_t end = std::min(start + static_cast<size_t>(num_blocks) * kC3dBlock, bytes->size());
  std::map<int, std::string> groups;
  std::vector<Entry> entries;
  for (size_t at = start + 4; at != 0 && at < end;) {
    // A length below zero is that of an entry that is locked.
    const int length = std::abs(SignedByte(at, *bytes));
    if (length == 0) break;
    const Entry entry = ReadEntry(at, static_cast<size_t>(length), *bytes);
    if (entry.group < 0) {
      groups[-entry.group] = entry.name;
    } else {
      entries.push_back(entry);
    }
    at = entry.next;
  }
  for (const Entry& entry : entries) {
    ReadParameter(entry.content, groups[entry.group] + ":" + entry.name);
  }
}

void C3dParameters::ReadParameter(size_t at, const std::string& name) {
  C3dParameter parameter;
  parameter.type = SignedByte(at, bytes_);
  const auto num_dimensions = static_cast<size_t>(bytes_.Byte(at + 1));
  size_t count = 1;
  for (size_t i = 0; i < num_dimensions; ++i) {
    parameter.dimensions.push_back(static_cast<size_t>(bytes_.Byte(at + 2 + i)));
    count *= parameter.dimensions.back();
    if (count <= bytes_.size()) continue;
    bytes_.Fail(at + 2 + i, name + ": expected no more values than the file has bytes");
  }
  parameter.at = at + 2 + num_dimensions;
  const bool is_known =
      parameter.type == -1 || parameter.type == 1 || parameter.type == 2 || parameter.type == 4;
  if (!is_known) {
    bytes_.Fail(at,
                fmt::format("{}: expected a type -1, 1, 2 or 4, found {}", name, parameter.type));
  }
  bytes_.Text(parameter.at, count * static_cast<size_t>(std::abs(parameter.type)));
  parameters_[name] = parameter;
}

size_t C3dParameters::Place(const std::string& name) const {
  const auto found = parameters_.find(name);
  return found == parameters_.end() ? 0 : found->second.at;
}

std::optional<double> C3dParameters::Number(const std::string& name, size_t index) const {
  const auto found = parameters_.find(name);
  if (found == parameters_.end()) return std::nullopt;
  const C3dParameter& parameter = found->second;
  size_t count = 1;
  for (const size_t dimension : parameter.dimensions) count *= dimension;
  if (index >= count) return std::nullopt;
  const size_t at = parameter.at + index * static_cast<size_t>(std::abs(parameter.type));
  if (parameter.type == 1) return bytes_.Byte(at);
  if (parameter.type == 2) return bytes_.Word(at);
  if (parameter.type == 4) return bytes_.Float(at);
  bytes_.Fail(at, name + ": expected a number, found text");
}

std::vector<std::string> C3dParameters::Texts(const std::string& name) const {
  constexpr size_t kMost = 65'535;  // points that a file can count
  std::vector<std::string> texts;
  for (int part = 1; texts.size() <= kMost; ++part) {
    const auto found = parameters_.find(part == 1 ? name : name + std::to_string(part));
    if (found == parameters_.end()) break;
    const C3dParameter& parameter = found->second;
    if (parameter.type != -1) {
      bytes_.Fail(parameter.at, found->first + ": expected text, found numbers");
    }
    const std::vector<size_t>& dimensions = parameter.dimensions;
    const size_t length = dimensions.empty() ? 1 : dimensions[0];
    const size_t count = dimensions.size() < 2 ? 1 : dimensions[1];
    for (size_t i = 0; i < count; ++i) {
      std::string text(bytes_.Text(parameter.at + i * length, length));
      text.erase(std::min(text.find('\0'), text.size()));
      text.erase(text.find_last_not_of(" \t") + 1);
      texts.push_back(text);
    }
  }
  return texts;
}

}  // namespace clothfit
