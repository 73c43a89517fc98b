// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/recording/clouds/file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/recording/clouds/point_table.h"
#include "tracking/recording/limits.h"
#include "tracking/text/csv.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;
using Encoding = PointTable::Encoding;

// The lines of a header, word by word.
class HeaderLines {
 public:
  HeaderLines(std::string_view text, const fs::path& file) : rest_(text), file_(file) {}

  // The next line's words. Throws at the end of the file.
  std::vector<std::string> Next() {
    if (rest_.empty()) throw InputError(file_.string(), "its header is cut off");
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++line_;
    std::vector<std::string> words;
    while (!(line = TrimBlanks(line)).empty()) {
      const std::size_t end = std::min(line.find_first_of(" \t"), line.size());
      words.emplace_back(line.substr(0, end));
      line.remove_prefix(end);
    }
    return words;
  }
  std::string_view rest() const { return rest_; }
  int next_line() const { return line_ + 1; }
  [[noreturn]] void Fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: line {}", file_.string(), line_), problem);
  }
  std::int64_t Count(const std::string& word) const {
    const std::optional<int> count = ParseInteger(word);
    if (count && *count >= 0 && *count <= kMostCloudPoints) return *count;
    Fail(fmt::format("expected a number from 0 to {}, found {}", kMostCloudPoints, Quoted(word)));
  }

 private:
  std::string_view rest_;
  const fs::path& file_;
  int line_ = 0;
};

struct PlyElement {
  std::string name;
  PointTable table;
  bool has_list = false;
};

PointTable::Column PlyColumn(const std::vector<std::string>& words, const HeaderLines& header) {
  static const std::map<std::string, std::pair<char, int>> kTypes = {
      {"char", {'I', 1}},  {"uchar", {'U', 1}},  {"short", {'I', 2}},   {"ushort", {'U', 2}},
      {"int", {'I', 4}},   {"uint", {'U', 4}},   {"float", {'F', 4}},   {"double", {'F', 8}},
      {"int8", {'I', 1}},  {"uint8", {'U', 1}},  {"int16", {'I', 2}},   {"uint16", {'U', 2}},
      {"int32", {'I', 4}}, {"uint32", {'U', 4}}, {"float32", {'F', 4}}, {"float64", {'F', 8}}};
  const auto type = words.size() == 3 ? kTypes.find(words[1]) : kTypes.end();
  if (type == kTypes.end()) header.Fail("expected 'property TYPE NAME' with a type of PLY");
  return {words[2], type->second.first, type->second.second, 1};
}

std::vector<PlyElement> ReadPlyHeader(HeaderLines* header, Encoding* encoding) {
  static const std::map<std::string, Encoding> kEncodings = {
      {"ascii", Encoding::kText},
      {"binary_little_endian", Encoding::kLittleEndian},
      {"binary_big_endian", Encoding::kBigEndian}};
  std::vector<PlyElement> elements;
  bool has_format = false;
  for (std::vector<std::string> words = header->Next();; words = header->Next()) {
    const std::string key = words.empty() ? "" : words[0];
    if (key == "end_header") break;
    if (key == "format" && words.size() == 3) {
      const auto found = kEncodings.find(words[1]);
      if (found == kEncodings.end() || words[2] != "1.0")
        header->Fail("expected ascii, binary_little_endian or binary_big_endian, and 1.0");
      *encoding = found->second;
      has_format = true;
    } else if (key == "element" && words.size() == 3) {
      elements.push_back({words[1], {}, false});
      elements.back().table.num_rows = header->Count(words[2]);
    } else if (key == "property" && !elements.empty() && words.size() > 1 && words[1] == "list") {
      elements.back().has_list = true;
    } else if (key == "property" && !elements.empty()) {
      elements.back().table.columns.push_back(PlyColumn(words, *header));
    } else if (key != "comment" && key != "obj_info" && key != "ply" && !key.empty()) {
      header->Fail("expected a header of PLY, found " + Quoted(key));
    }
  }
  if (!has_format) header->Fail("the header ends without 'format'");
  return elements;
}

// Takes rows that are no points off the data.
void SkipRows(const PlyElement& element, PointTable* data) {
  if (data->encoding != Encoding::kText) {
    const auto bytes = static_cast<std::size_t>(BytesOfRow(element.table) * element.table.num_rows);
    data->data.remove_prefix(std::min(bytes, data->data.size()));
    return;
  }
  for (std::int64_t row = 0; row < element.table.num_rows && !data->data.empty(); ++row) {
    data->data.remove_prefix(std::min(data->data.find('\n') + 1, data->data.size()));
    ++data->first_line;
  }
}

std::vector<Eigen::Vector3d> ReadPly(const std::string& text, const fs::path& file) {
  HeaderLines header(text, file);
  PointTable points;
  const std::vector<PlyElement> elements = ReadPlyHeader(&header, &points.encoding);
  points.data = header.rest();
  points.first_line = header.next_line();
  for (const PlyElement& element : elements) {
    if (element.has_list && (element.name == "vertex" || points.encoding != Encoding::kText))
      throw InputError(file.string(), "has a list before or among its points; expected them first");
    if (element.name == "vertex") {
      points.columns = element.table.columns;
      points.num_rows = element.table.num_rows;
      return PointsOf(points, file);
    }
    SkipRows(element, &points);
  }
  throw InputError(file.string(), "has no element 'vertex'");
}

void CheckPcdLine(const std::vector<std::string>& words, std::size_t expected,
                  const HeaderLines& header) {
  if (words.size() == expected) return;
  header.Fail(
      fmt::format("expected {} entries of {}, found {}", expected - 1, words[0], words.size() - 1));
}

void ReadPcdColumns(const std::vector<std::string>& words, const HeaderLines& header,
                    PointTable* points) {
  const std::string& key = words[0];
  if (key == "FIELDS") points->columns.resize(words.size() - 1);
  CheckPcdLine(words, points->columns.size() + 1, header);
  for (std::size_t i = 1; i < words.size(); ++i) {
    PointTable::Column& column = points->columns[i - 1];
    if (key == "FIELDS") column.name = words[i];
    if (key == "TYPE") column.kind = words[i][0];
    if (key == "SIZE") column.bytes = static_cast<int>(header.Count(words[i]));
    if (key == "COUNT") column.count = static_cast<int>(header.Count(words[i]));
  }
}

void CheckPcdColumns(const PointTable& points, const HeaderLines& header) {
  constexpr int kMostNumbers = 100'000;  // a histogram of a point has some hundred
  for (const PointTable::Column& column : points.columns) {
    const int size = column.bytes;
    const bool is_size = size == 4 || size == 8 || (column.kind != 'F' && (size == 1 || size == 2));
    const bool is_kind = std::string_view("FIU").find(column.kind) != std::string_view::npos;
    if (is_kind && is_size && column.count >= 1 && column.count <= kMostNumbers) continue;
    header.Fail(fmt::format("the header gives {} no type F, I or U of 1, 2, 4 or 8 bytes",
                            Quoted(column.name)));
  }
}

std::vector<Eigen::Vector3d> ReadPcd(const std::string& text, const fs::path& file) {
  HeaderLines header(text, file);
  PointTable points;
  for (std::vector<std::string> words = header.Next();; words = header.Next()) {
    const std::string key = words.empty() ? "#" : words[0];
    if (key == "FIELDS" || key == "TYPE" || key == "SIZE" || key == "COUNT") {
      ReadPcdColumns(words, header, &points);
    } else if (key == "POINTS") {
      CheckPcdLine(words, 2, header);
      points.num_rows = header.Count(words[1]);
    } else if (key == "DATA") {
      CheckPcdLine(words, 2, header);
      if (words[1] != "ascii" && words[1] != "binary")
        header.Fail("expected ascii or binary, found " + Quoted(words[1]));
      if (words[1] == "binary") points.encoding = Encoding::kLittleEndian;
      CheckPcdColumns(points, header);
      break;
    } else if (key[0] != '#' && key != "VERSION" && key != "WIDTH" && key != "HEIGHT" &&
               key != "VIEWPOINT") {
      header.Fail("expected a header of PCD, found " + Quoted(key));
    }
  }
  points.data = header.rest();
  points.first_line = header.next_line();
  return PointsOf(points, file);
}

std::vector<Eigen::Vector3d> ReadCsvCloud(const fs::path& file) {
  std::vector<Eigen::Vector3d> points;
  ReadCsv(file, {"x", "y", "z"}, [&](const CsvRow& row) {
    if (!row.IsMissing(0, 3)) points.push_back(row.Vector3(0));
    if (points.size() > kMostCloudPoints)
      row.Fail(fmt::format("expected at most {} points", kMostCloudPoints));
  });
  return points;
}

}  // namespace

const std::vector<std::string>& CloudExtensions() {
  static const std::vector<std::string> extensions = {".ply", ".pcd", ".csv"};
  return extensions;
}

std::vector<Eigen::Vector3d> ReadCloudFile(const fs::path& file) {
  if (file.extension() == ".csv") return ReadCsvCloud(file);
  const std::string text = ReadInputFile(file);
  if (file.extension() == ".pcd") return ReadPcd(text, file);
  if (!StartsWith(text, "ply"))
    throw InputError(file.string(), "expected a PLY file, which begins with 'ply'");
  return ReadPly(text, file);
}

std::string CloudAsPly(const std::vector<Eigen::Vector3d>& points) {
  std::string text = fmt::format(
      "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n",
      points.size());
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3f single = point.cast<float>();
    text.append(reinterpret_cast<const char*>(single.data()), 3 * sizeof(float));
  }
  return text;
}

}  // namespace clothfit
