// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of the Python module.
#pragma once

#include <clothfit/clothfit.h>
#include <pybind11/pybind11.h>

namespace clothfit::python {

void AddRecording(pybind11::module_* module);
void AddConfig(pybind11::module_* module);
void AddFit(pybind11::module_* module);
void AddDiagnosis(pybind11::module_* module);
void AddSimulation(pybind11::module_* module);

// What to do with a folder that is there already.
Existing ToExisting(bool replace, bool resume);

}  // namespace clothfit::python
