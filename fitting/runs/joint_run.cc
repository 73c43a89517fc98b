// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/runs/joint_run.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "fitting/fit/joint_fit.h"
#include "fitting/fit/two_starts.h"
#include "fitting/runs/fit_run.h"
#include "fitting/runs/summary.h"
#include "fitting/runs/workload.h"

namespace clothfit {
namespace {

using Json = nlohmann::ordered_json;

std::vector<NamedScene> FittedOf(const std::vector<JointRecording>& recordings) {
  std::vector<NamedScene> fitted;
  for (const JointRecording& one : recordings)
    if (!one.config.hold_out) fitted.push_back({one.name, &one.scene, &one.config});
  return fitted;
}

// What is to be said of every recording, in their order.
std::vector<FitResult> ResultsOfEach(const std::vector<JointRecording>& recordings,
                                     const FitResult& all) {
  std::vector<FitResult> results;
  std::size_t next = 0;
  for (const JointRecording& one : recordings) {
    if (one.config.hold_out) {
      results.push_back(PredictRecording(one.scene, one.config, all));
    } else {
      results.push_back(all.recordings.empty() ? all : all.recordings[next++]);
    }
  }
  return results;
}

// A recording in the summary of the whole.
Json EntryOf(const JointRecording& one, const FitResult& result) {
  const Json whole = SummaryAsJson(one.scene, one.config, result);
  Json entry = {{"name", one.name},
                {"path", one.config.recording},
                {"run", RunFolder::PlaceOf(one.name).string()},
                {"held_out_whole", one.config.hold_out}};
  for (const char* key : {"cost", "fit", "held_out", "before", "frames", "noise_factor", "misfit",
                          "lack_of_support", "unknown_in_held_out_frames"})
    entry[key] = whole.at(key);
  entry["noise"] = {{"marker_m", one.scene.marker_sigma}, {"track_px", one.scene.track_sigma}};
  return entry;
}

void Write(const std::vector<JointRecording>& recordings, const RunFolder& run,
           const std::vector<RunFolder>& runs, const FitResult& all, bool is_over) {
  Json summary = JointSummaryAsJson(all);
  summary["recordings"] = Json::array();
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const JointRecording& one = recordings[i];
    if (is_over)
      WriteFit(one.scene, one.config, all.recordings[i], runs[i]);
    else
      WriteResults(one.scene, one.config, all.recordings[i], runs[i]);
    summary["recordings"].push_back(EntryOf(one, all.recordings[i]));
  }
  run.WriteParameters(all);
  run.WriteSummary(summary);
  if (is_over) run.AppendLog("status: " + ToString(all.status));
}

}  // namespace

void CheckFittableTogether(const std::vector<JointRecording>& recordings) {
  CheckJoint(FittedOf(recordings));
  Workload all;
  for (const JointRecording& one : recordings) {
    if (one.config.hold_out) continue;
    const Workload work = WorkOfFit(one.scene, one.config);
    all.bytes += work.bytes;
    all.num_free += work.num_free;
    all.num_particles = std::max(all.num_particles, work.num_particles);
  }
  CheckAffordable(recordings.front().scene, all);
}

FitResult FitIntoJointRun(const std::vector<JointRecording>& recordings, const RunFolder& run,
                          const FitCallbacks& callbacks, bool resume) {
  std::vector<RunFolder> runs;
  std::vector<JointRecording> unchecked = recordings;
  for (JointRecording& one : unchecked) {
    runs.push_back(run.OfRecording(one.name));
    runs.back().WriteConfig(one.config);
    one.config.check_intersections = false;  // only the result is worth it
  }
  std::vector<const RunFolder*> of_fitted;
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (!recordings[i].config.hold_out) of_fitted.push_back(&runs[i]);
  // As FitIntoRun keeps them.
  const JointScenes scenes(FittedOf(unchecked));
  const bool stands = resume && of_fitted.front()->HasParameters();
  FitCallbacks keeping = callbacks;
  keeping.checkpoint = [&](const FitCheckpoint& best) {
    if (stands || best.theta.size() != scenes.free().size()) return;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      WriteParametersSoFar(scenes[i].free, scenes.free().Of(i, best.theta), *of_fitted[i]);
  };
  const auto with_each = [&](FitResult all) {
    all.recordings = ResultsOfEach(unchecked, all);
    return all;
  };
  // Before another start is tried, since an interrupt leaves no time for it.
  keeping.stands = [&](const Scene&, const FitConfig&, const FitResult& first) {
    Write(recordings, run, runs, with_each(first), false);
  };
  return FitWithCheckpoint(
      run, keeping, resume,
      [&](const FitCallbacks& with_run) {
        return with_each(FitFromTwoStarts(FittedOf(unchecked), with_run));
      },
      [&](const FitResult& all) { Write(recordings, run, runs, all, true); });
}

}  // namespace clothfit
