// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/small_diagnosis.h"

#include <cmath>

#include "fitting/diagnosis/answer/folder.h"
#include "fitting/diagnosis/answer/summary_text.h"
#include "fitting/files/npy_file.h"
#include "tests/support/small_run.h"

namespace clothfit {
namespace {

namespace fs = std::filesystem;

Candidate MakeCandidate(const std::string& name, double score, bool is_short_listed) {
  Candidate candidate;
  candidate.name = name;
  candidate.parameters = {{name + ".x", "m/s", 1.0, 0.5, 1.5}};
  candidate.score = score;
  candidate.raw_score = 0.5 * score;
  candidate.share = score / 100.0;
  candidate.p_value = candidate.q_value = is_short_listed ? 1e-9 : 0.5;
  candidate.is_short_listed = is_short_listed;
  candidate.why_not = is_short_listed ? "" : "the null does as much with p = 0.5";
  return candidate;
}

Model MakeModel(const FitConfig& config, const std::string& effect, bool is_kept) {
  Model model;
  model.effects = {effect};
  model.config = config;
  model.parameters = {{effect + ".x", "m/s", 1.0, 0.5, 1.5},
                      {effect + ".y", "m/s", 0.0, -0.1, 0.1},
                      {effect + ".z", "m/s", 0.0, -0.1, 0.1}};
  model.explained = 0.8;
  model.validation = {0.02, 0.01, 0.008, 0.0017, 0.003, true, false, false};
  model.is_kept = is_kept;
  return model;
}

}  // namespace

fs::path MakeSmallDiagnosis(const fs::path& folder) {
  const fs::path run = MakeSmallRun(folder);
  const Recording recording = ReadRecording(folder / "rec");
  Diagnosis diagnosis;
  diagnosis.verdict = Verdict::kNamed;
  diagnosis.baseline = DefaultConfig(recording);
  ReadConfig(run / "config.yaml", &diagnosis.baseline);
  diagnosis.baseline.recording = (folder / "rec").string();
  diagnosis.residual_rms = 1.4;
  diagnosis.discretisation_rms = 0.2;
  diagnosis.gate_p_value = 1e-6;
  diagnosis.left_rms = 1.35;
  for (int k = 0; k < 400; ++k) diagnosis.null_left_rms.push_back(1.0 + 0.04 * std::sin(k));
  diagnosis.discrepancy.emplace();
  diagnosis.discrepancy->is_significant = true;
  diagnosis.discrepancy->low_uv = diagnosis.discrepancy->high_uv = Eigen::Vector2d::Zero();
  diagnosis.discrepancy->direction = Eigen::Vector3d::UnitX();
  diagnosis.discrepancy->words = "The middle is pushed along +x.";
  diagnosis.discrepancy_class.emplace();
  diagnosis.discrepancy_class->words = "It comes from outside.";
  diagnosis.ranking = {MakeCandidate("wind", 90.0, true), MakeCandidate("gust", 88.0, true),
                       MakeCandidate("hem", 2.0, false)};
  diagnosis.models = {MakeModel(diagnosis.baseline, "wind", true),
                      MakeModel(diagnosis.baseline, "gust", false)};
  diagnosis.answer = diagnosis.models[0];
  diagnosis.effects = {"wind"};
  diagnosis.confidence_set = {"wind", "gust"};
  diagnosis.separating = {"twice as fast", 0.012, 0.003};
  diagnosis.words = DescribeDiagnosis(diagnosis);
  diagnosis.seconds = {{"baseline", 1.0}, {"ranking", 2.0}};
  diagnosis.motions.answer = ReadPointsNpy(run / "trajectory.npy");
  diagnosis.motions.baseline = diagnosis.motions.answer;
  for (Eigen::VectorXd& x : diagnosis.motions.baseline) x.array() += 0.01;
  diagnosis.motions.missing_force.assign(
      9, Eigen::VectorXd::Constant(diagnosis.motions.answer[0].size(), 0.1));
  diagnosis.motions.resolution = {5, 5};
  diagnosis.motions.held_out = Splits::FrameRange{8, 11};
  const DiagnosisFolder written(folder / "diagnosis", DiagnosisFolder::Existing::kRefuse);
  written.Write(diagnosis);
  return written.path();
}

}  // namespace clothfit
