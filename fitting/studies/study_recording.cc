// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/study_recording.h"

#include <stdexcept>

#include <fmt/format.h>

#include "tracking/features/tracking_folder.h"
#include "tracking/files/output_folder.h"
#include "tracking/files/part_folder.h"
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

// All but the masks.
void CopyTruth(const fs::path& from, const fs::path& to) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(from / "truth"))
    if (entry.is_regular_file()) files.push_back("truth/" + entry.path().filename().string());
  OutputFolder(to, FolderKind::kRecording, "study", Existing::kResume).Begin(files);
  for (const std::string& file : files) fs::copy_file(from / file, to / file);
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
  PartFolder part(place);  // another study may make the same one
  const fs::path pictures = part.path() / "pictures", seen = part.path() / "seen";
  Synthesize(RecordingOptions(job.input), pictures, Overwrite::kRefuse);
  TrackingOptions options;
  options.num_threads = 1;
  TrackingCallbacks callbacks;
  callbacks.stop = context.stop;
  TrackIntoFolder(ReadRecording(pictures), options, seen, Overwrite::kRefuse, callbacks);
  if (context.stop != nullptr && *context.stop) throw std::runtime_error("stopped");
  CopyTruth(pictures, seen);
  part.MoveToFreePlace();
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
