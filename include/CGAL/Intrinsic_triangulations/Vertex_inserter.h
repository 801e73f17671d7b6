// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/Crossing_lists.h>
#include <CGAL/Intrinsic_triangulations/internal/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/internal/Local_marks.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// inserts vertices into a triangulation \f$T_2\f$, and removes them (Section 3.5).
///
/// The object keeps for every edge of \f$T_2\f$ the edges of \f$T_1\f$ that cross it, in order. So an
/// insertion looks only at the crossings on the face in which it takes place, however far the edges of
/// \f$T_1\f$ run. The triangulation must not be changed by others while the object is used.
/// Memory: 24 bytes for each edge, and four and more for each crossing.
///
/// \tparam Traits_ a model of `IntrinsicGeometryTraits` whose number type is a floating point type
template <typename Traits_ = Euclidean_geometry_traits<double>>
class Vertex_inserter
{
public:
  /// the geometry.
  typedef Traits_ Traits;
  /// the type of the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the type of lengths and barycentric coordinates.
  typedef typename Traits::FT FT;
  /// the type of normal coordinates.
  typedef typename Traits::Integer Integer;

  /// prepares changes of `tri`. Complexity: linear in the elements and crossings.
  explicit Vertex_inserter(Triangulation& tri) : m_tri(tri), m_lists(tri), m_marks(tri) {}

  /// the triangulation.
  const Triangulation& triangulation() const { return m_tri; }

  /// inserts a vertex at the point `p` of \f$T_2\f$: into the face, or into an edge if one coordinate is
  /// zero. Whatever the rounding, the integer coordinates are those of a point in one region between
  /// edges of \f$T_1\f$ (Section 3.5.1), and if `p` is on a shared edge, the vertex is on that edge of
  /// \f$T_1\f$. Complexity: linear in the crossings on the sides of the face.
  /// \param p a point with coordinates that are not negative and sum up to one
  /// \returns the vertex; one that was there already if two coordinates are zero
  /// \throws Numerical_error if a new edge has no positive finite length; nothing has changed then.
  Vertex_index insert(const Face_location<FT>& p)
  {
    const auto side = internal::sides(p.first, m_tri.mesh());
    for(std::size_t s = 0; s < 3; ++s) {
      const FT &at_target = p.second[(s + 1) % 3], &at_apex = p.second[(s + 2) % 3];
      if(at_target == 0 && at_apex == 0)
        return m_tri.mesh().source(side[s]);
      if(at_apex == 0 && p.second[s] > 0 && at_target > 0 && can_be_split(side[s]))
        return split_edge(side[s], at_target);
    }
    return split_face(p);
  }

  /// whether the edge of `h` can be split: not if both of its sides are in one face.
  bool can_be_split(Halfedge_index h) const
  {
    return flip_status(h, m_tri.mesh()) != Operation_status::same_face;
  }

  /// inserts a vertex into the edge of `h`, at `t` between its source and its target. `h` leads on from
  /// there. Complexity: linear in the crossings on the sides of its faces.
  /// \throws Numerical_error if a new edge has no positive finite length; nothing has changed then.
  /// \pre `can_be_split(h)` and \f$0 < t < 1\f$
  Vertex_index split_edge(Halfedge_index h, const FT& t)
  {
    return m_tri.coordinates().is_shared(m_tri.mesh().edge(h)) ? split_shared_edge(h, t)
                                                               : split_crossed_edge(h, t);
  }

  /// flips the edge of `h`, see `Intrinsic_triangulation::flip()`. Complexity: linear in the crossings.
  void flip(Halfedge_index h)
  {
    m_tri.flip(h);
    m_lists.after_flip(h);
  }

  /// removes the inserted vertex `v`: flips edges until three are left, the most convex first
  /// (Section 3.5.2), and merges the faces there. The place of the vertex stays as garbage, see
  /// `Intrinsic_triangulation::collect_garbage()`.
  /// Complexity: in practice quadratic in the degree.
  /// \param v the vertex
  /// \param after_flip a function that is called with a halfedge of every flipped edge
  /// \returns the face that takes its place; null if no more edges could be flipped: then the vertex
  ///          stays, and the triangulation is valid, but perhaps not Delaunay
  /// \pre `triangulation().is_inserted(v)`
  template <typename After_flip>
  Face_index remove(Vertex_index v, const After_flip& after_flip);

  /// the same.
  Face_index remove(Vertex_index v)
  {
    return remove(v, [](Halfedge_index) {});
  }

private:
  typedef internal::Local_marks<Traits> Marks;

  Vertex_index split_face(const Face_location<FT>& p)
  {
    m_marks.set_face(p.first, m_lists);
    const internal::Face_map<FT, Marks> face_map(m_marks, m_tri.input_mesh());
    const std::size_t region = face_map.region_of(p.second);
    const auto [input_face, map] = face_map.region_map(region);
    const auto n = face_map.regions().crossings_to_corners(region);
    const Vertex_index m = m_tri.split_face(p, {Integer(n[0]), Integer(n[1]), Integer(n[2])},
                                            {input_face, map(p.second)});
    const Halfedge_index a = first_spoke(m, m_tri.mesh());
    const Halfedge_index b = next_spoke(a, m_tri.mesh());
    m_lists.after_cut({a, b, next_spoke(b, m_tri.mesh())});
    return m;
  }

  // the number of crossings from a point on `h` after `p` of its crossings to the opposite corner
  Integer crossings_to_apex(Halfedge_index h, std::size_t p) const
  {
    if(m_tri.mesh().is_border(h))
      return Integer(0);
    const internal::Face_regions regions(
      {m_lists.count(h), m_lists.count(m_tri.mesh().next(h)), m_lists.count(m_tri.mesh().prev(h))});
    return Integer(regions.crossings_to_corners(regions.region_at_side(0, p))[2]);
  }

  Vertex_index split_shared_edge(Halfedge_index h, const FT& t)
  {
    const Halfedge_index o = m_tri.mesh().opposite(h);
    const Edge_split<Integer> n{Integer(-1), Integer(-1), crossings_to_apex(h, 0),
                                crossings_to_apex(o, 0)};
    const Vertex_index m = m_tri.split_edge(h, t, n);
    update_split(h);
    return m;
  }

  Vertex_index split_crossed_edge(Halfedge_index h, const FT& t)
  {
    m_marks.set_face(m_tri.mesh().face(h), m_lists);
    const internal::Face_map<FT, Marks> face_map(m_marks, m_tri.input_mesh());
    const std::size_t s = internal::side_number(h, m_tri.mesh()), n = m_lists.count(h);
    std::size_t p = 0;
    while(p < n && m_marks.here(s, p) < t)
      ++p;
    const auto [input_face, map] = face_map.region_map(face_map.regions().region_at_side(s, p));
    const Edge_split<Integer> split{Integer(p), Integer(n - p), crossings_to_apex(h, p),
                                    crossings_to_apex(m_tri.mesh().opposite(h), n - p)};
    const Vertex_index m =
      m_tri.split_edge(h, t, split, {input_face, map(internal::barycentric_coordinates(s, t))});
    update_split(h);
    return m;
  }

  // after an edge has been split, of which `h` is the second part
  void update_split(Halfedge_index h)
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index o = mesh.opposite(h);
    const Halfedge_index im = mesh.prev(mesh.is_border(h) ? h : mesh.opposite(mesh.prev(h)));
    m_lists.after_split(im, h);
    if(!mesh.is_border(im) && !mesh.is_border(o))
      m_lists.after_cut({mesh.next(im), mesh.next(o)});
    else
      m_lists.after_cut({mesh.next(mesh.is_border(o) ? im : o)});
  }

  // ---- Removal ----

  // The excess over pi of the greater of the two angles at the ends of the edge of `h`, in the diamond
  // around it. Where it is not positive, the edge can be flipped.
  FT concavity(Halfedge_index h) const
  {
    const Delta_complex& mesh = m_tri.mesh();
    const Halfedge_index o = mesh.opposite(h);
    const auto angle = [&](Halfedge_index x) {
      return internal::angle_at_source(x, mesh, m_tri.length_map());
    };
    const FT at_source = angle(h) + angle(mesh.next(o)), at_target = angle(o) + angle(mesh.next(h));
    return (std::max)(at_source, at_target) - FT(CGAL_PI);
  }

  bool can_be_flipped(Halfedge_index h) const
  {
    return flip_status(h, m_tri.mesh()) == Operation_status::possible &&
           !m_tri.is_constrained(m_tri.mesh().edge(h));
  }

  Halfedge_index edge_to_flip(Vertex_index v) const;

  Triangulation& m_tri;
  internal::Crossing_lists<Traits> m_lists;
  Marks m_marks;
};

// A vertex with less than three spokes gets more if an edge opposite to it is flipped; otherwise a flip of
// a spoke takes one away, and that of a loop two. Angles at the vertex itself may exceed pi by rounding.
template <typename Traits>
Halfedge_index Vertex_inserter<Traits>::edge_to_flip(Vertex_index v) const
{
  const Delta_complex& mesh = m_tri.mesh();
  std::size_t degree = 0;
  FT best = FT(1e-6); // beyond rounding of the angles
  Halfedge_index result, link;
  FT best_link = best;
  Halfedge_index h = first_spoke(v, mesh);
  const Halfedge_index first = h;
  do {
    ++degree;
    if(can_be_flipped(h)) {
      const FT c = mesh.target(h) == v ? FT(-4) : concavity(h);
      if(c < best) {
        best = c;
        result = h;
      }
    }
    if(mesh.is_border(h))
      break;
    if(can_be_flipped(mesh.next(h)) && concavity(mesh.next(h)) < best_link) {
      best_link = concavity(mesh.next(h));
      link = mesh.next(h);
    }
    h = next_spoke(h, mesh);
  } while(h != first);
  return degree < 3 ? link : result;
}

template <typename Traits>
template <typename After_flip>
Face_index Vertex_inserter<Traits>::remove(Vertex_index v, const After_flip& after_flip)
{
  CGAL_precondition(m_tri.is_inserted(v));
  const Delta_complex& mesh = m_tri.mesh();
  for(std::size_t flips = 0; removal_status(v, mesh) != Operation_status::possible; ++flips) {
    const Halfedge_index h = edge_to_flip(v);
    if(!h.is_valid() || flips > 10000)
      return mesh.null_face();
    flip(h);
    after_flip(h);
  }
  const Face_index f = m_tri.remove_degree_3_vertex(v);
  for(Halfedge_index h : internal::sides(f, mesh))
    m_lists.set_if_shared(mesh.edge(h));
  return f;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VERTEX_INSERTER_H
