// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_STEREOGRAPHIC_TRIANGULATION_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_STEREOGRAPHIC_TRIANGULATION_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Convexity_certificate.h>
#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_predicates.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Edge_stack.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents a triangulated sphere by vertices in the plane and one vertex at infinity. The plane
// has the stereographic projection of an inscribed polyhedron. Flips can make the triangulation
// exactly Delaunay, hence convex on the sphere. If the sphere is symmetric, a part of one half may
// be missing that edges from the other half do not reach. Beyond the border of the missing part,
// the triangulation is the mirror image of the other half.
template <typename FT>
class Stereographic_triangulation
{
  typedef Plane_predicates<FT> Predicates;

public:
  typedef typename Predicates::Point Point;

  Stereographic_triangulation(const Delta_complex& mesh, std::vector<Point> position,
                              Vertex_index at_infinity)
    : m_mesh(mesh), m_position(std::move(position)), m_at_infinity(at_infinity)
  {}

  bool is_finite(Face_index f) const
  {
    for(Halfedge_index h : sides(f, m_mesh))
      if(m_mesh.target(h) == m_at_infinity)
        return false;
    return true;
  }

  // Flips edges that are not convex, as far as possible. Rounding leaves only few such edges. Each
  // flip moves the surface of the polyhedron outwards, so the loop ends even if triangles are
  // reversed.
  std::vector<Halfedge_index> make_convex()
  {
    std::vector<Halfedge_index> flips;
    Intrinsic_triangulations::Edge_stack stack(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges())
      stack.push(e);
    flip_waiting(
      m_mesh, stack, [this](Halfedge_index h) { return !is_concave(h); },
      [&](Halfedge_index h) {
        flip_edge(h, m_mesh);
        flips.push_back(h);
      });
    return flips;
  }

  // Returns the certificate. A surface without a face in the plane is a flat polygon with two
  // sides, and counts as convex.
  Convexity_certificate certificate() const
  {
    Convexity_certificate result;
    for(Edge_index e : m_mesh.edges())
      result.concave_edges += is_concave(m_mesh.halfedge(e));
    std::size_t finite_faces = 0;
    for(Face_index f : m_mesh.faces()) {
      const auto side = sides(f, m_mesh);
      if(!is_finite(f))
        continue;
      ++finite_faces;
      result.flipped_triangles +=
        m_predicates.orientation(at(m_mesh.source(side[0])), at(m_mesh.source(side[1])),
                                 at(m_mesh.source(side[2]))) <= 0;
    }
    result.is_simple = finite_faces == 0 || number_of_local_maxima() == 1;
    return result;
  }

private:
  const Point& at(Vertex_index v) const { return m_position[v.idx()]; }

  // Returns whether the edge ij of the faces ijk and jil is concave as seen from outside. It is
  // concave if l is inside the circle through i, j and k. A border edge lies beside a mirror
  // image, and is never concave.
  bool is_concave(Halfedge_index h) const
  {
    if(m_mesh.is_border(Edge_index(h)))
      return false;
    const Halfedge_index o = m_mesh.opposite(h);
    return in_circle({m_mesh.target(o), m_mesh.target(h), m_mesh.target(m_mesh.next(h)),
                      m_mesh.target(m_mesh.next(o))}) > 0;
  }

  // Returns the predicate for a circle, or for a line if one point is infinity. An exchange of two
  // points changes the sign.
  int in_circle(const std::array<Vertex_index, 4>& v) const
  {
    for(std::size_t a = 0; a < 4; ++a)
      if(v[a] == m_at_infinity) {
        std::array<Vertex_index, 4> other = v;
        std::swap(other[a], other[0]);
        if(std::count(other.begin(), other.end(), m_at_infinity) > 1)
          return 0;
        const int sign = m_predicates.orientation(at(other[1]), at(other[2]), at(other[3]));
        return a == 0 ? sign : -sign;
      }
    return m_predicates.in_circle(at(v[0]), at(v[1]), at(v[2]), at(v[3]));
  }

  // Returns the number of local maxima on the boundary of the part in the plane. If a closed curve
  // always turns left, this number is its number of turns.
  std::size_t number_of_local_maxima() const
  {
    std::size_t result = 0;
    for_each_outgoing_halfedge(m_at_infinity, m_mesh, [&](Halfedge_index h) {
      const Point &before = at(m_mesh.target(previous_around_source(h, m_mesh))),
                  &here = at(m_mesh.target(h)),
                  &after = at(m_mesh.target(next_around_source(h, m_mesh)));
      result += is_below(before, here) && is_below(after, here);
    });
    return result;
  }

  static bool is_below(const Point& p, const Point& q)
  {
    return p[1] < q[1] || (p[1] == q[1] && p[0] < q[0]);
  }

  Predicates m_predicates;
  Delta_complex m_mesh;
  std::vector<Point> m_position;
  Vertex_index m_at_infinity;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_STEREOGRAPHIC_TRIANGULATION_H
