// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/json_text.h"

#include <nlohmann/json.hpp>

#include "autodiff_sim/base/error.h"
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

bool IsShallowIn(std::string_view bytes, Json::input_format_t format) {
  JsonLevels levels;
  Json::sax_parse(bytes, &levels, format);
  return levels.AreFew();
}

}  // namespace

std::string ReadJsonText(const std::filesystem::path& file) {
  std::string text = ReadInputFile(file, kMostJsonBytes);
  if (IsShallowIn(text, Json::input_format_t::json)) return text;
  throw InputError(file.string(), "is nested too deep; expected at most " +
                                      std::to_string(kMostJsonLevels) + " levels");
}

bool IsShallowCbor(std::string_view bytes) {
  return IsShallowIn(bytes, Json::input_format_t::cbor);
}

}  // namespace clothfit
