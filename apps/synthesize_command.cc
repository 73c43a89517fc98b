// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit synthesize: a recording made by simulation, with its truth.
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "apps/commands.h"
#include "autodiff_sim/error.h"
#include "tracking/synthetic_presets.h"
#include "tracking/synthetic_recording.h"
#include "tracking/text.h"

namespace clothfit {
namespace {

struct SynthesizeOptions {
  std::string output, preset;
  std::string scenario = ToString(SyntheticScenario::kTwoCornerSwing);
  std::vector<double> size;
  std::vector<int> resolution, markers;
  std::vector<std::string> set;
  SyntheticOptions made;
  bool hide_density = false, force = false;
};

// "air_drag.normal=0.8"
std::pair<std::string, double> ParseAssignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::optional<double> value =
      equals == std::string::npos ? std::nullopt : ParseNumber(text.substr(equals + 1));
  if (!value) throw InputError("--set", "'" + text + "': expected TERM.PARAMETER=NUMBER");
  return {text.substr(0, equals), *value};
}

SyntheticOptions OptionsOf(const SynthesizeOptions& options) {
  SyntheticOptions made = options.made;
  made.name = std::filesystem::path(options.output).lexically_normal().filename().string();
  if (made.name.empty()) {  // "demo/"
    made.name =
        std::filesystem::path(options.output).lexically_normal().parent_path().filename().string();
  }
  if (!options.preset.empty()) {
    const std::string name = made.name;
    made = PresetOptions("--preset", options.preset);
    made.name = name;
    made.frame_count = std::min(made.frame_count, options.made.frame_count);
    made.truth_points = {61, 61};
  } else {
    made.scenario = ParseSyntheticScenario("--scenario", options.scenario);
  }
  if (!options.size.empty()) made.size = {options.size[0], options.size[1]};
  if (!options.resolution.empty()) made.resolution = {options.resolution[0], options.resolution[1]};
  if (!options.markers.empty()) made.markers = {options.markers[0], options.markers[1]};
  for (const std::string& assignment : options.set)
    made.parameters.insert_or_assign(ParseAssignment(assignment).first,
                                     ParseAssignment(assignment).second);
  made.tell_density = !options.hide_density;
  made.Check("synthesize");
  return made;
}

int RunSynthesizeCommand(const SynthesizeOptions& options) {
  const SyntheticOptions made = OptionsOf(options);
  const std::filesystem::path folder = options.output;
  if (std::filesystem::exists(folder / "recording.yaml") && !options.force) {
    throw InputError(options.output, "already holds a recording; --force replaces it");
  }
  const SyntheticRecording synthetic =
      Synthesize(made, folder, Overwrite::kAllow, [](double share, const std::string& stage) {
        std::fprintf(stderr, "\r%3.0f %% %s   ", 100.0 * share, stage.c_str());
      });
  fmt::print("{}: {} frames, {} markers, {} tracks\n", options.output, made.frame_count,
             synthetic.recording.markers.size(), synthetic.recording.tracks.size());
  return kExitSuccess;
}

void AddSceneOptions(CLI::App* command, SynthesizeOptions* options) {
  SyntheticOptions& made = options->made;
  command->add_option("--preset", options->preset, "");
  command->add_option("--scenario", options->scenario, JoinNames(SyntheticScenarioNames()))
      ->type_name("NAME");
  command->add_option("--size", options->size, "m along u and v")->type_name("U V")->expected(2);
  command->add_option("--resolution", options->resolution, "particles along u and v")
      ->type_name("NU NV")
      ->expected(2);
  command
      ->add_option("--refinement", made.refinement,
                   "simulate with this many times as many cells each way")
      ->type_name("N");
  command->add_option("--frames", made.frame_count, "number of frames")->type_name("N");
  command->add_option("--rate", made.frame_rate, "frames a second")->type_name("HZ");
  command->add_option("--steps", made.steps_per_frame, "simulated steps a frame")->type_name("N");
  command
      ->add_option("--set", options->set,
                   "value of a parameter, else its initial one; may be repeated")
      ->type_name("TERM.PARAMETER=VALUE")
      ->allow_extra_args(false);
}

void AddObservationOptions(CLI::App* command, SynthesizeOptions* options) {
  SyntheticOptions& made = options->made;
  command->add_option("--markers", options->markers, "markers along u and v; 0 0: none")
      ->type_name("MU MV")
      ->expected(2);
  command->add_option("--noise", made.marker_sigma, "sigma of the markers, m")->type_name("M");
  command->add_option("--cameras", made.num_cameras, "cameras around the cloth that track points")
      ->type_name("N");
  command->add_option("--track-noise", made.track_sigma, "sigma of the tracks, px")
      ->type_name("PX");
  command->add_option("--seed", made.seed, "of the noise")->type_name("N");
  command->add_option("--held-out", made.held_out_share, "share of the frames, at the end")
      ->type_name("SHARE");
  command
      ->add_option("--hide-handle", made.hidden_handles,
                   "do not tell the path of this handle; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command->add_flag("--hide-density", options->hide_density, "do not tell the areal density");
}

}  // namespace

void AddSynthesizeCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("synthesize", "make a recording by simulation, with its truth");
  const auto options = std::make_shared<SynthesizeOptions>();
  command->add_option("-o,--output", options->output, "folder of the recording")
      ->type_name("RECORDING")
      ->required();
  AddSceneOptions(command, options.get());
  AddObservationOptions(command, options.get());
  command->add_flag("--force", options->force, "replace the recording that is there");
  command->footer(
      "Example:\n"
      "  clothfit synthesize -o lift --scenario corner-lift --cameras 3 --set air_drag.normal=0.5");
  command->callback(
      [options, action] { *action = [options] { return RunSynthesizeCommand(*options); }; });
}

}  // namespace clothfit
