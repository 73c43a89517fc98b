// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/batch/batch.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "fitting/runs/fit_run.h"
#include "tracking/features/tracking_folder.h"
#include "tracking/files/part_folder.h"
#include "tracking/files/whole_file.h"
#include "tracking/outliers/outliers.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

// What a table says of how well a run explains its recording: JSON's name, title, and the value.
struct ResultColumn {
  const char *name, *title;
  std::optional<double> (*value)(const FitResult& result);
};

template <std::optional<double> Evaluation::*kMember, int kFactor = 1>
std::optional<double> ErrorOf(const FitResult& result) {
  const std::optional<double>& error = result.after.*kMember;
  return error ? std::optional<double>(kFactor * *error) : std::nullopt;
}

template <double Misfit::*kMember>
std::optional<double> MisfitOf(const FitResult& result) {
  return result.misfit ? std::optional<double>((*result.misfit).*kMember) : std::nullopt;
}

constexpr ResultColumn kColumns[] = {
    {"marker_mm", "markers, mm", ErrorOf<&Evaluation::marker_rms, 1000>},
    {"held_out_marker_mm", "held out", ErrorOf<&Evaluation::held_out_marker_rms, 1000>},
    {"track_px", "tracks, px", ErrorOf<&Evaluation::track_rms>},
    {"held_out_track_px", "held out", ErrorOf<&Evaluation::held_out_track_rms>},
    {"cloud_mm", "clouds, mm", ErrorOf<&Evaluation::cloud_rms, 1000>},
    {"held_out_cloud_mm", "held out", ErrorOf<&Evaluation::held_out_cloud_rms, 1000>},
    {"silhouette_px", "silhouettes, px", ErrorOf<&Evaluation::silhouette_error>},
    {"held_out_silhouette_px", "held out", ErrorOf<&Evaluation::held_out_silhouette_error>},
    {"chi_square", "chi-square", MisfitOf<&Misfit::chi_square>},
    {"chi_square_limit", "of noise, at most", MisfitOf<&Misfit::limit>}};

Recording TrackInto(const RunFolder& run, const Recording& recording, const JobContext& context) {
  const fs::path folder = run.path() / "observations";
  run.Add({"observations/"});
  TrackingOptions options;
  options.num_threads = 1;
  TrackingCallbacks callbacks;
  callbacks.stop = context.stop;
  const TrackingResult found =
      TrackIntoFolder(recording, options, folder, Overwrite::kRefuse, callbacks);
  if (found.num_frames < recording.frame_count) throw std::runtime_error("stopped");
  return ReadRecording(folder);
}

nlohmann::json ToJson(const FitResult& result) {
  nlohmann::json json = {{"status", ToString(result.status)},
                         {"iterations", result.iterations},
                         {"simulations", result.simulations}};
  for (const ResultColumn& column : kColumns) {
    const std::optional<double> value = column.value(result);
    json[column.name] = value ? nlohmann::json(*value) : nlohmann::json();
  }
  json["parameters"] = nlohmann::json::array();
  for (const ParameterEstimate& one : result.estimates) {
    if (!one.free) continue;
    json["parameters"].push_back({{"name", one.name},
                                  {"unit", one.unit},
                                  {"value", one.value},
                                  {"lower95", one.lower95},
                                  {"upper95", one.upper95},
                                  {"determined", one.determined}});
  }
  return json;
}

// `place`: where the folder is moved to afterwards.
FitResult FitInto(const fs::path& folder, const fs::path& place, const BatchFit& fit,
                  const JobContext& context) {
  const RunFolder run(folder, RunFolder::Existing::kRefuse);
  Recording recording = ReadRecording(fit.recording);
  const bool track = recording.markers.empty() && recording.tracks.empty() &&
                     !HasClouds(recording) && HasPictures(recording);
  if (track) recording = TrackInto(run, recording, context);
  FitConfig config = BatchConfig(fit, recording);
  if (config.leave_out_outliers) LeaveOutOutliers(&recording);
  const std::string outliers = DescribeOutliers(recording);
  if (!outliers.empty()) run.AppendLog("left out as gross errors: " + outliers);
  if (track) config.recording = fs::absolute(place / "observations").lexically_normal().string();
  const Scene scene = MakeScene(recording, config);
  CheckFittable(scene, config);
  CheckContact(scene, config);
  FitCallbacks callbacks;
  callbacks.stop = context.stop;
  return FitIntoRun(scene, config, run, callbacks, false).result;
}

std::string Cell(const nlohmann::json& value, bool markdown) {
  if (value.is_null()) return markdown ? "-" : "";
  return markdown ? fmt::format("{:.3g}", value.get<double>()) : FormatNumber(value.get<double>());
}

}  // namespace

JobFolderContents BatchContents(const std::vector<BatchFit>& fits, std::string description) {
  JobFolderContents contents;
  contents.kind = FolderKind::kBatch;
  contents.list.command = "batch";
  contents.file = "batch.yaml";
  contents.description = std::move(description);
  contents.files = {"batch.csv", "parameters.csv", "batch.md"};
  for (const BatchFit& fit : fits) {
    contents.list.jobs.push_back({fit.name, fit});
    contents.files.push_back("runs/" + fit.name + "/");
  }
  return contents;
}

JobPlan BatchPlan(JobList list, const fs::path& folder) {
  JobPlan plan;
  plan.list = std::move(list);
  plan.work = [folder](const Job& job, const JobContext& context) {
    auto fit = job.input.get<BatchFit>();
    fit.name = job.name;
    return RunBatchFit(folder, fit, context);
  };
  plan.report = [folder](const std::vector<JobResult>& results) {
    return WriteBatchTables(folder, results);
  };
  return plan;
}

nlohmann::json RunBatchFit(const fs::path& folder, const BatchFit& fit, const JobContext& context) {
  const fs::path place = folder / "runs" / fit.name;
  PartFolder part(place);
  const FitResult result = FitInto(part.path(), place, fit, context);
  part.MoveToPlace();
  if (result.status == FitStatus::kFailed)
    throw std::runtime_error("the simulation diverges, see " + (place / "log.txt").string());
  return ToJson(result);
}

std::string WriteBatchTables(const fs::path& folder, const std::vector<JobResult>& results) {
  std::string csv = "name,status,simulations", parameters =
                                                   "name,parameter,unit,value,lower95,upper95,"
                                                   "determined\n";
  std::string text = "| fit | status | simulations | s |", line = "|---|---|---:|---:|";
  for (const ResultColumn& column : kColumns) {
    csv += fmt::format(",{}", column.name);
    text += fmt::format(" {} |", column.title);
    line += "---:|";
  }
  csv += "\n";
  text += "\n" + line + "\n";
  for (const JobResult& result : results) {
    if (!result.IsDone()) {
      csv += result.name + ",failed" + std::string(1 + std::size(kColumns), ',') + "\n";
      text += fmt::format("| {} | failed: {} |\n", result.name, result.problem);
      continue;
    }
    const nlohmann::json& output = result.output;
    const auto status = output.at("status").get<std::string>();
    const int simulations = output.at("simulations");
    csv += fmt::format("{},{},{}", result.name, status, simulations);
    text +=
        fmt::format("| {} | {} | {} | {:.1f} |", result.name, status, simulations, result.seconds);
    for (const ResultColumn& column : kColumns) {
      csv += "," + Cell(output.at(column.name), false);
      text += " " + Cell(output.at(column.name), true) + " |";
    }
    csv += "\n";
    text += "\n";
    for (const nlohmann::json& one : output.at("parameters")) {
      parameters +=
          fmt::format("{},{},{},{},{},{},{}\n", result.name, one.at("name").get<std::string>(),
                      one.at("unit").get<std::string>(), Cell(one.at("value"), false),
                      Cell(one.at("lower95"), false), Cell(one.at("upper95"), false),
                      one.at("determined").get<bool>());
    }
  }
  WriteWholeFile(folder / "batch.csv", csv);
  WriteWholeFile(folder / "parameters.csv", parameters);
  WriteWholeFile(folder / "batch.md", text);
  return text;
}

}  // namespace clothfit
