// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Man pages and completion, all from what the commands say of themselves.
#include "apps/commands/reference/manual_pages.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/command_line/help_text.h"
#include "apps/process/exit_status.h"
#include "fitting/files/version.h"
#include "tracking/files/whole_file.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

std::vector<const CLI::App*> Listed(const CLI::App& command) {
  return command.get_subcommands([](const CLI::App*) { return true; });
}

// troff takes a backslash, and a dot or an apostrophe at the beginning of a line, for its own, and
// a bare hyphen for one of typography.
std::string AsTroff(const std::string& line) {
  std::string text = !line.empty() && (line[0] == '.' || line[0] == '\'') ? "\\&" : "";
  for (const char c : line) {
    if (c == '\\' || c == '-') text += '\\';
    text += c;
    if (c == '\\') text.back() = 'e';
  }
  return text;
}

// "Options:" alone on its line.
bool IsHeading(const std::string& line) {
  return line.size() > 1 && line[0] != ' ' && line.back() == ':' && line.find(": ") == line.npos;
}

std::string ManPage(const CLI::App& command, const std::string& before) {
  const std::string called = before + (before.empty() ? "" : " ") + command.get_name();
  std::string title = called;
  std::replace(title.begin(), title.end(), ' ', '-');
  std::string heading = title;
  std::transform(title.begin(), title.end(), heading.begin(), [](char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  });
  std::string page = fmt::format(
      ".TH {} 1 \"\" \"clothfit {}\" \"clothfit\"\n.SH NAME\n{} \\- {}\n.SH DESCRIPTION\n.nf\n",
      heading, Version(), AsTroff(title), AsTroff(command.get_description()));
  std::istringstream help(HelpText(&command, called, CLI::AppFormatMode::Normal));
  for (std::string line; std::getline(help, line);) {
    if (IsHeading(line)) {
      page += fmt::format(".fi\n.SH \"{}\"\n.nf\n", AsTroff(line.substr(0, line.size() - 1)));
    } else {
      page += AsTroff(line) + "\n";
    }
  }
  return page + ".fi\n";
}

void WritePages(const CLI::App& command, const std::string& before, const fs::path& folder) {
  const std::string called = before + (before.empty() ? "" : " ") + command.get_name();
  std::string title = called;
  std::replace(title.begin(), title.end(), ' ', '-');
  WriteWholeFile(folder / (title + ".1"), ManPage(command, before));
  for (const CLI::App* one : Listed(command)) WritePages(*one, called, folder);
}

std::string WordsOfOptions(const CLI::App& command) {
  std::string words;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) words += " --" + name;
    for (const std::string& name : option->get_snames()) words += " -" + name;
  }
  return words;
}

// Lines of a case: which commands and which options may follow the words of a command so far.
std::string CompletionCases(const CLI::App& command, const std::string& called) {
  std::string names;
  for (const CLI::App* one : Listed(command)) names += " " + one->get_name();
  std::string cases =
      fmt::format("    '{}') names='{}' options='{}' ;;\n", called, names, WordsOfOptions(command));
  for (const CLI::App* one : Listed(command))
    cases += CompletionCases(*one, called + (called.empty() ? "" : " ") + one->get_name());
  return cases;
}

// Words of commands are taken as far as one has commands of its own. After help stand the names of
// commands too, and none of their options.
std::string BashCompletion(const CLI::App& root) {
  return "# bash completion of clothfit, written by clothfit manual-pages\n"
         "_clothfit() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} command= names= options= is_help= i\n"
         "  for ((i = 1; i <= COMP_CWORD; ++i)); do\n"
         "    case $command in\n" +
         CompletionCases(root, "") +
         "    esac\n"
         "    [[ $i -lt $COMP_CWORD && -n $names ]] || break\n"
         "    if [[ $i == 1 && ${COMP_WORDS[i]} == help ]]; then\n"
         "      is_help=1\n"
         "    elif [[ \" $names \" == *\" ${COMP_WORDS[i]} \"* ]]; then\n"
         "      command=${command:+$command }${COMP_WORDS[i]}\n"
         "    else\n"
         "      names= options=\n"
         "      break\n"
         "    fi\n"
         "  done\n"
         "  COMPREPLY=()\n"
         "  if [[ $current == -* ]]; then\n"
         "    [[ -n $is_help ]] || COMPREPLY=($(compgen -W \"$options\" -- \"$current\"))\n"
         "  elif [[ -n $names ]]; then\n"
         "    COMPREPLY=($(compgen -W \"$names\" -- \"$current\"))\n"
         "  fi\n"
         "}\n"
         "complete -o bashdefault -o default -F _clothfit clothfit\n";
}

}  // namespace

int WriteManualPages(const CLI::App& root, const fs::path& folder) {
  const fs::path pages = folder / "man/man1", completions = folder / "bash-completion/completions";
  fs::create_directories(pages);
  fs::create_directories(completions);
  WritePages(root, "", pages);
  WriteWholeFile(completions / "clothfit", BashCompletion(root));
  return kExitSuccess;
}

}  // namespace clothfit
