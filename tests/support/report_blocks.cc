// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/report_blocks.h"

#include <limits>
#include <stdexcept>

#include <zlib.h>

namespace clothfit {

std::string FromBase64(std::string_view text) {
  const std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    group = group << 6 | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xff);
  }
  return bytes;
}

std::vector<std::uint32_t> UnpackRows(std::string_view packed, std::size_t count, std::size_t row,
                                      std::size_t width) {
  std::string planes(count * width, '\0');
  uLongf size = planes.size();
  const int status = uncompress(reinterpret_cast<Bytef*>(planes.data()), &size,
                                reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (status != Z_OK || size != planes.size()) throw std::runtime_error("block cannot be inflated");
  std::vector<std::uint32_t> values(count);
  const std::uint32_t mask = width == 2 ? 0xffffu : 0xffffffffu;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t difference = 0;
    for (std::size_t plane = 0; plane < width; ++plane) {
      const auto byte = static_cast<unsigned char>(planes[plane * count + i]);
      difference |= static_cast<std::uint32_t>(byte) << (8 * plane);
    }
    values[i] = (difference + (i < row ? 0u : values[i - row])) & mask;
  }
  return values;
}

std::string ScriptOfPage(const std::string& html, const std::string& id) {
  const std::size_t tag = html.find("id=\"" + id + "\">");
  if (tag == std::string::npos) return "";
  const std::size_t begin = html.find('>', tag) + 1;
  return html.substr(begin, html.find("</script>", begin) - begin);
}

nlohmann::json DataOfPage(const std::string& html) {
  return nlohmann::json::parse(ScriptOfPage(html, "report-data"));
}

std::vector<double> NumbersOfBlock(const std::string& html, const nlohmann::json& block) {
  std::size_t count = 1, row = 1;
  for (std::size_t i = 0; i < block.at("shape").size(); ++i) {
    const auto size = block.at("shape")[i].get<std::size_t>();
    count *= size;
    if (i > 0) row *= size;
  }
  const std::string id = "blob-" + std::to_string(block.at("blob").get<int>());
  const auto values = UnpackRows(FromBase64(ScriptOfPage(html, id)), count, row, 2);
  const auto lower = block.at("lower").get<std::vector<double>>();
  const auto upper = block.at("upper").get<std::vector<double>>();
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t c = i % lower.size();
    numbers.push_back(values[i] == 65535 ? std::numeric_limits<double>::quiet_NaN()
                                         : lower[c] + values[i] / 65534.0 * (upper[c] - lower[c]));
  }
  return numbers;
}

}  // namespace clothfit
