// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line/help_text.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace clothfit {
namespace {

// Characters; where descriptions of options begin, and of commands.
constexpr std::size_t kWidth = 79, kColumn = 28, kCommandColumn = 14;

const char* const kCommonGroup = "Options";  // of what has no group, --help among it

// `text` in lines from `column` on; the first line has `column` characters already.
std::string Wrapped(const std::string& text, std::size_t column) {
  std::istringstream words(text);
  std::string lines, word;
  std::size_t used = column;
  while (words >> word) {
    const bool is_first = used == column;
    if (!is_first && used + 1 + word.size() > kWidth) {
      lines += "\n" + std::string(column, ' ');
      used = column;
    } else if (!is_first) {
      lines += " ";
      ++used;
    }
    lines += word;
    used += word.size();
  }
  return lines;
}

std::string Row(const std::string& label, const std::string& description,
                std::size_t column = kColumn) {
  std::string row = "  " + label;
  if (description.empty()) return row + "\n";
  const bool has_room = row.size() + 2 <= column;
  row += has_room ? std::string(column - row.size(), ' ') : "\n" + std::string(column, ' ');
  return row + Wrapped(description, column) + "\n";
}

// What stands for the value: none of a flag; the choices where there are some.
std::string ValueName(const CLI::Option& option) {
  if (option.get_type_size() == 0) return "";
  if (!option.get_option_text().empty()) return option.get_option_text();
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));  // CLI11 appends what its validators say
}

// Empty where there is none, or nothing is the default. Of several values as they are typed.
std::string DefaultOf(const CLI::Option& option) {
  std::string text = option.get_default_str();
  const bool is_nothing = text.empty() || text == "[]" || text == "{}" || text == "\"\"";
  if (option.get_type_size() == 0 || is_nothing) return "";
  if (text.front() != '[' || text.back() != ']') return text;
  text = text.substr(1, text.size() - 2);
  if (option.get_delimiter() != ',') std::replace(text.begin(), text.end(), ',', ' ');
  return text;
}

std::string OptionDescription(const CLI::Option& option) {
  std::string text = option.get_description();
  if (option.get_required() && !option.get_positional()) text += " (required)";
  const std::string value = DefaultOf(option);
  return value.empty() ? text : text + fmt::format(" (default: {})", value);
}

std::string RowsOf(const std::string& title, const std::vector<const CLI::Option*>& options) {
  if (options.empty()) return "";
  std::string text = "\n" + title + ":\n";
  for (const CLI::Option* option : options)
    text += Row(OptionLabel(*option), OptionDescription(*option));
  return text;
}

std::vector<const CLI::Option*> Arguments(const CLI::App& command) {
  return command.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

// The groups in the order in which they were made, the common one last.
std::string OptionGroups(const CLI::App& command) {
  std::vector<std::string> groups = command.get_groups();
  const auto common = std::find(groups.begin(), groups.end(), kCommonGroup);
  if (common != groups.end()) std::rotate(common, common + 1, groups.end());
  std::string text;
  for (const std::string& group : groups) {
    if (group.empty()) continue;
    text += RowsOf(group, command.get_options([&group](const CLI::Option* option) {
      return option->nonpositional() && option->get_group() == group;
    }));
  }
  return text;
}

std::string CommandGroups(const CLI::App& command) {
  std::string text, group;
  for (const CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string title = one->get_group() == "Subcommands" ? "Commands" : one->get_group();
    if (title != group) text += "\n" + title + ":\n";
    group = title;
    text += Row(one->get_name(), one->get_description(), kCommandColumn);
  }
  return text;
}

std::string Usage(const CLI::App& command, const std::string& name) {
  std::string text = "Usage: " + name;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_required() && option->nonpositional()) text += " " + OptionLabel(*option);
  }
  const auto comma = [&text] { return text.find(", --"); };
  while (comma() != std::string::npos) {  // the short name is enough here
    text.erase(comma(), text.find(' ', comma() + 2) - comma());
  }
  for (const CLI::Option* option : Arguments(command)) {
    const std::string label = OptionLabel(*option);
    text += option->get_required() ? " " + label : " [" + label + "]";
  }
  const bool has_commands = !command.get_subcommands([](const CLI::App*) { return true; }).empty();
  return text + (has_commands ? " COMMAND" : "") + " [OPTIONS]\n";
}

// Lines that begin with a blank or end with a colon stay; the others are paragraphs.
std::string Footer(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text, paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) text += Wrapped(paragraph, 0) + "\n";
    paragraph.clear();
  };
  for (std::string line; std::getline(lines, line);) {
    const bool stays = line.empty() || line.front() == ' ' || line.back() == ':';
    if (stays) {
      end_paragraph();
      text += line + "\n";
    } else {
      paragraph += line + " ";
    }
  }
  end_paragraph();
  return text;
}

}  // namespace

std::string OptionLabel(const CLI::Option& option) {
  if (option.get_positional()) {
    const bool is_many = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
    const std::string& text = option.get_option_text();
    return (text.empty() ? option.get_name(true, false) : text) + (is_many ? " ..." : "");
  }
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  const std::string value = ValueName(option);
  return fmt::format("{}{}{}", fmt::join(names, ", "), value.empty() ? "" : " ", value);
}

std::string HelpText(const CLI::App* command, const std::string& name, CLI::AppFormatMode) {
  std::string text = name + ": " + command->get_description();
  text = Wrapped(text, 0) + "\n\n" + Usage(*command, name);
  text += RowsOf("Arguments", Arguments(*command));
  text += CommandGroups(*command) + OptionGroups(*command);
  const std::string footer = command->get_footer();
  return footer.empty() ? text : text + "\n" + Footer(footer);
}

}  // namespace clothfit
