// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SURGERY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SURGERY_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Intrinsic_surface.h>
#include <CGAL/Intrinsic_simplification/internal/operations/angles.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/assertions.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Returns the angle at the center of the sides of a polygon that are chords of a circle.
inline double central_angle(const std::vector<double>& sides, double radius)
{
  double sum = 0;
  for(double s : sides)
    sum += 2 * std::asin((std::min)(1., s / (2 * radius)));
  return sum;
}

// Returns the radius of the circle in which a polygon with these sides is inscribed. No side may be
// longer than the side of an equilateral triangle in this circle. If one is, returns the radius of
// the circle in which it is such a side. The central angle decreases with the radius. Since asin(x)
// is at most pi x / 2, it is at most 2 pi at a fourth of the perimeter.
inline double disk_radius(const std::vector<double>& sides)
{
  double perimeter = 0, longest = 0;
  for(double s : sides) {
    perimeter += s;
    longest = (std::max)(longest, s);
  }
  double low = longest / std::sqrt(3.), high = (std::max)(low, perimeter / 4);
  if(central_angle(sides, low) <= 2 * pi<double>())
    return low;
  for(double middle = (low + high) / 2; low < middle && middle < high; middle = (low + high) / 2)
    (central_angle(sides, middle) > 2 * pi<double>() ? low : high) = middle;
  return high;
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationApplications
/// a surface that can be cut along closed curves, and whose boundary loops can be closed by disks.
/// It maps points from the original surface and back.
///
/// A disk that closes a loop has one vertex, the apex. Edges of one length join it to all vertices
/// of the loop. The disk is flat, and its boundary inscribed in a circle, unless an edge of the
/// loop is longer than \f$\sqrt{3}\f$ times the radius. Then the edges to the apex are
/// \f$1/\sqrt{3}\f$ times as long as the longest edge, and the disk is a cone.
///
/// Nothing changes outside the disks: faces, edges and vertices keep their indices, lengths and
/// angles. New elements have greater indices. Along a cut, the left side gets new vertices and the
/// right side new edges.
///
/// The surface may be triangulated again between operations. Then faces and edges get other
/// indices; the map includes this change.
/// \cgalModels `IntrinsicSurface`
class Surface_surgery
{
public:
  /// the type of the input, and of the result.
  typedef Intrinsic_surface::Triangulation Triangulation;
  /// a face and barycentric coordinates that sum up to one.
  typedef Intrinsic_triangulations::Face_location<double> Location;
  /// a readable property map from edges to their lengths.
  typedef Intrinsic_surface::Length_map Length_map;

  /// starts with the intrinsic triangulation \f$T_2\f$ of `tri`. Complexity: linear.
  /// \pre `tri` has no garbage
  explicit Surface_surgery(const Triangulation& tri)
    : m_origin(tri.mesh().vertices().begin(), tri.mesh().vertices().end()),
      m_number_of_faces(tri.mesh().number_of_faces())
  {
    CGAL_precondition(!tri.mesh().has_garbage());
    copy_from(tri);
  }

  /// \name The Surface
  /// @{

  /// returns the current connectivity.
  const Delta_complex& mesh() const { return m_mesh; }

  /// returns the current lengths of the edges.
  Length_map length_map() const { return Length_map(m_length.data()); }

  /// returns an intrinsic triangulation of the current surface, with \f$T_1 = T_2\f$, the input of
  /// other functions. Constrained edges remain constrained, on both sides of a cut. Complexity:
  /// linear.
  Triangulation triangulation() const
  {
    const auto is_constrained = boost::make_function_property_map<Edge_index>(
      [this](Edge_index e) { return m_is_constrained[e] != 0; });
    return Triangulation(m_mesh, Intrinsic_triangulations::parameters::edge_length_map(length_map())
                                   .edge_is_constrained_map(is_constrained));
  }

  /// returns the vertex of the original surface from which `v` comes; null if `v` is the apex of a
  /// disk.
  Vertex_index original_vertex(Vertex_index v) const { return m_origin[v]; }

  /// returns the number of closed loops, including two for each cut.
  std::size_t number_of_disks() const { return m_number_of_disks; }

  /// returns the area of all disks.
  double filled_area() const { return m_filled_area; }

  /// @}
  /// \name The Map
  /// @{

  /// maps a point of the original surface to the same point of the current surface. A point on a
  /// cut is mapped to the side of its face. Complexity: constant, plus
  /// `Intrinsic_triangulations::point_across()` for each retriangulation.
  Location image(Location p) const
  {
    for(const Triangulation& stage : m_stages)
      p = point_across(stage, Intrinsic_triangulations::Side::input, p);
    return p;
  }

  /// maps a point of the current surface to the original surface; returns nothing for a point in a
  /// disk. Complexity: see `image()`.
  std::optional<Location> preimage(Location p) const
  {
    for(auto stage = m_stages.rbegin(); stage != m_stages.rend(); ++stage) {
      if(p.first.idx() >= stage->mesh().number_of_faces())
        return std::nullopt;
      p = point_across(*stage, Intrinsic_triangulations::Side::intrinsic, p);
    }
    return p.first.idx() < m_number_of_faces ? std::optional(p) : std::nullopt;
  }

  /// @}
  /// \name Operations
  /// @{

  /// closes the boundary loop of the border halfedge `border` by a disk. Complexity: linear in the
  /// length of the loop.
  /// \returns the apex
  /// \pre `mesh().is_border(border)`
  Vertex_index close(Halfedge_index border)
  {
    CGAL_precondition(m_mesh.is_border(border));
    const std::vector<Halfedge_index> loop = border_loop(border, m_mesh);
    std::vector<double> sides;
    for(Halfedge_index h : loop)
      sides.push_back(length(h));
    const double radius = internal::disk_radius(sides);
    const Vertex_index apex = add_vertex(Vertex_index());
    std::vector<Halfedge_index> outgoing; // from the source of each side
    for(Halfedge_index h : loop)
      outgoing.push_back(add_edge(m_mesh.source(h), apex, radius, false));
    for(std::size_t i = 0; i < loop.size(); ++i)
      fill(loop[i], outgoing[(i + 1) % loop.size()], opposite(outgoing[i]), radius);
    m_mesh.set_halfedge(apex, outgoing[0]);
    for(Halfedge_index h : loop)
      m_mesh.set_halfedge(m_mesh.target(h), h);
    ++m_number_of_disks;
    return apex;
  }

  /// cuts the surface along a closed curve of edges, which makes two boundary loops. Complexity:
  /// linear in the degrees of its vertices.
  /// \param loop the halfedges of the curve, in their order along it
  /// \returns border halfedges of both loops, the left one first
  /// \pre the curve passes no vertex twice, and none on the boundary
  std::pair<Halfedge_index, Halfedge_index> cut(const std::vector<Halfedge_index>& loop)
  {
    std::vector<Halfedge_index> right; // border halfedges, in the direction of `loop`
    for(Halfedge_index h : loop)
      right.push_back(split_sides(h));
    for(std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t j = (i + 1) % loop.size();
      m_mesh.set_next(right[i], right[j]);
      m_mesh.set_next(opposite(loop[j]), opposite(loop[i]));
    }
    for(std::size_t i = 0; i < loop.size(); ++i)
      m_mesh.set_halfedge(m_mesh.target(right[i]), right[i]);
    for(Halfedge_index h : loop)
      separate_left(opposite(h));
    return {opposite(loop[0]), right[0]};
  }

  /// replaces the triangulation of the surface by \f$T_2\f$ of `tri`, whose input is the current
  /// surface. Complexity: linear.
  /// \pre no vertices have been inserted
  void retriangulate(Triangulation tri)
  {
    CGAL_precondition(tri.number_of_inserted_vertices() == 0 &&
                      tri.input_mesh().number_of_faces() == m_mesh.number_of_faces());
    copy_from(tri);
    m_stages.push_back(std::move(tri));
  }

  /// @}

private:
  static std::vector<Halfedge_index> border_loop(Halfedge_index border, const Delta_complex& mesh)
  {
    std::vector<Halfedge_index> result{border};
    for(Halfedge_index h = mesh.next(border); h != border; h = mesh.next(h))
      result.push_back(h);
    return result;
  }

  void copy_from(const Triangulation& tri)
  {
    m_mesh = tri.mesh();
    m_mesh.remove_all_property_maps();
    m_length.clear();
    m_is_constrained.clear();
    for(Edge_index e : m_mesh.edges()) {
      m_length.push_back(tri.length(e));
      m_is_constrained.push_back(tri.is_constrained(e));
    }
  }

  double length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  Vertex_index add_vertex(Vertex_index origin)
  {
    m_origin.push_back(origin);
    return m_mesh.add_vertex();
  }

  Halfedge_index add_edge(Vertex_index source, Vertex_index target, double length,
                          bool is_constrained)
  {
    const Halfedge_index h = m_mesh.add_edge();
    m_mesh.set_target(h, target);
    m_mesh.set_target(opposite(h), source);
    m_length.push_back(length);
    m_is_constrained.push_back(is_constrained);
    return h;
  }

  // Creates a face of a side of a loop and two edges to the apex.
  void fill(Halfedge_index side, Halfedge_index to_apex, Halfedge_index from_apex, double radius)
  {
    const Face_index f = m_mesh.add_face();
    m_mesh.set_halfedge(f, side);
    m_mesh.set_next(side, to_apex);
    m_mesh.set_next(to_apex, from_apex);
    m_mesh.set_next(from_apex, side);
    for(Halfedge_index h : {side, to_apex, from_apex})
      m_mesh.set_face(h, f);
    m_filled_area += Intrinsic_triangulations::quadrupled_area(length(side), radius, radius) / 4;
  }

  // Replaces the other side of `h`, which becomes a border halfedge, by a new edge. Returns the
  // border halfedge of the new edge, in the direction of `h`.
  Halfedge_index split_sides(Halfedge_index h)
  {
    const Halfedge_index o = opposite(h);
    const Halfedge_index inner =
      add_edge(m_mesh.target(h), m_mesh.source(h), length(h), m_is_constrained[Edge_index(h)] != 0);
    const Face_index f = m_mesh.face(o);
    const Halfedge_index before = m_mesh.prev(o), after = m_mesh.next(o);
    m_mesh.set_next(before, inner);
    m_mesh.set_next(inner, after);
    m_mesh.set_face(inner, f);
    if(m_mesh.halfedge(f) == o)
      m_mesh.set_halfedge(f, inner);
    m_mesh.set_face(o, Delta_complex::null_face());
    return opposite(inner);
  }

  // Creates a vertex for the vertex fan of the border halfedge `border`, and makes it the target.
  void separate_left(Halfedge_index border)
  {
    const Vertex_index v = add_vertex(m_origin[m_mesh.target(border)]);
    Halfedge_index h = border;
    do {
      m_mesh.set_target(h, v);
      h = opposite(m_mesh.next(h));
    } while(h != border);
    m_mesh.set_halfedge(v, border);
  }

  Delta_complex m_mesh;
  std::vector<double> m_length;
  std::vector<char> m_is_constrained;
  std::vector<Vertex_index> m_origin;
  std::vector<Triangulation> m_stages; // each over the surface before it
  std::size_t m_number_of_faces;       // before the first operation
  std::size_t m_number_of_disks = 0;
  double m_filled_area = 0;
};

/// \ingroup PkgIntrinsicSimplificationApplications
/// closes all boundary loops of `surface` that are at most `maximum_length` long by disks, see
/// `Surface_surgery`. Complexity: linear.
/// \returns the number of closed loops
inline std::size_t close_boundary_loops(Surface_surgery& surface, double maximum_length)
{
  std::size_t result = 0;
  for(Halfedge_index h : Intrinsic_triangulations::boundary_loops(surface.mesh())) {
    double length = 0;
    for(Halfedge_index side : halfedges_around_face(h, surface.mesh()))
      length += get(surface.length_map(), Edge_index(side));
    if(length <= maximum_length) {
      surface.close(h);
      ++result;
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SURFACE_SURGERY_H
