// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit simulate: a recording's scene with given parameters, without a fit.
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "fitting/runs/fit_run.h"

namespace clothfit {
namespace {

struct SimulateOptions {
  ConfigOptions config;
  std::string output;
  std::optional<int> frames;
  bool force = false;
  bool check_intersections = false;
};

int CountFrames(const SimulateOptions& options, const Recording& recording) {
  const int frames = options.frames.value_or(recording.frame_count);
  if (frames >= 1 && frames <= recording.frame_count) return frames;
  throw InputError("--frames", fmt::format("{}: expected 1 to {}, the recording's length", frames,
                                           recording.frame_count));
}

int RunSimulateCommand(const SimulateOptions& options) {
  Recording recording = ReadRecordingOf(options.config);
  FitConfig config = ReadConfigOf(options.config, recording);
  if (options.check_intersections) config.check_intersections = true;
  CheckConfig(config);
  LeaveOutOutliers(config, &recording);
  const int frames = CountFrames(options, recording);
  const Scene scene = MakeScene(recording, config);
  CheckSimulable(scene);
  CheckContact(scene, config);
  const RunFolder run(options.output, ExistingIf(options.force));
  StepReport steps;
  const int reached = SimulateIntoRun(scene, config, run, frames - 1, &steps);
  Print("{} frames of {} particles: {}\n", reached, scene.mesh.num_particles(),
        run.path().string());
  const std::string contact = DescribeContact(scene, config, steps);
  if (!contact.empty()) Print("{}\n", contact);
  if (steps.intersections > 0) {
    throw std::runtime_error(fmt::format(
        "the cloth passes through itself, an obstacle or the ground, {} times after all steps; "
        "--self-contact prevents it",
        steps.intersections));
  }
  if (reached == frames) {
    const std::string out = ShellWord(run.path().string());
    PrintNext("clothfit export " + out + " --format gltf -o cloth.glb");
    return kExitSuccess;
  }
  throw std::runtime_error(
      fmt::format("the simulation fails after frame {} of {}", reached - 1, frames));
}

}  // namespace

void AddSimulateCommand(CLI::App* app, Action* action) {
  CLI::App* const command = app->add_subcommand(
      "simulate", "simulate a recording's scene with given parameters, without a fit");
  const auto options = std::make_shared<SimulateOptions>();
  BeginGroup(command, "The simulation");
  command->add_option("-o,--output", options->output, "folder for the trajectory")
      ->type_name("OUT")
      ->required();
  command->add_option("--frames", options->frames, "how many frames; all if left out")
      ->type_name("N");
  command->add_flag("--check-intersections", options->check_intersections,
                    "count after every step where the cloth passes through itself, an obstacle or "
                    "the ground; exit status 1 where it does");
  command->add_flag("--force", options->force, "replace the run that is there; other files stay");
  AddConfigOptions(command, &options->config);
  command->footer(
      "Writes trajectory.npy (frames x particles x 3, m), mesh.obj, residuals.csv and "
      "config.yaml.\n\n"
      "Example:\n"
      "  clothfit simulate data/demo -o runs/heavy --set cloth.areal_density=0.3 --frames 60");
  command->callback(
      [options, action] { *action = [options] { return RunSimulateCommand(*options); }; });
}

}  // namespace clothfit
