// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// clothfit fit A B ...: several recordings of one cloth in one fit.
#include <algorithm>
#include <utility>

#include "apps/commands/fits/fit_options.h"
#include "apps/commands/fits/fit_result_text.h"
#include "apps/process/exit_status.h"
#include "apps/process/interrupt.h"
#include "apps/terminal/progress_display.h"
#include "apps/terminal/terminal.h"
#include "autodiff_sim/base/error.h"
#include "autodiff_sim/base/names.h"
#include "fitting/report/records/run_record.h"
#include "fitting/report/verdict/joint_verdict.h"
#include "fitting/runs/fit_run.h"
#include "fitting/runs/joint_run.h"
#include "tracking/files/output_folder.h"
#include "tracking/outliers/outliers.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// A recording as it was given, and made ready.
struct Prepared {
  ListedRecording listed;
  Recording recording;  // before gross errors are left out
  JointRecording joint;
  bool is_tracked_first = false;  // it has pictures only
};

bool AreSame(const std::vector<ListedRecording>& a, const std::vector<ListedRecording>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ListedRecording& one, const ListedRecording& other) {
                      return one.name == other.name && one.path == other.path &&
                             one.is_held_out == other.is_held_out;
                    });
}

std::vector<ListedRecording> ListOf(const FitOptions& options) {
  if (!options.resume) return ListRecordings(options.recordings, options.hold_out);
  std::vector<ListedRecording> of_run = ReadRecordingList(options.run);
  const bool are_given = !options.recordings.empty() || !options.hold_out.empty();
  if (are_given && !AreSame(of_run, ListRecordings(options.recordings, options.hold_out)))
    throw InputError("--resume", "the recordings differ from those of the run, see " +
                                     (fs::path(options.run) / "recordings.yaml").string());
  return of_run;
}

// `source`: the recording, or what was tracked of it. A resumed run goes on as it began: its own
// config stands where no other is given.
Prepared Prepare(const ListedRecording& listed, Recording source, const FitOptions& options) {
  Prepared one{listed, std::move(source), {}, false};
  ConfigOptions own = options.config;
  if (options.resume && own.config.empty())
    own.config = (fs::path(options.run) / RunFolder::PlaceOf(listed.name) / "config.yaml").string();
  one.is_tracked_first = HasPicturesOnly(one.recording);
  FitConfig config = ReadConfigOf(own, one.recording);
  config.recording = fs::absolute(one.recording.path).lexically_normal().string();
  config.hold_out = listed.is_held_out;
  ApplyOptions(options, &config);
  Recording recording = one.recording;
  if (config.leave_out_outliers) LeaveOutOutliers(&recording);
  Scene scene = MakeScene(recording, config);
  if (one.is_tracked_first || listed.is_held_out) {
    CheckSimulable(scene);
  } else {
    CheckFittable(scene, config);
  }
  CheckContact(scene, config);
  one.joint = {listed.name, std::move(config), std::move(scene)};
  return one;
}

std::vector<JointRecording> JointOf(const std::vector<Prepared>& prepared) {
  std::vector<JointRecording> joint;
  for (const Prepared& one : prepared) joint.push_back(one.joint);
  return joint;
}

// False where it was interrupted.
bool TrackPictures(const RunFolder& run, const FitOptions& options,
                   std::vector<Prepared>* prepared) {
  for (Prepared& one : *prepared) {
    if (!one.is_tracked_first) continue;
    const std::optional<Recording> tracked =
        TrackIntoRun(one.recording, run.OfRecording(one.listed.name), options);
    if (!tracked) return false;
    one = Prepare(one.listed, *tracked, options);
  }
  return true;
}

void PrintAll(const std::vector<Prepared>& prepared) {
  for (const Prepared& one : prepared) {
    PrintOutliers(one.joint.scene.recording, one.listed.name);
    PrintWarnings(one.recording, one.listed.name);
    PrintWarnings(one.joint.scene, one.listed.name);
  }
}

FitResult FitAllWithDisplay(const std::vector<JointRecording>& recordings, const RunFolder& run,
                            const FitOptions& options) {
  int frames = 0;
  for (const JointRecording& one : recordings)
    if (!one.config.hold_out) frames += one.scene.recording.frame_count;
  ProgressDisplay display;
  FitCallbacks callbacks;
  callbacks.stop = StopOnInterrupt();
  if (!options.quiet) {
    callbacks.progress = [&](const FitProgress& progress) { display.Show(progress, frames); };
    callbacks.note = [&](const std::string& line) { display.Note(line); };
  }
  FitResult result = FitIntoJointRun(recordings, run, callbacks, options.resume);
  display.Finish();
  return result;
}

int ReportAll(const FitResult& result, const std::vector<JointRecording>& recordings,
              const RunFolder& run, bool quiet) {
  if (!quiet) {
    Print("{}\n{}\nrun: {}\n", DescribeJointResult(result, NamesOf(recordings)),
          DescribeVerdict(JudgeJointFit(ReadJointSummary(run.path()))), run.path().string());
  }
  return EndOfFit(result, run, quiet);
}

}  // namespace

bool IsOfSeveral(const FitOptions& options) {
  if (options.resume && !options.run.empty() && options.recordings.empty())
    return KindOfFolder(options.run) == FolderKind::kJointRun;
  return options.recordings.size() > 1 || !options.hold_out.empty();
}

int RunFitOfSeveral(const FitOptions& options) {
  if (options.run.empty())
    throw InputError("-o", "is missing; expected the run's folder, of several recordings");
  if (options.finest)
    throw InputError("--finest", "is for one recording; several keep their meshes");
  const std::vector<ListedRecording> listed = ListOf(options);
  std::vector<Prepared> prepared;
  std::vector<std::string> names;
  for (const ListedRecording& one : listed) {
    prepared.push_back(Prepare(one, ReadRecording(one.path), options));
    names.push_back(one.name);
  }
  CheckFittableTogether(JointOf(prepared));
  const RunFolder run =
      RunFolder::OfSeveral(options.run, ExistingIf(options.force, options.resume), names);
  if (!options.resume) WriteRecordingList(listed, run.path());
  if (!TrackPictures(run, options, &prepared)) return kExitInterrupted;
  if (options.resume) {
    for (const Prepared& one : prepared)
      RequireSameConfig(run.OfRecording(one.listed.name), one.recording, one.joint.config);
  }
  if (!options.quiet) PrintAll(prepared);
  const std::vector<JointRecording> joint = JointOf(prepared);
  return ReportAll(FitAllWithDisplay(joint, run, options), joint, run, options.quiet);
}

}  // namespace clothfit
