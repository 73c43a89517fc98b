// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// small_diagnosis FOLDER: writes FOLDER/diagnosis for the test of its page, since a diagnosis in
// earnest takes minutes.
#include "tests/support/small_diagnosis.h"

#include <cstdio>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: small_diagnosis FOLDER\n", stderr);
    return 2;
  }
  clothfit::MakeSmallDiagnosis(argv[1]);
  return 0;
}
