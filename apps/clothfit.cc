// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The clothfit command. Whatever goes wrong is one line on the standard error.
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "apps/command_line/command_line.h"
#include "apps/command_line/help_text.h"
#include "apps/command_line/option_errors.h"
#include "apps/command_line/version_text.h"
#include "apps/commands/commands.h"
#include "apps/commands/reference/manual_pages.h"
#include "apps/process/memory_limit.h"
#include "apps/process/signals.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"

extern "C" void openblas_set_num_threads(int num_threads);

namespace clothfit {
namespace {

int Fail(const std::string& problem, int status) {
  std::fprintf(Terminal(), "clothfit: error: %s\n", Printable(problem).c_str());
  return status;
}

int Fail(const std::filesystem::filesystem_error& error) {
  return Fail(error.path1().string() + ": " + error.code().message(), kExitBadInput);
}

using AddCommand = void (*)(CLI::App* app, Action* action);

// Listed so by --help, under what they are for.
struct CommandGroup {
  const char* title;
  std::vector<AddCommand> commands;
};

void AddHelpCommand(CLI::App* app, Action*) {
  app->add_subcommand("help", "what a command does and which options it has");  // CompleteCommands
}

std::vector<CommandGroup> CommandGroups() {
  return {
      {"Make and check recordings",
       {AddImportCommand, AddTrackCommand, AddSynthesizeCommand, AddCheckCommand}},
      {"Fit and explain them",
       {AddFitCommand, AddDiagnoseCommand, AddSimulateCommand, AddBatchCommand}},
      {"Look at results and use them",
       {AddReportCommand, AddDrawCommand, AddPredictCommand, AddExportCommand, AddEvaluateCommand}},
      {"Measure clothfit itself",
       {AddCompareCommand, AddGradcheckCommand, AddStudyCommand, AddTrialsCommand}},
      {"Do lists of jobs", {AddJobCommand, AddJobsCommand, AddStatusCommand}},
      {"Look up", {AddTermsCommand, AddHelpCommand}}};
}

void DeclareCommands(CLI::App* app, Action* action) {
  app->require_subcommand(1);
  app->formatter_fn(HelpText);
  app->set_version_flag(
      "--version", [app] { return app->count("--verbose") > 0 ? VersionDetails() : VersionLine(); },
      "show the version; for a report of a bug with --verbose");
  app->add_flag("--verbose", "with --version: libraries, compiler and machine, too");
  app->set_help_flag("-h,--help", "show this help");
  app->footer(
      "Examples:\n"
      "  clothfit check data/demo\n"
      "  clothfit fit data/demo -o runs/demo\n"
      "  clothfit report runs/demo -o demo.html\n\n"
      "'clothfit help COMMAND' tells more. The beginning of a command is enough where only one\n"
      "begins so. Exit status: 0 done, 1 failed, 2 bad input, 130 interrupted.");
  for (const CommandGroup& group : CommandGroups()) {
    for (const AddCommand add : group.commands) {
      add(app, action);
      app->get_subcommands([](CLI::App*) { return true; }).back()->group(group.title);
    }
  }
}

int Run(int argc, char** argv) {
  CLI::App app("fits a simulated cloth to recordings of a real one", "clothfit");
  Action action;
  DeclareCommands(&app, &action);
  RefuseWhatIsNotFinite(&app);
  if (argc == 3 && std::string(argv[1]) == "manual-pages") return WriteManualPages(app, argv[2]);
  const std::vector<std::string> words = CompleteCommands(app, {argv + 1, argv + argc});
  try {
    std::vector<std::string> from_last(words.rbegin(), words.rend());  // as CLI11 takes them
    app.parse(from_last);
  } catch (const CLI::Success& success) {  // --help and --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return Fail(DescribeParseError(app, error, words), kExitBadInput);
  }
  const int status = action();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw InputError("standard output", "cannot be written");
  }
  return status;
}

}  // namespace
}  // namespace clothfit

// The program, for main.cc: seen from outside where this is in libclothfit.
extern "C" __attribute__((visibility("default"))) int clothfit_main(int argc, char** argv);

int clothfit_main(int argc, char** argv) {
  using namespace clothfit;  // NOLINT(google-build-using-namespace): this is the program
  ListenToSignals();
  TakeTerminal();
  LimitMemory();
  openblas_set_num_threads(1);
  cv::setNumThreads(1);  // cameras are looked at side by side instead
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // errors are told here
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is then an error that can be told
  try {
    return Run(argc, argv);
  } catch (const InputError& error) {
    return Fail(error.what(), kExitBadInput);
  } catch (const std::filesystem::filesystem_error& error) {
    return Fail(error);
  } catch (const std::bad_alloc&) {
    return Fail("out of memory", kExitFailure);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return Fail("standard output: cannot be written", kExitBadInput);
    return Fail(error.what(), kExitFailure);
  }
}
