// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// What this machine's processor has of the levels of x86-64 (System V ABI, x86-64 psABI 1.0, table
// 3.1), as far as compilers use them for numbers. Plain C++ for the baseline, since it runs before
// anything else may.
#pragma once

#include <cstring>

namespace clothfit {

// From the highest to the lowest that clothfit is compiled for.
inline constexpr const char* kInstructionSets[] = {"x86-64-v4", "x86-64-v3", "x86-64-v2"};

inline bool ProcessorHas(const char* instruction_set) {
#if defined(__x86_64__)
  __builtin_cpu_init();
  const auto is = [&](const char* name) { return std::strcmp(instruction_set, name) == 0; };
  const bool v2 = __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt");
  const bool v3 = v2 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                  __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                  __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512vl");
  return is("x86-64-v4") ? v4 : is("x86-64-v3") ? v3 : is("x86-64-v2") ? v2 : true;
#else
  return std::strncmp(instruction_set, "x86-64", 6) != 0;
#endif
}

}  // namespace clothfit
