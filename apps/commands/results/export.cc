// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit export: a run's motion, or its cloth, in the files of other programs.
#include "fitting/export/export.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "fitting/jobs/shell.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct ExportOptions {
  std::string run, format, output;
  OverlayOptions overlay;
  bool force = false;
};

// The format that is named, else the one whose files end as the output's name does.
const ExportFormat& FindFormat(const std::string& name, const std::string& output) {
  std::vector<std::string> names, alike;
  const ExportFormat* found = nullptr;
  const std::string extension = std::filesystem::path(output).extension().string();
  for (const ExportFormat& format : ExportFormats()) {
    names.push_back(format.name);
    if (format.name != name && (!name.empty() || format.extension != extension)) continue;
    found = &format;
    alike.push_back(format.name);
  }
  if (alike.size() == 1) return *found;
  if (alike.size() > 1) {
    throw InputError("--format", "is missing: " + extension + " may be " + JoinNames(alike));
  }
  if (name.empty()) throw InputError("--format", "is missing: expected one of " + JoinNames(names));
  throw InputError("--format", "'" + name + "': " + Suggestion(name, names));
}

int RunExportCommand(const ExportOptions& options) {
  if (std::filesystem::path(options.output).extension() == ".gltf") {
    throw InputError(options.output,
                     "expected a name that ends in .glb: glTF is written in its binary form");
  }
  const ExportFormat& format = FindFormat(options.format, options.output);
  const RunFolder run = RunFolder::Open(options.run);
  const int frames =
      ExportRun(run, format.name, options.overlay, options.output, OverwriteIf(options.force));
  Print("{} frames: {}\n", frames, options.output);
  PrintNext(format.name == "gltf" ? "open " + ShellWord(options.output) + ", in Blender for example"
                                  : "read " + ShellWord(options.output) + " in another program");
  return kExitSuccess;
}

std::string FormatsInWords() {
  std::string text = "Formats:\n";
  for (const ExportFormat& format : ExportFormats()) {
    text += fmt::format("  {:<7} {}: {}\n", format.name, format.extension, format.doc);
  }
  return text;
}

}  // namespace

void AddExportCommand(CLI::App* app, Action* action) {
  CLI::App* const command =
      app->add_subcommand("export", "a run's motion, or its cloth, in the files of other programs");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("RUN", options->run, "folder of the run")->required();
  command->add_option("--format", options->format, "see below; else as OUT ends")
      ->type_name("NAME");
  command->add_option("-o,--output", options->output, "file to write, or folder for a file a frame")
      ->type_name("OUT")
      ->required();
  command->add_option("--camera", options->overlay.camera, "of a video; the first if left out")
      ->type_name("NAME");
  command
      ->add_option("--pictures", options->overlay.pictures,
                   "recording with the pictures of a video; where the run found them if left out")
      ->type_name("RECORDING");
  command->add_flag("--force", options->force,
                    "replace the file, or what was exported to the folder");
  command->footer(FormatsInWords() +
                  "\nExample:\n"
                  "  clothfit export runs/demo --format gltf -o demo.glb");
  command->callback(
      [options, action] { *action = [options] { return RunExportCommand(*options); }; });
}

}  // namespace clothfit
