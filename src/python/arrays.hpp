// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <initializer_list>
#include <vector>

#include "base/vec3.hpp"

// numpy arrays of what the rooms below hold in vectors. Each array is a copy of its own.
namespace nugget::python {

namespace py = pybind11;

/// An array of `rows` times `columns` whose entries `value(row, column)` gives.
template <class T, class Value>
py::array_t<T> matrix(std::size_t rows, std::size_t columns, Value value) {
  py::array_t<T> out({rows, columns});
  auto entry = out.template mutable_unchecked<2>();
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j < columns; ++j)
      entry(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(j)) = static_cast<T>(value(i, j));
  return out;
}

/// An array of `size` entries `value(i)`.
template <class T, class Value>
py::array_t<T> column(std::size_t size, Value value) {
  py::array_t<T> out(static_cast<py::ssize_t>(size));
  auto entry = out.template mutable_unchecked<1>();
  for (std::size_t i = 0; i < size; ++i) entry(static_cast<py::ssize_t>(i)) = static_cast<T>(value(i));
  return out;
}

inline py::array_t<double> numbers(const std::vector<double>& values) {
  return column<double>(values.size(), [&](std::size_t i) { return values[i]; });
}

/// Three columns x y z.
inline py::array_t<double> vectors(const std::vector<Vec3d>& values) {
  return matrix<double>(values.size(), 3, [&](std::size_t i, std::size_t j) {
    const Vec3d& v = values[i];
    return j == 0 ? v.x : j == 1 ? v.y : v.z;
  });
}

}  // namespace nugget::python
