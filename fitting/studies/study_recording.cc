// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/study_recording.h"

#include <stdexcept>

#include <fmt/format.h>
#include <unistd.h>

#include "tracking/features/tracking_folder.h"
#include "tracking/synthetic/presets.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

SyntheticOptions RecordingOptions(const nlohmann::json& input) {
  const auto experiment = input.at("experiment").get<std::string>();
  SyntheticOptions options = PresetOptions("experiment", experiment);
  options.name = experiment;
  options.frame_count = input.at("frames");
  const int generator = input.at("generator"), width = input.at("picture");
  options.refinement = 2;
  options.resolution.setConstant((generator + 1) / 2);
  options.truth_points.setConstant(generator);
  options.pictures.size = {width, 3 * width / 4};
  options.pictures.threads = 1;
  options.seed += input.at("seed").get<unsigned>() - 1;
  for (const SyntheticHandle& handle :
       MakeSyntheticMotion(options.scenario, options.size, options.Duration()).handles)
    options.hidden_handles.push_back(handle.name);
  return options;
}

}  // namespace

Job RecordingJob(const StudyOptions& options, const std::string& experiment) {
  const std::string name = fmt::format("{}-{}f-{}p-{}px-seed{}", experiment, options.frames,
                                       options.generator, options.picture, options.seed);
  return {name,
          {{"experiment", experiment},
           {"frames", options.frames},
           {"generator", options.generator},
           {"picture", options.picture},
           {"seed", options.seed}}};
}

nlohmann::json MakeStudyRecording(const fs::path& folder, const Job& job,
                                  const JobContext& context) {
  const fs::path place = folder / job.name;
  if (fs::exists(place)) return {{"folder", job.name}};
  fs::path part = place;  // in case somebody else, taken for dead, is still making it
  part += fmt::format(".{}.part", getpid());
  fs::remove_all(part);
  Synthesize(RecordingOptions(job.input), part / "pictures", Overwrite::kAllow,
             [&](double, const std::string&) { context.alive(); });
  TrackingOptions options;
  options.num_threads = 1;
  TrackingCallbacks callbacks;
  callbacks.stop = context.stop;
  callbacks.on_frame = [&](int) { context.alive(); };
  const Recording recording = ReadRecording(part / "pictures");
  TrackIntoFolder(recording, options, part / "seen", Overwrite::kAllow, callbacks);
  if (context.stop != nullptr && *context.stop) throw std::runtime_error("stopped");
  fs::copy(part / "pictures" / "truth", part / "seen" / "truth", fs::copy_options::recursive);
  fs::remove_all(part / "seen" / "truth" / "masks");
  std::error_code exists;
  fs::rename(part, place, exists);
  if (exists && !fs::exists(place)) throw std::runtime_error(exists.message());
  fs::remove_all(part);
  return {{"folder", job.name}};
}

fs::path SeenFolder(const fs::path& folder, const StudyOptions& options,
                    const std::string& experiment) {
  return folder / RecordingJob(options, experiment).name / "seen";
}

fs::path PictureFolder(const fs::path& folder, const StudyOptions& options,
                       const std::string& experiment) {
  return folder / RecordingJob(options, experiment).name / "pictures";
}

}  // namespace clothfit
