// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Everything that could explain what a fit leaves, ranked: one differentiated pass over all absent
// terms at their off values, against a null that is simulated again.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fitting/diagnosis/evidence/candidates.h"
#include "fitting/diagnosis/evidence/rao_score.h"
#include "fitting/diagnosis/fitted/options.h"
#include "fitting/diagnosis/fitted/rows.h"
#include "fitting/diagnosis/gate/null_residuals.h"
#include "fitting/diagnosis/rank/candidate.h"

namespace clothfit {

// A candidate as it was scored, with what is needed to switch it on.
struct RankedCandidate {
  Candidate summary;
  CandidateTerm term;              // physics only
  Probe probe;                     // the best
  std::vector<std::string> names;  // of the amounts: parameters, or faults
  Eigen::VectorXd amounts, sigma;  // in their units
  std::vector<int> columns;        // at the best probe
  std::vector<int> faults;         // indices into Ranking::faults, observation only
  std::vector<std::string> parts;  // effects that it stands for together; none: itself
  // Where a fit may begin besides.
  struct Start {
    Probe probe;
    Eigen::VectorXd amounts;
  };
  std::vector<Start> other_starts;

  // Is there so many times more of it than the null passes for?
  bool Exceeds(double detection_limits) const {
    const double limit = summary.detection_limit;
    return limit > 0.0 && amounts.norm() >= detection_limits * limit;
  }

  std::size_t NumUnknowns() const { return names.size() + probe.size() - EndsOfLine(probe).size(); }

  std::vector<std::string> Effects() const {
    return parts.empty() ? std::vector<std::string>{summary.name} : parts;
  }
};

struct Ranking {
  std::vector<RankedCandidate> candidates;  // the highest score first
  std::vector<Fault> faults;
  double gate_p_value = 1.0;          // of the residual when the faults have taken their part
  double left_rms = 0.0;              // root mean square of the same, in sigmas
  std::vector<double> null_left_rms;  // the same of every draw of the null
  double unexplained = 0.0;           // the same in sums of squares, above that of the null
  double residual_rms = 0.0,
         discretisation_rms = 0.0;  // in sigmas: of all rows, and of the twins, D_0
  double null_mean = 0.0;           // sum of squares that the null leaves
  // The most that all candidates together could take of it, above what they take of the null.
  double explainable = 0.0;
  double promised = 0.0;  // share of the sum that a full step of the baseline's own fit would take
  int num_rows = 0;
  Extent extent;
  // Cosine of two candidates' effects after projection; 0 for observation faults.
  double Cosine(const RankedCandidate& a, const RankedCandidate& b) const;
  std::optional<Projection> projection;
  // The discretisation errors of the fit: for a later ranking or location on the same mesh and
  // step.
  std::shared_ptr<const DiscretisationErrors> errors;
  // D_h, their part in a prediction of held-out frames, root mean square; 0 where it is not known.
  double PredictionError() const { return errors ? errors->held_out_rms : 0.0; }
};

// What is known before a ranking.
struct RankingStart {
  std::shared_ptr<const DiscretisationErrors> errors;  // null: measured
  CandidateSet set = CandidateSet::kCatalogue;
  int draws = 3;        // of the discretisation error, where it is measured
  int probes = 8;       // places, times and shapes of a candidate that are looked at first
  int refinements = 2;  // of the best ones' places and shapes
};

// Forecasts are held to noise alone, without their discretisation error.
// Throws std::runtime_error where the fitted scene cannot be simulated.
Ranking RankCandidates(const FittedScene& fitted, const DiagnosisOptions& options,
                       const RankingStart& start = {});

}  // namespace clothfit
