// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The subcommands of clothfit. Each declares its options and, where the command line asks for it,
// sets the action. An action checks its input, makes one library call and prints the result.
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "apps/process/exit_status.h"

namespace clothfit {

// Returns the ExitStatus.
using Action = std::function<int()>;

void AddFitCommand(CLI::App* app, Action* action);
void AddSimulateCommand(CLI::App* app, Action* action);
void AddPredictCommand(CLI::App* app, Action* action);
void AddDrawCommand(CLI::App* app, Action* action);
void AddCheckCommand(CLI::App* app, Action* action);
void AddCompareCommand(CLI::App* app, Action* action);
void AddDiagnoseCommand(CLI::App* app, Action* action);
void AddTermsCommand(CLI::App* app, Action* action);
void AddGradcheckCommand(CLI::App* app, Action* action);
void AddSynthesizeCommand(CLI::App* app, Action* action);
void AddEvaluateCommand(CLI::App* app, Action* action);
void AddTrackCommand(CLI::App* app, Action* action);
void AddStudyCommand(CLI::App* app, Action* action);
void AddTrialsCommand(CLI::App* app, Action* action);
void AddExportCommand(CLI::App* app, Action* action);
void AddReportCommand(CLI::App* app, Action* action);
void AddImportCommand(CLI::App* app, Action* action);
void AddBatchCommand(CLI::App* app, Action* action);
void AddJobCommand(CLI::App* app, Action* action);
void AddJobsCommand(CLI::App* app, Action* action);
void AddStatusCommand(CLI::App* app, Action* action);

// Of `study`, those that are lists of jobs: attraction, reconstructions, ...
void AddJobStudies(CLI::App* study, Action* action);

}  // namespace clothfit
