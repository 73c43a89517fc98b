// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers on the cloth that a report can colour it by: one a particle and frame.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/report/scene/scene.h"

namespace clothfit {

struct ScalarField {
  std::string name, title, unit;  // unit "m", "m/s", "1", "N/m^2", ...
  bool diverging = false;         // zero is the middle of its colours
  // By the motion's name; one vector a frame, one number a particle, NaN where it is not known.
  std::map<std::string, std::vector<Eigen::VectorXd>> values;
};

// Distance from the observations: from markers and from the rays of tracks, spread over the mesh
// between them; far from any it is not known. Empty without either.
std::vector<ScalarField> ResidualField(const ReportScene& report);
// Distance of the simulated outline from the measured one, all cameras together, along the outlines
// and a little inwards; elsewhere it is not known. Empty without masks.
std::vector<ScalarField> OutlineField(const ReportScene& report);
// Largest principal strain of the triangles around each particle.
ScalarField StrainField(const ReportScene& report);
// Speed, by differences of the positions.
ScalarField SpeedField(const ReportScene& report);
// Distance from the true place of each particle. Empty where no truth is known.
std::vector<ScalarField> TruthField(const ReportScene& report);

// All of these, the most telling first.
std::vector<ScalarField> CommonFields(const ReportScene& report);

}  // namespace clothfit
