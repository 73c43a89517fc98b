// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Finds a wind and the cloth in it from the cloth's motion, and prints what it took.
#include <cstdio>

#include "tests/support/wind_problem.h"

int main() {
  const clothfit::WindProblem problem;
  std::fputs(clothfit::WindAsMarkdown(problem, clothfit::RecoverWind(problem)).c_str(), stdout);
  return 0;
}
