// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECORATED_LENGTH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECORATED_LENGTH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTraits
/// an edge whose ends are the centers of circles that do not meet, except that they may touch. The
/// tangent of both circles that passes between them has a length \f$t_{ij}\f$ with
/// \f$\ell_{ij}^2 = (r_i + r_j)^2 + t_{ij}^2\f$. For radii of zero it is the length of the edge.
///
/// As vectors of M&ouml;bius geometry, circles have the scalar products \f$\langle v_i, v_i\rangle
/// = r_i^2\f$ and \f$\langle v_i, v_j\rangle = -\eta_{ij}\f$, with \f$\eta_{ij} = (\ell_{ij}^2 -
/// r_i^2 - r_j^2)/2 = t_{ij}^2/2 + r_i r_j\f$. The quotient \f$\eta_{ij}/(r_i r_j)\f$ is the
/// inversive distance, which is 1 for circles that touch. Formulas in tangents and radii need no
/// differences. In contrast, \f$\eta_{ij}\f$ does not resolve the distance of circles that almost
/// touch.
template <typename FT>
struct Decorated_length
{
  FT tangent,      ///< \f$t_{ij}\f$
    source_radius, ///< \f$r_i\f$
    target_radius; ///< \f$r_j\f$

  /// returns the Gram coordinate \f$\eta_{ij}\f$.
  FT gram() const { return excess() + source_radius * target_radius; }

  /// returns by how much the Gram coordinate exceeds the Gram coordinate of circles that touch.
  FT excess() const { return tangent * tangent / 2; }

  /// returns \f$\eta_{ij}^2 - r_i^2 r_j^2\f$, which is zero if and only if the circles touch.
  FT determinant() const { return excess() * (excess() + 2 * (source_radius * target_radius)); }

  /// returns the distance of the centers, the length of the edge.
  FT length() const
  {
    using std::sqrt;
    const FT radii = source_radius + target_radius;
    return radii == 0 ? tangent : FT(sqrt(FT(radii * radii + tangent * tangent)));
  }

  /// returns \f$\sinh(x/2)\f$ for the hyperbolic distance \f$x\f$ of the centers of two circles
  /// in the hyperbolic plane, whose radii \f$R\f$ satisfy \f$2 r = \tanh R\f$. For radii of zero
  /// it is the length of the tangent. It is NaN if a circle is too large, with \f$2 r \ge 1\f$.
  ///
  /// With \f$c\f$ the product of both \f$1/\cosh R\f$, \f$\cosh x = (1 + 4\eta)/c\f$. The
  /// difference \f$1 + 4 r_i r_j - c\f$ is \f$4 (r_i + r_j)^2 / (1 + 4 r_i r_j + c)\f$, so that
  /// no digit is lost.
  FT hyperbolic_length() const
  {
    using std::sqrt;
    const FT radii = source_radius + target_radius;
    if(radii == 0)
      return tangent;
    const FT c = sqrt(FT((1 - 2 * source_radius) * (1 + 2 * source_radius))) *
                 sqrt(FT((1 - 2 * target_radius) * (1 + 2 * target_radius)));
    const FT apart = 2 * (radii * radii) / (1 + 4 * (source_radius * target_radius) + c);
    return sqrt(FT((tangent * tangent + apart) / c));
  }

  /// returns the length \f$2 \sin(x/2)\f$ of the chord between the centers of two circles on the
  /// unit sphere, at the distance \f$x\f$. Their angles \f$R\f$ satisfy \f$r = \tan R\f$. For radii
  /// of zero it is the length of the tangent.
  ///
  /// With \f$c\f$ the product of both \f$1/\cos R\f$, \f$c \cos x = 1 - \eta\f$. The difference
  /// \f$c - 1\f$ is \f$(r_i^2 + r_j^2 + r_i^2 r_j^2) / (c + 1)\f$, so that no digit is lost.
  FT spherical_length() const
  {
    using std::sqrt;
    const FT r = source_radius * source_radius, s = target_radius * target_radius;
    if(source_radius + target_radius == 0)
      return tangent;
    const FT c = sqrt(FT(1 + r)) * sqrt(FT(1 + s));
    return sqrt(FT(2 * (gram() + (r + s + r * s) / (c + 1)) / c));
  }

  /// returns the same edge from its other end.
  Decorated_length reversed() const { return {tangent, target_radius, source_radius}; }
};

/// \ingroup PkgIntrinsicTriangulationsTraits
/// returns the length \f$t_{ij}\f$ of the tangent between two circles, or zero if they touch or
/// meet. The circles have the radii `source_radius` and `target_radius`, and their centers the
/// distance `length`. Complexity: constant.
template <typename FT>
FT tangent_length(const FT& length, const FT& source_radius, const FT& target_radius)
{
  using std::sqrt;
  const FT radii = source_radius + target_radius;
  if(radii == 0)
    return length;
  return length > radii ? FT(sqrt(FT((length - radii) * (length + radii)))) : FT(0);
}

namespace internal {

namespace square_roots {

using std::sqrt;

template <typename FT, typename = void>
struct Has_square_root : std::false_type
{};

template <typename FT>
struct Has_square_root<FT, std::void_t<decltype(FT(sqrt(std::declval<const FT&>())))>>
  : std::true_type
{};

} // namespace square_roots

// Determines whether a number type has the function `sqrt()`.
using square_roots::Has_square_root;

// Returns -det G for the Gram matrix G of three circles, as the square of the volume that their
// vectors span. The sides ij, jk and ki are oriented.
template <typename FT>
FT squared_volume(const Decorated_length<FT>& ij, const Decorated_length<FT>& jk,
                  const Decorated_length<FT>& ki)
{
  const FT &r_i = ij.source_radius, &r_j = ij.target_radius, &r_k = ki.source_radius;
  const FT at_j = r_i * jk.gram(), at_i = r_j * ki.gram();
  return r_k * r_k * ij.determinant() + at_i * at_i + at_j * at_j +
         2 * (ij.gram() * jk.gram() * ki.gram());
}

// Returns the positive part of the height of the power center of a triangle ijk over ij. The
// height, times twice the area and the length of ij, is this part minus the determinant of ij.
template <typename FT>
FT height_over(const Decorated_length<FT>& ij, const FT& gram_ki, const FT& gram_jk)
{
  const FT radii = ij.source_radius + ij.target_radius;
  return (ij.target_radius * radii + ij.excess()) * gram_ki +
         (ij.source_radius * radii + ij.excess()) * gram_jk;
}

template <typename FT>
Decorated_length<FT> multiplied(const Decorated_length<FT>& edge, const FT& factor)
{
  return {factor * edge.tangent, factor * edge.source_radius, factor * edge.target_radius};
}

// Returns the edge with numbers of another type.
template <typename Number, typename FT>
Decorated_length<Number> with_numbers(const Decorated_length<FT>& edge)
{
  return {Number(edge.tangent), Number(edge.source_radius), Number(edge.target_radius)};
}

// Stores the circles at the corners of two neighboring faces ijk and jil, in a unit that keeps
// products of many lengths in range. All terms are sums of products of nonnegative numbers.
template <typename FT>
class Decorated_diamond
{
  typedef Decorated_length<FT> Edge;

public:
  explicit Decorated_diamond(const Diamond<Edge>& edge)
    : Decorated_diamond(edge,
                        1 / (edge.ij.tangent + (edge.ij.source_radius + edge.ij.target_radius)))
  {}

  // Returns t_kl after ij has been flipped. Let A be the Gram matrix of i and j, and b_k, b_l the
  // products of both with k and l. Then eta_kl = sqrt(kk ll) - b_k A^-1 b_l. Here kk is the square
  // of the part of k that is orthogonal to i and j, minus r_k r_l. With r = 0 it is Ptolemy's
  // relation (Equation 4.4).
  // \pre the circles i and j do not touch
  FT flipped_tangent() const
  {
    using std::sqrt;
    const FT D = m_edge.ij.determinant();
    const FT r_k = m_edge.ki.source_radius, r_l = m_edge.lj.source_radius;
    const FT q_k = product(k(), k()), q_l = product(l(), l());
    const FT kk = r_k * r_k * D + q_k, ll = r_l * r_l * D + q_l;
    const FT root = FT(sqrt(kk)) * FT(sqrt(ll));
    const FT apart = (D * (r_k * r_k * q_l + r_l * r_l * q_k) + q_k * q_l) / (root + r_k * r_l * D);
    return FT(sqrt(FT(2 * (apart + product(k(), l())) / D))) / m_factor;
  }

  // Stores the terms of the weighted ideal Delaunay condition. The edge ij satisfies it if `inner`
  // is not greater than `outer`.
  struct Condition
  {
    FT inner, outer;
  };
  Condition condition() const
  {
    using std::sqrt;
    const FT volume_k = sqrt(squared_volume(m_edge.ij, m_edge.jk, m_edge.ki));
    const FT volume_l = sqrt(squared_volume(m_edge.ij.reversed(), m_edge.il, m_edge.lj));
    return {m_edge.ij.determinant() * (volume_k + volume_l),
            volume_k * height(l()) + volume_l * height(k())};
  }

private:
  Decorated_diamond(const Diamond<Edge>& edge, const FT& factor)
    : m_factor(factor),
      m_edge{multiplied(edge.ij, factor), multiplied(edge.jk, factor), multiplied(edge.ki, factor),
             multiplied(edge.il, factor), multiplied(edge.lj, factor)}
  {}

  // Stores the Gram coordinates of an apex with i and j.
  struct Apex
  {
    FT to_i, to_j;
  };
  Apex k() const { return {m_edge.ki.gram(), m_edge.jk.gram()}; }
  Apex l() const { return {m_edge.il.gram(), m_edge.lj.gram()}; }

  // Returns - b_x A^-1 b_y times the determinant.
  FT product(const Apex& x, const Apex& y) const
  {
    const FT &r_i = m_edge.ij.source_radius, &r_j = m_edge.ij.target_radius;
    return r_j * r_j * (x.to_i * y.to_i) + r_i * r_i * (x.to_j * y.to_j) +
           m_edge.ij.gram() * (x.to_i * y.to_j + x.to_j * y.to_i);
  }

  // Returns the sum of both entries of A^-1 b_x, times the determinant.
  FT height(const Apex& x) const { return height_over(m_edge.ij, x.to_i, x.to_j); }

  FT m_factor; // the inverse of the unit
  Diamond<Edge> m_edge;
};

// Determines whether this geometry can have circles at the vertices.
template <typename Traits, typename = void>
struct Has_radii : std::false_type
{};

template <typename Traits>
struct Has_radii<Traits, std::void_t<decltype(std::declval<const Traits&>().has_radii())>>
  : std::true_type
{};

// Returns a function that returns the decorated length of a halfedge, from a map of tangents.
// `traits` has the radii of vertices.
template <typename Traits, typename LengthMap>
auto decorated_lengths(const Traits& traits, const LengthMap& tangent, const Delta_complex& mesh)
{
  return [&traits, tangent, &mesh](Halfedge_index h) {
    return Decorated_length<typename Traits::FT>{
      get(tangent, mesh.edge(h)), traits.radius(mesh.source(h)), traits.radius(mesh.target(h))};
  };
}

// Calls a function object of `traits` with the diamond of the halfedge `h`: with radii if they
// exist, otherwise with lengths.
template <typename Function, typename Traits, typename LengthMap>
auto of_diamond(const Function& function, [[maybe_unused]] const Traits& traits,
                const LengthMap& length, Halfedge_index h, const Delta_complex& mesh)
{
  if constexpr(Has_radii<Traits>::value)
    if(traits.has_radii())
      return function(diamond_of(decorated_lengths(traits, length, mesh), h, mesh));
  return function(diamond(length, h, mesh));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECORATED_LENGTH_H
