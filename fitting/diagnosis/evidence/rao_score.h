// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The efficient score (Lagrange multiplier) test (Rao 1948): by how much the sum of squares would
// fall, to first order, were a group of absent parameters let go, after everything that the
// baseline, the observation's faults and numerical error could do instead has been taken out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace clothfit {

// Columns d residuals / d (something), residuals in sigmas.
class ColumnSet {
 public:
  explicit ColumnSet(Eigen::Index num_rows) : values_(num_rows, 0) {}
  // Returns the index of the first.
  int Add(const Eigen::MatrixXd& columns);
  int size() const { return static_cast<int>(values_.cols()); }
  const Eigen::MatrixXd& values() const { return values_; }

 private:
  Eigen::MatrixXd values_;
};

// What may explain a residual without being looked for: a column and one over its squared sigma; 0
// where nothing is known of its amount.
struct Nuisance {
  int column;
  double precision;
};

// Parameters that are let go together.
struct ScoredGroup {
  std::vector<int> columns;
  std::vector<bool> is_one_sided;  // amounts below 0 are impossible
  std::vector<double> precision;   // one over squared sigmas of the amounts; empty: unknown
};

struct Score {
  double decrease = 0.0;    // of the sum of squares
  Eigen::VectorXd amounts;  // estimates, one a column
  Eigen::VectorXd sigma;    // of each by itself, from unit noise; infinite where nothing shows it
};

// Inner products with what the nuisances can explain taken out. Column c of the Gram matrix belongs
// to column c of the set.
class Projection {
 public:
  Projection(const Eigen::MatrixXd& gram, const std::vector<Nuisance>& nuisances);
  // Of all columns with each other, and of a vector that is given by its products with them.
  const Eigen::MatrixXd& gram() const { return projected_; }
  Eigen::VectorXd Products(const Eigen::VectorXd& products) const;
  // Of two such vectors that have this product.
  double Product(double product, const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

 private:
  std::vector<int> columns_;
  Eigen::MatrixXd cross_;    // all columns x nuisances
  Eigen::MatrixXd inverse_;  // of the nuisances' information
  Eigen::MatrixXd projected_;
};

// The scores of a group for residuals that are given by their projected products with all columns.
class Scorer {
 public:
  Scorer(const Projection& projection, ScoredGroup group);
  Score Of(const Eigen::VectorXd& projected_products) const;

 private:
  Eigen::MatrixXd InverseOf(const std::vector<int>& in) const;

  ScoredGroup group_;
  std::vector<int> all_;
  Eigen::MatrixXd information_, inverse_;
};

// The score of a group for one residual.
Score ScoreOf(const Projection& projection, const ScoredGroup& group,
              const Eigen::VectorXd& projected_products);

// By how much these columns together, of either sign each, would lower the sum of squares of each
// column of products (columns x residuals).
Eigen::VectorXd DecreasesOfAll(const Projection& projection, const std::vector<int>& columns,
                               const Eigen::MatrixXd& projected_products);

// Cosine between what two groups can do, after projection: the largest canonical correlation.
double LargestCosine(const Projection& projection, const std::vector<int>& a,
                     const std::vector<int>& b);

// The probability of a value at least this large, from draws of a positive quantity: by counting,
// and beyond the draws by the normal law that the draws' cube roots follow nearly (Wilson and
// Hilferty 1931).
double TailProbability(const std::vector<double>& draws, double value);

// The normal deviate that is as unlikely as this chi-squared of so many degrees of freedom (Wilson
// and Hilferty 1931); 0 of none.
double NormalDeviate(double chi_squared, double freedom);

// Benjamini and Hochberg 1995: the smallest false-discovery rate at which each is discovered.
std::vector<double> FalseDiscoveryRates(const std::vector<double>& p_values);

}  // namespace clothfit
