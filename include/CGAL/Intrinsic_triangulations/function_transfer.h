// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FUNCTION_TRANSFER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FUNCTION_TRANSFER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/check_finite.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/sparse_assembly.h>

#include <CGAL/property_map.h>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// returns the matrix that maps values at the vertices of one triangulation to values at the
/// vertices of the subdivision. The function is linear on the faces of `side`. Rows sum up to one
/// and have at most three entries, which are not negative. Complexity: linear.
/// \tparam Subdivision a class derived from `Subdivision_base`
/// \tparam NamedParameters a sequence of named parameters
/// \param side the triangulation on whose faces the function is linear
/// \param subdivision the subdivision
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used; see \ref it_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename Subdivision,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Eigen::SparseMatrix<typename Subdivision::FT>
interpolation_matrix(typename Subdivision::Side side, const Subdivision& subdivision,
                     const NamedParameters& np = CGAL::parameters::default_values())
{
  const auto collect = [&](std::size_t v, auto& entries) {
    const auto w =
      subdivision.weights(side, Vertex_index(static_cast<Delta_complex::size_type>(v)));
    for(std::size_t c = 0; c < w.size; ++c)
      entries.emplace_back(static_cast<int>(w.vertex[c].idx()), w.weight[c]);
  };
  Eigen::SparseMatrix<typename Subdivision::FT, Eigen::RowMajor> by_rows;
  assemble(concurrency_of(np), subdivision.mesh().number_of_vertices(),
           subdivision.mesh(side).number_of_vertices(), collect, by_rows);
  return by_rows;
}

namespace internal {

template <typename FT>
using Corner_matrix = Eigen::Matrix<FT, 3, 3>;

// Returns the integrals over a triangle of unit area of products of two linear functions, given by
// their values at its corners. Row a of `f` contains the values of the functions f at corner a.
template <typename FT>
Corner_matrix<FT> integrals_of_products(const Corner_matrix<FT>& f, const Corner_matrix<FT>& g)
{
  const Corner_matrix<FT> ones = Corner_matrix<FT>::Constant(FT(1));
  return f.transpose() * (ones + Corner_matrix<FT>::Identity()) * g / FT(12);
}

template <typename FT>
Corner_matrix<FT> rows(const Barycentric_coordinates<FT>& a, const Barycentric_coordinates<FT>& b,
                       const Barycentric_coordinates<FT>& c)
{
  Corner_matrix<FT> m;
  m << a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2];
  return m;
}

// Returns the integrals over a region of products of barycentric coordinates of both
// triangulations, relative to the area of a face. Rows are the corners of the face in the
// triangulation from which `map` maps.
template <typename FT>
Corner_matrix<FT> integrals_on_region(const Polygon_map<FT>& map)
{
  Corner_matrix<FT> sum = Corner_matrix<FT>::Zero();
  for(std::size_t c = 1; c + 1 < map.size(); ++c) {
    const FT area = orientation(map.corner(0), map.corner(c), map.corner(c + 1));
    sum += area * integrals_of_products<FT>(rows(map.corner(0), map.corner(c), map.corner(c + 1)),
                                            rows(map.image(0), map.image(c), map.image(c + 1)));
  }
  return sum;
}

// Adds the contributions of two faces to the entries of their corners.
template <typename FT>
void add_at_corners(Face_index row_face, const Delta_complex& row_mesh, Face_index column_face,
                    const Delta_complex& column_mesh, const Corner_matrix<FT>& values,
                    std::vector<Eigen::Triplet<FT>>& entries)
{
  const auto row = sides(row_face, row_mesh), column = sides(column_face, column_mesh);
  for(std::size_t a = 0; a < 3; ++a)
    for(std::size_t b = 0; b < 3; ++b)
      entries.emplace_back(int(row_mesh.source(row[a]).idx()),
                           int(column_mesh.source(column[b]).idx()), values(int(a), int(b)));
}

// Returns the integrals of products of hat functions of `side` (rows) and of the other
// triangulation (columns), with the areas of faces of `side`. The hat functions of the other
// triangulation sum up to one even if its areas are rounding errors.
template <typename Traits>
Eigen::SparseMatrix<typename Traits::FT>
mixed_mass_matrix(Side side, const Correspondence<Traits>& correspondence, Concurrency concurrency)
{
  typedef typename Traits::FT FT;
  typedef Correspondence_marks<Traits> Marks;
  const auto& tri = correspondence.triangulation();
  const Delta_complex &mesh = correspondence.mesh(side),
                      &other_mesh = correspondence.mesh(other(side));
  const auto area = [&](Face_index f) { return Face_metric<FT>(f, tri.surface(side)).area(); };
  const auto add_face = [&](Face_index f, std::vector<Eigen::Triplet<FT>>& entries) {
    const Marks marks(Side::intrinsic, f, correspondence);
    const Face_map<FT, Marks> face_map(marks, tri.input_mesh());
    const FT own_area = side == Side::intrinsic ? area(f) : FT(0);
    for(std::size_t m = 0; m < face_map.regions().size(); ++m) {
      const auto [input_face, map] = face_map.region_map(m);
      if(side == Side::intrinsic)
        add_at_corners<FT>(f, mesh, input_face, other_mesh, own_area * integrals_on_region(map),
                           entries);
      else
        add_at_corners<FT>(input_face, mesh, f, other_mesh,
                           area(input_face) * integrals_on_region(map.inverse()), entries);
    }
  };
  std::vector<std::vector<Eigen::Triplet<FT>>> chunks(number_of_chunks(tri.mesh().num_faces()));
  for_each_in_chunks<Face_index>(concurrency, tri.mesh(),
                                 [&](Face_index f) { add_face(f, chunks[f.idx() / chunk_size]); });
  std::vector<Eigen::Triplet<FT>> all;
  for(auto& chunk : chunks) {
    all.insert(all.end(), chunk.begin(), chunk.end());
    std::vector<Eigen::Triplet<FT>>().swap(chunk);
  }
  return matrix_of(all, mesh.number_of_vertices(), other_mesh.number_of_vertices());
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// returns the integrals \f$\int \varphi_i \psi_j\f$ of products of hat functions \f$\varphi_i\f$
/// of \f$T_2\f$ (rows) and \f$\psi_j\f$ of \f$T_1\f$ (columns). They are exact up to rounding,
/// since the products are integrated over the regions of the common subdivision. Complexity: linear
/// in the faces and crossings.
/// \tparam NamedParameters a sequence of named parameters
/// \param correspondence the crossings of both
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used; see \ref it_parallel}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Eigen::SparseMatrix<typename Traits::FT>
mixed_mass_matrix(const Correspondence<Traits>& correspondence,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::mixed_mass_matrix(Side::intrinsic, correspondence, concurrency_of(np));
}

namespace internal {

// Returns the values of a function that is linear on the faces of `from`, at the vertices of the
// other triangulation.
template <typename Traits>
Eigen::Matrix<typename Traits::FT, Eigen::Dynamic, 1>
values_at_vertices(const Intrinsic_triangulation<Traits>& tri, Side from,
                   const Eigen::Matrix<typename Traits::FT, Eigen::Dynamic, 1>& values)
{
  if(from == Side::intrinsic)
    return values.head(tri.input_mesh().number_of_vertices());
  Eigen::Matrix<typename Traits::FT, Eigen::Dynamic, 1> result(tri.mesh().number_of_vertices());
  interpolate(tri, CGAL::make_property_map(values.data()), CGAL::make_property_map(result.data()));
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// finds the piecewise linear function on the other triangulation that is closest, in the
/// \f$L^2\f$ norm, to a piecewise linear function on `from`. It has the same integral, and is the
/// function itself if that is possible. At a vertex without faces of positive area, it has the
/// value of the function at this vertex. Complexity: linear in the faces and crossings, and a
/// sparse Cholesky factorization.
/// \param correspondence the crossings of both
/// \param from the triangulation on whose faces `values` is linear
/// \param values the values at the vertices
/// \throws Invalid_input if a value is infinite or NaN
/// \throws Numerical_error if the mass matrix cannot be factorized since areas are out of range
template <typename Traits>
Eigen::Matrix<typename Traits::FT, Eigen::Dynamic, 1>
transfer_function(const Correspondence<Traits>& correspondence, Side from,
                  const Eigen::Matrix<typename Traits::FT, Eigen::Dynamic, 1>& values)
{
  typedef typename Traits::FT FT;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  typedef Eigen::SparseMatrix<FT> Matrix;
  internal::check_all_finite(values, "the value");
  const auto& tri = correspondence.triangulation();
  const Side to = internal::other(from);
  Matrix mass = mass_matrix(tri.surface(to));
  Vector moments = internal::mixed_mass_matrix(to, correspondence, Concurrency()) * values;
  const Vector is_massless =
    mass.diagonal().unaryExpr([](const FT& m) { return FT(m == 0 ? 1 : 0); });
  mass += Matrix(is_massless.asDiagonal());
  moments += is_massless.cwiseProduct(internal::values_at_vertices(tri, from, values));
  const Eigen::SimplicialLDLT<Matrix> factorization(mass);
  if(factorization.info() != Eigen::Success || !(factorization.vectorD().minCoeff() > 0))
    throw Numerical_error("the mass matrix cannot be factorized: areas are out of range");
  return factorization.solve(moments);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FUNCTION_TRANSFER_H
