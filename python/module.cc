// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
#include "python/module.h"

PYBIND11_MODULE(_clothfit, module) {
  using namespace clothfit::python;  // NOLINT(google-build-using-namespace): this is the module
  pybind11::register_exception<clothfit::InputError>(module, "InputError", PyExc_ValueError).doc() =
      "Input that cannot be used: one line with the place, what stood there, what was expected.";
  module.attr("__version__") = clothfit::Version();
  AddRecording(&module);
  AddConfig(&module);
  AddFit(&module);
  AddDiagnosis(&module);
  AddSimulation(&module);
}
