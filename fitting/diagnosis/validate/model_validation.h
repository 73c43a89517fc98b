// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether a model predicts frames better that its fit has not seen.
#pragma once

#include <optional>

#include "fitting/diagnosis/model/screening.h"
#include "fitting/diagnosis/validate/held_out_validation.h"

namespace clothfit {

// What a model is held against. All must outlive it.
struct ValidationStart {
  const FittedScene& before;  // the fit without what the model has
  const HeldOutErrors& errors;
  const Ranking& ranking;  // of what is missing in that fit
  const DiagnosisOptions& options;
};

// On the frames that are held out. A camera is put right where it looks: by its own tracks, where
// there are markers, too.
HeldOutValidation ValidateOnHeldOut(const FittedModel& model, const ValidationStart& start);

// Where the held-out frames alone do not validate it: against recordings of the fit without it,
// else on earlier frames, both below. Empty where neither validates it, and for faults.
std::optional<HeldOutValidation> ValidateOtherwise(const FittedModel& model,
                                                   const ValidationStart& start);

// On the held-out frames or, where those alone do not validate it and a validation is asked for,
// otherwise.
HeldOutValidation ValidateByAnyTest(const FittedModel& model, const ValidationStart& start);

// On the second half of the fitted frames, predicted by both after a fit to the first half alone,
// begun from where they are. For physics that the held-out frames cannot show either way, since the
// motion has come to rest by then, or a gust is over. Empty where they do show that the model is
// worse, or where its error is higher there by a twentieth, where they are not the last ones, and
// where a fit fails.
// `by_chance` (m or px): what predictions of recordings of the fit without the model gain by it,
// where that is known; else the prediction has to improve by all that mesh and step do to it.
std::optional<HeldOutValidation> ValidateOnEarlier(const FittedModel& model,
                                                   const ValidationStart& start,
                                                   std::optional<double> by_chance = {});

// Against recordings of the fit without the model, simulated finer (TwinRecording): both are fitted
// to them, too, and what the model gains there is what mesh and step let it gain. For physics whose
// improvement is less than what mesh and step do to the prediction itself, which is mostly the same
// in both. Proven is what gains more in the fitted frames than in any of them, and whose prediction
// improves by more. Empty where there are neither markers nor tracks, where mesh and step alone
// leave more than the recording does or the fit is hopelessly far off, where the prediction does
// not improve, and where every fit fails.
std::optional<HeldOutValidation> ValidateOnTwins(const FittedModel& model,
                                                 const ValidationStart& start);

}  // namespace clothfit
