// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fit has evaluated, on disk. A fit is a deterministic search: done again with the values
// that it got before, it takes the same way to the same bits, and simulates only what is new. So
// nothing of the search itself has to be kept, whichever it is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

class EvaluationJournal {
 public:
  // Reads what is there, up to the first entry that is damaged or cut off, and goes on behind it.
  // Nothing of another version's is taken. Throws InputError where the file cannot be used.
  explicit EvaluationJournal(std::filesystem::path file);

  // What was evaluated at `at` under this name, once; of several the first that was not asked for
  // yet.
  std::optional<Eigen::VectorXd> Recall(const std::string& name, const Eigen::VectorXd& at);
  // Appends it. What is long is left out once the file has 500 MB, and is evaluated again.
  void Add(const std::string& name, const Eigen::VectorXd& at, const Eigen::VectorXd& numbers);

  int num_recalled() const { return num_recalled_; }

 private:
  void Read();

  std::filesystem::path file_;
  std::uintmax_t size_ = 0;
  std::map<std::string, std::vector<Eigen::VectorXd>> known_;  // those of a key newest first
  int num_recalled_ = 0;
};

}  // namespace clothfit
