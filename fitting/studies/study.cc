// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/studies/study.h"

#include <algorithm>
#include <utility>

namespace clothfit {

std::vector<Study> Studies() {
  return {AttractionStudy(), ReconstructionStudy(), LocalParameterStudy(),
          AugmentedStudy(),  CameraStudy(),         RuntimeStudy(),
          OptimiserStudy(),  GradientStudy(),       ContactStudy()};
}

std::vector<DoneFit> DoneFits(const std::vector<Job>& jobs, const std::vector<JobResult>& results) {
  std::vector<DoneFit> done;
  for (const Job& job : jobs) {
    for (const JobResult& result : results) {
      if (result.name == job.name) done.push_back({StudyFitOf(job), ReadStudyFit(result.output)});
    }
  }
  return done;
}

const DoneFit* FindFit(const std::vector<DoneFit>& fits,
                       const std::function<bool(const StudyFit&)>& matches) {
  const auto found =
      std::find_if(fits.begin(), fits.end(), [&](const DoneFit& one) { return matches(one.fit); });
  return found == fits.end() ? nullptr : &*found;
}

std::vector<double> ValuesOr(const StudyOptions& options, std::vector<double> reduced,
                             std::vector<double> full) {
  if (!options.values.empty()) return options.values;
  return options.full ? std::move(full) : std::move(reduced);
}

}  // namespace clothfit
