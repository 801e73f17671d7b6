// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTEGER_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTEGER_COORDINATES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Outgoing_halfedges.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Returns a number of crossings.
// \throws Overflow_error if indices of a mesh cannot represent it
template <typename Integer>
Delta_complex::size_type countable(const Integer& crossings)
{
  const auto count = static_cast<Delta_complex::size_type>(crossings);
  if(static_cast<Integer>(count) != crossings)
    throw Overflow_error("more crossings than a mesh can index");
  return count;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// holds four values on the edges at a vertex \f$m\f$ that splits the edge \f$ij\f$ of a diamond.
/// On the boundary one of \f$mk\f$ and \f$ml\f$ does not exist, and its value is unspecified.
template <typename T>
struct Edge_split
{
  T im, ///< on the first part of the edge
    mj, ///< on the second part
    mk, ///< on the edge to the vertex on the left of \f$ij\f$
    ml; ///< on the edge to the vertex on the right
};

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// holds the coordinates of the edges from a vertex \f$m\f$ that splits a face to the three
/// corners.
template <typename Integer>
struct Face_split
{
  std::array<Integer, 3> n; ///< the normal coordinates
  std::array<Outgoing_halfedges::size_type, 3>
    r; ///< the roundabouts at \f$m\f$; 0 if it is inside a face of \f$T_1\f$
};

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// the normal coordinates \f$n\f$ and roundabouts \f$r\f$ of Section 3.1, as property maps on the
/// edges and halfedges of a triangulation \f$T_2\f$. They encode how the edges of a triangulation
/// \f$T_1\f$ of the same surface run over \f$T_2\f$. They are independent of lengths and exact.
///
/// The curves of \f$T_1\f$ that cross a halfedge are counted from its source, starting with 0.
///
/// \tparam Integer_ a signed integer type; a bounded one is checked for overflow.
template <typename Integer_>
class Integer_coordinates
{
public:
  /// the type of normal coordinates.
  typedef Integer_ Integer;
  /// the type of roundabouts.
  typedef Outgoing_halfedges::size_type size_type;
  /// the type of the map of normal coordinates.
  typedef Delta_complex::Property_map<Edge_index, Integer> Normal_coordinate_map;
  /// the type of the map of roundabouts.
  typedef Delta_complex::Property_map<Halfedge_index, size_type> Roundabout_map;

  /// a crossing \f$\zeta\f$ of a curve of \f$T_1\f$ that leaves the face of `halfedge` through it.
  /// Its index, counted from the source of `halfedge`, is `number`.
  struct Crossing
  {
    Halfedge_index halfedge; ///< the halfedge that is crossed
    Integer number;          ///< the index of the crossing on it
  };

  /// how a curve continues in the face beyond a crossing \f$\overrightarrow{ij}\f$ (Figure 3.6).
  enum class Turn
  {
    around_source, ///< it cuts off the corner at \f$i\f$
    around_target, ///< it cuts off the corner at \f$j\f$
    ends           ///< it ends at the opposite corner
  };

  /// creates coordinates that are attached to no mesh.
  Integer_coordinates() = default;

  /// attaches the maps "e:normal_coordinate" and "h:roundabout" to `mesh`. New maps have every
  /// edge shared. If `mesh` is \f$T_1\f$, its roundabouts are the indices of its own outgoing
  /// halfedges.
  explicit Integer_coordinates(Delta_complex& mesh)
    : m_n(mesh.template add_property_map<Edge_index, Integer>("e:normal_coordinate", -1).first),
      m_r(mesh.template add_property_map<Halfedge_index, size_type>("h:roundabout", 0).first)
  {}

  /// \name Access
  /// @{

  /// returns the normal coordinate \f$n\f$ of `e`: -1 if the edge is in \f$T_1\f$ too, otherwise
  /// the number of its crossings with edges of \f$T_1\f$.
  const Integer& normal_coordinate(Edge_index e) const { return m_n[e]; }

  /// returns the roundabout \f$r\f$ of `h`: the index of the first outgoing halfedge of \f$T_1\f$
  /// at or counterclockwise from `h` around its source.
  size_type roundabout(Halfedge_index h) const { return m_r[h]; }

  /// returns whether the edge of `h` is in \f$T_1\f$ too.
  bool is_shared(Edge_index e) const { return m_n[e] < 0; }

  /// returns the number \f$n^+\f$ of crossings on the edge of `h`.
  Integer crossings(Halfedge_index h) const
  {
    return Intrinsic_triangulations::crossings(m_n[Edge_index(h)]);
  }

  /// returns the map of normal coordinates.
  const Normal_coordinate_map& normal_coordinate_map() const { return m_n; }
  /// returns the map of roundabouts.
  const Roundabout_map& roundabout_map() const { return m_r; }

  /// @}
  /// \name Corners
  /// @{

  /// returns the number \f$e\f$ of curves that start at the corner opposite to `h` and cross `h`
  /// (Equation 3.1).
  /// \pre `h` is not a border halfedge
  Integer curves_leaving(Halfedge_index h, const Delta_complex& mesh) const
  {
    return Intrinsic_triangulations::curves_leaving(crossings(h), crossings(mesh.prev(h)),
                                                    crossings(mesh.next(h)));
  }

  /// returns the number \f$c\f$ of curves that cut off the corner opposite to `h` (Equation 3.2).
  /// \pre `h` is not a border halfedge
  Integer curves_around(Halfedge_index h, const Delta_complex& mesh) const
  {
    return Intrinsic_triangulations::curves_around(crossings(h), crossings(mesh.prev(h)),
                                                   crossings(mesh.next(h)));
  }

  /// returns the number of outgoing halfedges of \f$T_1\f$ at or counterclockwise from `h` and
  /// before the next outgoing halfedge of \f$T_2\f$. These are the halfedges that start in the
  /// corner at the source of `h`, and the halfedge along `h`.
  Integer outgoing_halfedges_from(Halfedge_index h, const Delta_complex& mesh) const
  {
    const int along = Intrinsic_triangulations::is_shared(m_n[Edge_index(h)]);
    if(mesh.is_border(h))
      return Integer(along);
    return static_cast<Integer>(curves_leaving(mesh.next(h), mesh) + along);
  }

  /// @}
  /// \name Tracing
  /// Algorithms 1 and 2.
  /// @{

  /// returns the first crossing of curve `k` of the curves that leave the source of `outgoing`
  /// inside its corner. Curves are counted from `outgoing`.
  /// \pre `k < curves_leaving(next(outgoing))`
  Crossing first_crossing(Halfedge_index outgoing, const Integer& k,
                          const Delta_complex& mesh) const
  {
    const Halfedge_index opposite_side = mesh.next(outgoing);
    return {opposite_side, static_cast<Integer>(curves_around(mesh.prev(outgoing), mesh) + k)};
  }

  /// moves `c` to the next crossing of its curve, and leaves it unchanged if the curve ends.
  /// Repeated calls reach the end of every curve that starts at a corner, if the crossings are
  /// valid in every face. A crossing has at most one predecessor and the first has none, so no
  /// crossing repeats.
  Turn advance(Crossing& c, const Delta_complex& mesh) const
  {
    const Halfedge_index ji = mesh.opposite(c.halfedge);
    const Halfedge_index ik = mesh.next(ji), kj = mesh.prev(ji);
    if(c.number < curves_around(kj, mesh)) {
      c.halfedge = ik;
      return Turn::around_source;
    }
    const Integer from_target = static_cast<Integer>(crossings(ji) - c.number);
    if(from_target <= curves_around(ik, mesh)) {
      c = Crossing{kj, static_cast<Integer>(crossings(kj) - from_target)};
      return Turn::around_target;
    }
    return Turn::ends;
  }

  /// returns the outgoing halfedge of \f$T_1\f$ along which the curve that ends beyond `c` runs,
  /// seen from its end.
  /// \pre `advance(c)` returns `Turn::ends`
  Halfedge_index outgoing_at_end(const Crossing& c, const Delta_complex& mesh,
                                 const Outgoing_halfedges& outgoing_halfedges) const
  {
    const Halfedge_index ji = mesh.opposite(c.halfedge);
    const Halfedge_index outgoing = mesh.prev(ji);
    const Integer from_j = static_cast<Integer>(crossings(ji) - 1 - c.number);
    return outgoing_in_corner(outgoing,
                              static_cast<Integer>(from_j - curves_around(mesh.next(ji), mesh)),
                              mesh, outgoing_halfedges);
  }

  /// returns outgoing halfedge `k` of the halfedges of \f$T_1\f$ that start inside the corner at
  /// the source of `outgoing`.
  Halfedge_index outgoing_in_corner(Halfedge_index outgoing, const Integer& k,
                                    const Delta_complex& mesh,
                                    const Outgoing_halfedges& outgoing_halfedges) const
  {
    const Vertex_index v = mesh.source(outgoing);
    const size_type along = static_cast<size_type>(is_shared(Edge_index(outgoing)));
    return outgoing_halfedges.halfedge(
      v, wrap(m_r[outgoing] + along + static_cast<size_type>(k), outgoing_halfedges.degree(v)));
  }

  /// calls `visit(k, start)` for every curve that starts inside the corner at the source of
  /// `outgoing`. The curve has index `k` in the corner, and runs along the outgoing halfedge
  /// `start` of \f$T_1\f$. Complexity: linear in the number of these curves.
  template <typename Visit>
  void for_each_curve_end(Halfedge_index outgoing, const Delta_complex& mesh,
                          const Outgoing_halfedges& outgoing_halfedges, const Visit& visit) const
  {
    // A boundary edge is shared.
    if(!(m_n[Edge_index(mesh.next(outgoing))] > 0))
      return;
    const Integer leaving = curves_leaving(mesh.next(outgoing), mesh);
    for(Integer k(0); k < leaving; ++k)
      visit(k, outgoing_in_corner(outgoing, k, mesh, outgoing_halfedges));
  }

  /// returns the halfedge of \f$T_1\f$ that coincides with `h`. \pre `is_shared(edge(h))`
  Halfedge_index shared_halfedge(Halfedge_index h, const Delta_complex& mesh,
                                 const Outgoing_halfedges& outgoing_halfedges) const
  {
    return outgoing_halfedges.halfedge(mesh.source(h), m_r[h]);
  }

  /// @}
  /// \name Modification
  /// @{

  /// turns the edge of `h` as `flip_edge()` does and updates its normal coordinate (Equation 3.4)
  /// and the roundabouts of its halfedges (Equation 3.5). Complexity: constant.
  /// \throws Overflow_error if the new normal coordinate is out of range; nothing has changed then.
  /// \pre `flip_status(h, mesh) == Operation_status::possible`
  void flip(Halfedge_index h, Delta_complex& mesh, const Outgoing_halfedges& outgoing_halfedges)
  {
    const Diamond<Integer> n = diamond(m_n, h, mesh);
    const Integer n_kl = flipped_normal_coordinate(n);
    internal::check_range(n_kl);
    const Halfedge_index lk = h, kl = opposite(h), ki = mesh.prev(lk), lj = mesh.prev(kl);
    flip_edge(h, mesh);
    m_n[Edge_index(h)] = n_kl;
    m_r[kl] =
      following_roundabout(ki, n.ki, n.il, n_kl, outgoing_halfedges.degree(mesh.target(lk)));
    m_r[lk] =
      following_roundabout(lj, n.lj, n.jk, n_kl, outgoing_halfedges.degree(mesh.target(kl)));
  }

  /// inserts a vertex into the face of `h` as `split_face()` does (Section 3.5.1).
  /// Complexity: constant.
  /// \param h a halfedge that is not a border halfedge
  /// \param at the coordinates of the edges from the new vertex to the source of `h`, its target,
  ///   and the target of the next halfedge. At most one of them is shared
  /// \param outgoing the first outgoing halfedge of the new vertex if it is on an edge of
  ///   \f$T_1\f$, otherwise null
  /// \param mesh the mesh
  /// \param outgoing_halfedges the outgoing halfedges of \f$T_1\f$, to which the outgoing
  ///   halfedges of the new vertex are added
  /// \returns the new vertex
  /// \throws Overflow_error if a normal coordinate is out of range; nothing has changed then.
  Vertex_index split_face(Halfedge_index h, const Face_split<Integer>& at, Halfedge_index outgoing,
                          Delta_complex& mesh, Outgoing_halfedges& outgoing_halfedges)
  {
    for(const Integer& value : at.n)
      internal::check_range(value);
    const std::array<Halfedge_index, 3> side{h, mesh.next(h), mesh.prev(h)};
    const Vertex_index m = mesh.target(Intrinsic_triangulations::split_face(h, mesh));
    outgoing_halfedges.set_inserted(m, outgoing);
    for(std::size_t s = 0; s < 3; ++s) {
      const Halfedge_index inward = mesh.opposite(mesh.prev(side[s]));
      m_n[Edge_index(inward)] = at.n[s];
      m_r[mesh.opposite(inward)] = at.r[s];
      m_r[inward] = following_roundabout(side[s], m_n[Edge_index(side[s])], at.n[(s + 1) % 3],
                                         at.n[s], outgoing_halfedges.degree(mesh.source(inward)));
    }
    return m;
  }

  /// inserts a vertex \f$m\f$ into the edge \f$ij\f$ of `h` as `split_edge()` does (Section 3.5.1).
  /// Complexity: constant.
  /// \param h the halfedge from \f$i\f$ to \f$j\f$
  /// \param n the normal coordinates of the new edges; the two parts of a shared edge are shared
  /// \param r the roundabouts of the halfedges from \f$m\f$ along these edges
  /// \param outgoing the first outgoing halfedge of \f$m\f$ if it is on an edge of \f$T_1\f$,
  ///   otherwise null
  /// \param mesh the mesh
  /// \param outgoing_halfedges the outgoing halfedges of \f$T_1\f$, to which the outgoing
  ///   halfedges of \f$m\f$ are added
  /// \returns \f$m\f$; `h` leads from \f$m\f$ to \f$j\f$
  /// \throws Overflow_error if a normal coordinate is out of range; nothing has changed then.
  /// \pre the two sides of the edge are not in one face
  Vertex_index split_edge(Halfedge_index h, const Edge_split<Integer>& n,
                          const Edge_split<size_type>& r, Halfedge_index outgoing,
                          Delta_complex& mesh, Outgoing_halfedges& outgoing_halfedges)
  {
    CGAL_precondition(flip_status(h, mesh) != Operation_status::same_face);
    for(const Integer& value : {n.im, n.mj, n.mk, n.ml})
      internal::check_range(value);
    const Halfedge_index o = mesh.opposite(h);
    const size_type r_i = m_r[h];
    const Halfedge_index im = Intrinsic_triangulations::split_edge(h, mesh);
    const Vertex_index m = mesh.target(im);
    outgoing_halfedges.set_inserted(m, outgoing);
    m_n[Edge_index(im)] = n.im;
    m_n[Edge_index(h)] = n.mj;
    m_r[im] = r_i;
    m_r[mesh.opposite(im)] = r.im;
    m_r[h] = r.mj;
    set_cut(im, n.mk, r.mk, mesh, outgoing_halfedges);
    set_cut(o, n.ml, r.ml, mesh, outgoing_halfedges);
    return m;
  }

  /// makes the edge of `h` shared. An edge of \f$T_1\f$ joins its ends, and starts along the
  /// outgoing halfedges with indices `r_source` and `r_target`.
  void set_shared(Halfedge_index h, size_type r_source, size_type r_target)
  {
    m_n[Edge_index(h)] = Integer(-1);
    m_r[h] = r_source;
    m_r[opposite(h)] = r_target;
  }

  /// sets the coordinates as they come from a file.
  void set(Edge_index e, const Integer& n) { m_n[e] = n; }
  /// sets the coordinates as they come from a file.
  void set(Halfedge_index h, size_type r) { m_r[h] = r; }

  /// @}

  /// checks the numbers against each other. The crossings in each face must be valid, boundary
  /// edges must be shared, and the outgoing halfedges of both triangulations must agree around
  /// every vertex. Complexity: linear.
  bool is_valid(const Delta_complex& mesh, const Outgoing_halfedges& outgoing_halfedges) const
  {
    for(Edge_index e : mesh.edges())
      if(m_n[e] < -1 || (mesh.is_border(e) && m_n[e] != -1))
        return false;
    for(Face_index f : mesh.faces())
      if(!has_valid_crossings(mesh.halfedge(f), mesh))
        return false;
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v) && !has_valid_roundabouts(v, mesh, outgoing_halfedges))
        return false;
    return true;
  }

private:
  // Wraps `position`, which exceeds the degree by less than one round.
  static size_type wrap(size_type position, size_type degree)
  {
    return position < degree ? position : position - degree;
  }

  // Returns the roundabout of k->l, from the preceding outgoing halfedge k->i and the normal
  // coordinates of their face (Equation 3.5).
  size_type following_roundabout(Halfedge_index ki, const Integer& n_ki, const Integer& n_il,
                                 const Integer& n_kl, size_type degree) const
  {
    const Integer leaving = Intrinsic_triangulations::curves_leaving(
      Intrinsic_triangulations::crossings(n_il), Intrinsic_triangulations::crossings(n_ki),
      Intrinsic_triangulations::crossings(n_kl));
    const size_type along = static_cast<size_type>(Intrinsic_triangulations::is_shared(n_ki));
    return wrap(m_r[ki] + static_cast<size_type>(leaving) + along, degree);
  }

  // Sets the coordinates of the edge mk after a vertex m has split an edge; k is on the left of its
  // part `im`.
  void set_cut(Halfedge_index im, const Integer& n_mk, size_type r_mk, const Delta_complex& mesh,
               const Outgoing_halfedges& outgoing_halfedges)
  {
    if(mesh.is_border(im))
      return;
    const Halfedge_index mk = mesh.next(im), ki = mesh.next(mk);
    m_n[Edge_index(mk)] = n_mk;
    m_r[mk] = r_mk;
    m_r[mesh.opposite(mk)] = following_roundabout(ki, m_n[Edge_index(ki)], m_n[Edge_index(im)],
                                                  n_mk, outgoing_halfedges.degree(mesh.source(ki)));
  }

  bool has_valid_crossings(Halfedge_index h, const Delta_complex& mesh) const
  {
    return are_valid_crossings(crossings(h), crossings(mesh.next(h)), crossings(mesh.prev(h)));
  }

  bool has_valid_roundabouts(Vertex_index v, const Delta_complex& mesh,
                             const Outgoing_halfedges& outgoing_halfedges) const
  {
    const size_type degree = outgoing_halfedges.degree(v);
    const Halfedge_index first = first_outgoing_halfedge(v, mesh);
    Integer total(0);
    for(Halfedge_index h = first;; h = next_around_source(h, mesh)) {
      if(m_r[h] >= (std::max)(degree, size_type(1)))
        return false;
      total += outgoing_halfedges_from(h, mesh);
      if(mesh.is_border(h))
        return m_r[h] == degree - 1 && total == Integer(degree);
      const Halfedge_index following = next_around_source(h, mesh);
      if(total > Integer(degree) ||
         m_r[following] !=
           wrap(m_r[h] + static_cast<size_type>(outgoing_halfedges_from(h, mesh)), degree))
        return false;
      if(following == first)
        return total == Integer(degree);
    }
  }

  Normal_coordinate_map m_n;
  Roundabout_map m_r;
};

/// \ingroup PkgIntrinsicTriangulationsIntegerCoordinates
/// collects the values of the edge map `map` on the diamond around the edge of `h`. Beyond a border
/// halfedge there is no face, and the two values there are unspecified.
template <typename EdgeMap>
inline Diamond<typename boost::property_traits<EdgeMap>::value_type>
diamond(const EdgeMap& map, Halfedge_index h, const Delta_complex& mesh)
{
  return internal::diamond_of([&](Halfedge_index x) { return map[mesh.edge(x)]; }, h, mesh);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTEGER_COORDINATES_H
