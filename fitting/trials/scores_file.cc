// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The rows of trials.csv, by one table of columns that both writes and reads.
#include <cmath>
#include <functional>

#include "autodiff_sim/base/error.h"
#include "fitting/trials/summary.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct Column {
  std::string name;
  std::function<std::string(const TrialScore&)> write;
  std::function<bool(const std::string& word, TrialScore*)> read;  // false: it makes no sense
};

// A comma or a line's end would be taken for the next field or row.
std::string AsField(std::string text) {
  for (char& c : text) {
    if (c == ',' || c == '\n' || c == '\r') c = ';';
  }
  return text;
}

Column TextColumn(const char* name, std::string TrialScore::*value) {
  return {name, [value](const TrialScore& score) { return AsField(score.*value); },
          [value](const std::string& word, TrialScore* score) {
            score->*value = word;
            return true;
          }};
}

template <class T>
bool ParseAs(const std::string& word, T* value) {
  const std::optional<double> number = ParseNumber(word);
  if (number) *value = static_cast<T>(*number);
  return number.has_value();
}

template <class T>
Column NumberColumn(const char* name, T TrialScore::*value) {
  return {
      name,
      [value](const TrialScore& score) { return FormatNumber(static_cast<double>(score.*value)); },
      [value](const std::string& word, TrialScore* score) {
        return ParseAs(word, &(score->*value));
      }};
}

// Empty for what does not apply; 0 and 1 for no and yes.
template <class T>
Column NumberColumn(const char* name, std::optional<T> TrialScore::*value) {
  return {name,
          [value](const TrialScore& score) {
            const double number = score.*value ? static_cast<double>(*(score.*value)) : NAN;
            return std::isfinite(number) ? FormatNumber(number) : std::string();
          },
          [value](const std::string& word, TrialScore* score) {
            if (word.empty()) return true;
            T number{};
            if (!ParseAs(word, &number)) return false;
            score->*value = number;
            return true;
          }};
}

Column StatusColumn() {
  return {"status",
          [](const TrialScore& score) {
            return std::string(score.status == TrialStatus::kDone ? "done" : "failed");
          },
          [](const std::string& word, TrialScore* score) {
            score->status = word == "done" ? TrialStatus::kDone : TrialStatus::kFailed;
            return word == "done" || word == "failed";
          }};
}

const std::vector<Column>& Columns() {
  using Score = TrialScore;
  static const std::vector<Column> columns = {
      TextColumn("trial", &Score::name),
      TextColumn("kind", &Score::kind),
      TextColumn("motion", &Score::motion),
      TextColumn("observation", &Score::observation),
      TextColumn("size", &Score::size),
      TextColumn("truth", &Score::truth),
      StatusColumn(),
      TextColumn("verdict", &Score::verdict),
      TextColumn("named", &Score::named),
      TextColumn("top", &Score::top),
      NumberColumn("num_named", &Score::num_named),
      NumberColumn("over_limit", &Score::over_limit),
      NumberColumn("named_first", &Score::named_first),
      NumberColumn("top_right", &Score::top_right),
      NumberColumn("in_ambiguity", &Score::in_ambiguity),
      NumberColumn("ambiguity_size", &Score::ambiguity_size),
      NumberColumn("both_named", &Score::both_named),
      NumberColumn("false_alarm", &Score::false_alarm),
      NumberColumn("fault_named", &Score::fault_named),
      NumberColumn("flagged", &Score::flagged),
      NumberColumn("class_right", &Score::class_right),
      NumberColumn("tie_right", &Score::tie_right),
      NumberColumn("region_overlap", &Score::region_overlap),
      NumberColumn("onset_error", &Score::onset_error),
      NumberColumn("parameter_error", &Score::parameter_error),
      NumberColumn("covered", &Score::covered),
      NumberColumn("intervals", &Score::intervals),
      NumberColumn("held_out_before", &Score::held_out_before),
      NumberColumn("held_out_after", &Score::held_out_after),
      NumberColumn("held_out_true", &Score::held_out_true),
      NumberColumn("gap_closed", &Score::gap_closed),
      TextColumn("nonce", &Score::nonce),
      TextColumn("sha256", &Score::digest),
      NumberColumn("seconds", &Score::seconds),
      TextColumn("problem", &Score::problem),
  };
  return columns;
}

std::vector<std::string> Split(const std::string& line, char between) {
  std::vector<std::string> parts(1);
  for (const char c : line) {
    if (c == between) {
      parts.emplace_back();
    } else {
      parts.back().push_back(c);
    }
  }
  return parts;
}

std::string Header() {
  std::string header;
  for (const Column& column : Columns()) header += (header.empty() ? "" : ",") + column.name;
  return header;
}

}  // namespace

std::string ScoresAsCsv(const std::vector<TrialScore>& scores) {
  std::string text = Header() + "\n";
  for (const TrialScore& score : scores) {
    std::string line;
    for (const Column& column : Columns())
      line += (&column == &Columns().front() ? "" : ",") + column.write(score);
    text += line + "\n";
  }
  return text;
}

std::vector<TrialScore> ReadScores(const std::string& place, const std::string& csv) {
  std::vector<std::string> lines = Split(csv, '\n');
  if (lines.back().empty()) lines.pop_back();
  if (lines.empty() || lines.front() != Header())
    throw InputError(place, "line 1: is no table of this version's trials");
  std::vector<TrialScore> scores;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::string line = place + ": line " + std::to_string(i + 1);
    const std::vector<std::string> words = Split(lines[i], ',');
    if (words.size() != Columns().size()) {
      throw InputError(line, std::to_string(words.size()) + " fields: expected " +
                                 std::to_string(Columns().size()));
    }
    TrialScore score;
    for (std::size_t c = 0; c < words.size(); ++c) {
      if (!Columns()[c].read(words[c], &score))
        throw InputError(line + ": " + Columns()[c].name, "'" + words[c] + "': expected a number");
    }
    scores.push_back(std::move(score));
  }
  return scores;
}

}  // namespace clothfit
