// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_ARRAYS_H
#define INTRINSIC_PYTHON_ARRAYS_H

#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
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
// of each row or column, and the shape. The arrays share the ownership of the matrix: nothing is
// copied.
template <class Matrix>
py::tuple sparse_arrays(Matrix matrix)
{
  matrix.makeCompressed();
  auto* const owned = new Matrix;
  const py::capsule owner(owned, [](void* p) { delete static_cast<Matrix*>(p); });
  owned->swap(matrix); // Eigen 3.4 would copy it
  const auto array = [&](auto* values, py::ssize_t n) {
    return py::array(py::dtype::of<std::decay_t<decltype(*values)>>(), {n}, values, owner);
  };
  return py::make_tuple(array(owned->valuePtr(), owned->nonZeros()),
                        array(owned->innerIndexPtr(), owned->nonZeros()),
                        array(owned->outerIndexPtr(), owned->outerSize() + 1),
                        py::make_tuple(owned->rows(), owned->cols()));
}

// Returns a matrix with the weights `weights(row)` of vertices in each row, without zeros.
template <class Weights>
Eigen::SparseMatrix<double, Eigen::RowMajor>
matrix_of_weights(std::size_t rows, std::size_t columns, const Weights& weights)
{
  const auto collect = [&](std::size_t row, auto& entries) {
    const auto w = weights(row);
    for(std::size_t c = 0; c < w.size; ++c)
      if(w.weight[c] != 0)
        entries.emplace_back(int(w.vertex[c].idx()), w.weight[c]);
  };
  return CGAL::Intrinsic_triangulations::assembled<Eigen::SparseMatrix<double, Eigen::RowMajor>>(
    rows, columns, collect);
}

// Returns an array of `value_of(element)` for the elements of a range.
template <class Range, class Value>
py::array array_over(const Range& range, const Value& value_of)
{
  std::vector<std::decay_t<decltype(value_of(*range.begin()))>> result;
  result.reserve(range.size());
  for(const auto& element : range)
    result.push_back(value_of(element));
  return array_of(std::move(result));
}

// Returns an array of the indices of elements of a mesh.
template <class Index>
py::array indices_of(const std::vector<Index>& elements)
{
  return array_over(elements, [](Index i) { return std::int64_t(i.idx()); });
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
