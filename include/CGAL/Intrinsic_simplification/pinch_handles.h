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

// Cuts along edge loops that have no common vertex, round by round.
class Handle_pincher
{
public:
  Handle_pincher(Surface_surgery& surface, double maximum_length)
    : m_surface(surface), m_maximum(maximum_length)
  {}

  // Cuts with growing bounds on the length of edge loops. So searches are short if handles are
  // small, and few searches are long.
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

  // Returns the effort: the number of searches for loops, and of vertices that they reached.
  std::size_t number_of_searches() const { return m_searches; }
  std::size_t number_of_visits() const { return m_visits; }

private:
  // The first bound has this number of mean edge lengths.
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
/// removes handles with a closed curve of edges around or through them whose length is at most
/// `maximum_length`. It cuts the surface along such curves, the shortest ones first, and closes
/// both sides by disks, see `Surface_surgery`. No curve separates the surface. So each cut lowers
/// the genus by one, and components and boundary loops remain. Faces and edges beside the curves do
/// not change.
///
/// The search visits the vertices in turn. From each vertex it finds the shortest curve that does
/// not separate the surface and consists of two shortest paths and an edge between them
/// \cgalCite{EW05}. The greatest length of curves doubles, from a few edges up to the bound. Curves
/// without common vertices are cut in one round. The next round searches the new surface, including
/// disks.
///
/// A handle remains if all short curves around it pass a vertex of the boundary. It also remains if
/// no curve of edges around it is short enough; refine the surface if edges are long beside the
/// handle. The length alone does not distinguish handles from tunnels, and a thin torus is a handle
/// too. To cut along geodesics, make them edges (`Intrinsic_triangulations::Edge_paths`), and call
/// `Surface_surgery::retriangulate()` and `Surface_surgery::cut()`.
/// \returns the number of handles that were cut
///
/// Complexity: \f$O(n \log n)\f$ for each round. Each length has few rounds, since disjoint curves
/// are cut in one round. A search is not repeated near vertices at which a search failed. So
/// searches reach each vertex a few times in a round, unless many curves have about the length of
/// the bound.
inline std::size_t pinch_handles(Surface_surgery& surface, double maximum_length)
{
  return internal::Handle_pincher(surface, maximum_length)();
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_PINCH_HANDLES_H
