// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/run.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "apps/report/assets.h"
#include "autodiff_sim/base/names.h"
#include "clothfit/detail/boundary.h"
#include "clothfit/detail/data.h"
#include "fitting/export/export.h"
#include "fitting/report/page/file.h"
#include "fitting/report/report.h"
#include "fitting/report/verdict/facts.h"
#include "fitting/runs/fit_run.h"
#include "tracking/outliers/outliers.h"
#include "tracking/recording/folder/validation.h"

namespace clothfit::v0 {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// As ReadQueries does of the rows of a file.
void CheckQueries(const std::vector<PredictionQuery>& queries, const Scene& scene) {
  constexpr double kSlack = 1e-6;  // of a triangle: rounding
  std::vector<Eigen::Vector2d> uv;
  for (const PredictionQuery& query : queries) {
    const std::string place = fmt::format("point {}", query.line);
    CheckFrame(scene.recording, query.frame, place);
    CheckOnCloth(scene.recording, query.uv, place);
    uv.push_back(query.uv);
  }
  const std::vector<SurfacePoint> points = LocateOnCloth(scene.mesh, uv);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& weights = points[i].weights;
    if (*std::min_element(weights.begin(), weights.end()) < -kSlack)
      throw InputError(
          fmt::format("point {}: (u, v) = ({}, {}) is outside the cloth", i, uv[i].x(), uv[i].y()));
  }
}

std::shared_ptr<const RunData> Load(const fs::path& folder, FittedRun fitted,
                                    std::shared_ptr<const PassingFolder> passing) {
  RunRecord record = ReadRunRecord(RunFolder::Open(folder));
  PageVerdict verdict = JudgeFit(FactsOf(record));
  const ClothMesh& mesh = fitted.scene.mesh;
  Array trajectory = ToFrames(record.trajectory, mesh.num_particles());
  record.trajectory.clear();
  Array uv = ToRows(mesh.uv, 2);
  return std::make_shared<const RunData>(RunData{folder, std::move(record), std::move(verdict),
                                                 std::move(fitted), std::move(trajectory),
                                                 std::move(uv), std::move(passing)});
}

FitCallbacks ToFitCallbacks(const Callbacks& callbacks) {
  FitCallbacks all;
  all.stop = callbacks.stop;
  if (callbacks.progress) {
    all.progress = [&callbacks](const FitProgress& progress) {
      callbacks.progress(progress.stage, progress.fraction);
    };
  }
  return all;
}

// A run names its recording's folder: one that was made in memory is written into the run.
void KeepRecording(const RunFolder& run, const Recording& recording, FitConfig* config) {
  const fs::path folder = run.path() / "recording";
  run.Add({"recording/"});
  recording.Write(folder.string(), Existing::kReplace);
  config->recording = fs::absolute(folder).lexically_normal().string();
}

Run FitInto(const fs::path& folder, const Recording& recording, FitConfig config,
            const FitOptions& options, std::shared_ptr<const PassingFolder> passing) {
  clothfit::Recording used = recording.data().recording;
  config.Check("config");
  ForgetChosenMesh(&config);
  if (config.leave_out_outliers) LeaveOutOutliers(&used);
  Scene scene = MakeScene(used, config);
  CheckFittable(scene, config);
  CheckContact(scene, config);
  {
    const RunFolder run(folder, ToInternal(options.existing));
    config.recording = used.path.string();
    if (used.path.empty()) KeepRecording(run, recording, &config);
    if (options.existing == Existing::kResume) RequireSameConfig(run, used, config);
    const FitOnMesh fit = FitIntoRun(scene, config, run, ToFitCallbacks(options.callbacks),
                                     options.existing == Existing::kResume);
    if (fit.result.status == FitStatus::kFailed)
      throw std::runtime_error("the fit failed: the simulation diverges at the start");
    config = fit.config;
    if (fit.scene) scene = *fit.scene;
  }
  return Run(Load(folder, {std::move(config), std::move(scene)}, std::move(passing)));
}

std::optional<double> NumberOf(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

Errors ErrorsOf(const Json& object) {
  return {NumberOf(object, "marker_rms_m"), NumberOf(object, "track_rms_px"),
          NumberOf(object, "cloud_rms_m"), NumberOf(object, "silhouette_error_px")};
}

double NumberOrNan(const Json& json) { return json.is_number() ? json.get<double>() : NAN; }

}  // namespace

PassingFolder::PassingFolder() {
  std::string name = (fs::temp_directory_path() / "clothfit-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
  path = name;
}

PassingFolder::~PassingFolder() {
  std::error_code ignored;
  fs::remove_all(path, ignored);
}

Array ToFrames(const std::vector<Eigen::VectorXd>& frames, int num_particles) {
  Array array;
  array.shape = {frames.size(), static_cast<std::size_t>(num_particles), 3};
  array.values.reserve(frames.size() * static_cast<std::size_t>(3 * num_particles));
  for (const Eigen::VectorXd& x : frames)
    array.values.insert(array.values.end(), x.data(), x.data() + x.size());
  return array;
}

Run Fit(const Recording& recording, const Config& config, const FitOptions& options) {
  return AtBoundary([&] {
    const FitConfig& given = config.data().config;
    if (!options.folder.empty()) return FitInto(options.folder, recording, given, options, nullptr);
    const auto passing = std::make_shared<const PassingFolder>();
    return FitInto(passing->path / "run", recording, given, options, passing);
  });
}

Run::Run(std::shared_ptr<const RunData> data) : data_(std::move(data)) {}

Run Run::Read(const std::string& folder) {
  return AtBoundary(
      [&] { return Run(Load(folder, ReadFittedRun(RunFolder::Open(folder)), nullptr)); });
}

std::string Run::folder() const { return data_->folder.string(); }
std::string Run::status() const { return data_->record.summary.at("status").get<std::string>(); }
std::string Run::verdict() const { return data_->verdict.headline; }
std::vector<std::string> Run::sentences() const { return data_->verdict.sentences; }
double Run::seconds() const { return data_->record.summary.value("seconds", 0.0); }
Errors Run::fitted() const { return ErrorsOf(data_->record.summary.at("fit")); }
Errors Run::held_out() const { return ErrorsOf(data_->record.summary.at("held_out")); }
const Array& Run::trajectory() const { return data_->trajectory; }
const Array& Run::uv() const { return data_->uv; }
const std::vector<std::array<int, 3>>& Run::triangles() const {
  return data_->fitted.scene.mesh.triangles;
}

std::vector<Estimate> Run::estimates() const {
  std::vector<Estimate> estimates;
  for (const auto& [name, json] : data_->record.summary.at("parameters").items()) {
    Estimate estimate{name, json.value("unit", ""), NumberOrNan(json.at("value")),
                      NumberOrNan(json.at("start")), json.value("free", false)};
    if (estimate.free) {
      estimate.lower = NumberOrNan(json.at("interval").at(0));
      estimate.upper = NumberOrNan(json.at("interval").at(1));
      estimate.determined = json.value("determined", false);
      estimate.at_bound = json.value("at_bound", false);
    }
    estimates.push_back(std::move(estimate));
  }
  return estimates;
}

double Run::Value(const std::string& parameter) const {
  std::vector<std::string> names;
  for (const Estimate& estimate : estimates()) {
    if (estimate.name == parameter) return estimate.value;
    names.push_back(estimate.name);
  }
  throw InputError("'" + parameter + "': " + Suggestion(parameter, names));
}

Array Run::Predict(const std::vector<int>& frame, const std::vector<Vector2>& uv) const {
  return AtBoundary([&] {
    if (frame.size() != uv.size())
      throw InputError(fmt::format("predict: {} frames for {} points; expected as many",
                                   frame.size(), uv.size()));
    std::vector<PredictionQuery> queries;
    for (std::size_t i = 0; i < uv.size(); ++i)
      queries.push_back({frame[i], ToEigen(uv[i]), static_cast<int>(i)});
    CheckQueries(queries, data_->fitted.scene);
    return ToRows(clothfit::Predict(data_->fitted, RunFolder::Open(data_->folder), queries), 3);
  });
}

void Run::Report(const std::string& file, Existing existing) const {
  AtBoundary([&] {
    PageFile page(file, ToOverwrite(existing));
    page.Write(MakeReport(RunFolder::Open(data_->folder), PageAssets()).html);
  });
}

void Run::Export(const std::string& format, const std::string& file, Existing existing) const {
  AtBoundary([&] {
    const std::vector<std::string> names = NamesOf(ExportFormats());
    if (std::find(names.begin(), names.end(), format) == names.end())
      throw InputError("format: '" + format + "': " + Suggestion(format, names));
    ExportRun(RunFolder::Open(data_->folder), format, {}, file, ToOverwrite(existing));
  });
}

}  // namespace clothfit::v0
