// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "fitting/diagnosis/validate/held_out_validation.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace clothfit {

HeldOutValidation Validate(const HeldOutErrors& before, const HeldOutErrors& after, int block,
                           const IrreducibleError& irreducible, std::uint64_t seed) {
  HeldOutValidation validation;
  validation.before = before.Rms();
  validation.after = after.Rms();
  validation.noise = irreducible.noise;
  validation.irreducible = std::hypot(irreducible.noise, irreducible.discretisation);
  if (!before.is_complete || !after.is_complete || before.squared.size() != after.squared.size()) {
    validation.is_validated = after.is_complete && !before.is_complete && !after.squared.empty();
    return validation;
  }
  const auto frames = static_cast<int>(before.squared.size());
  block = std::clamp(block, 1, std::max(1, frames / 4));
  std::mt19937_64 random(seed);
  std::vector<double> improvements, squares;
  constexpr int kResamples = 1000;
  for (int k = 0; k < kResamples; ++k) {
    double sum_before = 0.0, sum_after = 0.0;
    for (int n = 0; n < frames;) {
      const auto first =
          static_cast<int>(random() % static_cast<std::uint64_t>(frames - block + 1));
      for (int i = 0; i < block && n < frames; ++i, ++n) {
        sum_before += before.squared[static_cast<std::size_t>(first + i)];
        sum_after += after.squared[static_cast<std::size_t>(first + i)];
      }
    }
    improvements.push_back(std::sqrt(sum_before / frames) - std::sqrt(sum_after / frames));
    squares.push_back((sum_before - sum_after) / frames);
  }
  std::sort(improvements.begin(), improvements.end());
  std::sort(squares.begin(), squares.end());
  validation.improvement_lower95 = improvements[kResamples / 20];
  constexpr double kWorthHaving = 0.05;  // of the noise
  validation.is_validated =
      validation.improvement_lower95 > std::max(0.0, kWorthHaving * irreducible.noise) &&
      squares[kResamples / 20] > irreducible.discretisation * irreducible.discretisation;
  return validation;
}

}  // namespace clothfit
