// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/c3d_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace clothfit {
namespace {

class Writer {
 public:
  explicit Writer(C3dProcessor processor) : processor_(processor) {}

  void Byte(int value) { bytes_ += static_cast<char>(value); }
  void Text(const std::string& text) { bytes_ += text; }
  void Word(int value) {
    const int low = value & 0xFF;
    const int high = (value >> 8) & 0xFF;
    const bool is_mips = processor_ == C3dProcessor::kMips;
    Byte(is_mips ? high : low);
    Byte(is_mips ? low : high);
  }
  void Float(float value) {
    // A float of DEC is four times that of IEEE 754 with its words swapped.
    if (processor_ == C3dProcessor::kDec) value *= 4.0F;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    const int high = static_cast<int>(bits >> 16U);
    const int low = static_cast<int>(bits & 0xFFFFU);
    const bool is_high_first = processor_ != C3dProcessor::kIntel;
    Word(is_high_first ? high : low);
    Word(is_high_first ? low : high);
  }
  void FillBlock() { bytes_.resize((bytes_.size() + kC3dBlock - 1) / kC3dBlock * kC3dBlock); }
  size_t size() const { return bytes_.size(); }
  const std::string& bytes() const { return bytes_; }

 private:
  C3dProcessor processor_;
  std::string bytes_;
};

struct Parameter {
  std::string name;
  int type = 0;
  std::vector<int> dimensions;
  std::string values;
};

template <class Put>
std::string ValuesBy(C3dProcessor processor, Put put) {
  Writer values(processor);
  put(&values);
  return values.bytes();
}

Parameter TextsOf(const std::string& name, const std::vector<std::string>& texts) {
  size_t length = 1;
  for (const std::string& text : texts) length = std::max(length, text.size());
  Parameter parameter{name, -1, {int(length), int(texts.size())}, ""};
  for (std::string text : texts) {
    text.resize(length, ' ');
    parameter.values += text;
  }
  return parameter;
}

// Labels beyond the 255 that one parameter can hold go into LABELS2, LABELS3, ...
std::map<std::string, std::vector<std::string>> LabelsOf(const MarkerTake& take) {
  std::map<std::string, std::vector<std::string>> labels;
  for (size_t i = 0; i < take.markers.size(); ++i) {
    const size_t part = i / 255 + 1;
    const std::string name = "POINT:LABELS" + (part == 1 ? "" : std::to_string(part));
    labels[name].push_back(take.markers[i].name);
  }
  return labels;
}

void PutParameters(const std::vector<Parameter>& parameters, Writer* file) {
  std::map<std::string, int> groups;
  for (const Parameter& parameter : parameters) {
    const std::string group = parameter.name.substr(0, parameter.name.find(':'));
    const std::string name = parameter.name.substr(group.size() + 1);
    if (groups.emplace(group, int(groups.size()) + 1).second) {
      file->Byte(-int(group.size()));  // locked
      file->Byte(-groups[group]);
      file->Text(group);
      file->Word(2 + 1 + 4);
      file->Byte(4);
      file->Text("text");
    }
    file->Byte(int(name.size()));
    file->Byte(groups[group]);
    file->Text(name);
    file->Word(2 + 2 + int(parameter.dimensions.size()) + int(parameter.values.size()) + 1);
    file->Byte(parameter.type);
    file->Byte(int(parameter.dimensions.size()));
    for (const int dimension : parameter.dimensions) file->Byte(dimension);
    file->Text(parameter.values);
    file->Byte(0);
  }
  file->Byte(0);
}

void PutPoint(const std::optional<Eigen::Vector3d>& position, double scale, Writer* file) {
  const Eigen::Vector3d place = position.value_or(Eigen::Vector3d::Zero());
  for (int axis = 0; axis < 3; ++axis) {
    if (scale < 0.0) {
      file->Float(static_cast<float>(place[axis]));
    } else {
      file->Word(static_cast<int>(std::lround(place[axis] / scale)));
    }
  }
  constexpr int kSeen = 0x0302;  // cameras 1 and 2, a residual of two scales
  const int residual = position ? kSeen : -1;
  if (scale < 0.0) {
    file->Float(static_cast<float>(residual));
  } else {
    file->Word(residual);
  }
}

}  // namespace

std::string C3dFile::Bytes(const MarkerTake& take) const {
  const auto num_frames = static_cast<int>(take.num_frames());
  std::map<std::string, std::vector<float>> all_numbers = numbers;
  all_numbers.insert({{"POINT:SCALE", {float(scale)}}, {"POINT:RATE", {float(take.frame_rate)}}});
  std::map<std::string, std::vector<int>> all_words = words;
  all_words.insert({{"POINT:USED", {int(take.markers.size())}},
                    {"POINT:FRAMES", {std::min(num_frames, 65535)}}});
  std::map<std::string, std::vector<std::string>> all_texts = texts;
  all_texts.insert({"POINT:UNITS", {"mm"}});
  for (const auto& labels : LabelsOf(take)) all_texts.insert(labels);
  std::vector<Parameter> parameters;
  for (const auto& [name, values] : all_numbers) {
    const auto& of_it = values;
    parameters.push_back({name, 4, {int(values.size())}, ValuesBy(processor, [&](Writer* to) {
                            for (const float value : of_it) to->Float(value);
                          })});
  }
  for (const auto& [name, values] : all_words) {
    const auto& of_it = values;
    parameters.push_back({name, 2, {int(values.size())}, ValuesBy(processor, [&](Writer* to) {
                            for (const int value : of_it) to->Word(value);
                          })});
  }
  for (const auto& [name, values] : all_texts) parameters.push_back(TextsOf(name, values));
  parameters.erase(std::remove_if(parameters.begin(), parameters.end(),
                                  [&](const Parameter& one) {
                                    return std::count(left_out.begin(), left_out.end(), one.name);
                                  }),
                   parameters.end());
  Writer section(processor);
  PutParameters(parameters, &section);
  const auto num_blocks = static_cast<int>((section.size() + 4 + kC3dBlock - 1) / kC3dBlock);

  Writer file(processor);
  file.Byte(2);
  file.Byte(0x50);
  file.Word(int(take.markers.size()));
  file.Word(num_analog);
  file.Word(1);
  file.Word(std::min(num_frames, 65535));
  file.Word(10);
  file.Float(static_cast<float>(scale));
  file.Word(2 + num_blocks);
  file.Word(num_analog > 0 ? 1 : 0);
  file.Float(static_cast<float>(take.frame_rate));
  file.FillBlock();
  for (const int byte : {1, 0x50, num_blocks, int(processor)}) file.Byte(byte);
  file.Text(section.bytes());
  file.FillBlock();
  for (size_t frame = 0; frame < take.num_frames(); ++frame) {
    for (const MarkerPath& marker : take.markers) PutPoint(marker.positions[frame], scale, &file);
    for (int i = 0; i < num_analog; ++i) scale < 0.0 ? file.Float(7.0F) : file.Word(7);
  }
  file.FillBlock();
  return file.bytes();
}

}  // namespace clothfit
