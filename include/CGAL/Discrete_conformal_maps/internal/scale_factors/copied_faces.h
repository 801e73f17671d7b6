// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_COPIED_FACES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_COPIED_FACES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

// These functions choose the faces that a doubled surface copies.
namespace CGAL::Discrete_conformal_maps::internal {

// Marks the faces at vertices within `width` rings around `front`.
inline void mark_faces_around(std::vector<Vertex_index> front, std::size_t width,
                              const Delta_complex& mesh, std::vector<char>& is_marked)
{
  std::vector<char> is_near(mesh.num_vertices(), 0);
  const auto add = [&](Vertex_index v, std::vector<Vertex_index>& to) {
    if(!is_near[v.idx()])
      to.push_back(v);
    is_near[v.idx()] = 1;
  };
  for(std::size_t ring = 0; ring <= width; ++ring) {
    std::vector<Vertex_index> next;
    for(Vertex_index v : front)
      for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
        if(!mesh.is_border(h))
          is_marked[mesh.face(h).idx()] = 1;
        add(mesh.target(h), next);
      });
    front = std::move(next);
  }
}

// Extends marks to whole regions of faces joined by flipped edges. No flip crosses the boundary of
// a region. The flips start from `mesh`, in which each face has an original with a mark.
inline void mark_flipped_regions(Delta_complex mesh,
                                 std::initializer_list<const std::vector<Halfedge_index>*> flips,
                                 const std::vector<Face_index>& original_face,
                                 std::vector<char>& is_marked)
{
  boost::disjoint_sets_with_storage<> regions(is_marked.size());
  for(const auto* part : flips)
    for(Halfedge_index h : *part) {
      regions.union_set(original_face[mesh.face(h).idx()].idx(),
                        original_face[mesh.face(mesh.opposite(h)).idx()].idx());
      flip_edge(h, mesh);
    }
  std::vector<char> is_region_marked(is_marked.size(), 0);
  for(std::size_t f = 0; f < is_marked.size(); ++f)
    is_region_marked[regions.find_set(f)] |= is_marked[f];
  for(std::size_t f = 0; f < is_marked.size(); ++f)
    is_marked[f] = is_region_marked[regions.find_set(f)];
}

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_COPIED_FACES_H
