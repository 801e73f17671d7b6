// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>
#include <CGAL/Intrinsic_simplification/internal/topology/Short_loops.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <cstddef>

namespace CGAL::Intrinsic_simplification {

namespace internal {

// Cuts along edge loops that have no vertex in common, round by round.
class Handle_pincher
{
public:
  Handle_pincher(Surface_surgery& surface, double maximum_length)
    : m_surface(surface), m_maximum(maximum_length)
  {}

  // Bounds of the length of edge loops grow. So searches stay near if handles are small, and few
  // searches go far.
  std::size_t operator()()
  {
    const std::size_t genus = Intrinsic_triangulations::topological_type(m_surface.mesh()).genus;
    const double all = total_length();
    double bound = first_bound * all / static_cast<double>(m_surface.mesh().number_of_edges());
    std::size_t result = 0;
    for(bool is_last = false; !is_last && result < genus; bound *= 2) {
      is_last = !(bound < m_maximum && bound < all);
      result += pinch_up_to(is_last ? m_maximum : bound, genus - result);
    }
    return result;
  }

  // the effort: how often loops have been looked for, and the vertices reached by that
  std::size_t number_of_searches() const { return m_searches; }
  std::size_t number_of_visits() const { return m_visits; }

private:
  // the first bound, in mean edge lengths
  static constexpr double first_bound = 4;

  std::size_t pinch_up_to(double bound, std::size_t genus)
  {
    std::size_t result = 0;
    for(bool is_going_on = true; is_going_on && result < genus;) {
      const std::size_t pinched = pinch_round(bound);
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

  std::size_t pinch_round(double bound)
  {
    Short_loops search(m_surface);
    const auto loops = search.disjoint_loops(bound);
    ++m_searches;
    m_visits += search.number_of_visits();
    for(const auto& loop : loops) {
      const auto [left, right] = m_surface.cut(loop.halfedges);
      m_surface.close(left);
      m_surface.close(right);
    }
    return loops.size();
  }

  Surface_surgery& m_surface;
  double m_maximum;
  std::size_t m_searches = 0;
  std::size_t m_visits = 0;
};

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationApplications
/// takes away handles around which, or through which, a closed curve of edges of a length of at
/// most `maximum_length` leads: cuts the surface along such curves, the shortest ones first, and
/// closes both sides by disks, see `Surface_surgery`. No curve separates the surface: each cut
/// lowers the genus by one, and components and boundary loops stay. Faces and edges beside the
/// curves stay as they are.
///
/// The curves start from one vertex after the other: the shortest one that is closed by an edge
/// between two shortest paths from there and does not separate. The length up to which they are
/// looked for doubles, from some edges up to the bound. Curves that have no vertex in common are
/// cut in one round; then others are looked for, disks included.
///
/// A handle stays if all short curves around it pass a vertex of the boundary, or if no curve of
/// edges around it is short enough: edges that are long beside the handle hide it, and refinement
/// shows it. By the length alone it is not known whether a handle or a tunnel is cut, and a thin
/// torus is a handle as well. To cut along geodesics, make them edges
/// (`Intrinsic_triangulations::Edge_paths`), and call `Surface_surgery::retriangulate()` and
/// `Surface_surgery::cut()`.
/// \returns the number of handles that have been cut
///
/// Complexity: \f$O(n \log n)\f$ for each round. There are few rounds for each length, since
/// disjoint curves are cut in one round. A search is not repeated near vertices where one has found
/// nothing; so searches reach each vertex a few times in a round, unless there are many curves of
/// about the length of the bound.
inline std::size_t pinch_handles(Surface_surgery& surface, double maximum_length)
{
  return internal::Handle_pincher(surface, maximum_length)();
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
