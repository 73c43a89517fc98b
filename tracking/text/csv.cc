// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tracking/text/csv.h"

#include <algorithm>

#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

// A number has twenty digits, a name no more than kLongestName.
constexpr size_t kLongestField = 1000;

// No more than `most` of them: a line of two billion commas has as many.
void SplitFields(std::string_view line, size_t most, std::vector<std::string_view>* fields) {
  fields->clear();
  for (size_t start = 0; start <= line.size() && fields->size() < most;) {
    const size_t end = std::min(line.find(',', start), line.size());
    fields->push_back(TrimBlanks(line.substr(start, end - start)));
    start = end + 1;
  }
}

// Takes the next line off the text.
std::string_view NextLine(std::string_view* text) {
  const size_t end = std::min(text->find('\n'), text->size());
  const std::string_view line = text->substr(0, end);
  text->remove_prefix(std::min(end + 1, text->size()));
  return line;
}

// Where in the file's header each of the expected columns stands.
std::vector<size_t> ColumnPlaces(const std::filesystem::path& file,
                                 const std::vector<std::string>& columns,
                                 const std::vector<std::string_view>& header) {
  const std::string place = file.string() + ": line 1";
  for (const std::string_view& name : header) {
    if (std::find(columns.begin(), columns.end(), name) == columns.end()) {
      throw InputError(place, "unknown column " + Quoted(name) + "; " + Suggestion(name, columns));
    }
    if (std::count(header.begin(), header.end(), name) > 1) {
      throw InputError(place, "column " + Quoted(name) + " appears more than once");
    }
  }
  std::vector<size_t> places;
  for (const std::string& name : columns) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      throw InputError(place, "column " + Quoted(name) + " is missing; expected the columns " +
                                  JoinNames(columns));
    }
    places.push_back(static_cast<size_t>(found - header.begin()));
  }
  return places;
}

}  // namespace

double CsvRow::Number(size_t column) const {
  const std::optional<double> value = ParseNumber(fields_[column]);
  if (!value) Fail(column, "expected a finite number, found " + Quoted(fields_[column]));
  return *value;
}

int CsvRow::Integer(size_t column) const {
  const std::optional<int> value = ParseInteger(fields_[column]);
  if (!value) Fail(column, "expected an integer, found " + Quoted(fields_[column]));
  return *value;
}

std::string CsvRow::Text(size_t column) const {
  if (fields_[column].empty()) Fail(column, "is empty");
  return std::string(fields_[column]);
}

Eigen::Vector2d CsvRow::Vector2(size_t first_column) const {
  return {Number(first_column), Number(first_column + 1)};
}

Eigen::Vector3d CsvRow::Vector3(size_t first_column) const {
  return {Number(first_column), Number(first_column + 1), Number(first_column + 2)};
}

bool CsvRow::IsMissing(size_t first_column, size_t count) const {
  size_t empty_count = 0;
  size_t first_empty = first_column;
  for (size_t column = first_column + count; column-- > first_column;) {
    if (!fields_[column].empty()) continue;
    ++empty_count;
    first_empty = column;
  }
  if (empty_count != 0 && empty_count != count) {
    Fail(first_empty, "is empty while its neighbours are not; expected all or none");
  }
  return empty_count != 0;
}

void CsvRow::Fail(const std::string& problem) const {
  throw InputError(file_->string() + ": line " + std::to_string(line_), problem);
}

void CsvRow::Fail(size_t column, const std::string& problem) const {
  Fail((*columns_)[column] + ": " + problem);
}

void ReadCsv(const std::filesystem::path& file, const std::vector<std::string>& columns,
             const std::function<void(const CsvRow&)>& visit, size_t most_rows) {
  const std::string content = ReadTextFile(file);
  std::string_view text = content;
  if (StartsWith(text, "\xEF\xBB\xBF")) text.remove_prefix(3);
  std::vector<std::string_view> fields;
  // With one too many there is one that is not among them.
  const size_t most_fields = columns.size() + 1;
  SplitFields(NextLine(&text), most_fields, &fields);
  const std::vector<size_t> places = ColumnPlaces(file, columns, fields);

  CsvRow row;
  row.file_ = &file;
  row.columns_ = &columns;
  row.fields_.resize(columns.size());
  size_t rows = 0;
  for (row.line_ = 2; !text.empty(); ++row.line_) {
    const std::string_view line = NextLine(&text);
    if (TrimBlanks(line).empty()) continue;
    if (++rows > most_rows) row.Fail("expected at most " + std::to_string(most_rows) + " rows");
    SplitFields(line, most_fields, &fields);
    if (fields.size() != columns.size()) {
      row.Fail("expected " + std::to_string(columns.size()) + " fields, found " +
               std::to_string(std::count(line.begin(), line.end(), ',') + 1));
    }
    for (size_t i = 0; i < places.size(); ++i) {
      row.fields_[i] = fields[places[i]];
      if (row.fields_[i].size() > kLongestField)
        row.Fail(i, "expected at most " + std::to_string(kLongestField) + " bytes, found " +
                        Quoted(row.fields_[i]));
    }
    visit(row);
  }
}

}  // namespace clothfit
