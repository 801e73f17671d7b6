// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_ACROSS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_ACROSS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Correspondence_marks.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_map.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Face_regions.h>
#include <CGAL/Intrinsic_triangulations/internal/tracing/Input_face_walk.h>

#include <CGAL/enum.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Locates points of one triangulation on the other. Exact signs decide on which side of the curves
// through its face a point lies.
template <typename Traits>
class Element_locator
{
  typedef Correspondence_marks<Traits> Marks;
  typedef Input_face_walk<Traits> Walk;
  typedef std::array<double, 3> Coordinates;

public:
  explicit Element_locator(const Correspondence<Traits>& correspondence)
    : m_correspondence(correspondence),
      m_tri(correspondence.triangulation()),
      m_decisions(m_tri, correspondence.courses())
  {}

  Surface_element operator()(Side side, const Face_location<double>& p)
  {
    const Delta_complex& mesh = m_correspondence.mesh(side);
    const Surface_point<double> point = surface_point(p, mesh);
    if(is_at_vertex(point))
      return element_of_vertex(mesh.source(halfedge_of(point)));
    if(on_edge(point) && m_correspondence.is_shared(side, Edge_index(halfedge_of(point))))
      return shared_edge(side, halfedge_of(point));
    return side == Side::input && m_correspondence.contains_inserted(p.first)
             ? element_by_search(p)
             : element_by_curves(side, p);
  }

private:
  // ---- By the curves that cross the face ----

  Surface_element element_by_curves(Side side, const Face_location<double>& p)
  {
    const Marks marks(side, p.first, m_correspondence);
    const auto halfedge = sides(p.first, m_correspondence.mesh(side));
    const Delta_complex& other = m_correspondence.mesh(internal::other(side));
    const Face_map<typename Traits::FT, Marks> map(marks, other);
    const Face_regions& regions = map.regions();
    std::optional<Region_corner> tie;
    const auto is_before = [&](const Region_corner& mark, const Region_corner& other_mark) {
      const Sign sign = side == Side::input ? side_of_intrinsic(halfedge[mark.side], mark.mark, p)
                                            : side_of_input(halfedge, mark, other_mark, p.second);
      if(sign == ZERO)
        tie = mark;
      return sign == POSITIVE;
    };
    const std::size_t region = regions.find(
      [&](std::size_t s, std::size_t j) {
        const auto curve = regions.curve_around(s, j);
        return is_before(curve[0], curve[1]);
      },
      [&](std::size_t j) {
        return is_before(regions.end_of_curve(j), {regions.apex(), Region_corner::none, false});
      });
    if(tie)
      return Edge_index(marks.across(tie->side, tie->mark).halfedge);
    return map.region_map(region).first;
  }

  // Returns the element of the other triangulation that contains a vertex.
  Surface_element element_of_vertex(Vertex_index v) const
  {
    if(!m_tri.is_inserted(v))
      return v;
    const Surface_point<double>& p = m_tri.inserted_vertex(v);
    if(on_edge(p))
      return Edge_index(halfedge_of(p));
    return std::get<Face_location<double>>(p).first;
  }

  // Returns the edge of the other triangulation along `h`.
  Surface_element shared_edge(Side side, Halfedge_index h) const
  {
    return Edge_index(side == Side::input ? m_correspondence.outgoing_before(side, h)
                                          : m_tri.input_halfedge(h));
  }

  // Compares sides, seen from the edge of T2 that leaves the face as crossing `number`. Returns
  // POSITIVE if `p` is on the side of the source of the halfedge `h` of T1. Returns NEGATIVE if it
  // is on the side of its target.
  Sign side_of_intrinsic(Halfedge_index h, std::size_t number, const Face_location<double>& p)
  {
    const auto crossing =
      m_correspondence.crossing(Side::input, h, static_cast<Delta_complex::size_type>(number));
    const Halfedge_index x = crossing.across.halfedge;
    return -side_of_piece(x, m_correspondence.crossings_on_intrinsic().position(x, crossing.id), p);
  }

  // Returns POSITIVE if `p` is on the left of the halfedge `x` of T2. `p` is in the face of T1 in
  // which `x` has its piece `piece`.
  Sign side_of_piece(Halfedge_index x, std::size_t piece, const Face_location<double>& p)
  {
    return m_decisions.decide([&](const auto& development) {
      const auto strip = development.strip(x);
      const std::size_t n = strip.crossed.size();
      const auto side = piece < n ? strip.crossed[piece]
                        : n == 0  ? strip.first
                                  : development.beyond(strip.crossed[n - 1]);
      const auto w = development.weights(coordinates_from(side.halfedge, p, m_tri.input_mesh()));
      return sign_of_imaginary(conj(strip.end) * development.point(side, w));
    });
  }

  // Compares sides, seen from the edge of T1 that passes `mark` and `end`. The point has the
  // coordinates `b` in a face of T2. Returns POSITIVE if it is on the side of the source of the
  // side that has `mark`. The result is the sign of the sum of the heights of the corners over that
  // edge, with these weights.
  Sign side_of_input(const std::array<Halfedge_index, 3>& halfedge, const Region_corner& mark,
                     const Region_corner& end, const Coordinates& b)
  {
    const std::size_t s = mark.side, t = (s + 1) % 3, u = (s + 2) % 3;
    const Halfedge_index back = opposite(halfedge[s]);
    const std::size_t from_target = m_correspondence.courses().count(back) - 1 - mark.mark;
    return m_decisions.decide([&](const auto& development) {
      const auto w = development.weights(b);
      const auto near = development.strip(halfedge[s]).crossed[mark.mark];
      const auto far = development.strip(back).crossed[from_target];
      const auto square_near = m_decisions.squared_length(near),
                 square_far = m_decisions.squared_length(far);
      const auto difference =
        w[s] * m_decisions.height(near) * square_far - w[t] * m_decisions.height(far) * square_near;
      if(end.is_vertex())
        return sign_of_imaginary(difference);
      const auto third = development.strip(halfedge[u]).crossed[end.mark];
      return sign_of_imaginary(difference * m_decisions.squared_length(third) -
                               w[u] * m_decisions.height(third) * square_near * square_far);
    });
  }

  // ---- By a search over regions of a face of T1 ----

  Surface_element element_by_search(const Face_location<double>& p)
  {
    const Walk walk(m_correspondence);
    std::optional<Surface_element> result;
    const double sum = p.second[0] + p.second[1] + p.second[2];
    const Coordinates b{p.second[0] / sum, p.second[1] / sum, p.second[2] / sum};
    walk.for_each_region(walk.region_of({p.first, b}), [&](const typename Walk::Region_id& id) {
      result = element_at(id, walk.region(id), p);
      return result.has_value();
    });
    if(!result)
      throw Numerical_error("face " + std::to_string(p.first.idx()) +
                            " of the input has no region with the point: edges are bent");
    return *result;
  }

  // Returns the element that contains `p`, or nothing if `p` is not in the region or on its sides.
  std::optional<Surface_element> element_at(const typename Walk::Region_id& id,
                                            const Region& region, const Face_location<double>& p)
  {
    const auto halfedge = sides(id.first, m_tri.mesh());
    std::optional<Edge_index> tie;
    for(std::size_t c = 0; c < region.size(); ++c) {
      const Region_corner& corner = region[c];
      if(corner.arc_follows)
        continue;
      const Halfedge_index x = halfedge[corner.side];
      const Sign sign = m_correspondence.is_shared(Side::intrinsic, Edge_index(x))
                          ? side_of_shared(x, p)
                          : side_of_piece(x, corner.is_vertex() ? 0 : corner.mark + 1, p);
      if(sign == NEGATIVE)
        return {};
      if(sign == ZERO)
        tie = Edge_index(x);
    }
    if(!tie)
      return id.first;
    for(Halfedge_index h : halfedge)
      if(is_at_inserted(m_tri.mesh().source(h), p))
        return m_tri.mesh().source(h);
    return *tie;
  }

  // Returns the side of `p`, which lies in the face of T1 to the left of the shared halfedge `x`.
  Sign side_of_shared(Halfedge_index x, const Face_location<double>& p) const
  {
    return CGAL::sign(coordinates_from(m_tri.input_halfedge(x), p, m_tri.input_mesh())[2]);
  }

  // Returns whether the vertex `v` of T2 is an inserted vertex that lies exactly at `p`.
  bool is_at_inserted(Vertex_index v, const Face_location<double>& p) const
  {
    if(!m_tri.is_inserted(v))
      return false;
    bool result = false;
    for_each_location(m_tri.inserted_vertex(v), m_tri.input_mesh(), [&](const auto& q) {
      result = result || (q.first == p.first && are_proportional(q.second, p.second));
    });
    return result;
  }

  static bool are_proportional(const Coordinates& a, const Coordinates& b)
  {
    const auto is_zero = [&](std::size_t s, std::size_t t) {
      return Exact_ring(a[s]) * Exact_ring(b[t]) == Exact_ring(a[t]) * Exact_ring(b[s]);
    };
    return is_zero(0, 1) && is_zero(1, 2) && is_zero(2, 0);
  }

  const Correspondence<Traits>& m_correspondence;
  const Intrinsic_triangulation<Traits>& m_tri;
  Exact_decisions<Traits> m_decisions;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsCertificates
/// finds the vertex, edge or face of one triangulation that contains a point of the other one, by
/// exact decisions. A vertex or an edge is returned only if the point lies on it exactly. A face
/// is returned only if the point lies inside it.
///
/// \param correspondence the crossings of both
/// \param side the triangulation on which `p` lies
/// \param p a `Face_location`, an `Edge_location` or a `Surface_point`, with coordinates that are
///   not negative; the point has exactly these numbers divided by their sum
///
/// Complexity: logarithmic in the number of crossings on the sides of the face. For each of them
/// it is linear in the crossings on one or two edges of \f$T_2\f$. In a face of \f$T_1\f$ that
/// contains inserted vertices, the complexity is as for `point_across()`. Each side of the
/// searched regions adds a term that is linear in its crossings.
/// \tparam Traits `Euclidean_geometry_traits<double>` or `Exact_Euclidean_geometry_traits`
/// \throws Numerical_error if a decision is not made by 1024 bits and involves more than twelve
///         independent square roots, or edges of \f$T_2\f$ are bent
/// \pre the edges of \f$T_2\f$ are straight, see `Delaunay_certificate::is_geodesic()`
template <typename Traits, typename Point = Face_location<double>>
Surface_element element_across(const Correspondence<Traits>& correspondence, Side side,
                               const Point& p)
{
  return internal::Element_locator<Traits>(correspondence)(
    side, face_location(p, correspondence.mesh(side)));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_ACROSS_H
