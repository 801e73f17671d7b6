// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/glued_sides.h"

#include "reading/Scanner.h"

#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/glue_boundary.h>

#include <array>
#include <cstddef>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

// Reads the number of a vertex.
Mesh::Vertex_index vertex(Scanner& in, const Mesh& mesh)
{
  const Scanner::Place start = in.place();
  const std::size_t i = in.count();
  if(i >= mesh.number_of_vertices()) {
    in.return_to(start);
    in.fail("vertex " + std::to_string(i) + ": the mesh has " +
            std::to_string(mesh.number_of_vertices()) + ", counted from 0");
  }
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(i));
}

} // namespace

std::vector<std::pair<Mesh::Halfedge_index, Mesh::Halfedge_index>>
read_glued_sides(const std::string& path, const Mesh& mesh,
                 const Mesh::Property_map<Mesh::Edge_index, double>& length)
{
  Scanner in(path);
  IT::Paired_sides sides(mesh, length);
  bool has_lines = false;
  for(in.skip_comments('#'); !in.at_end(); in.skip_comments('#')) {
    const Scanner::Place start = in.place();
    std::array<Mesh::Vertex_index, 4> v;
    for(Mesh::Vertex_index& corner : v)
      corner = vertex(in, mesh);
    try {
      sides.add(v[0], v[1], v[2], v[3]);
    } catch(const IT::Invalid_input& error) {
      in.return_to(start);
      in.fail(error.what());
    }
    if(!in.at_line_end('#'))
      in.fail("more than four numbers in a line");
    has_lines = true;
  }
  if(!has_lines)
    return {};
  try {
    return sides.complete_pairs();
  } catch(const IT::Invalid_input& error) {
    in.fail_as_a_whole(error.what());
  }
}
