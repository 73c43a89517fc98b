// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The clothfit command. With libclothfit this is all of it: the loader chooses the library.
extern "C" int clothfit_main(int argc, char** argv);  // apps/clothfit.cc

int main(int argc, char** argv) { return clothfit_main(argc, argv); }
