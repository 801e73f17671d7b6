// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_TREE_LOOP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_TREE_LOOP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns the loop that `h` closes along a tree, without what its two paths have in common.
// `entry(v)` is the last halfedge of the path to `v`, null for the root.
template <typename Entry>
std::vector<Halfedge_index> tree_loop(Halfedge_index h, const Entry& entry,
                                      const Delta_complex& mesh)
{
  const auto path_from_root = [&](Vertex_index v) {
    std::vector<Halfedge_index> result;
    for(Halfedge_index x = entry(v); x.is_valid(); x = entry(mesh.source(x)))
      result.push_back(x);
    std::reverse(result.begin(), result.end());
    return result;
  };
  const auto there = path_from_root(mesh.source(h)), back = path_from_root(mesh.target(h));
  std::size_t common = 0;
  while(common < (std::min)(there.size(), back.size()) && there[common] == back[common])
    ++common;
  std::vector<Halfedge_index> result(there.begin() + static_cast<std::ptrdiff_t>(common),
                                     there.end());
  result.push_back(h);
  for(std::size_t i = back.size(); i-- > common;)
    result.push_back(opposite(back[i]));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TOPOLOGY_TREE_LOOP_H
