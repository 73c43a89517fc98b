// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit draw: a picture of a fitted cloth beside what was measured.
#include <filesystem>
#include <memory>

#include "apps/commands/commands.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "fitting/files/npy_file.h"
#include "fitting/jobs/shell.h"
#include "fitting/pictures/picture.h"
#include "fitting/report/diagnosis/record.h"
#include "fitting/report/scene/scene.h"
#include "tracking/files/manifest.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

struct DrawOptions {
  std::string folder, output;
  PictureOptions picture;
  double azimuth = 35.0, elevation = 15.0;  // degrees
  bool force = false;
};

// Beside what a diagnosis found, if anything.
void ShowBaseline(const fs::path& diagnosis, const Scene& scene, PictureOptions* picture) {
  if (ReadDiagnosisRecord(diagnosis).effects.empty()) return;
  const fs::path file = diagnosis / "baseline.npy";
  picture->before = ReadPointsNpy(file);
  CheckTrajectory(file, scene, picture->before);
  picture->titles = {"baseline", "answer"};
}

int RunDrawCommand(DrawOptions options) {
  const Overwrite overwrite = OverwriteIf(options.force);
  CheckMayWrite(options.output, overwrite);
  constexpr double kDegree = M_PI / 180.0;
  options.picture.azimuth = options.azimuth * kDegree;
  options.picture.elevation = options.elevation * kDegree;
  if (IsRecordingFolder(options.folder)) {
    DrawRecording(ReadUnfitted(options.folder), options.picture, options.output, overwrite);
  } else {
    const RunFolder run = RunFolder::Open(options.folder);
    const FittedRun fitted = ReadFittedRun(run);
    if (KindOfFolder(options.folder) == FolderKind::kDiagnosis)
      ShowBaseline(options.folder, fitted.scene, &options.picture);
    DrawRun(fitted, run, options.picture, options.output, overwrite);
  }
  Print("picture: {}\n", options.output);
  PrintNext("clothfit report " + ShellWord(options.folder));
  return kExitSuccess;
}

}  // namespace

void AddDrawCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand(
      "draw", "a picture of a fitted cloth, before and after the fit, or of a recording");
  const auto options = std::make_shared<DrawOptions>();
  command->add_option("FOLDER", options->folder, "a run, a diagnosis or a recording")->required();
  command->add_option("-o,--output", options->output, "picture to write, .png or .jpg")
      ->type_name("FILE")
      ->required();
  command->add_option("--frames", options->picture.frames, "frames to draw; four if left out")
      ->type_name("N ...");
  command
      ->add_option("--azimuth", options->azimuth, "degrees about the vertical, from -y towards x")
      ->type_name("DEGREES")
      ->capture_default_str();
  command->add_option("--elevation", options->elevation, "degrees above the horizon")
      ->type_name("DEGREES")
      ->capture_default_str();
  command->add_flag("--force", options->force, "replace FILE");
  command->footer(
      "The upper row is the fit's start, or a diagnosis' baseline, the lower its result; of a\n"
      "recording there is one row, with the default material. Black dots are the measured "
      "markers,\n"
      "red lines lead to where the simulation has them, orange is where hands hold the cloth.\n"
      "Obstacles are grey, those that a diagnosis found, too.\n\n"
      "Example:\n"
      "  clothfit draw runs/demo -o demo.png --frames 20 80");
  command->callback(
      [options, action] { *action = [options] { return RunDrawCommand(*options); }; });
}

}  // namespace clothfit
