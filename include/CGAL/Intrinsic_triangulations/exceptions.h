// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXCEPTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXCEPTIONS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// base of all exceptions of the package; `what()` describes the error and its position.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// the input violates a precondition; `what()` names the defect and the element that has it.
class Invalid_input : public Error
{
public:
  using Error::Error;
};

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// vertices of negative curvature show that a surface is not the surface of a convex polyhedron.
class Negative_curvature : public Invalid_input
{
  std::vector<std::size_t> m_vertices;

  static std::string scientific(double x)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%.3g", x);
    return text;
  }

public:
  /// makes an error for one or more vertices. `curvature` is the curvature of the first one.
  Negative_curvature(const std::vector<std::size_t>& vertices, double curvature)
    : Invalid_input("vertex " + std::to_string(vertices.front()) + " has negative curvature, " +
                    scientific(curvature) + " radians" +
                    (vertices.size() == 1
                       ? std::string()
                       : ", and so have " + std::to_string(vertices.size() - 1) + " others")),
      m_vertices(vertices)
  {}

  /// returns the indices of the vertices of negative curvature.
  const std::vector<std::size_t>& vertices() const { return m_vertices; }
};

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// rounding leaves no result, such as a positive finite length or a decision.
class Numerical_error : public Error
{
public:
  using Error::Error;
};

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// heat underflows somewhere: it must flow for a longer time.
class Underflow_error : public Numerical_error
{
public:
  using Numerical_error::Numerical_error;
};

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// an integer would exceed its range: a normal coordinate, or a number of crossings or elements.
class Overflow_error : public Error
{
public:
  using Error::Error;
};

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// more flips than allowed were needed.
class Flip_limit_exceeded : public Error
{
public:
  using Error::Error;
};

namespace internal {

// Calls `change()`. If it throws, calls `undo()` and throws again.
template <typename Change, typename Undo>
void change_or_undo(const Change& change, const Undo& undo)
{
  try {
    change();
  } catch(...) {
    undo();
    throw;
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsExceptions
/// a file does not follow its format; `line()` returns where reading stopped.
class File_format_error : public Error
{
  std::size_t m_line;

public:
  /// makes an error in line `line`.
  File_format_error(const std::string& message, std::size_t line)
    : Error("line " + std::to_string(line) + ": " + message), m_line(line)
  {}

  /// returns the offending line, counted from 1.
  std::size_t line() const { return m_line; }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXCEPTIONS_H
