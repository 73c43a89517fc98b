// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Two fits that are compared: of one recording, or of two.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fitting/report/scene/frame_misfit.h"
#include "fitting/report/scene/scene.h"
#include "fitting/report/verdict/page_verdict.h"

namespace clothfit {

struct PairedRun {
  std::string name;   // what tells it from the other: the end of its folder's path
  ReportScene scene;  // with one motion, the fit's
  VerdictFacts facts;
  PageVerdict verdict;               // of this run alone
  std::vector<FrameMisfit> misfits;  // on its own mesh, one a frame
};

struct RunPair {
  PairedRun first, second;
  bool is_one_recording = false;
};

// Runs of `fit`, or what `diagnose` wrote. `pictures`: as for GatherReportScene. Throws InputError
// where one of them is no such folder, is incomplete, or where both are the same run.
RunPair ReadRunPair(const std::filesystem::path& folder, const std::filesystem::path& other,
                    const std::filesystem::path& pictures);

// The shortest ends of two paths that differ; of one folder in two places "a/fit" and "b/fit".
std::array<std::string, 2> NamesApart(const std::filesystem::path& folder,
                                      const std::filesystem::path& other);

// An error of one kind of both runs, over the fitted or the held-out frames. In m or px.
struct PairedError {
  std::string kind;
  bool held_out = false;
  std::string unit;
  std::optional<double> first, second;
};
std::vector<PairedError> PairErrors(const VerdictFacts& first, const VerdictFacts& second);

// A physical parameter that at least one of two runs has found.
struct PairedParameter {
  struct Side {
    std::optional<double> value;
    std::optional<std::array<double, 2>> interval;  // 95 %
    bool is_free = false, is_determined = false, is_at_bound = false;
  };
  std::string name, doc, unit;
  bool is_log = false;
  std::array<double, 2> bounds = {0.0, 0.0};  // that hold those of both
  Side first, second;
  // From the first to the second: of one on a logarithmic scale the natural logarithm of their
  // ratio. Empty where one of the two is not known.
  std::optional<double> difference;
  // In half widths of the difference's 95 % interval, that of two independent estimates: beyond 1
  // the two disagree. Empty where a run has not determined it.
  std::optional<double> in_joint_intervals;

  bool Disagrees() const { return in_joint_intervals && std::abs(*in_joint_intervals) > 1.0; }
};
std::vector<PairedParameter> PairParameters(const ReportScene& first, const ReportScene& second);

// What their configs say differently, but for the recording.
std::vector<ConfigDifference> DifferentSettings(const RunPair& pair);

// Who predicts better, by how much, and what else differs.
PageVerdict JudgePair(const RunPair& pair, const std::vector<PairedParameter>& parameters);

}  // namespace clothfit
