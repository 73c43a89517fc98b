// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit import video: videos put into a recording.
#include <memory>

#include "apps/commands/recordings/import.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/printable.h"
#include "tracking/camera/camera_file.h"
#include "tracking/import/pictures/video.h"

namespace clothfit {
namespace {

struct VideoOptions {
  std::vector<std::string> videos, backgrounds;
  std::string output;
  bool force = false;
  SceneOptions scene;
};

std::vector<NamedVideo> Named(const std::vector<std::string>& texts, const char* expected) {
  std::vector<NamedVideo> named;
  for (const std::string& text : texts) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) throw InputError(text, expected);
    named.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  return named;
}

int RunImportVideo(const VideoOptions& options) {
  const std::vector<NamedVideo> videos =
      Named(options.videos, "expected CAMERA=FILE or CAMERA=FOLDER");
  const std::vector<NamedVideo> backgrounds = Named(options.backgrounds, "expected CAMERA=FILE");
  std::vector<std::string> notes;
  std::vector<Camera> cameras;  // are needed for corners alone
  const std::filesystem::path folder = options.output;
  const SceneOptions& scene = options.scene;
  if (scene.DescribesScene()) CheckIsNew(folder);
  if (!scene.corners.empty()) cameras = ReadCameras(folder / "cameras.yaml");
  SceneStart start = scene.Start(cameras, &notes);
  const ImportedVideos imported =
      ImportVideos(videos, start, options.output, OverwriteIf(options.force), backgrounds);
  Print("{}: {} cameras, {} frames at {:g} Hz\n", options.output, videos.size(),
        imported.frame_count, imported.frame_rate);
  notes.insert(notes.end(), imported.notes.begin(), imported.notes.end());
  for (const std::string& note : notes) Print("{}\n", Printable(note));
  start.frame_count = imported.frame_count;
  start.frame_rate = imported.frame_rate;
  PrintWhatIsMissing(options.output, start);
  return kExitSuccess;
}

}  // namespace

void AddImportVideo(CLI::App* import, Action* action) {
  CLI::App* const command =
      import->add_subcommand("video", "copies of videos or of folders of PNG pictures");
  const auto options = std::make_shared<VideoOptions>();
  command
      ->add_option("VIDEO", options->videos,
                   "one a camera: a video, or a folder of pictures such as 000001.png")
      ->option_text("CAMERA=FILE")  // a name of CLI11 2.4 has no =
      ->required();
  command->add_option("-o,--output", options->output, "folder of the recording, old or new")
      ->type_name("RECORDING")
      ->required();
  command
      ->add_option("--background", options->backgrounds,
                   "PNG of what CAMERA sees without the cloth, for silhouettes; may be repeated")
      ->type_name("CAMERA=FILE")
      ->allow_extra_args(false);
  command->add_flag(
      "--force", options->force,
      "replace imported videos, and set frame count and rate of recording.yaml, whoever wrote it");
  AddSceneOptions(command, &options->scene);
  command->footer(
      "Examples:\n  clothfit import video left=GX01.MP4 right=GX02.MP4 -o drape\n"
      "  clothfit import video left=frames/left right=frames/right -o drape --rate 30");
  command->callback(
      [options, action] { *action = [options] { return RunImportVideo(*options); }; });
}

}  // namespace clothfit
