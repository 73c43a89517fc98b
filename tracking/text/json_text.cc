// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/json_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "autodiff_sim/base/input_file.h"

namespace clothfit {
namespace {

using Json = nlohmann::json;

// Ends the parsing at the first level too many; of all else it takes no note.
class JsonLevels : public nlohmann::json_sax<Json> {
 public:
  bool AreFew() const { return depth_ <= kMostJsonLevels; }

  bool start_object(std::size_t) override { return Open(); }
  bool start_array(std::size_t) override { return Open(); }
  bool end_object() override { return Close(); }
  bool end_array() override { return Close(); }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(Json::number_integer_t) override { return true; }
  bool number_unsigned(Json::number_unsigned_t) override { return true; }
  bool number_float(Json::number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Json::binary_t&) override { return true; }
  bool key(std::string&) override { return true; }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

 private:
  bool Open() {
    ++depth_;
    return AreFew();
  }
  bool Close() {
    --depth_;
    return true;
  }
  int depth_ = 0;
};

bool IsShallowJson(const std::string& text) {
  JsonLevels levels;
  Json::sax_parse(text, &levels);
  return levels.AreFew();
}

}  // namespace

std::string ReadJsonText(const std::filesystem::path& file) {
  std::string text = ReadInputFile(file, kMostJsonBytes);
  if (IsShallowJson(text)) return text;
  throw InputError(file.string(), "is nested too deep; expected at most " +
                                      std::to_string(kMostJsonLevels) + " levels");
}

nlohmann::ordered_json OrNull(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

bool IsShallowCbor(std::string_view bytes) {
  enum Major { kBytes = 2, kText = 3, kList = 4, kMap = 5, kTag = 6 };  // RFC 8949, sec. 3.1
  constexpr std::uint64_t kUntilBreak = ~std::uint64_t{0};
  constexpr unsigned kBreak = 0xff, kEndless = 31;
  std::vector<std::uint64_t> open;  // items that are to come in each list or map
  for (std::size_t at = 0; at < bytes.size();) {
    const unsigned head = static_cast<unsigned char>(bytes[at++]), info = head & 31;
    if (head == kBreak) {
      if (open.empty() || open.back() != kUntilBreak) return true;
      open.pop_back();
    } else {
      if (!open.empty() && open.back() != kUntilBreak) --open.back();
      const std::size_t width = info < 24 || info == kEndless ? 0 : std::size_t{1} << (info - 24);
      if (width > 8 || width > bytes.size() - at || head >> 5 == kTag) return true;
      std::uint64_t count = width > 0 ? 0 : info;
      if (info == kEndless) count = kUntilBreak;
      for (std::size_t i = 0; i < width; ++i)
        count = count << 8 | static_cast<unsigned char>(bytes[at++]);
      switch (head >> 5) {
        case kBytes:
        case kText:
          if (info == kEndless) return false;  // its pieces may have pieces
          if (count > bytes.size() - at) return true;
          at += static_cast<std::size_t>(count);
          break;
        case kMap:
          open.push_back(info == kEndless ? count : 2 * std::min(count, kUntilBreak / 4));
          break;
        case kList:
          open.push_back(count);
          break;
        default:
          break;
      }
    }
    if (open.size() > kMostJsonLevels) return false;
    while (!open.empty() && open.back() == 0) open.pop_back();
    if (open.empty()) return true;
  }
  return true;
}

}  // namespace clothfit
