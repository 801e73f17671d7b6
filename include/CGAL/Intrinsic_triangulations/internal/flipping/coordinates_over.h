// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_COORDINATES_OVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_COORDINATES_OVER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/flip_to_shared.h>

#include <algorithm>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

inline bool has_same_faces(const Delta_complex& a, const Delta_complex& b)
{
  if(a.number_of_vertices() != b.number_of_vertices() || a.number_of_edges() != b.number_of_edges())
    return false;
  const auto agree = [&](Halfedge_index h) {
    return a.next(h) == b.next(h) && a.target(h) == b.target(h) && a.face(h) == b.face(h);
  };
  return std::all_of(a.halfedges_begin(), a.halfedges_end(), agree);
}

// Stores T2 after the flips that turn it into T1.
template <typename Traits>
struct Flipped_to_input
{
  typedef Integer_coordinates<typename Traits::Integer> Coordinates;

  explicit Flipped_to_input(const Triangulation_pair<Traits>& pair)
    : mesh(pair.mesh()),
      coordinates(mesh),
      outgoing_halfedges(pair.outgoing_halfedges()),
      flips(flip_to_shared(coordinates, mesh, outgoing_halfedges))
  {}

  // Returns the halfedge of T1 that `h` has become.
  Halfedge_index input_halfedge(Halfedge_index h) const
  {
    return coordinates.shared_halfedge(h, mesh, outgoing_halfedges);
  }

  Delta_complex mesh;
  Coordinates coordinates;
  const Outgoing_halfedges& outgoing_halfedges;
  std::vector<Halfedge_index> flips;
};

// Copies the coordinates of each halfedge h of `mesh` from the halfedge image[h] of `other`.
template <typename Integer>
void copy_coordinates(const Delta_complex& mesh, const std::vector<Halfedge_index>& image,
                      const Integer_coordinates<Integer>& from, Integer_coordinates<Integer>& to)
{
  for(Halfedge_index h : mesh.halfedges()) {
    to.set(mesh.edge(h), from.normal_coordinate(mesh.edge(image[h])));
    to.set(h, from.roundabout(image[h]));
  }
}

// Returns the connectivity of T3, the second triangulation of `pair`, with the integer coordinates
// of T2, the second triangulation of `base`. T2 is the input of the result. First T2 over itself is
// flipped to T1. Then T1 is flipped to T3, in the reverse order of the flips from T3.
template <typename Traits>
Delta_complex coordinates_over(const Triangulation_pair<Traits>& base,
                               const Triangulation_pair<Traits>& pair)
{
  typedef Integer_coordinates<typename Traits::Integer> Coordinates;
  const Flipped_to_input<Traits> from_base(base), from_pair(pair);

  Delta_complex mesh = without_maps(base.mesh());
  Coordinates coordinates(mesh);
  const Outgoing_halfedges outgoing_halfedges(mesh, coordinates.roundabout_map());
  for(Halfedge_index h : from_base.flips)
    coordinates.flip(h, mesh, outgoing_halfedges);

  std::vector<Halfedge_index> halfedge_at(mesh.num_halfedges()), image(mesh.num_halfedges());
  for(Halfedge_index h : mesh.halfedges())
    halfedge_at[from_base.input_halfedge(h)] = h;
  for(Halfedge_index h : mesh.halfedges())
    image[h] = halfedge_at[from_pair.input_halfedge(h)];

  Delta_complex result = without_maps(from_pair.mesh);
  Coordinates over(result);
  copy_coordinates(result, image, coordinates, over);
  for(auto h = from_pair.flips.rbegin(); h != from_pair.flips.rend(); ++h)
    for(int turn = 0; turn < 3; ++turn) // four flips restore the edge
      over.flip(*h, result, outgoing_halfedges);
  return result;
}

template <typename Traits>
void check_common_input(const Triangulation_pair<Traits>& a, const Triangulation_pair<Traits>& b)
{
  if(!has_same_faces(a.input_mesh(), b.input_mesh()))
    throw Invalid_input("the two triangulations do not have the same input");
}

template <typename Traits>
bool have_inserted_vertices(const Triangulation_pair<Traits>& a,
                            const Triangulation_pair<Traits>& b)
{
  return a.number_of_inserted_vertices() > 0 || b.number_of_inserted_vertices() > 0;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_COORDINATES_OVER_H
