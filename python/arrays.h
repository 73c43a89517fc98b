// SPDX-FileCopyrightText: 2026 The clothfit authors
// SPDX-License-Identifier: Apache-2.0
//
// Arrays of clothfit as NumPy's, and the other way round, without a copy where none is needed.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <clothfit/clothfit.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

namespace clothfit::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<int, py::array::c_style | py::array::forcecast>;

// A view of numbers that belong to `owner`, which lives as long as the view; not to be written to.
template <class Number, class Owner>
py::array View(const Number* numbers, const std::vector<std::size_t>& shape, Owner owner) {
  auto kept = std::make_unique<Owner>(std::move(owner));
  const py::capsule base(kept.release(), [](void* p) { delete static_cast<Owner*>(p); });
  py::array_t<Number> view(shape, numbers, base);
  view.attr("flags").attr("writeable") = false;
  return std::move(view);
}

// Takes the numbers over; the array is the caller's to change.
inline py::array Take(Array array) {
  auto kept = std::make_unique<Array>(std::move(array));
  const Array& numbers = *kept;
  const py::capsule base(kept.release(), [](void* p) { delete static_cast<Array*>(p); });
  return py::array_t<double>(numbers.shape, numbers.values.data(), base);
}

// Throws InputError unless the array has this shape; -1 is any number.
template <class AnyArray>
void RequireShape(const AnyArray& array, const std::vector<py::ssize_t>& shape,
                  const std::string& name, const std::string& expected) {
  bool is_right = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (std::size_t i = 0; is_right && i < shape.size(); ++i)
    is_right = shape[i] < 0 || array.shape(static_cast<py::ssize_t>(i)) == shape[i];
  if (is_right) return;
  throw InputError(name + ": expected an array of shape " + expected + ", found " +
                   py::str(py::tuple(array.attr("shape"))).cast<std::string>());
}

// n x 2 numbers as vectors.
inline std::vector<Vector2> ToVector2s(const Numbers& array, const std::string& name) {
  RequireShape(array, {-1, 2}, name, "(points, 2)");
  std::vector<Vector2> vectors;
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    vectors.push_back({array.at(i, 0), array.at(i, 1)});
  return vectors;
}

// n x 3 numbers as vectors.
inline std::vector<Vector3> ToVector3s(const Numbers& array, const std::string& name) {
  RequireShape(array, {-1, 3}, name, "(points, 3)");
  std::vector<Vector3> vectors;
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    vectors.push_back({array.at(i, 0), array.at(i, 1), array.at(i, 2)});
  return vectors;
}

}  // namespace clothfit::python
