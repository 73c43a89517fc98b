// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Ends a program that was compiled for another processor with one line before it stumbles over an
// instruction that this one lacks. Compiled for the baseline, and run before all other
// initialisers.
#include <cstring>

#include <unistd.h>

#include "apps/launcher/instruction_set.h"

namespace {

constexpr const char* kBuiltFor = CLOTHFIT_INSTRUCTION_SET;

void Write(const char* text) {
  if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

__attribute__((constructor(101))) void CheckProcessor() {
  if (clothfit::ProcessorHas(kBuiltFor)) return;
  Write("clothfit: error: this program was built for ");
  Write(kBuiltFor);
  Write(", which this processor lacks; 'make portable' builds one for all\n");
  _exit(2);
}

}  // namespace
