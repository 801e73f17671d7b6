// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_simplification/internal/topology/Short_loops.h>
#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// determines along which curves handles are cut.
enum class Cutting_curves
{
  geodesics, ///< closed geodesics, which flips of edges make edges
  edges      ///< closed curves of edges of the surface, which stays triangulated as it is
};

namespace internal {

// The loops of one round, shortened all together, so that they do not cross.
class Handle_pincher
{
  typedef std::vector<Halfedge_index> Curve;

public:
  Handle_pincher(Surface_surgery& surface, double maximum_length, Cutting_curves curves)
    : m_surface(surface), m_maximum(maximum_length), m_curves(curves)
  {}

  // Bounds of the length of edge loops grow, so that searches do not go far where handles are
  // small, and are few when they go far.
  std::size_t operator()()
  {
    if(m_curves == Cutting_curves::geodesics)
      make_Delaunay();
    const std::size_t genus = Intrinsic_triangulations::topological_type(m_surface.mesh()).genus;
    const double all = total_length(), last = greatest_edge_loop();
    double bound = first_bound * all / static_cast<double>(m_surface.mesh().number_of_edges());
    std::size_t result = 0;
    for(bool is_last = false; !is_last && result < genus; bound *= 2) {
      is_last = !(bound < last && bound < all);
      result += pinch_up_to(is_last ? last : bound, genus - result);
    }
    return result;
  }

  // the effort: how often loops have been looked for, and the vertices reached by that
  std::size_t number_of_searches() const { return m_searches; }
  std::size_t number_of_visits() const { return m_visits; }

private:
  // the first bound, in mean edge lengths
  static constexpr double first_bound = 4;

  // In a Delaunay triangulation of the plane, shortest paths along edges are less than twice as
  // long as straight lines; so edge loops are looked for up to twice the length.
  double greatest_edge_loop() const
  {
    return m_curves == Cutting_curves::geodesics ? 2 * m_maximum : m_maximum;
  }

  // Where geodesics touch themselves or each other, the edge loops take their place.
  std::size_t pinch_up_to(double bound, std::size_t genus)
  {
    std::size_t result = 0;
    for(bool is_going_on = true; is_going_on && result < genus;) {
      std::size_t pinched = 0;
      if(m_curves == Cutting_curves::geodesics)
        pinched = pinch_geodesics(bound);
      if(pinched == 0)
        pinched = pinch(edge_loops((std::min)(bound, m_maximum)));
      is_going_on = pinched > 0;
      result += pinched;
    }
    return result;
  }

  double total_length() const
  {
    double result = 0;
    for(Edge_index e : m_surface.mesh().edges())
      result += get(m_surface.length_map(), e);
    return result;
  }

  void make_Delaunay()
  {
    Surface_surgery::Triangulation tri = m_surface.triangulation();
    if(Intrinsic_triangulations::make_Delaunay(tri) > 0)
      m_surface.retriangulate(std::move(tri));
  }

  std::vector<Curve> edge_loops(double maximum_length)
  {
    Short_loops search(m_surface);
    std::vector<Curve> result;
    for(auto& loop : search.disjoint_loops(maximum_length))
      result.push_back(std::move(loop.halfedges));
    ++m_searches;
    m_visits += search.number_of_visits();
    return result;
  }

  std::size_t pinch_geodesics(double bound)
  {
    const std::vector<Curve> loops = edge_loops(bound);
    if(loops.empty())
      return 0;
    Surface_surgery::Triangulation tri = m_surface.triangulation();
    Intrinsic_triangulations::Edge_paths<Intrinsic_surface::Traits> paths(tri);
    for(const Curve& loop : loops)
      paths.add_loop(loop);
    paths.shorten();
    std::vector<std::pair<double, std::size_t>> order;
    for(std::size_t i = 0; i < loops.size(); ++i)
      if(paths.length(i) <= m_maximum)
        order.emplace_back(paths.length(i), i);
    std::sort(order.begin(), order.end());
    std::vector<Curve> geodesics;
    std::vector<bool> is_used(tri.mesh().num_vertices(), false);
    for(const auto& [length, i] : order)
      if(Curve curve = paths.halfedges(i); is_free(curve, tri.mesh(), is_used)) {
        for(Halfedge_index h : curve)
          is_used[tri.mesh().target(h)] = true;
        geodesics.push_back(std::move(curve));
      }
    if(geodesics.empty())
      return 0;
    make_Delaunay_beside(geodesics, tri);
    m_surface.retriangulate(std::move(tri));
    return pinch(geodesics);
  }

  // Where flips have shortened curves, needles are left.
  static void make_Delaunay_beside(const std::vector<Curve>& curves,
                                   Surface_surgery::Triangulation& tri)
  {
    std::vector<Edge_index> added;
    for(const Curve& curve : curves)
      for(Halfedge_index h : curve)
        if(!tri.is_constrained(Edge_index(h))) {
          tri.set_constrained(Edge_index(h), true);
          added.emplace_back(h);
        }
    Intrinsic_triangulations::make_Delaunay(tri);
    for(Edge_index e : added)
      tri.set_constrained(e, false);
  }

  // whether a curve passes no vertex twice and none that is used or on the boundary
  static bool is_free(const Curve& curve, const Delta_complex& mesh,
                      const std::vector<bool>& is_used)
  {
    std::vector<Vertex_index> vertices;
    for(Halfedge_index h : curve)
      vertices.push_back(mesh.target(h));
    std::sort(vertices.begin(), vertices.end());
    return !curve.empty() &&
           std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end() &&
           std::none_of(vertices.begin(), vertices.end(),
                        [&](Vertex_index v) { return is_used[v] || mesh.is_border(v); });
  }

  std::size_t pinch(const std::vector<Curve>& curves)
  {
    for(const Curve& curve : curves) {
      const auto [left, right] = m_surface.cut(curve);
      m_surface.close(left);
      m_surface.close(right);
    }
    return curves.size();
  }

  Surface_surgery& m_surface;
  double m_maximum;
  Cutting_curves m_curves;
  std::size_t m_searches = 0;
  std::size_t m_visits = 0;
};

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// takes away handles around which, or through which, a closed curve of a length of at most
/// `maximum_length` leads: cuts the surface along such curves, the shortest ones first, and closes
/// both sides by disks, see `Surface_surgery`. No curve separates the surface: each cut lowers the
/// genus by one, and components and boundary loops stay.
///
/// Curves are found among edges: from one vertex after the other, the shortest one that is closed
/// by an edge between two shortest paths from there and does not separate. The length up to which
/// they are looked for doubles, from some edges up to the bound. Curves that have no vertex in
/// common are shortened together by flips, to geodesics in their class (see
/// `Intrinsic_triangulations::Edge_paths`), and cut; then others are looked for, disks included. A
/// curve that touches itself, another one or the boundary waits for the next round. If all that are
/// so long do so, those edge loops are cut that are short enough as they are.
///
/// With geodesics the surface is made Delaunay before and beside the curves.
///
/// A handle stays if all short curves around it pass a vertex of the boundary, or if no edge loop
/// around it is shorter than twice `maximum_length`: edges that are long beside the handle hide
/// it, and refinement shows it. By the length alone it is not known whether a handle or a tunnel
/// is cut, and a thin torus is a handle as well.
/// \returns the number of handles that have been cut
/// \throws what `Intrinsic_triangulations::Edge_paths` and `make_Delaunay()` throw
///
/// Complexity: \f$O(n \log n)\f$ for each round, and shortening. There are few rounds for each
/// length, since disjoint curves are cut in one round. A search is not repeated near vertices where
/// one has found nothing; so searches reach each vertex a few times in a round, unless there are
/// many curves of about the length of the bound.
inline std::size_t pinch_handles(Surface_surgery& surface, double maximum_length,
                                 Cutting_curves curves = Cutting_curves::geodesics)
{
  return internal::Handle_pincher(surface, maximum_length, curves)();
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
