// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/glued_sides.h"

#include "reading/Scanner.h"

#include <cmath>
#include <cstddef>
#include <set>

namespace {

// The lengths of two sides may differ by this value, relative to their mean, because coordinates in
// files of nets often have few digits.
constexpr double side_tolerance = 1e-5;

// Reads the number of a vertex.
Mesh::Vertex_index vertex(Scanner& in, const Mesh& mesh)
{
  const std::size_t i = in.count();
  if(i >= mesh.number_of_vertices())
    in.fail("vertex " + std::to_string(i) + ": the mesh has " +
            std::to_string(mesh.number_of_vertices()) + ", counted from 0");
  return Mesh::Vertex_index(static_cast<Mesh::size_type>(i));
}

std::string name(Mesh::Vertex_index v, Mesh::Vertex_index w)
{
  return "the side from " + std::to_string(v.idx()) + " to " + std::to_string(w.idx());
}

// Reads two vertices, and returns the halfedge from the first to the second.
Mesh::Halfedge_index side(Scanner& in, const Mesh& mesh)
{
  const Mesh::Vertex_index v = vertex(in, mesh), w = vertex(in, mesh);
  const Mesh::Halfedge_index h = mesh.halfedge(v, w);
  if(!h.is_valid() || !mesh.is_border(mesh.edge(h)))
    in.fail(name(v, w) + " is not on the boundary of the mesh");
  return h;
}

double length(Mesh::Halfedge_index h, const Mesh& mesh)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

} // namespace

Glued_sides read_glued_sides(const std::string& path, const Mesh& mesh)
{
  Scanner in(path);
  Glued_sides result;
  std::set<Mesh::Edge_index> glued;
  for(in.skip_comments('#'); !in.at_end(); in.skip_comments('#')) {
    Mesh::Halfedge_index h = side(in, mesh), o = side(in, mesh);
    for(const auto x : {h, o})
      if(!glued.insert(mesh.edge(x)).second)
        in.fail(name(mesh.source(x), mesh.target(x)) + " is glued twice");
    const double a = length(h, mesh), b = length(o, mesh);
    if(!(std::abs(a - b) <= side_tolerance * (a + b) / 2))
      in.fail("the two sides have different lengths, " + std::to_string(a) + " and " +
              std::to_string(b));
    if(mesh.is_border(h) == mesh.is_border(o))
      in.fail("the surface would not be oriented; the sides must run in opposite directions "
              "around the net");
    if(!in.at_line_end('#'))
      in.fail("more than four numbers in a line");
    result.pairs.emplace_back(mesh.is_border(h) ? mesh.opposite(h) : h,
                              mesh.is_border(o) ? mesh.opposite(o) : o);
  }
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h) && glued.count(mesh.edge(h)) == 0 && !result.pairs.empty())
      in.fail_as_a_whole(name(mesh.target(h), mesh.source(h)) + " is not glued");
  return result;
}
