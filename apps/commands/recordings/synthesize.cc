// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit synthesize: a recording made by simulation, with its truth.
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/options/config.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "tracking/synthetic/keys.h"
#include "tracking/synthetic/presets.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct SynthesizeOptions {
  std::string output, config, preset;
  std::map<std::string, std::vector<std::string>> words;  // by the key's name
  std::map<std::string, bool> flags;
  bool force = false;
};

// The last part of the folder's path: "demo/" is demo.
std::string NameOf(const std::string& output) {
  const std::filesystem::path path = std::filesystem::absolute(output).lexically_normal();
  const std::string name = path.filename().string();
  return name.empty() ? path.parent_path().filename().string() : name;
}

// What the command line says goes before what the config file says.
SyntheticSettings SettingsOf(const SynthesizeOptions& options) {
  SyntheticSettings settings;
  if (!options.config.empty()) settings = ReadSyntheticConfig(options.config);
  if (!options.preset.empty()) settings["preset"] = {"--preset", {options.preset}};
  for (const SyntheticKey& key : SyntheticKeys()) {
    SyntheticSetting& setting = settings[key.name];
    if (const auto words = options.words.find(key.name);
        words != options.words.end() && !words->second.empty()) {
      // Of parameters the command line changes some; those of the file stay.
      if (key.kind != SyntheticKey::Kind::kMap) setting.words.clear();
      setting.words.insert(setting.words.end(), words->second.begin(), words->second.end());
      setting.place = key.option;
    } else if (const auto flag = options.flags.find(key.name); flag != options.flags.end()) {
      setting = {key.option, {flag->second ? "true" : "false"}};
    }
    if (setting.place.empty()) settings.erase(key.name);
  }
  return settings;
}

// Where a key was set, or the option that would set it.
std::string PlaceOf(const SyntheticSettings& settings, const std::string& name) {
  if (const auto setting = settings.find(name); setting != settings.end())
    return setting->second.place;
  for (const SyntheticKey& key : SyntheticKeys()) {
    if (key.name == name) return key.option;
  }
  return name;
}

int RunSynthesizeCommand(const SynthesizeOptions& options) {
  const SyntheticSettings settings = SettingsOf(options);
  SyntheticOptions made = MakeSyntheticOptions(settings);
  made.name = NameOf(options.output);
  made.Check([&settings](const std::string& key) { return PlaceOf(settings, key); });
  ProgressDisplay display(ProgressDisplay::Lines::kNowAndThen);
  const SyntheticRecording synthetic =
      Synthesize(made, options.output, OverwriteIf(options.force),
                 [&](double share, const std::string& stage) { display.Show(stage, "", share); });
  display.Finish();
  Print("{}: {} frames, {} markers, {} tracks, {} pictures\n", options.output, made.frame_count,
        synthetic.recording.markers.size(), synthetic.recording.tracks.size(),
        made.images ? made.frame_count * made.num_cameras : 0);
  PrintNext("clothfit fit " + ShellWord(options.output));
  return kExitSuccess;
}

std::string ValueOf(const SyntheticKey& key, const SyntheticOptions& options) {
  std::vector<std::string> words = key.words(options);
  if (key.kind == SyntheticKey::Kind::kFlag) return words[0] == "true" ? "on" : "off";
  for (std::string& word : words) {
    if (const auto number = ParseNumber(word)) word = fmt::format("{:.4g}", *number);
  }
  return JoinNames(words, " ");
}

// With the default, and that of images where it is another.
std::string DescriptionOf(const SyntheticKey& key) {
  const std::string value = ValueOf(key, {}), with_images = ValueOf(key, ImageOptions());
  if (value.empty()) return key.doc;
  const bool is_other = key.name != "images" && with_images != value;
  return fmt::format("{} (default: {}{})", key.doc, value,
                     is_other ? ", with --images " + with_images : "");
}

void AddKey(CLI::App* command, const SyntheticKey& key, SynthesizeOptions* options) {
  BeginGroup(command, key.group);
  const std::string name = key.option.substr(2), doc = DescriptionOf(key);
  if (key.kind == SyntheticKey::Kind::kFlag) {
    command->add_flag_function(
        key.option + ",!--no-" + name,
        [options, name = key.name](std::int64_t count) { options->flags[name] = count > 0; }, doc);
    return;
  }
  CLI::Option* const option =
      command->add_option(key.option, options->words[key.name], doc)->type_name(key.type);
  if (key.kind == SyntheticKey::Kind::kValues) {
    option->expected(key.count);
  } else {
    option->allow_extra_args(false);
  }
}

}  // namespace

void AddSynthesizeCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("synthesize", "make a recording by simulation, with its truth");
  const auto options = std::make_shared<SynthesizeOptions>();
  BeginGroup(command, "The recording");
  command->add_option("-o,--output", options->output, "folder of the recording")
      ->type_name("RECORDING")
      ->required();
  command
      ->add_option("--preset", options->preset,
                   "with images, to be changed by the other options; " + JoinNames(PresetNames()))
      ->type_name("NAME");
  command->add_option("--config", options->config, "YAML file of preset and the options below")
      ->type_name("FILE");
  for (const SyntheticKey& key : SyntheticKeys()) AddKey(command, key, options.get());
  BeginGroup(command, "The recording");
  command->add_flag("--force", options->force,
                    "replace what clothfit wrote there; other files stay");
  command->footer(
      "Examples:\n"
      "  clothfit synthesize -o lift --scenario corner-lift --cameras 3 --set air_drag.normal=0.5\n"
      "  clothfit synthesize -o experiment --preset experiment-1 --texture plain --frames 60");
  command->callback(
      [options, action] { *action = [options] { return RunSynthesizeCommand(*options); }; });
}

}  // namespace clothfit
