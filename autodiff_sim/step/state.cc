// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Derivatives in blocks of lanes.
#include "autodiff_sim/step/state.h"

#include <algorithm>

namespace clothfit {

Sensitivity::Sensitivity(const State& state, const Eigen::MatrixXd& parameter_directions)
    : parameters_(parameter_directions) {
  lanes_.resize(static_cast<std::size_t>((num_directions() + kLanes - 1) / kLanes));
  for (StateLanes& lane : lanes_) {
    for (Lanes<kLanes>* part : {&lane.x, &lane.v, &lane.previous_x, &lane.previous_v}) {
      part->setZero(state.x.size(), kLanes);
    }
    lane.memory.setZero(state.memory.size(), kLanes);
  }
}

namespace {

Eigen::MatrixXd Gather(const std::vector<StateLanes>& lanes, int directions,
                       Lanes<kLanes> StateLanes::*part) {
  if (lanes.empty()) return {};
  Eigen::MatrixXd all((lanes.front().*part).rows(), directions);
  for (int c = 0; c < directions; c += kLanes) {
    const int count = std::min(kLanes, directions - c);
    all.middleCols(c, count) = (lanes[c / kLanes].*part).leftCols(count);
  }
  return all;
}

}  // namespace

double Sensitivity::ActiveShare() const {
  const auto active = std::count_if(lanes_.begin(), lanes_.end(),
                                    [](const StateLanes& lanes) { return !lanes.is_zero; });
  return lanes_.empty() ? 0.0 : static_cast<double>(active) / static_cast<double>(lanes_.size());
}

Eigen::MatrixXd Sensitivity::x() const { return Gather(lanes_, num_directions(), &StateLanes::x); }
Eigen::MatrixXd Sensitivity::v() const { return Gather(lanes_, num_directions(), &StateLanes::v); }

void Sensitivity::Move(const Eigen::VectorXd& amounts, State* state) const {
  for (int c = 0; c < num_directions(); c += kLanes) {
    const int count = std::min(kLanes, num_directions() - c);
    const StateLanes& lane = lanes_[c / kLanes];
    const Eigen::VectorXd part = amounts.segment(c, count);
    state->x += lane.x.leftCols(count) * part;
    state->v += lane.v.leftCols(count) * part;
    state->memory += lane.memory.leftCols(count) * part;
    state->previous_x += lane.previous_x.leftCols(count) * part;
    state->previous_v += lane.previous_v.leftCols(count) * part;
  }
}

void Sensitivity::SetInitial(const Eigen::MatrixXd& dx, const Eigen::MatrixXd& dv) {
  for (int c = 0; c < num_directions(); c += kLanes) {
    const int count = std::min(kLanes, num_directions() - c);
    StateLanes& lane = lanes_[c / kLanes];
    lane.x.leftCols(count) = dx.middleCols(c, count);
    lane.v.leftCols(count) = dv.middleCols(c, count);
    lane.is_zero = lane.x.isZero(0.0) && lane.v.isZero(0.0);
  }
}

}  // namespace clothfit
