// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_WEIGHTED_FORMULAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_WEIGHTED_FORMULAS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsWeights
/// the weights of the four corners of two neighboring faces \f$ijk\f$ and \f$jil\f$.
template <typename FT>
struct Diamond_weights
{
  FT i, ///< where the edge begins
    j,  ///< where the edge ends
    k,  ///< on its left
    l;  ///< on its right
};

namespace internal {

// Returns the corners i, j, k, l of the faces ijk and jil of `h`, which begins at i and ends at j.
inline std::array<Vertex_index, 4> diamond_corners(Halfedge_index h, const Delta_complex& mesh)
{
  return {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)),
          mesh.target(mesh.next(opposite(h)))};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsWeights
/// returns the weights at the corners of the two faces of `h`. \pre `h` has two faces
template <typename WeightMap>
auto diamond_weights(const WeightMap& weight, Halfedge_index h, const Delta_complex& mesh)
{
  typedef typename boost::property_traits<WeightMap>::value_type FT;
  const auto [i, j, k, l] = internal::diamond_corners(h, mesh);
  return Diamond_weights<FT>{get(weight, i), get(weight, j), get(weight, k), get(weight, l)};
}

namespace internal {

// Returns the weights of circles, which are their squared radii. The result refers to `radius`.
template <typename RadiusMap>
auto squared_radius_map(const RadiusMap& radius)
{
  return boost::make_function_property_map<Vertex_index>([&radius](Vertex_index v) {
    const auto r = get(radius, v);
    return r * r;
  });
}

// Represents a triangle ijk with weights, seen from its side ij.
template <typename FT>
class Weighted_triangle
{
public:
  Weighted_triangle(const FT& ij, const FT& jk, const FT& ki, const FT& w_i, const FT& w_j,
                    const FT& w_k)
    : m_ij(ij), m_jk(jk), m_ki(ki), m_above_i(w_i - w_k), m_above_j(w_j - w_k)
  {}

  // Returns the height of the power center over ij, times 8 times the area, divided by the length
  // of ij. It is linear in the weights, and needs no root.
  FT scaled_height() const
  {
    return doubled_corner_product(m_ij, m_jk, m_ki) +
           (m_above_i * doubled_corner_product(m_ki, m_ij, m_jk) +
            m_above_j * doubled_corner_product(m_jk, m_ij, m_ki)) /
             (m_ij * m_ij);
  }

  // Returns the greatest change of `scaled_height()` by a relative error `u` of the lengths.
  FT error_of_height(const FT& u) const
  {
    const FT squares = m_ij * m_ij + m_jk * m_jk + m_ki * m_ki;
    return 4 * u * squares * (1 + (absolute(m_above_i) + absolute(m_above_j)) / (m_ij * m_ij));
  }

  // Returns the height of the power center over ij, positive on the side of k.
  FT height() const { return m_ij * scaled_height() / (2 * quadrupled_area(m_ij, m_jk, m_ki)); }

  // Returns 16 times the squared area after changes of all sums of two sides minus the third. They
  // change as much as a relative error `u` of the sides allows. They increase if `u` is positive,
  // and decrease if it is negative.
  FT squared_area(const FT& u) const
  {
    const FT change = u * (m_ij + m_jk + m_ki);
    return (m_ij + m_jk + m_ki) * positive(m_ij + (m_jk - m_ki) + change) *
           positive(m_jk + (m_ki - m_ij) + change) * positive(m_ki + (m_ij - m_jk) + change);
  }

private:
  static FT positive(const FT& x) { return x > 0 ? x : FT(0); }
  static FT absolute(const FT& x) { return x > 0 ? x : FT(-x); }

  FT m_ij, m_jk, m_ki, m_above_i, m_above_j;
};

template <typename FT>
std::array<Weighted_triangle<FT>, 2> weighted_triangles(const Diamond<FT>& length,
                                                        const Diamond_weights<FT>& weight)
{
  return {Weighted_triangle<FT>(length.ij, length.jk, length.ki, weight.i, weight.j, weight.k),
          Weighted_triangle<FT>(length.ij, length.il, length.lj, weight.j, weight.i, weight.l)};
}

// Returns the sum of the cotangents of the two angles at i, times both areas and 4. It is positive
// if and only if the diamond is strictly convex at i.
template <typename FT>
FT cotangents_at_source(const Diamond<FT>& length)
{
  return doubled_corner_product(length.jk, length.ij, length.ki) *
           quadrupled_area(length.ij, length.il, length.lj) +
         doubled_corner_product(length.lj, length.ij, length.il) *
           quadrupled_area(length.ij, length.jk, length.ki);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsWeights
/// decides whether an edge satisfies the local weighted Delaunay condition. The signed heights of
/// the power centers of its two faces over the edge must have a nonnegative sum. With equal
/// weights this is the Delaunay condition (Equation 2.6).
///
/// With a floating-point type the tolerance is one-sided, as in
/// `Euclidean_geometry_traits::Is_locally_Delaunay`. An edge counts as not weighted Delaunay only
/// if this is true for all lengths within `error` of the given ones. The weights are taken as
/// exact.
template <typename FT>
struct Is_locally_weighted_Delaunay
{
  /// the relative error that is granted to every length.
  FT error = rounding_unit<FT>();

  /// returns whether the edge is weighted Delaunay.
  bool operator()(const Diamond<FT>& length, const Diamond_weights<FT>& weight) const
  {
    const auto [left, right] = internal::weighted_triangles(length, weight);
    const FT k = left.scaled_height() + left.error_of_height(error);
    const FT l = right.scaled_height() + right.error_of_height(error);
    if(!(k < 0))
      return !(l < 0) || !is_greater(l, left, k, right);
    return !(l < 0) && !is_greater(k, right, l, left);
  }

  /// returns whether the edge is weighted Delaunay and far from a tie: both power centers are on
  /// the side of their face.
  bool is_certain(const Diamond<FT>& length, const Diamond_weights<FT>& weight) const
  {
    const auto [left, right] = internal::weighted_triangles(length, weight);
    return left.scaled_height() > left.error_of_height(error) &&
           right.scaled_height() > right.error_of_height(error);
  }

private:
  // Returns whether the negative height over one area certainly exceeds the positive height over
  // the other.
  bool is_greater(const FT& negative, const internal::Weighted_triangle<FT>& of_positive,
                  const FT& positive, const internal::Weighted_triangle<FT>& of_negative) const
  {
    return negative * negative * of_positive.squared_area(-error) >
           positive * positive * of_negative.squared_area(error);
  }
};

/// \ingroup PkgIntrinsicTriangulationsWeights
/// returns the height of the power center of the face of `h` over the edge of `h`, positive on the
/// side of the face. The power center has equal power \f$|x - p|^2 - w\f$ to the three corners.
/// \param h a halfedge of the face
/// \param surface a model of `IntrinsicSurface`
/// \param weight a readable property map from vertices to the number type of lengths
/// \pre the area of the face is positive
template <typename Surface, typename WeightMap>
auto power_center_height(Halfedge_index h, const Surface& surface, const WeightMap& weight)
{
  const Delta_complex& mesh = surface.mesh();
  const auto [ij, jk, ki] = internal::side_lengths(h, surface);
  return internal::Weighted_triangle<Length_of<Surface>>(ij, jk, ki, get(weight, mesh.source(h)),
                                                         get(weight, mesh.target(h)),
                                                         get(weight, mesh.target(mesh.next(h))))
    .height();
}

/// \ingroup PkgIntrinsicTriangulationsWeights
/// returns the power center of the face of `h` in barycentric coordinates. The coordinate of the
/// source of `h` comes first. Coordinates are negative if the power center is outside the face.
/// Complexity: constant.
/// \param h a halfedge of the face
/// \param surface a model of `IntrinsicSurface`
/// \param weight a readable property map from vertices to their weights, which are squared lengths
/// \pre the area of the face is positive
template <typename Surface, typename WeightMap>
auto power_center(Halfedge_index h, const Surface& surface, const WeightMap& weight)
{
  typedef Length_of<Surface> FT;
  const Delta_complex& mesh = surface.mesh();
  const auto length = internal::side_lengths(h, surface);
  const FT doubled_area = quadrupled_area(length[0], length[1], length[2]) / 2;
  const std::array<Halfedge_index, 3> side{h, mesh.next(h), mesh.prev(h)};
  std::array<FT, 3> result; // heights over sides, as parts of the heights of the opposite corners
  for(std::size_t s = 0; s < 3; ++s)
    result[(s + 2) % 3] = power_center_height(side[s], surface, weight) * length[s] / doubled_area;
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsWeights
/// returns the signed length of the dual edge of `e`: the sum of the heights of the power centers
/// over the edge. For an inner edge it is not negative if and only if the edge is weighted
/// Delaunay. For a boundary edge it is the height of the only power center. Dual edges are
/// orthogonal to their edges. Complexity: constant.
/// \param e the edge
/// \param surface a model of `IntrinsicSurface`
/// \param weight a readable property map from vertices to their weights, which are squared lengths
/// \pre the areas of the faces at `e` are positive
template <typename Surface, typename WeightMap>
auto dual_edge_length(Edge_index e, const Surface& surface, const WeightMap& weight)
{
  const Delta_complex& mesh = surface.mesh();
  Length_of<Surface> result(0);
  for(Halfedge_index h : {first_halfedge(e), opposite(first_halfedge(e))})
    if(!mesh.is_border(h))
      result += power_center_height(h, surface, weight);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_WEIGHTED_FORMULAS_H
