// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit check: is a recording right, and what is in it?
#include <memory>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "fitting/jobs/shell.h"
#include "fitting/runs/fit_run.h"
#include "fitting/runs/workload.h"
#include "tracking/outliers/outliers.h"
#include "tracking/outliers/swapped_markers.h"
#include "tracking/recording/pictures/images.h"
#include "tracking/recording/warnings/summary.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

int RunCheckCommand(const std::string& folder) {
  const Recording recording = ReadRecording(folder);
  CheckPictures(recording);
  const FitConfig config = DefaultConfig(recording);
  const Scene scene = MakeScene(recording, config);
  CheckSimulable(scene);
  CheckAffordable(scene, WorkOfFit(scene, config));
  CheckContact(scene, config);
  Print("{}", DescribeRecording(recording));
  std::fflush(stdout);
  PrintWarnings(recording);
  Recording without = recording;
  LeaveOutOutliers(&without);
  const std::string swaps = DescribeSwaps(without);
  if (!swaps.empty())
    Print(Terminal(), "clothfit: warning: wrong labels, which fits put right: {}\n", swaps);
  const std::string outliers = DescribeOutliers(without);
  if (!outliers.empty())
    Print(Terminal(), "clothfit: warning: gross errors, which fits leave out: {}\n", outliers);
  const std::vector<std::string> unknown = HandlesUnknownInHeldOutFrames(scene);
  if (!unknown.empty()) {
    Print(Terminal(),
          "clothfit: warning: held-out frames cannot be judged: where {} {} then is not known\n",
          JoinNames(unknown), unknown.size() == 1 ? "is" : "are");
  }
  PrintNext("clothfit fit " + ShellWord(folder));
  return kExitSuccess;
}

}  // namespace

void AddCheckCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand("check", "check a recording and summarise it");
  const auto folder = std::make_shared<std::string>();
  command->add_option("RECORDING", *folder, "folder of the recording")->required();
  command->footer("Example:\n  clothfit check data/demo");
  command->callback([folder, action] { *action = [folder] { return RunCheckCommand(*folder); }; });
}

}  // namespace clothfit
