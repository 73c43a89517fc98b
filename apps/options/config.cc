// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "apps/options/config.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include "apps/options/value_checks.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/parallel.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/config/keys.h"
#include "tracking/outliers/outliers.h"
#include "tracking/outliers/swapped_markers.h"
#include "tracking/recording/warnings/summary.h"

namespace clothfit {
namespace {

// An option that is given once for each of its values, so that it swallows no other argument.
CLI::Option* AddRepeated(CLI::App* command, const std::string& name,
                         std::vector<std::string>* values, const std::string& type,
                         const std::string& doc) {
  return command->add_option(name, *values, doc)->type_name(type)->allow_extra_args(false);
}

// The options that set a key of the config.
const std::map<std::string, std::string>& OptionsOfKeys() {
  static const std::map<std::string, std::string> options = {
      {"cloth.resolution", "--resolution"},
      {"cloth.finest", "--finest"},
      {"initial_state.order", "--initial-order"},
      {"observations.alpha", "--alpha"},
      {"observations.beta", "--beta"},
      {"observations.frames", "--frames"},
      {"observations.every", "--every"},
      {"strategy.max_iterations", "--max-iterations"},
      {"strategy.max_simulations", "--max-simulations"},
      {"strategy.optimiser", "--optimiser"},
      {"strategy.window", "--window"}};
  return options;
}

// "[2, 1]" as "2 1".
std::string AsTyped(std::string value) {
  const auto is_of_list = [](char c) { return c == '[' || c == ']' || c == ','; };
  value.erase(std::remove_if(value.begin(), value.end(), is_of_list), value.end());
  return value;
}

void CheckFreedOnce(const ConfigOptions& options) {
  for (const std::string& name : options.free) {
    const bool twice = std::find(options.fix.begin(), options.fix.end(), name) != options.fix.end();
    if (twice) throw InputError("--free", "'" + name + "' is named by --fix too");
  }
}

std::string Prefix(const std::string& name) { return name.empty() ? "" : Printable(name) + ": "; }

// Terms before single parameters, so that the finer word has the last say.
void FreeAndFix(const ConfigOptions& options, FitConfig* config) {
  CheckFreedOnce(options);
  for (const bool single : {false, true}) {
    const auto is_turn = [single](const std::string& name) {
      return (name.find('.') != std::string::npos) == single;
    };
    for (const std::string& name : options.fix) {
      if (is_turn(name)) SetFree("--fix", name, false, config);
    }
    for (const std::string& name : options.free) {
      if (is_turn(name)) SetFree("--free", name, true, config);
    }
  }
}

}  // namespace

void BeginGroup(CLI::App* command, const std::string& title) {
  command->option_defaults()->group(title);
}

CLI::Option* DefaultIsKey(const std::string& key, CLI::Option* option,
                          const std::string& otherwise) {
  for (const ConfigKey& one : ConfigKeys()) {
    if (one.full_name() == key) return option->default_str(one.write(FitConfig()) + otherwise);
  }
  throw std::logic_error(key + ": no such key");
}

void AddFramesOptions(CLI::App* command, FramesOptions* frames) {
  command
      ->add_option("--frames", frames->range,
                   "first and last frame to fit; else all that are not held out")
      ->type_name("A B")
      ->expected(2);
  DefaultIsKey("observations.every",
               command->add_option("--every", frames->every, "of these frames, fit one in so many"))
      ->type_name("N");
}

void TakeFrames(const FramesOptions& frames, FitConfig* config) {
  if (frames.range) config->frames = {(*frames.range)[0], (*frames.range)[1]};
  if (frames.every) config->every = *frames.every;
}

void AddThreadLimit(CLI::App* command) {
  constexpr int kMostThreads = 1024;
  command
      ->add_option_function<int>(
          "--threads", LimitThreads,
          "threads at the same time, 0: all cores; no influence on the result")
      ->check(WholeNumber(0, kMostThreads))
      ->default_str("0")
      ->type_name("N");
}

void CheckConfig(const FitConfig& config) {
  for (const ConfigKey& key : ConfigKeys()) {
    const std::string problem = key.problem(config);
    const auto option = OptionsOfKeys().find(key.full_name());
    if (problem.empty() || option == OptionsOfKeys().end()) continue;
    throw InputError(option->second, AsTyped(key.write(config)) + "; " + problem);
  }
  if (config.alpha == 0.0 && config.beta == 0.0)
    throw InputError("--alpha, --beta", "both are 0: nothing is left to fit");
  config.Check("command line");
}

void AddConfigOptions(CLI::App* command, ConfigOptions* options,
                      std::vector<std::string>* recordings) {
  const char* const doc = "folder of the recording; may be left out where --config names it";
  if (recordings == nullptr) {
    command->add_option("RECORDING", options->recording, doc);
  } else {
    command->add_option("RECORDING", *recordings,
                        std::string(doc) + "; several of one cloth are fitted together");
  }
  BeginGroup(command, kModelGroup);
  command
      ->add_option("--config", options->config,
                   "YAML file of the keys that differ from the defaults")
      ->type_name("FILE");
  AddRepeated(command, "--set", &options->set, "TERM.PARAMETER=VALUE",
              "start value of a parameter (its value where it is fixed); may be repeated");
  AddRepeated(command, "--without", &options->without, "TERM",
              "put a force term at its off values; may be repeated");
  command->add_flag("--self-contact", options->self_contact,
                    "the cloth does not pass through itself; see the parameters contact.*");
  command
      ->add_option("--resolution", options->resolution,
                   "particles along u and v; else as the recording says")
      ->type_name("NU NV")
      ->expected(2);
  command->add_flag("--keep-outliers", options->keep_outliers,
                    "keep markers and tracks that are off by far more than their noise");
}

void AddFreeOptions(CLI::App* command, ConfigOptions* options) {
  BeginGroup(command, kModelGroup);
  AddRepeated(command, "--free", &options->free, "NAME",
              "estimate a parameter, or all of a term; may be repeated; see 'clothfit terms'");
  AddRepeated(command, "--fix", &options->fix, "NAME",
              "hold a parameter, or all of a term, at its value; may be repeated");
}

Recording ReadRecordingOf(const ConfigOptions& options) {
  std::string folder = options.recording;
  if (folder.empty() && !options.config.empty()) folder = ReadConfigRecording(options.config);
  if (folder.empty()) {
    throw InputError("RECORDING", "is missing; expected a recording's folder, here or in --config");
  }
  return ReadRecording(std::filesystem::absolute(folder).lexically_normal());
}

FitConfig ReadConfigOf(const ConfigOptions& options, const Recording& recording) {
  FitConfig config = DefaultConfig(recording);
  if (!options.config.empty()) ReadConfig(options.config, &config);
  config.recording = recording.path.string();
  for (const std::string& term : options.without) SwitchOff("--without", term, &config);
  for (const std::string& assignment : options.set) SetParameter("--set", assignment, &config);
  FreeAndFix(options, &config);
  if (options.self_contact) config.self_contact = true;
  if (options.keep_outliers) config.leave_out_outliers = false;
  if (options.resolution) {
    config.resolution = {(*options.resolution)[0], (*options.resolution)[1]};
    config.refined = false;
  }
  return config;
}

void LeaveOutOutliers(const FitConfig& config, Recording* recording, bool quiet) {
  if (!config.leave_out_outliers) return;
  LeaveOutOutliers(recording);
  if (!quiet) PrintOutliers(*recording);
}

void PrintOutliers(const Recording& recording, const std::string& name) {
  const std::string swaps = DescribeSwaps(recording);
  if (!swaps.empty()) Print(Terminal(), "clothfit: {}put right: {}\n", Prefix(name), swaps);
  const std::string outliers = DescribeOutliers(recording);
  if (!outliers.empty())
    Print(Terminal(), "clothfit: {}left out as gross errors: {}\n", Prefix(name), outliers);
}

void PrintWarnings(const Recording& recording, const std::string& name) {
  for (const std::string& warning : Warnings(recording))
    Print(Terminal(), "clothfit: {}warning: {}\n", Prefix(name), warning);
}

void PrintWarnings(const Scene& scene, const std::string& name) {
  std::vector<std::string> warnings;
  if (scene.silhouettes) warnings = scene.silhouettes->warnings;
  if (scene.clouds)
    warnings.insert(warnings.end(), scene.clouds->warnings.begin(), scene.clouds->warnings.end());
  for (const std::string& warning : warnings)
    Print(Terminal(), "clothfit: {}warning: {}\n", Prefix(name), warning);
}

}  // namespace clothfit
