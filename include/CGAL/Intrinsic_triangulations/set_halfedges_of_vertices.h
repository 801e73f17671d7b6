// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SET_HALFEDGES_OF_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SET_HALFEDGES_OF_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// gives each vertex a halfedge that leads to it: the last border halfedge, or the first halfedge
/// if there is no border halfedge. The result does not depend on the number of threads.
template <typename P>
void set_halfedges_of_vertices(Surface_mesh<P>& mesh, Concurrency concurrency)
{
  if(!concurrency.is_parallel())
    return internal::set_halfedges_of_vertices(mesh);
  typedef typename Surface_mesh<P>::size_type size_type;
  const size_type all = mesh.num_halfedges(), half = all / 2;
  const auto note = [&mesh](size_type begin, size_type end, std::vector<Halfedge_index>& noted) {
    noted.resize(mesh.num_vertices());
    for(Halfedge_index h(begin); h.idx() < end; ++h)
      if(Halfedge_index& x = noted[mesh.target(h).idx()]; mesh.is_border(h) || !x.is_valid())
        x = h;
  };
  std::vector<Halfedge_index> first, last;
  first.reserve(mesh.num_vertices());
  run_together(
    concurrency, [&] { note(0, half, first); }, [&] { note(half, all, last); });
  for_each_in_chunks<Vertex_index>(concurrency, mesh, [&](Vertex_index v) {
    const Halfedge_index a = first[v.idx()], b = last[v.idx()];
    const bool is_last = b.is_valid() && (!a.is_valid() || mesh.is_border(b));
    if(is_last || a.is_valid())
      mesh.set_halfedge(v, is_last ? b : a);
  });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SET_HALFEDGES_OF_VERTICES_H
