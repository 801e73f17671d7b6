// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_SHARED_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_SHARED_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Flips every edge that curve `k` in the corner of `outgoing` crosses, so that the curve becomes an
// edge. Appends the flipped halfedges to `flips`.
template <typename Integer>
void flip_along_curve(Halfedge_index outgoing, const Integer& k,
                      Integer_coordinates<Integer>& coordinates, Delta_complex& mesh,
                      const Outgoing_halfedges& outgoing_halfedges,
                      std::vector<Halfedge_index>& flips)
{
  typedef typename Integer_coordinates<Integer>::Turn Turn;
  auto crossing = coordinates.first_crossing(outgoing, k, mesh);
  for(Turn turn = Turn::around_source; turn != Turn::ends;) {
    flips.push_back(crossing.halfedge);
    turn = coordinates.advance(crossing, mesh);
    coordinates.flip(flips.back(), mesh, outgoing_halfedges);
  }
}

// Returns the index of the first curve in the corner of `outgoing` that runs along a halfedge of T1
// for which `is_wanted` holds.
template <typename Integer, typename Is_wanted>
std::optional<Integer>
first_curve(Halfedge_index outgoing, const Integer_coordinates<Integer>& coordinates,
            const Delta_complex& mesh, const Outgoing_halfedges& outgoing_halfedges,
            const Is_wanted& is_wanted)
{
  if(mesh.is_border(outgoing))
    return std::nullopt;
  const Integer leaving = coordinates.curves_leaving(mesh.next(outgoing), mesh);
  for(Integer k(0); k < leaving; ++k)
    if(is_wanted(coordinates.outgoing_in_corner(outgoing, k, mesh, outgoing_halfedges)))
      return k;
  return std::nullopt;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// flips until all edges of \f$T_1\f$ that have a halfedge with `is_wanted` are shared (Algorithm
/// 4). Flips of one curve can bring another into a corner that was examined before, so all corners
/// are examined again. Mosher (1988) proves that this ends.
/// \returns the halfedges that have been turned, in order
template <typename Integer, typename Is_wanted>
std::vector<Halfedge_index>
flip_to_share(Integer_coordinates<Integer>& coordinates, Delta_complex& mesh,
              const Outgoing_halfedges& outgoing_halfedges, const Is_wanted& is_wanted)
{
  std::vector<Halfedge_index> flips;
  for(std::size_t before = 1; before != flips.size();) {
    before = flips.size();
    for(Halfedge_index h : mesh.halfedges())
      while(const auto k =
              internal::first_curve(h, coordinates, mesh, outgoing_halfedges, is_wanted))
        internal::flip_along_curve(h, *k, coordinates, mesh, outgoing_halfedges, flips);
  }
  return flips;
}

namespace internal {

// Flips until all edges are shared.
template <typename Integer>
std::vector<Halfedge_index> flip_to_shared(Integer_coordinates<Integer>& coordinates,
                                           Delta_complex& mesh,
                                           const Outgoing_halfedges& outgoing_halfedges)
{
  return flip_to_share(coordinates, mesh, outgoing_halfedges, [](Halfedge_index) { return true; });
}

// Returns whether the curve that starts as number `k` in the corner of `outgoing` ends at the end
// of its edge of `input`.
template <typename Integer>
bool ends_at_twin(Halfedge_index outgoing, const Integer& k,
                  const Integer_coordinates<Integer>& coordinates, const Delta_complex& mesh,
                  const Delta_complex& input, const Outgoing_halfedges& outgoing_halfedges)
{
  typedef typename Integer_coordinates<Integer>::Turn Turn;
  const Halfedge_index start =
    coordinates.outgoing_in_corner(outgoing, k, mesh, outgoing_halfedges);
  auto crossing = coordinates.first_crossing(outgoing, k, mesh);
  while(coordinates.advance(crossing, mesh) != Turn::ends) {
  }
  return coordinates.outgoing_at_end(crossing, mesh, outgoing_halfedges) == input.opposite(start);
}

// Describes the first edge of `input` that does not run over `mesh` to its other end.
template <typename Integer>
std::string curve_defect(const Integer_coordinates<Integer>& coordinates, const Delta_complex& mesh,
                         const Delta_complex& input, const Outgoing_halfedges& outgoing_halfedges)
{
  for(Halfedge_index h : mesh.halfedges()) {
    bool good = !coordinates.is_shared(mesh.edge(h)) ||
                coordinates.shared_halfedge(mesh.opposite(h), mesh, outgoing_halfedges) ==
                  input.opposite(coordinates.shared_halfedge(h, mesh, outgoing_halfedges));
    if(!mesh.is_border(h))
      for(Integer k(0); good && k < coordinates.curves_leaving(mesh.next(h), mesh); ++k)
        good = ends_at_twin(h, k, coordinates, mesh, input, outgoing_halfedges);
    if(!good)
      return "an edge of the input that starts at vertex " + std::to_string(mesh.source(h).idx()) +
             " does not run to its other end";
  }
  return {};
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLIP_TO_SHARED_H
