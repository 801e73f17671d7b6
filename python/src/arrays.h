// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_ARRAYS_H
#define INTRINSIC_PYTHON_ARRAYS_H

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace py = pybind11;

// Arrays that the Python layer has checked have this type and are stored by rows. Others are
// rejected.
using Number_array = py::array_t<double, py::array::c_style>;
using Index_array = py::array_t<std::int64_t, py::array::c_style>;

// Returns an array that owns the values of a vector. Nothing is copied.
template <class Row>
py::array owning_array(std::vector<Row> values, std::vector<py::ssize_t> shape,
                       const py::dtype& type)
{
  auto* const owned = new std::vector<Row>(std::move(values));
  const py::capsule owner(owned, [](void* p) { delete static_cast<std::vector<Row>*>(p); });
  return py::array(type, std::move(shape), owned->data(), owner);
}

template <class T>
py::array array_of(std::vector<T> values)
{
  const auto n = static_cast<py::ssize_t>(values.size());
  return owning_array(std::move(values), {n}, py::dtype::of<T>());
}

template <class T, std::size_t columns>
py::array array_of(std::vector<std::array<T, columns>> rows)
{
  const auto n = static_cast<py::ssize_t>(rows.size());
  return owning_array(std::move(rows), {n, py::ssize_t(columns)}, py::dtype::of<T>());
}

// Returns an array that owns a matrix, with a row for each of its columns. Nothing is copied.
inline py::array array_of_columns(Eigen::MatrixXd matrix)
{
  auto* const owned = new Eigen::MatrixXd(std::move(matrix));
  const py::capsule owner(owned, [](void* p) { delete static_cast<Eigen::MatrixXd*>(p); });
  return py::array(py::dtype::of<double>(), {owned->cols(), owned->rows()}, owned->data(), owner);
}

// Returns the arguments of the constructors of scipy: the entries, their inner indices, the start
// of each row or column, and the shape.
template <class Matrix>
py::tuple sparse_arrays(const Matrix& matrix)
{
  typedef typename Matrix::Scalar Scalar;
  const auto n = static_cast<std::size_t>(matrix.nonZeros());
  const auto outer = static_cast<std::size_t>(matrix.outerSize()) + 1;
  return py::make_tuple(
    array_of(std::vector<Scalar>(matrix.valuePtr(), matrix.valuePtr() + n)),
    array_of(std::vector<std::int32_t>(matrix.innerIndexPtr(), matrix.innerIndexPtr() + n)),
    array_of(std::vector<std::int32_t>(matrix.outerIndexPtr(), matrix.outerIndexPtr() + outer)),
    py::make_tuple(matrix.rows(), matrix.cols()));
}

template <class T, int flags>
std::vector<T> vector_of(const py::array_t<T, flags>& array)
{
  return {array.data(), array.data() + array.size()};
}

// Calls `work()` while other threads of Python can run.
template <class Work>
auto released(const Work& work)
{
  const py::gil_scoped_release release;
  return work();
}

#endif // INTRINSIC_PYTHON_ARRAYS_H
