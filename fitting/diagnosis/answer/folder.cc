// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/folder.h"

#include <algorithm>

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/answer/json_text.h"
#include "fitting/diagnosis/answer/markdown_text.h"
#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/files/npy_file.h"
#include "fitting/runs/fit_run.h"
#include "tracking/files/whole_file.h"
#include "tracking/synthetic/picture_writer.h"
#include "tracking/text/text.h"

namespace clothfit {
namespace fs = std::filesystem;
namespace {

constexpr const char* kFits = "fits/";
constexpr const char* kFit = "fit/";
constexpr const char* kMap = "missing-force.png";
constexpr const char* kCloth = "missing-force-cloth.png";
constexpr const char* kBaseline = "baseline.npy";
constexpr const char* kAnswer = "model.npy";
constexpr const char* kForce = "missing-force.npy";

void WritePoints(const std::vector<Eigen::VectorXd>& frames, const fs::path& file) {
  if (!frames.empty()) WriteWholeFile(file, PointsAsNpy(frames));
}

// The kept fits are listed as long as it is; those of version 0.1.0 one by one.
bool IsUnfinished(const fs::path& folder) {
  const std::optional<Manifest> manifest = ReadManifest(folder);
  if (!manifest || manifest->kind != FolderKind::kDiagnosis) return false;
  const std::set<std::string> files = manifest->All();
  return std::any_of(files.begin(), files.end(),
                     [](const std::string& file) { return StartsWith(file, kFits); });
}

}  // namespace

DiagnosisFolder::DiagnosisFolder(const fs::path& folder, Existing existing) : path_(folder) {
  const bool is_unfinished = IsUnfinished(folder);
  if (existing == Existing::kRefuse && is_unfinished)
    throw InputError(
        folder.string(),
        "holds an unfinished diagnosis; --resume goes on with it, --force replaces it");
  output_ = std::make_shared<OutputFolder>(folder, FolderKind::kDiagnosis, "diagnose", existing);
  const bool goes_on = existing == Existing::kResume && output_->was_there();
  if (goes_on && !is_unfinished)
    throw InputError(folder.string(),
                     "holds a finished diagnosis; there is nothing to resume, --force replaces it");
  std::vector<std::string> files = {"config.yaml", "diagnosis.json", "diagnosis.md", kMap, kCloth,
                                    kBaseline,     kAnswer,          kForce,         kFit};
  if (goes_on) {
    output_->Remove(files);
    output_->Remove({"report.html"});  // of what was known before
  }
  files.insert(files.end(), {"log.txt", kFits});
  output_->Begin(files);
  OutputFolder(KeptFits(), FolderKind::kKeptFits, "diagnose", Existing::kResume).Begin({});
  if (goes_on) {
    AppendLog(fmt::format("resumed with {} fits", NumKeptFits(KeptFits())));
  } else {
    AppendLog("clothfit diagnose");
  }
}

void DiagnosisFolder::AppendLog(const std::string& line) const {
  AppendLine(path_ / "log.txt", line);
}

void DiagnosisFolder::Write(const Diagnosis& diagnosis) const {
  const FitConfig& config = diagnosis.answer ? diagnosis.answer->config : diagnosis.baseline;
  WriteWholeFile(path_ / "config.yaml", ConfigToYaml(config));
  WriteWholeFile(path_ / "diagnosis.md", DiagnosisAsMarkdown(diagnosis));
  WriteWholeFile(path_ / "diagnosis.json", DiagnosisAsJson(diagnosis));
  WritePoints(diagnosis.motions.baseline, path_ / kBaseline);
  WritePoints(diagnosis.motions.answer, path_ / kAnswer);
  WritePoints(diagnosis.motions.missing_force, path_ / kForce);
  if (diagnosis.discrepancy_pictures) {
    WritePicture(diagnosis.discrepancy_pictures->map, path_ / kMap);
    WritePicture(diagnosis.discrepancy_pictures->cloth, path_ / kCloth);
  }
  if (diagnosis.fit) {
    const DiagnosisFit& fit = *diagnosis.fit;
    const RunFolder run(path_ / RunFolder::kOfDiagnosis, Existing::kReplace);
    run.WriteConfig(fit.config);
    WriteFit(fit.scene, fit.config, fit.result, run);
  }
  if (diagnosis.verdict != Verdict::kInterrupted) output_->Remove({kFits});
}

}  // namespace clothfit
