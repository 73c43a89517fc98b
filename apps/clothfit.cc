// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The clothfit command. Whatever goes wrong is one line on the standard error.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>

#include "apps/commands.h"
#include "apps/version_text.h"
#include "autodiff_sim/base/error.h"
#include "tracking/text/text.h"

extern "C" void openblas_set_num_threads(int num_threads);

namespace clothfit {
namespace {

int Fail(std::string problem, int status) {
  std::replace(problem.begin(), problem.end(), '\n', ' ');
  std::fprintf(stderr, "clothfit: error: %s\n", problem.c_str());
  return status;
}

void DeclareCommands(CLI::App* app, Action* action) {
  app->require_subcommand(1);
  const CLI::Option* const verbose =
      app->add_flag("--verbose", "with --version: libraries, compiler and machine, too");
  app->set_version_flag(
      "--version", [verbose] { return verbose->empty() ? VersionLine() : VersionDetails(); },
      "version; for a report of a bug with --verbose");
  app->set_help_flag("-h,--help", "show this help");
  app->footer(
      "Examples:\n"
      "  clothfit check data/demo\n"
      "  clothfit fit data/demo -o runs/demo\n"
      "  clothfit predict runs/demo --at points.csv -o predicted.csv\n"
      "'clothfit COMMAND --help' tells more. Exit status: 0 done, 1 failed, 2 bad input.");
  AddFitCommand(app, action);
  AddBatchCommand(app, action);
  AddTrackCommand(app, action);
  AddSimulateCommand(app, action);
  AddPredictCommand(app, action);
  AddEvaluateCommand(app, action);
  AddDrawCommand(app, action);
  AddReportCommand(app, action);
  AddExportCommand(app, action);
  AddCheckCommand(app, action);
  AddCompareCommand(app, action);
  AddDiagnoseCommand(app, action);
  AddTermsCommand(app, action);
  AddGradcheckCommand(app, action);
  AddSynthesizeCommand(app, action);
  AddStudyCommand(app, action);
  AddTrialsCommand(app, action);
  AddImportCommand(app, action);
  AddManualPagesCommand(app, action);
}

// The innermost command that was named: motive for "import motive".
const CLI::App& InnermostCommand(const CLI::App& app) {
  const std::vector<CLI::App*> parsed = app.get_subcommands();
  return parsed.empty() ? app : InnermostCommand(*parsed.front());
}

std::vector<std::string> NamesOfCommands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* one : command.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(one->get_name());
  }
  return names;
}

// "did you mean '--frames'?" for an option that is none, or a command.
std::string NearestName(const CLI::App& command, const std::string& wrong) {
  std::vector<std::string> names;
  if (wrong.rfind('-', 0) == 0) {
    for (const CLI::Option* option : command.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
  } else {
    names = NamesOfCommands(command);
  }
  return names.empty() ? "one argument too many" : Suggestion(wrong, names);
}

std::string Describe(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> unknown = app.remaining(true);
  const CLI::App& command = InnermostCommand(app);
  const bool is_unknown = !unknown.empty() && (dynamic_cast<const CLI::ExtrasError*>(&error) ||
                                               !NamesOfCommands(command).empty());
  if (is_unknown) return unknown.front() + ": " + NearestName(command, unknown.front());
  return std::string(error.what()) + "; see --help";
}

int Run(int argc, char** argv) {
  CLI::App app("clothfit fits a simulated cloth to recordings of a real one.", "clothfit");
  Action action;
  DeclareCommands(&app, &action);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help and --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return Fail(Describe(app, error), kExitBadInput);
  }
  const int status = action();
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw InputError("standard output", "cannot be written");
  }
  return status;
}

}  // namespace
}  // namespace clothfit

// The program, for main.cc: all that it does is in the library.
extern "C" __attribute__((visibility("default"))) int clothfit_main(int argc, char** argv);

int clothfit_main(int argc, char** argv) {
  using namespace clothfit;  // NOLINT(google-build-using-namespace): this is the program
  openblas_set_num_threads(1);
  cv::setNumThreads(1);  // cameras are looked at side by side instead
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);  // errors are told here
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is then an error that can be told
  try {
    return Run(argc, argv);
  } catch (const InputError& error) {
    return Fail(error.what(), kExitBadInput);
  } catch (const std::bad_alloc&) {
    return Fail("out of memory", kExitFailure);
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) return Fail("standard output: cannot be written", kExitBadInput);
    return Fail(error.what(), kExitFailure);
  }
}
