// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Prints the highest instruction set of this machine that clothfit is compiled for.
#include <cstdio>

#include "apps/launcher/instruction_set.h"

int main() {
  for (const char* const instruction_set : clothfit::kInstructionSets) {
    if (!clothfit::ProcessorHas(instruction_set)) continue;
    std::puts(instruction_set);
    return 0;
  }
  return 0;
}
