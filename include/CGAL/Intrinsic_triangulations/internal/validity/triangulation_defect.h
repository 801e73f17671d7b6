// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_TRIANGULATION_DEFECT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_TRIANGULATION_DEFECT_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Triangulation_pair.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/flip_to_shared.h>
#include <CGAL/Intrinsic_triangulations/internal/input/copy_properties.h>
#include <CGAL/Intrinsic_triangulations/internal/validity/Delta_complex_defect.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns whether weights are not negative and sum up to one.
template <typename FT, std::size_t n>
bool are_weights(const std::array<FT, n>& b)
{
  return std::all_of(b.begin(), b.end(), [](const FT& x) { return x >= 0; }) &&
         CGAL::abs(std::accumulate(b.begin(), b.end(), FT(-1))) <= rounding_unit<FT>();
}

// Returns whether an inserted vertex can lie at `p`.
template <typename FT>
bool can_be_inserted(const Surface_point<FT>& p, const Delta_complex& input)
{
  if(const auto* e = on_edge(p))
    return input.has_valid_index(e->halfedge) && !input.is_border(e->halfedge) &&
           are_weights(e->weight);
  const auto* inside = std::get_if<Face_location<FT>>(&p);
  return inside && input.has_valid_index(inside->first) && are_weights(inside->second);
}

template <typename Traits>
void check_inserted(const Triangulation_pair<Traits>& pair)
{
  const auto& inserted = pair.inserted_vertices();
  if(!Has_distance<Traits>::value && !inserted.empty())
    throw Invalid_input("vertices cannot be inserted in this geometry");
  for(std::size_t i = 0; i < inserted.size(); ++i)
    if(!can_be_inserted(inserted[i], pair.input_mesh()))
      throw Invalid_input("inserted vertex " + std::to_string(i) + " has no position in the input");
  if(pair.mesh().num_vertices() != pair.input_mesh().num_vertices() + inserted.size())
    throw Invalid_input("the numbers of vertices and of positions differ");
}

// Returns whether the shared edge `e` has its length in T1. A whole edge must have this length
// bitwise. A part of an edge must have it up to the rounding of the positions of its ends.
template <typename Traits>
bool has_shared_length(const Triangulation_pair<Traits>& pair, Edge_index e)
{
  typedef typename Traits::FT FT;
  const Delta_complex& mesh = pair.mesh();
  const FT length = pair.shared_length(mesh.halfedge(e));
  if(!pair.is_inserted(mesh.vertex(e, 0)) && !pair.is_inserted(mesh.vertex(e, 1)))
    return pair.length(e) == length;
  const Edge_index whole(pair.input_outgoing_before(mesh.halfedge(e)));
  return CGAL::abs(FT(pair.length(e) - length)) <= rounding_unit<FT>() * pair.input_length(whole);
}

// Returns a defect between the two valid complexes, or an empty string if they have none.
template <typename Traits>
std::string correspondence_defect(const Triangulation_pair<Traits>& pair)
{
  const Delta_complex &input = pair.input_mesh(), &mesh = pair.mesh();
  const auto& coordinates = pair.coordinates();
  if(mesh.num_vertices() != input.num_vertices() + pair.inserted_vertices().size() ||
     Euler_characteristic(mesh) != Euler_characteristic(input))
    return "the two triangulations differ in their numbers of elements";
  for(Edge_index e : mesh.edges())
    if(!pair.traits().is_length_object()(pair.length(e)))
      return "edge " + std::to_string(e.idx()) + " has no positive finite length";
  if(!coordinates.is_valid(mesh, pair.outgoing_halfedges()))
    return "the integer coordinates contradict each other";
  for(Edge_index e : mesh.edges())
    if(coordinates.is_shared(e) && !has_shared_length(pair, e))
      return "edge " + std::to_string(e.idx()) + " is in the input with another length";
  return curve_defect(coordinates, mesh, input, pair.outgoing_halfedges());
}

inline void check_Delta_complex(const Delta_complex& mesh)
{
  if(const std::string defect = Delta_complex_defect(mesh); !defect.empty())
    throw Invalid_input(defect);
}

// Checks the triangles of the two valid complexes, and how they fit together.
template <typename Traits>
void check_correspondence(const Triangulation_pair<Traits>& pair)
{
  check_triangles(pair.input(), pair.traits());
  check_triangles(pair.intrinsic(), pair.traits());
  if(const std::string defect = correspondence_defect(pair); !defect.empty())
    throw Invalid_input(defect);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDITY_TRIANGULATION_DEFECT_H
