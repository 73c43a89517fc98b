// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The bytes of a C3D file and the parameters that stand in it.
// Reference: The C3D File Format, A Technical User Guide (Motion Lab Systems 2021; c3d.org).
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clothfit {

// The processor whose numbers the file has. Integers are little-endian but for MIPS; floats are
// those of IEEE 754, but the VAX's for DEC.
enum class C3dProcessor { kIntel = 84, kDec = 85, kMips = 86 };

// A file is divided into blocks of so many bytes, counted from 1.
inline constexpr size_t kC3dBlock = 512;

// Every access throws InputError with the offset, in bytes from 0, where the file ends before.
class C3dBytes {
 public:
  C3dBytes(std::filesystem::path file, std::string_view bytes)
      : file_(std::move(file)), bytes_(bytes) {}

  void set_processor(C3dProcessor processor) { processor_ = processor; }
  size_t size() const { return bytes_.size(); }
  std::string_view Text(size_t at, size_t count) const;
  int Byte(size_t at) const;  // 0 to 255
  int Word(size_t at) const;  // of two bytes, 0 to 65535
  int SignedWord(size_t at) const;
  double Float(size_t at) const;  // of four bytes

  [[noreturn]] void Fail(size_t at, const std::string& problem) const;

 private:
  std::filesystem::path file_;
  std::string_view bytes_;
  C3dProcessor processor_ = C3dProcessor::kIntel;
};

// A parameter's values, which stay in the file.
struct C3dParameter {
  int type = 0;  // -1: characters, 1: bytes, 2: words, 4: floats
  std::vector<size_t> dimensions;
  size_t at = 0;  // of its values, in bytes
};

class C3dParameters {
 public:
  // Reads the section of the parameters, and sets the processor as its header says.
  explicit C3dParameters(C3dBytes* bytes);

  bool Has(const std::string& name) const { return parameters_.count(name) > 0; }
  // The value of "POINT:RATE", for example, words without sign; empty where there is none so far.
  std::optional<double> Number(const std::string& name, size_t index = 0) const;
  // The texts of "POINT:LABELS" and "POINT:LABELS2" and so on, for example, without blanks at the
  // end.
  std::vector<std::string> Texts(const std::string& name) const;
  // Of one parameter or the header, for messages.
  size_t Place(const std::string& name) const;

 private:
  void ReadParameter(size_t at, const std::string& name);

  const C3dBytes& bytes_;
  std::map<std::string, C3dParameter> parameters_;  // by "GROUP:NAME"
};

}  // namespace clothfit
