// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/rollout/joint_vector.h"

namespace clothfit {

int JointVector::FindShared(const std::string& name) const {
  for (int i = 0; i < size(); ++i)
    if (IsShared(i) && entries_[static_cast<std::size_t>(i)].name == name) return i;
  return -1;
}

void JointVector::Add(const std::string& name, const FreeParameters& free,
                      const std::vector<bool>& is_shared) {
  const int num_before = size();
  std::vector<int> entries;
  std::vector<double> starts(start_.data(), start_.data() + start_.size());
  for (int i = 0; i < free.size(); ++i) {
    FreeEntry entry = free.entries()[static_cast<std::size_t>(i)];
    const bool shared = is_shared[static_cast<std::size_t>(i)];
    const int found = shared ? FindShared(entry.name) : -1;
    entries.push_back(found >= 0 ? found : size());
    if (found >= 0) continue;
    if (!shared && !name.empty()) entry.name = name + "/" + entry.name;
    entries_.push_back(entry);
    is_shared_.push_back(shared);
    starts.push_back(free.start()[i]);
  }
  start_ = Eigen::Map<const Eigen::VectorXd>(starts.data(), size());
  entries_of_.push_back(std::move(entries));
  AddPrior(free, num_before);
}

// What is known of shared entries is known once: of a later recording only rows about its own
// count.
void JointVector::AddPrior(const FreeParameters& free, int num_before) {
  const std::vector<int>& entries = entries_of_.back();
  std::vector<Eigen::Index> rows;
  for (Eigen::Index row = 0; row < free.prior_jacobian().rows(); ++row) {
    bool is_new = num_before == 0;
    for (int i = 0; i < free.size(); ++i)
      is_new = is_new || (entries[static_cast<std::size_t>(i)] >= num_before &&
                          free.prior_jacobian()(row, i) != 0.0);
    if (is_new) rows.push_back(row);
  }
  const Eigen::Index first = prior_jacobian_.rows();
  const auto count = first + static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(count, size());
  jacobian.topLeftCorner(first, prior_jacobian_.cols()) = prior_jacobian_;
  jacobian.bottomRows(count - first)(Eigen::all, entries) = free.prior_jacobian()(rows, Eigen::all);
  Eigen::VectorXd target(count);
  target << prior_target_, free.prior_target()(rows);
  prior_jacobian_ = std::move(jacobian);
  prior_target_ = std::move(target);
}

Eigen::VectorXd JointVector::Of(std::size_t recording, const Eigen::VectorXd& theta) const {
  return theta(entries_of_[recording]);
}

void JointVector::PutColumns(std::size_t recording, const RowMajorMatrix& columns,
                             Eigen::Index first_row, RowMajorMatrix* all) const {
  all->middleRows(first_row, columns.rows())(Eigen::all, entries_of_[recording]) = columns;
}

}  // namespace clothfit
