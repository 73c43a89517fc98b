// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit import markers: a recording of motion capture.
#include <memory>

#include <fmt/format.h>

#include "apps/commands/commands.h"
#include "apps/commands/recordings/import.h"
#include "apps/options/config.h"
#include "apps/options/value_checks.h"
#include "apps/terminal/next_step.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/printable.h"
#include "fitting/jobs/shell.h"
#include "tracking/import/take/file.h"
#include "tracking/import/take/recording.h"
#include "tracking/recording/folder/start.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

struct MarkersOptions {
  std::string file, output, layout;
  std::string unit;
  std::vector<double> size;
  std::vector<int> resolution;
  TakeFileOptions reading;
  TakeOptions take;
  bool no_grid = false, force = false;
};

TakeOptions TakeOptionsOf(const MarkersOptions& options) {
  TakeOptions take = options.take;
  if (!options.size.empty()) take.size = Eigen::Vector2d(options.size[0], options.size[1]);
  if (!options.resolution.empty()) {
    take.resolution = Eigen::Vector2i(options.resolution[0], options.resolution[1]);
  }
  if (!options.layout.empty()) {
    take.layout = ReadLayout(options.layout);
    take.layout_file = options.layout;
  }
  take.snap_to_grid = !options.no_grid;
  return take;
}

TakeFileOptions ReadingOptionsOf(const MarkersOptions& options) {
  TakeFileOptions reading = options.reading;
  if (!options.unit.empty()) reading.facts.metres_per_unit = MetresPerUnit(options.unit);
  return reading;
}

int RunImportMarkers(const MarkersOptions& options) {
  const Overwrite overwrite = OverwriteIf(options.force);
  OutputFolder output = OpenRecording(options.output, "import markers", overwrite);
  output.CheckMayWrite("recording.yaml");
  std::vector<std::string> notes;
  const MarkerTake take = ReadTake(options.file, ReadingOptionsOf(options), &notes);
  ImportedTake imported = MakeTakeRecording(take, TakeOptionsOf(options));
  notes.insert(notes.end(), imported.notes.begin(), imported.notes.end());
  Recording& recording = imported.recording;
  recording.name = NameOfFolder(options.output);
  std::map<std::string, std::string> files = FilesOf(recording);
  const std::string layout = LayoutAsCsv(imported.marker_names, imported.uv);
  files["layout.csv"] = layout;
  output.Begin(NamesOf(files));
  output.WriteAll(files);
  Print("{}: {} frames at {} Hz, {} markers, {} handles, cloth of {:.4f} x {:.4f} m\n",
        options.output, recording.frame_count, recording.frame_rate,
        imported.uv.size() - recording.handles.size(), recording.handles.size(),
        recording.cloth.size.x(), recording.cloth.size.y());
  for (const std::string& note : notes) Print("{}\n", Printable(note));
  Print("{}", layout);
  PrintNext("clothfit check " + ShellWord(options.output));
  return kExitSuccess;
}

void AddClothOptions(CLI::App* command, MarkersOptions* options) {
  BeginGroup(command, "The scene");
  TakeOptions& take = options->take;
  command
      ->add_option("--size", options->size,
                   "m along u and v; else what the markers span, and the margin")
      ->type_name("U V")
      ->expected(2);
  command->add_option("--margin", take.margin, "cloth beyond the outermost markers, m; else none")
      ->type_name("M");
  command
      ->add_option(
          "--resolution", options->resolution,
          fmt::format("particles along u and v; else {} on the longer side", kTakeParticles))
      ->type_name("NU NV")
      ->expected(2);
  AddDensityOption(command, &take.areal_density);
  command
      ->add_option("--obstacle", take.obstacles,
                   "what a rigid body stands for: none, capsule[:radius=M,length=M] or "
                   "box[:thickness=M,margin=M,below=M]; else as its markers suggest")
      ->type_name("BODY=SHAPE")
      ->allow_extra_args(false);
  command->add_option("--ground", take.ground_height, "height of a ground, m; else there is none")
      ->type_name("M");
}

void AddMarkerOptions(CLI::App* command, MarkersOptions* options) {
  BeginGroup(command, "The markers");
  TakeOptions& take = options->take;
  command
      ->add_option("--handle,--handles", take.handles,
                   "markers that something holds, separated by commas, or none; NAME= renames; "
                   "else found")
      ->type_name("[NAME=]MARKER")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--ignore", take.ignored, "markers to leave out, separated by commas; else none")
      ->type_name("MARKER")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--least-seen", take.least_seen,
                   "leave out markers seen in less than this share of the frames")
      ->type_name("SHARE")
      ->capture_default_str();
  command
      ->add_option("--layout", options->layout,
                   "table name,u,v (m) of every marker, such as layout.csv of another import; else "
                   "found from their distances")
      ->type_name("FILE");
  command->add_flag("--no-grid", options->no_grid, "do not look for a regular grid");
  command
      ->add_option("--sigma", take.marker_sigma,
                   "of the markers, m; else from their jitter and layout")
      ->type_name("M");
  command->add_option("--every", take.every, "keep one frame of so many")
      ->type_name("N")
      ->capture_default_str();
  AddHeldOutOption(command, &take.held_out_share);
}

void AddFileOptions(CLI::App* command, MarkersOptions* options) {
  BeginGroup(command, "The file, and the recording");
  TakeFacts& facts = options->reading.facts;
  command->add_option("-o,--output", options->output, "folder of the recording")
      ->type_name("RECORDING")
      ->required();
  command
      ->add_option("--up", facts.up,
                   "axis of FILE that points up, as in z or -y; else as FILE says")
      ->type_name("AXIS");
  command->add_option("--unit", options->unit, "of lengths in FILE; else as FILE says")
      ->type_name("m|cm|mm")
      ->check(OneOf({"m", "cm", "mm"}));
  command->add_option("--rate", facts.frame_rate, "frames a second of FILE; else as FILE says")
      ->type_name("HZ");
  command->add_flag("--skip-bad-rows", options->reading.skip_bad_rows,
                    "leave out rows that cannot be read");
  command->add_flag("--force", options->force,
                    "replace what was imported before; cameras and videos stay");
}

}  // namespace

void AddImportMarkers(CLI::App* import, Action* action) {
  CLI::App* const command = import->add_subcommand(
      "markers", "motion capture: C3D, TRC, OptiTrack Motive, Vicon, Qualisys or plain tables");
  command->alias("motive");  // what it was called when it read no other
  const auto options = std::make_shared<MarkersOptions>();
  command
      ->add_option("FILE", options->file,
                   "of motion capture; read by what is in it, whatever its name")
      ->required();
  AddFileOptions(command, options.get());
  AddMarkerOptions(command, options.get());
  AddClothOptions(command, options.get());
  command->footer(
      "Examples:\n"
      "  clothfit import markers take.csv -o take --every 4 --held-out 0.33\n"
      "  clothfit import markers take.trc -o take --up z --handle left=M1,right=M4 "
      "--obstacle Bar=capsule:radius=0.02");
  command->callback(
      [options, action] { *action = [options] { return RunImportMarkers(*options); }; });
}

}  // namespace clothfit
