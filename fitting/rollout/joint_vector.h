// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The vector that a fit of several recordings moves: what they share once, and what each has of its
// own.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "fitting/optimise/row_major_matrix.h"
#include "fitting/rollout/free_parameters.h"

namespace clothfit {

class JointVector : public FreeVector {
 public:
  // Adds a recording: of the first all entries in their order, so that one recording alone has the
  // vector that it has without this; of each other those that no recording before it shares.
  // is_shared: of its entries. Entries of its own are called NAME/..., where `name` is not empty.
  void Add(const std::string& name, const FreeParameters& free, const std::vector<bool>& is_shared);

  // Where a recording's own vector is in this one.
  const std::vector<int>& EntriesOf(std::size_t recording) const { return entries_of_[recording]; }
  bool IsShared(int entry) const { return is_shared_[static_cast<std::size_t>(entry)]; }
  // A recording's own vector.
  Eigen::VectorXd Of(std::size_t recording, const Eigen::VectorXd& theta) const;
  // A recording's columns into those of all; the others of these rows stay as they are.
  void PutColumns(std::size_t recording, const RowMajorMatrix& columns, Eigen::Index first_row,
                  RowMajorMatrix* all) const;

 private:
  int FindShared(const std::string& name) const;  // -1 where there is none yet
  void AddPrior(const FreeParameters& free, int num_before);

  std::vector<std::vector<int>> entries_of_;
  std::vector<bool> is_shared_;
};

}  // namespace clothfit
