// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_INSCRIBED_POLYGON_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_INSCRIBED_POLYGON_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Flattening_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Conformal_barycenter.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Unfolded_sphere.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Any_visitor.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/length_cross_ratios.h>
#include <CGAL/Intrinsic_triangulations/flip_to_shared.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the image of a disk with all vertices on the boundary. The mirror symmetry of its
// double fixes all vertices of the ideal polyhedron. So the symmetry is a reflection in a plane
// that contains all vertices, and the polyhedron is an ideal polygon with two sides. The boundary
// of the polygon consists of the geodesics of the boundary of the disk. Every triangulation of the
// polygon is a triangulation of the convex hull.
//
// Therefore no minimization is necessary. Edges of T_2 that cross the boundary are flipped. The
// chords from the vertex at infinity follow from face to face by Ptolemy's relation. The relation
// needs only sums, products and quotients of positive numbers. The bounds of Section 4.4.3 are the
// scale factors.
//
// Positions near infinity and near the origin have all digits at any scale. Therefore the vertices
// at infinity and at the origin are chosen as far from each other as possible. Then a strip whose
// ends are 1e-60 of its size keeps its vertices apart.
//
// `FT` is the number type of lengths and positions.
template <typename FT>
class Inscribed_polygon
{
  typedef std::array<FT, 2> Point;

public:
  // `mass` contains the mass of each vertex; `start` is one of the vertices.
  // \pre every vertex of the problem that is not isolated is on the boundary
  Inscribed_polygon(Doubled_problem& problem, const std::vector<double>& mass, Vertex_index start,
                    Any_visitor& visitor)
    : m_problem(problem),
      m_at_infinity(start),
      m_surface(problem.triangulation().mesh(),
                problem.template lengths<FT>(problem.triangulation()))
  {
    visitor.start(Flattening_stage::optimize);
    flip_to_boundary();
    collect_original_faces();
    measure_chords();
    m_at_infinity = mesh().source(smallest_side());
    measure_chords();
    for(const FT& chord : m_chord)
      m_u.push_back(static_cast<double>(FT(-2 * log(chord))));
    visitor.start(Flattening_stage::layout);
    m_result.layout.exists = true;
    clear_positions();
    try {
      lay_out(mass);
    } catch(const Intrinsic_triangulations::Numerical_error& e) {
      m_result.cause = e.what();
      certify();
    }
    complete_result();
  }

  const Unfolded_sphere& result() const { return m_result; }

  // Returns the logarithmic scale factors in the unit disk. Let x be the position of a vertex on
  // the line in units of `m_scale`, and c its chord from infinity. Its scale factor is 2 /
  // (m_scale c^2 (1 + x^2)).
  std::vector<Decimal_115> log_scales_in_disk() const
  {
    const Decimal_115 unit = converted<Decimal_115>(m_scale);
    std::vector<Decimal_115> result;
    for(std::size_t v = 0; v < m_chord.size(); ++v) {
      const Decimal_115 chord = converted<Decimal_115>(m_chord[v]),
                        x = converted<Decimal_115>(m_position[v][0]);
      result.push_back(log(Decimal_115(
        v == m_at_infinity.idx() ? 2 * unit : 2 / (unit * chord * chord * (1 + x * x)))));
    }
    for(Vertex_index v : m_problem.surface().vertices())
      if(m_problem.surface().is_isolated(v))
        result[v.idx()] = 0;
    return result;
  }

  // Returns the lengths of boundary edges of the surface with these scale factors, and zero for
  // other edges.
  std::vector<double> side_lengths_in_disk() const
  {
    const std::vector<Decimal_115> u = log_scales_in_disk();
    std::vector<double> result(m_problem.surface().num_edges(), 0);
    for(const auto& [h, input] : m_sides)
      result[input.idx()] = static_cast<double>(scaled_length(
        converted<Decimal_115>(length(h)),
        length_factor(Decimal_115(u[mesh().source(h).idx()] + u[mesh().target(h).idx()]))));
    return result;
  }

  // Returns whether a face of T_3 is a face of the front of the polygon, not of its back.
  bool is_original(Face_index f) const { return m_is_original[f.idx()]; }

private:
  const Delta_complex& mesh() const { return m_surface.mesh(); }
  const FT& length(Halfedge_index h) const { return m_surface.length(Edge_index(h)); }

  void clear_positions() { m_position.assign(m_problem.size(), Point{FT(0), FT(0)}); }

  // Completes the result. Every vertex is a neighbor of infinity, so no angle is prescribed, and
  // scale factors follow without a search.
  void complete_result()
  {
    m_result.layout.at_infinity = m_at_infinity;
    m_result.layout.is_extended = m_result.layout.is_flat = true;
    m_result.angle_error = 0;
    m_result.flips = m_surface.flips();
    m_result.layout.in_plane = in_range_of_squares(m_position);
    m_result.log_scale =
      spherical_log_scales(m_u, m_scale, m_position, m_at_infinity, m_problem.surface());
  }

  // Flips edges until all boundary edges exist. Records the halfedges of T_3 that have the
  // boundary on their right.
  void flip_to_boundary()
  {
    const Doubled_problem::Triangulation& tri = m_problem.triangulation();
    const Delta_complex& half = m_problem.surface();
    const auto is_boundary = [&](Halfedge_index h) {
      return h.idx() < half.num_halfedges() && half.is_border(Edge_index(h));
    };
    Delta_complex mesh = tri.mesh();
    Doubled_problem::Triangulation::Coordinates coordinates(mesh);
    m_surface.replay(Intrinsic_triangulations::flip_to_share(
      coordinates, mesh, tri.outgoing_halfedges(), is_boundary));
    m_is_on_boundary.assign(mesh.num_edges(), 0);
    for(Halfedge_index h : mesh.halfedges())
      if(coordinates.is_shared(Edge_index(h)))
        if(const Halfedge_index side =
             coordinates.shared_halfedge(h, mesh, tri.outgoing_halfedges());
           is_boundary(side)) {
          m_is_on_boundary[Edge_index(h).idx()] = 1;
          if(!half.is_border(side))
            m_sides.emplace_back(h, Edge_index(side));
        }
  }

  // Collects the faces of T_3 that triangulate the front of the polygon.
  void collect_original_faces()
  {
    m_is_original.assign(mesh().num_faces(), 0);
    std::vector<Halfedge_index> waiting;
    for(const auto& side : m_sides)
      waiting.push_back(side.first);
    while(!waiting.empty()) {
      const Halfedge_index h = waiting.back();
      waiting.pop_back();
      if(std::exchange(m_is_original[mesh().face(h).idx()], 1))
        continue;
      for(Halfedge_index side : sides(mesh().face(h), mesh()))
        if(!m_is_on_boundary[Edge_index(side).idx()])
          waiting.push_back(mesh().opposite(side));
    }
  }

  // Computes the lengths of the chords from the vertex at infinity. The faces at infinity come
  // first. Then each face beyond a side determines the chord to its opposite corner.
  void measure_chords()
  {
    m_chord.assign(m_problem.size(), FT(1));
    std::vector<Halfedge_index> waiting;
    for(Halfedge_index h : mesh().halfedges())
      if(is_original(mesh().face(h)) && mesh().source(h) == m_at_infinity) {
        m_chord[mesh().target(h).idx()] = length(h);
        m_chord[mesh().source(mesh().prev(h)).idx()] = length(mesh().prev(h));
        waiting.push_back(mesh().next(h));
      }
    while(!waiting.empty()) {
      const Halfedge_index h = mesh().opposite(waiting.back());
      waiting.pop_back();
      if(m_is_on_boundary[Edge_index(h).idx()])
        continue;
      const Halfedge_index next = mesh().next(h), prev = mesh().prev(h);
      m_chord[mesh().target(next).idx()] = (length(prev) * m_chord[mesh().target(h).idx()] +
                                            length(next) * m_chord[mesh().source(h).idx()]) /
                                           length(h);
      waiting.push_back(next);
      waiting.push_back(prev);
    }
  }

  // Returns the sides of the polygon from one neighbor of infinity to the other, counterclockwise.
  std::vector<Halfedge_index> sides_in_plane() const
  {
    std::vector<Halfedge_index> side_from(m_problem.size());
    for(const auto& side : m_sides)
      side_from[mesh().source(side.first).idx()] = side.first;
    std::vector<Halfedge_index> result;
    const auto after = [&](Halfedge_index h) { return side_from[mesh().target(h).idx()]; };
    for(Halfedge_index h = after(side_from[m_at_infinity.idx()]); mesh().target(h) != m_at_infinity;
        h = after(h))
      result.push_back(h);
    return result;
  }

  // Returns the distance between the ends of a side in the plane (Equation 4.15). It is the length
  // of a horocyclic arc at infinity.
  FT gap(Halfedge_index h) const
  {
    return length(h) / m_chord[mesh().source(h).idx()] / m_chord[mesh().target(h).idx()];
  }

  // Returns the side in the plane that is farthest from infinity.
  Halfedge_index smallest_side() const
  {
    const std::vector<Halfedge_index> sides = sides_in_plane();
    return *std::min_element(
      sides.begin(), sides.end(),
      [this](Halfedge_index h, Halfedge_index o) { return gap(h) < gap(o); });
  }

  // Lays out the polygon such that the center of mass is the center. If this needs more than 32
  // digits, the ends of the polygon are placed at the origin and at infinity. Positions
  // beside the origin have all digits.
  void lay_out(const std::vector<double>& mass)
  {
    const std::vector<Halfedge_index> sides = sides_in_plane();
    const auto end =
      std::size_t(std::find(sides.begin(), sides.end(), smallest_side()) - sides.begin());
    add_gaps(sides, end, FT(0));
    if(!is_in_range(sides)) {
      clear_positions();
      certify();
      return;
    }
    const Conformal_barycenter<FT> center(m_position, mass, m_at_infinity.idx());
    m_scale = center.height();
    const FT base = center.base()[0];
    const std::size_t nearest = nearest_side(sides, base);
    place(sides, nearest, at(mesh().source(sides[nearest])) - base);
    if(!m_result.is_good(tolerance::cross_ratio))
      place(sides, end, FT(0));
  }

  // Returns whether products of distances are in the range of their type, and have all digits.
  bool is_in_range(const std::vector<Halfedge_index>& sides) const
  {
    if(std::is_same<FT, Decimal_1500>::value)
      return true;
    const double least = static_cast<double>(gap(smallest_side())),
                 greatest = static_cast<double>(at(mesh().target(sides.back())) -
                                                at(mesh().source(sides.front())));
    return least > tolerance::least_distance && greatest < 1 / tolerance::least_distance;
  }

  // Returns the side whose source is nearest to `x`.
  std::size_t nearest_side(const std::vector<Halfedge_index>& sides, const FT& x) const
  {
    using std::abs;
    const auto distance = [&](Halfedge_index h) { return FT(abs(FT(at(mesh().source(h)) - x))); };
    return std::size_t(std::min_element(sides.begin(), sides.end(),
                                        [&](Halfedge_index h, Halfedge_index o) {
                                          return distance(h) < distance(o);
                                        }) -
                       sides.begin());
  }

  void place(const std::vector<Halfedge_index>& sides, std::size_t first, const FT& x)
  {
    add_gaps(sides, first, x);
    for(Point& p : m_position)
      p[0] = p[0] / m_scale;
    certify();
    m_result.cross_ratio_error = max_stereographic_cross_ratio_error(
      mesh(), [this](Edge_index e) { return m_surface.length(e); }, m_position, m_at_infinity);
  }

  // Sets the source of a side to `x`, and positions the other vertices beside it. Sums that start
  // at this side lose the fewest digits.
  void add_gaps(const std::vector<Halfedge_index>& sides, std::size_t first, const FT& x)
  {
    at(mesh().source(sides[first])) = x;
    for(std::size_t s = first; s < sides.size(); ++s)
      at(mesh().target(sides[s])) = at(mesh().source(sides[s])) + gap(sides[s]);
    for(std::size_t s = first; s > 0; --s)
      at(mesh().source(sides[s - 1])) = at(mesh().target(sides[s - 1])) - gap(sides[s - 1]);
  }

  FT& at(Vertex_index v) { return m_position[v.idx()][0]; }
  const FT& at(Vertex_index v) const { return m_position[v.idx()][0]; }

  // Certifies the result. The corners of each face must be in cyclic order on the line through
  // infinity. This condition suffices: all edges lie in one plane, and the two faces of an edge do
  // not overlap.
  void certify()
  {
    Convexity_certificate& certificate = m_result.layout.certificate = Convexity_certificate();
    for(Face_index f : mesh().faces())
      certificate.flipped_triangles += is_original(f) && !is_in_order(f);
    certificate.is_simple = certificate.flipped_triangles == 0;
  }

  bool is_in_order(Face_index f) const
  {
    int ascents = 0, descents = 0;
    for(Halfedge_index h : sides(f, mesh())) {
      const int order = order_of(mesh().source(h), mesh().target(h));
      ascents += order > 0;
      descents += order < 0;
    }
    return ascents == 2 && descents == 1;
  }

  // Returns 1 if `v` comes before `w`. Infinity comes after all other vertices.
  int order_of(Vertex_index v, Vertex_index w) const
  {
    if(v == m_at_infinity || w == m_at_infinity)
      return v == w ? 0 : w == m_at_infinity ? 1 : -1;
    return at(v) < at(w) ? 1 : at(w) < at(v) ? -1 : 0;
  }

  Doubled_problem& m_problem;
  Vertex_index m_at_infinity;
  Ptolemy_surface<FT> m_surface;      // the surface T_3
  std::vector<char> m_is_on_boundary; // for each edge
  // Stores the sides of the polygon with their edges of the surface. The polygon is on the left.
  std::vector<std::pair<Halfedge_index, Edge_index>> m_sides;
  std::vector<char> m_is_original; // for each face
  std::vector<FT> m_chord;
  std::vector<double> m_u;
  std::vector<Point> m_position; // the positions of the vertices of the surface itself, on a line
  FT m_scale = FT(1);
  Unfolded_sphere m_result;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_INSCRIBED_POLYGON_H
