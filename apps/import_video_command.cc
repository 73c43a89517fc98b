// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit import video: videos put into a recording.
#include <memory>

#include <fmt/format.h>

#include "apps/import_commands.h"
#include "autodiff_sim/base/error.h"
#include "tracking/import/video.h"

namespace clothfit {
namespace {

struct VideoOptions {
  std::vector<std::string> videos;
  std::string output;
  bool force = false;
  SceneOptions scene;
};

int RunImportVideo(const VideoOptions& options) {
  std::vector<NamedVideo> videos;
  for (const std::string& text : options.videos) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError(text, "expected CAMERA=FILE");
    }
    videos.push_back({text.substr(0, equals), text.substr(equals + 1)});
  }
  SceneStart start = options.scene.Start();
  const ImportedVideos imported =
      ImportVideos(videos, start, options.output, OverwriteIf(options.force));
  fmt::print("{}: {} videos, {} frames at {:g} Hz\n", options.output, videos.size(),
             imported.frame_count, imported.frame_rate);
  for (const std::string& note : imported.notes) fmt::print("{}\n", note);
  start.frame_count = imported.frame_count;
  start.frame_rate = imported.frame_rate;
  PrintWhatIsMissing(options.output, start);
  return kExitSuccess;
}

}  // namespace

void AddImportVideo(CLI::App* import, Action* action) {
  CLI::App* const command =
      import->add_subcommand("video", "copies of videos, with their frame count and rate");
  const auto options = std::make_shared<VideoOptions>();
  command->add_option("CAMERA=FILE", options->videos, "one a camera, anything OpenCV can open")
      ->required();
  command->add_option("-o,--output", options->output, "folder of the recording, old or new")
      ->type_name("RECORDING")
      ->required();
  command->add_flag("--force", options->force,
                    "replace imported videos, and set frame count and rate of recording.yaml");
  AddSceneOptions(command, &options->scene);
  command->footer("Example:\n  clothfit import video left=GX01.MP4 right=GX02.MP4 -o drape");
  command->callback(
      [options, action] { *action = [options] { return RunImportVideo(*options); }; });
}

}  // namespace clothfit
