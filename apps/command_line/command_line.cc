// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line/command_line.h"

#include <algorithm>

#include <fmt/format.h>

#include "apps/command_line/option_errors.h"
#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

std::vector<const CLI::App*> CommandsOf(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> NamesOf(const std::vector<const CLI::App*>& commands) {
  std::vector<std::string> names;
  for (const CLI::App* one : commands) names.push_back(one->get_name());
  return names;
}

// "clothfit import markers"
std::string FullName(const CLI::App& command) {
  return command.get_parent() == nullptr
             ? command.get_name()
             : FullName(*command.get_parent()) + " " + command.get_name();
}

std::string HowToList(const CLI::App& command) {
  std::string words = FullName(command);
  const std::size_t blank = words.find(' ');
  words.insert(std::min(blank, words.size()), " help");
  return "'" + words + "'";
}

// The nearest of the right names in a question, or where they are listed.
std::string Nearest(const std::string& wrong, const std::vector<std::string>& names,
                    const std::string& what, const CLI::App& command) {
  const std::string text = Suggestion(wrong, names);
  if (StartsWith(text, "did you mean")) return text;
  return fmt::format("no {} of '{}'; {} lists them", what, FullName(command), HowToList(command));
}

// Its name and what else it is called.
std::vector<std::string> AllNamesOf(const CLI::App& command) {
  std::vector<std::string> names = command.get_aliases();
  names.insert(names.begin(), command.get_name());
  return names;
}

const CLI::App& FindCommand(const CLI::App& app, const std::string& word) {
  std::vector<const CLI::App*> fitting;
  for (const CLI::App* one : CommandsOf(app)) {
    bool fits = false;
    for (const std::string& name : AllNamesOf(*one)) {
      if (name == word) return *one;
      fits = fits || StartsWith(name, word);
    }
    if (fits) fitting.push_back(one);
  }
  if (fitting.size() == 1) return *fitting[0];
  if (fitting.size() > 1) {
    throw InputError(word, "may be " + JoinNames(NamesOf(fitting)));
  }
  throw InputError(word, Nearest(word, NamesOf(CommandsOf(app)), "command", app));
}

// The innermost command that was named: markers for "import markers".
const CLI::App& InnermostCommand(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  return parsed.empty() ? app : InnermostCommand(*parsed.front());
}

std::vector<std::string> OptionsOf(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// "-v" and "--vers" stand for "--version".
std::string OptionThatBeginsSo(const std::string& wrong, const std::vector<std::string>& names) {
  const std::string letters = wrong.substr(wrong.find_first_not_of('-'));
  for (const std::string& name : names) {
    if (StartsWith(name, "--" + letters)) return name;
  }
  return "";
}

std::string DescribeUnknown(const CLI::App& app, const CLI::App& command,
                            const std::string& unknown) {
  const std::string typed = unknown.substr(0, unknown.find('='));
  const bool is_option =
      StartsWith(typed, "-") && typed.find_first_not_of('-') != std::string::npos;
  if (!is_option) return "one argument too many";
  const std::string near = OptionThatBeginsSo(typed, OptionsOf(command));
  if (!near.empty()) return "did you mean '" + near + "'?";
  const std::string of_all = OptionThatBeginsSo(typed, OptionsOf(app));
  if (!of_all.empty()) return "did you mean 'clothfit " + of_all + "'?";
  return Nearest(typed, OptionsOf(command), "option", command);
}

}  // namespace

std::vector<std::string> CompleteCommands(const CLI::App& app, std::vector<std::string> words) {
  const bool asks_help = !words.empty() && words[0] == "help";
  if (asks_help) words.erase(words.begin());
  const CLI::App* command = &app;
  for (std::string& word : words) {
    if (StartsWith(word, "-") || CommandsOf(*command).empty()) break;
    command = &FindCommand(*command, word);
    word = command->get_name();
  }
  RefuseValuesOfFlags(*command, words);
  if (asks_help) words.emplace_back("--help");
  return words;
}

std::string DescribeParseError(const CLI::App& app, const CLI::ParseError& error,
                               const std::vector<std::string>& words) {
  const CLI::App& command = InnermostCommand(app);
  const std::vector<std::string> unknown = app.remaining(true);
  const bool needs_command = !CommandsOf(command).empty();
  if (!unknown.empty() && (dynamic_cast<const CLI::ExtrasError*>(&error) || needs_command))
    return unknown.front() + ": " + DescribeUnknown(app, command, unknown.front());
  if (needs_command) return fmt::format("expected a command; {} lists them", HowToList(command));
  return fmt::format("{}; {} tells more", DescribeOptionError(command, error, words),
                     HowToList(command));
}

}  // namespace clothfit
