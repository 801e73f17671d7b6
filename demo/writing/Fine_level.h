// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_FINE_LEVEL_H
#define INTRINSIC_FINE_LEVEL_H

#include "commands/triangulation_stages.h"
#include "reading/Input_mesh.h"
#include "writing/Fine_vertices.h"
#include "writing/Output_mesh.h"

#include <CGAL/Intrinsic_simplification/Surface_surgery.h>

#include <cstddef>
#include <vector>

// Describes how the fine level of a simplification was derived from the input. Vertices may have
// been inserted, which split edges and faces. Then vertices may have been added by disks and cuts.
class Fine_level
{
public:
  // Constructs the level from the input, or from `split` unless it is null, with its inserted
  // vertices. Both must outlive this object.
  explicit Fine_level(const Mesh& input, const Triangulation* split = nullptr);

  // Adds the vertices of disks and cuts of the current level.
  void add_vertices(const CGAL::Intrinsic_simplification::Surface_surgery& surgery)
  {
    m_vertices.add(surgery);
  }

  bool is_input() const
  {
    return m_split == nullptr && m_vertices.size() == m_vertices.number_before_surgery();
  }
  std::size_t number_of_input_vertices() const { return m_input->number_of_vertices(); }

  // Returns the face of the input, or null if `f` is in a disk.
  Mesh::Face_index input_face(Mesh::Face_index f) const;

  // Returns the edge of the input. Returns null if `e` is inside a face, in a disk, or has been
  // made by a cut.
  Mesh::Edge_index input_edge(Mesh::Edge_index e) const;

  // Extends values at the first vertices, at least the vertices of the input, to the others.
  template <class Value>
  void extend(std::vector<Value>& values, const Value& zero) const
  {
    m_vertices.extend(values, zero);
  }

  // Returns the positions of the vertices.
  std::vector<Point> points() const { return m_vertices.positions(m_input->points()); }

  // Returns the data of the input on the level, whose faces are `triangles`.
  Triangle_data data(const Input_mesh& input, const Polygons& triangles) const;

private:
  const Mesh* m_input;
  const Triangulation* m_split;
  Fine_vertices m_vertices;
  std::size_t m_edges, m_faces; // without disks and cuts
};

#endif // INTRINSIC_FINE_LEVEL_H
