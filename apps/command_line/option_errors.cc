// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line/option_errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "apps/command_line/help_text.h"
#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

using Words = std::vector<std::string>;

// -o where that was typed, else --output; of an argument "FILE", as the help calls it.
std::string TypedName(const CLI::Option& option, const Words& words) {
  if (option.get_positional()) {
    const std::string label = OptionLabel(option);
    return label.substr(0, label.find(" ..."));
  }
  for (const std::string& word : words) {
    for (const std::string& name : option.get_lnames())
      if (word.substr(0, word.find('=')) == "--" + name) return "--" + name;
    for (const std::string& name : option.get_snames())
      if (StartsWith(word, "-" + name)) return "-" + name;
  }
  return option.get_name();
}

// The option that the parser's text is about; null where there is none.
const CLI::Option* OptionOf(const CLI::App& command, std::string text) {
  const std::string convert = "Could not convert: ";
  if (StartsWith(text, convert)) text.erase(0, convert.size());
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (StartsWith(text, name + ":") || StartsWith(text, name + " ")) return option;
  }
  return nullptr;
}

// Two that are given and exclude each other, or one that is and another that it needs and is not.
std::string DescribePair(const CLI::App& command, const Words& words) {
  for (const CLI::Option* one : command.get_options()) {
    if (one->count() == 0) continue;
    const std::string name = TypedName(*one, words);
    for (const CLI::Option* other : one->get_excludes()) {
      if (other->count() > 0) {
        return fmt::format("{}, {}: both are given; expected one of them", name,
                           TypedName(*other, words));
      }
    }
    for (const CLI::Option* other : one->get_needs()) {
      if (other->count() == 0) return name + ": expected " + other->get_name() + " too";
    }
  }
  return "";
}

// Whether the help calls the option's values one of these.
bool IsCalled(const CLI::Option& option, const Words& names) {
  const std::string type = option.get_type_name();
  return std::find(names.begin(), names.end(), type.substr(0, type.find(':'))) != names.end();
}

// Numbers that count something, and all others.
bool AreWholeNumbers(const CLI::Option& option) {
  return IsCalled(option, {"N", "N ...", "NU NV", "A B", "K", "PX", "W H"});
}
bool AreOtherNumbers(const CLI::Option& option) {
  return IsCalled(option, {"DEGREES", "HZ", "KG/M2", "M", "MB", "S", "S11 .. S44", "SHARE", "U V",
                           "V", "W", "X Y Z"});
}

// "inf", "nan" and "1e999", which CLI11 takes for numbers.
bool IsNotFinite(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return end != text.c_str() && *end == '\0' && !std::isfinite(value);
}

// "a number", "2 whole numbers".
std::string Several(int count, const std::string& what) {
  return count > 1 ? fmt::format("{} {}s", count, what) : "a " + what;
}

Words Choices(const CLI::Option& option) {
  Words names;
  std::istringstream text(option.get_option_text());
  for (std::string name; std::getline(text, name, '|');) names.push_back(name);
  return names;
}

// "1; expected 2 values" where there are too few or too many.
std::string DescribeNumber(const CLI::Option& option) {
  const std::string found = JoinNames(option.results(), " ");
  const std::string what = AreWholeNumbers(option) ? "whole number" : "value";
  const int count = option.get_items_expected_min();
  const bool is_too_many = option.results().size() > 1 && count <= 1;
  return fmt::format("{}; expected {}", found.empty() ? "no value" : found,
                     is_too_many ? "one " + what : Several(count, what));
}

// "foo; expected a number" of values that are none of the option's kind.
std::string DescribeKind(const CLI::Option& option) {
  const Words& values = option.results();
  if (values.empty()) return DescribeNumber(option);
  const Words choices = Choices(option);
  if (choices.size() > 1) return values.front() + "; " + Suggestion(values.front(), choices);
  const std::string all = JoinNames(values, " ");
  if (option.get_type_size_max() > 1)  // of several kinds
    return fmt::format("{}; expected {}", all, option.get_type_name());
  const auto is_no_number = [](const std::string& value) { return !ParseNumber(value); };
  auto wrong = std::find_if(values.begin(), values.end(), is_no_number);
  const bool are_numbers = wrong == values.end();
  if (are_numbers) {  // but broken, or too large
    wrong = std::find_if(values.begin(), values.end(),
                         [](const std::string& value) { return !ParseInteger(value); });
  }
  const std::string what = are_numbers || AreWholeNumbers(option) ? "whole number" : "number";
  const int count = option.get_items_expected_min();
  const bool is_one = count <= 1 && wrong != values.end();
  return fmt::format("{}; expected {}", is_one ? *wrong : all, Several(count, what));
}

template <class Kind>
bool Is(const CLI::ParseError& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

}  // namespace

std::string DescribeOptionError(const CLI::App& command, const CLI::ParseError& error,
                                const Words& words) {
  const std::string text = error.what();
  if (Is<CLI::ExcludesError>(error) || Is<CLI::RequiresError>(error))
    return DescribePair(command, words);
  const CLI::Option* const option = OptionOf(command, text);
  if (option == nullptr) return text;
  const std::string name = TypedName(*option, words);
  if (Is<CLI::RequiredError>(error))
    return fmt::format("{}: is missing ({})", name, option->get_description());
  if (Is<CLI::ConversionError>(error)) return name + ": " + DescribeKind(*option);
  if (Is<CLI::ArgumentMismatch>(error)) return name + ": " + DescribeNumber(*option);
  return name + text.substr(option->get_name().size());
}

void RefuseWhatIsNotFinite(CLI::App* app) {
  for (CLI::App* command : app->get_subcommands([](CLI::App*) { return true; }))
    RefuseWhatIsNotFinite(command);
  for (CLI::Option* option : app->get_options()) {
    const bool are_whole = AreWholeNumbers(*option);
    if (!are_whole && !AreOtherNumbers(*option)) continue;
    const char* const expected = are_whole ? "a whole number" : "a finite number";
    const auto problem = [expected](const std::string& text) {
      return IsNotFinite(text) ? text + "; expected " + expected : "";
    };
    option->check(CLI::Validator(problem, ""));
  }
}

void RefuseValuesOfFlags(const CLI::App& command, const Words& words) {
  for (const std::string& word : words) {
    if (word == "--") return;
    const std::size_t equals = word.find('=');
    if (!StartsWith(word, "--") || equals == std::string::npos) continue;
    const std::string name = word.substr(0, equals);
    const CLI::Option* const option = command.get_option_no_throw(name);
    if (option != nullptr && option->get_items_expected_max() == 0)
      throw InputError(name, word.substr(equals + 1) + "; expected no value");
  }
}

}  // namespace clothfit
