// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MENDED_TOPOLOGY_H
#define INTRINSIC_MENDED_TOPOLOGY_H

#include "commands/Statistics.h"
#include "reading/Mesh_reader.h"

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>

#include <cstddef>
#include <vector>

// A surface whose short boundary loops have been closed and whose short handles have been cut,
// along edges, so that the rest of it is what it was.
class Mended_topology
{
public:
  typedef CGAL::Intrinsic_simplification::Surface_surgery::Triangulation Triangulation;

  // lengths of zero leave loops or handles as they are
  Mended_topology(const Triangulation& start, double closed_length, double pinched_length);

  Triangulation triangulation() const { return m_surface.triangulation(); }

  // what has been done
  void describe(Statistics& statistics) const;

  // For each vertex after those of the start, in order, those in the middle of which it is to be
  // seen: the vertex that it is a copy of, or those around a disk.
  std::vector<std::vector<Mesh::Vertex_index>> sources_of_new_vertices() const;

private:
  std::size_t m_number_of_vertices; // of the start
  CGAL::Intrinsic_triangulations::Topological_type m_before;
  CGAL::Intrinsic_simplification::Surface_surgery m_surface;
  std::size_t m_closed = 0, m_pinched = 0;
};

#endif // INTRINSIC_MENDED_TOPOLOGY_H
