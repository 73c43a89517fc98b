// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/answer/folder.h"

#include <fmt/format.h>

#include "autodiff_sim/base/error.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "fitting/diagnosis/fitted/fit_runner.h"
#include "fitting/files/npy_file.h"
#include "tracking/files/whole_file.h"
#include "tracking/synthetic/picture_writer.h"

namespace clothfit {
namespace fs = std::filesystem;
namespace {

constexpr const char* kMap = "missing-force.png";
constexpr const char* kCloth = "missing-force-cloth.png";
constexpr const char* kBaseline = "baseline.npy";
constexpr const char* kAnswer = "model.npy";
constexpr const char* kForce = "missing-force.npy";

void WritePoints(const std::vector<Eigen::VectorXd>& frames, const fs::path& file) {
  if (!frames.empty()) WriteWholeFile(file, PointsAsNpy(frames));
}

}  // namespace

DiagnosisFolder::DiagnosisFolder(const fs::path& folder, Existing existing) : path_(folder) {
  const bool is_there = fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder));
  const bool is_diagnosis = fs::exists(folder / "diagnosis.json") || fs::exists(folder / "log.txt");
  if (is_there && !is_diagnosis)
    throw InputError(folder.string(),
                     "holds something else than a diagnosis; expected a new folder");
  const bool is_unfinished = is_there && fs::is_directory(KeptFits());
  if (is_there && existing == Existing::kRefuse)
    throw InputError(folder.string(),
                     is_unfinished ? "holds an unfinished diagnosis; --resume goes on with it, "
                                     "--force replaces it"
                                   : "already holds a diagnosis; --force replaces it");
  if (is_there && existing == Existing::kResume && !is_unfinished)
    throw InputError(folder.string(),
                     "holds a finished diagnosis; there is nothing to resume, --force replaces it");
  std::error_code error;
  if (existing == Existing::kReplace) fs::remove_all(KeptFits(), error);
  fs::create_directories(KeptFits(), error);
  if (is_there && existing == Existing::kResume) {
    AppendLog(fmt::format("resumed with {} fits", NumKeptFits(KeptFits())));
  } else {
    WriteWholeFile(folder / "log.txt", "clothfit diagnose\n");
  }
  for (const char* name : {"diagnosis.json", "diagnosis.md", "config.yaml", kMap, kCloth, kBaseline,
                           kAnswer, kForce, "report.html"})
    fs::remove(folder / name, error);
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
  std::error_code error;
  if (diagnosis.verdict != Verdict::kInterrupted) fs::remove_all(KeptFits(), error);
}

}  // namespace clothfit
