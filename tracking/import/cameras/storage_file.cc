// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/import/cameras/storage_file.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <opencv2/core.hpp>
#include <yaml-cpp/binary.h>
#include <yaml-cpp/depthguard.h>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/import/cameras/storage_xml.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

// JSON is YAML but for the comments that FileStorage writes, each a line of its own.
void BlankComments(std::string* text) {
  for (std::size_t line = 0; line < text->size(); ++line) {
    const std::size_t end = std::min(text->find('\n', line), text->size());
    const std::size_t first = text->find_first_not_of(" \t", line);
    if (first != std::string::npos && text->compare(first, 2, "//") == 0)
      std::fill(text->begin() + first, text->begin() + end, ' ');
    line = end;
  }
}

YAML::Node YamlDocument(const std::string& text, int first_line, const std::string& file) {
  try {
    YAML::Node node = YAML::Load(text);
    if (!node.IsMap()) throw InputError(file, "expected keys and values, as OpenCV writes them");
    return node;
  } catch (const YAML::DeepRecursion&) {
    throw InputError(file, "is nested too deep");
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}: line {}: column {}", file, first_line + error.mark.line + 1,
                                 error.mark.column + 1),
                     error.msg);
  }
}

// What FileStorage begins where it appends to a file of YAML.
std::vector<YAML::Node> YamlDocuments(const std::string& text, const std::string& file) {
  constexpr std::string_view kNext = "\n...\n---\n";
  constexpr std::size_t kMostDocuments = 100;
  std::vector<YAML::Node> documents;
  int line = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (documents.size() == kMostDocuments)
      throw InputError(file, fmt::format("has more than {} documents", kMostDocuments));
    const std::size_t end = std::min(text.find(kNext, at), text.size());
    const std::string document = text.substr(at, end - at);
    documents.push_back(YamlDocument(document, line, file));
    line += static_cast<int>(std::count(document.begin(), document.end(), '\n') +
                             std::count(kNext.begin(), kNext.end(), '\n'));
    at = end + kNext.size();
  }
  if (documents.empty()) throw InputError(file, "is empty");
  return documents;
}

constexpr int kMostStorageNumbers = 1000;

void AppendNumbers(const YAML::Node& node, const std::string& place, int depth,
                   std::vector<double>* numbers) {
  constexpr int kDeepest = 3;
  // An empty list would let aliases multiply without any number.
  if (node.IsSequence() && node.size() > 0 && depth < kDeepest) {
    for (const YAML::Node& item : node) AppendNumbers(item, place, depth + 1, numbers);
    return;
  }
  const std::string text = node.IsScalar() ? node.Scalar() : "";
  std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == std::string::npos) throw InputError(place, "expected a matrix or a list of numbers");
  while (begin != std::string::npos) {  // a list of XML is one text
    const std::size_t end = std::min(text.find_first_of(kSpace, begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::optional<double> number = ParseNumber(word);
    if (!number || numbers->size() >= kMostStorageNumbers) {
      throw InputError(place,
                       fmt::format("expected a matrix or a list of at most {} finite numbers,"
                                   " found {}",
                                   kMostStorageNumbers, Quoted(word)));
    }
    numbers->push_back(*number);
    begin = text.find_first_not_of(kSpace, end);
  }
}

// What FileStorage::WRITE_BASE64 makes of a matrix: 24 bytes that repeat its type, then the
// numbers.
std::vector<double> BinaryNumbers(const std::string& text, std::size_t count, char type,
                                  const std::string& place) {
  constexpr std::size_t kHeader = 24;
  const std::size_t depth = std::string_view("ucwsifd").find(type);  // in the order of CV_8U...
  constexpr std::string_view kAlphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/= \n\r\t";
  std::vector<unsigned char> bytes;
  if (text.find_first_not_of(kAlphabet) == std::string::npos)  // else it reads beyond its table
    bytes = YAML::DecodeBase64(text);
  if (depth == std::string_view::npos ||
      bytes.size() != kHeader + count * static_cast<std::size_t>(CV_ELEM_SIZE1(depth))) {
    throw InputError(place, fmt::format("expected {} numbers in base 64", count));
  }
  std::vector<double> numbers;
  cv::Mat(1, static_cast<int>(count), static_cast<int>(depth), bytes.data() + kHeader)
      .convertTo(numbers, CV_64F);
  if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
    throw InputError(place, "expected finite numbers");
  return numbers;
}

std::vector<double> MatrixNumbers(const YAML::Node& node, const std::string& place) {
  const int rows = node["rows"].as<int>(0), columns = node["cols"].as<int>(0);
  if (rows < 1 || columns < 1 || rows > kMostStorageNumbers / columns)
    throw InputError(place, fmt::format("expected a matrix, found {} x {}", rows, columns));
  std::string type = node["dt"].as<std::string>("");  // d, or 3d of three channels
  type.erase(std::remove(type.begin(), type.end(), '"'), type.end());
  const int channels = type.size() == 2 ? type[0] - '0' : 1;
  const YAML::Node data = node["data"];
  if (type.empty() || type.size() > 2 || channels < 1 || channels > 9 || !data.IsDefined())
    throw InputError(place, "expected a matrix of rows, cols, dt and data");
  const auto count = static_cast<std::size_t>(rows * columns * channels);
  constexpr std::string_view kJsonMark = "$base64$";
  std::string text = data.IsScalar() ? data.Scalar() : "";
  text.erase(0, std::min(text.find_first_not_of(kSpace), text.size()));
  if (StartsWith(text, kJsonMark)) text.erase(0, kJsonMark.size());
  constexpr std::size_t kHeaderCharacters = 32;  // no number has as many
  if (text.find_first_of(kSpace) >= kHeaderCharacters && text.size() > kHeaderCharacters)
    return BinaryNumbers(text, count, type.back(), place);
  std::vector<double> numbers;
  AppendNumbers(data, place, 0, &numbers);
  if (numbers.size() != count)
    throw InputError(place, fmt::format("expected {} numbers, found {}", count, numbers.size()));
  return numbers;
}

}  // namespace

std::vector<YAML::Node> ReadStorageFile(const std::filesystem::path& file) {
  // As of any YAML. A calibration with a thousand views of its board has half of it.
  constexpr std::size_t kMostStorageBytes = 4 << 20;
  std::string text = ReadInputFile(file, kMostStorageBytes);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const char begin = first == std::string::npos ? '\0' : text[first];
  if (begin == '<') return {ReadStorageXml(text, file.string())};
  if (begin == '{') BlankComments(&text);
  return YamlDocuments(text, file.string());
}

std::vector<double> StorageNumbers(const YAML::Node& node, const std::string& place) {
  if (node.IsMap()) return MatrixNumbers(node, place);
  std::vector<double> numbers;
  AppendNumbers(node, place, 0, &numbers);
  return numbers;
}

}  // namespace clothfit
