// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// All that a report shows of one run, before it is written down.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/report/records/run_record.h"
#include "fitting/runs/obstacles.h"
#include "fitting/runs/prediction.h"
#include "tracking/recording/surface/truth.h"

namespace clothfit {

// One simulation of the recording, open loop from frame 0.
struct Motion {
  std::string name;                        // "before", "after"
  std::string title;                       // "Start", "Fit", "Baseline", "With wind"
  std::vector<Eigen::VectorXd> positions;  // 3N, m, one a frame that it reached
};

struct ReportScene {
  RunRecord record;  // of a fit's run; empty for other folders
  FittedRun fitted;
  std::vector<Motion> motions;
  // Masks of all frames and cameras; null where there are none.
  std::shared_ptr<const Silhouettes> silhouettes;
  std::optional<Recording> pictures;  // the recording that has pictures of these cameras
  std::vector<TruthPoint> truth;      // empty where it is not known
  std::vector<std::string> notes;     // what the page has to say about itself

  const Scene& scene() const { return fitted.scene; }
};

// Where they are for the page's last motion: with what the fit found, or as the config says. Then
// those that a folder brings along.
std::vector<ObstacleSurface> ObstaclesOf(const ReportScene& report,
                                         const std::vector<ObstacleSurface>& brought = {});

// At the values that a fit begins with.
std::vector<Eigen::VectorXd> SimulateStart(const FittedRun& fitted);

// A scene whose motions are still to be filled in. Throws InputError as ReadRecording does.
ReportScene GatherReportScene(FittedRun fitted, const std::filesystem::path& pictures);

// Throws InputError, naming the file, where these are not positions of the scene's particles.
void CheckTrajectory(const std::filesystem::path& file, const Scene& scene,
                     const std::vector<Eigen::VectorXd>& trajectory);

// `pictures`: a recording's folder; empty: where the run's recording, or its origin, has them.
// Throws InputError as ReadRunRecord and ReadRecording do.
ReportScene GatherReportScene(const RunFolder& run, const std::filesystem::path& pictures);

}  // namespace clothfit
