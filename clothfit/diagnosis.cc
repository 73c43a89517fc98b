// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "clothfit/diagnosis.h"

#include <optional>
#include <utility>

#include "clothfit/detail/boundary.h"
#include "clothfit/detail/data.h"
#include "fitting/diagnosis/answer/folder.h"
#include "fitting/diagnosis/answer/headline.h"
#include "fitting/diagnosis/pipeline/diagnose.h"
#include "fitting/runs/fit_run.h"
#include "tracking/outliers/outliers.h"

namespace clothfit::v0 {
namespace {

Model ToModel(const clothfit::Model& model) {
  Model result;
  result.effects = model.effects;
  for (const EffectParameter& p : model.parameters)
    result.amounts.push_back({p.name, p.unit, p.value, p.lower90, p.upper90});
  result.log_evidence = model.log_evidence;
  result.explained = model.explained;
  result.kept = model.is_kept;
  return result;
}

Diagnosis ToDiagnosis(const clothfit::Diagnosis& found) {
  const FitConfig& config = found.answer ? found.answer->config : found.baseline;
  Diagnosis diagnosis{ToString(found.verdict),
                      HeadlineOf(found),
                      found.words,
                      found.effects,
                      found.confidence_set,
                      found.sets_beside,
                      found.residual_rms,
                      found.discretisation_rms,
                      {},
                      {},
                      Config(std::make_unique<ConfigData>(ConfigData{config}))};
  for (const clothfit::Candidate& c : found.ranking)
    diagnosis.candidates.push_back(
        {c.name, c.kind == CandidateKind::kPhysics, c.share, c.p_value, c.is_short_listed});
  for (const clothfit::Model& model : found.models) diagnosis.models.push_back(ToModel(model));
  return diagnosis;
}

clothfit::DiagnosisOptions ToInternal(const DiagnosisOptions& options) {
  clothfit::DiagnosisOptions all;
  all.excluded = options.exclude;
  all.max_effects = options.max_effects;
  all.max_models = options.max_models;
  all.finest_side = options.finest_side;
  all.progress = options.callbacks.progress;
  all.stop = options.callbacks.stop;
  return all;
}

}  // namespace

Diagnosis Diagnose(const Recording& recording, const Config& config,
                   const DiagnosisOptions& options) {
  return AtBoundary([&] {
    clothfit::Recording used = recording.data().recording;
    const FitConfig& given = config.data().config;
    given.Check("config");
    if (given.leave_out_outliers) LeaveOutOutliers(&used);
    CheckFittable(MakeScene(used, given), given);
    clothfit::DiagnosisOptions all = ToInternal(options);
    std::optional<DiagnosisFolder> folder;
    if (!options.folder.empty()) {
      folder.emplace(options.folder, ToInternal(options.existing));
      all.kept_fits = folder->KeptFits();
      all.log = [&folder](const std::string& line) { folder->AppendLog(line); };
    }
    const clothfit::Diagnosis found = clothfit::Diagnose(used, given, all);
    if (folder) folder->Write(found);
    return ToDiagnosis(found);
  });
}

}  // namespace clothfit::v0
