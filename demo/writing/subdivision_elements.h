// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SUBDIVISION_ELEMENTS_H
#define INTRINSIC_SUBDIVISION_ELEMENTS_H

#include "writing/Output_mesh.h"

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Converts any subdivision to a mesh that is written: its elements, and the elements of the
// triangulations that contain them. A `Part` has the members of a `Subdivision_part` of the
// library, and for each face the side that leads to its first corner. Attributes copy it, which is
// cheap, and are valid as long as the subdivision.

// Represents the whole subdivision except for faces without area, which have two sides.
template <class Subdivision>
class Whole_subdivision
{
public:
  explicit Whole_subdivision(const Subdivision& subdivision) : m_subdivision(&subdivision)
  {
    std::vector<Mesh::Face_index> faces;
    faces.reserve(mesh().number_of_faces());
    for(const Mesh::Face_index f : mesh().faces())
      if(mesh().degree(f) > 2)
        faces.push_back(f);
    m_faces = std::make_shared<const std::vector<Mesh::Face_index>>(std::move(faces));
  }

  const Subdivision& subdivision() const { return *m_subdivision; }
  const Mesh& mesh() const { return m_subdivision->mesh(); }

  auto vertices() const { return mesh().vertices(); }
  auto edges() const { return mesh().edges(); }
  const std::vector<Mesh::Face_index>& faces() const { return *m_faces; }
  Mesh::size_type number(Mesh::Vertex_index v) const { return v; }

  Mesh::Halfedge_index side_to_first_corner(Mesh::Face_index f) const
  {
    return mesh().prev(mesh().halfedge(f));
  }

private:
  const Subdivision* m_subdivision;
  std::shared_ptr<const std::vector<Mesh::Face_index>> m_faces;
};

template <class Range>
auto element(const Range& range, std::size_t i)
{
  return *(range.begin() + static_cast<std::ptrdiff_t>(i));
}

// Adds one value, `value(element)`, for each of the elements that the member function returns.
template <class Part, class Elements, class Value>
void add_attribute(std::vector<Attribute>& data, const std::string& name, const Part& part,
                   Elements (Part::*elements)() const, const Value& value)
{
  data.emplace_back(name, (part.*elements)().size(),
                    [=](std::size_t i) { return value(element((part.*elements)(), i)); });
}

template <class Part>
void add_edges_and_polygons(const Part& part, Output_mesh& result)
{
  const auto& mesh = part.mesh();
  result.edges.reserve(part.edges().size());
  for(const auto e : part.edges())
    result.edges.push_back({part.number(mesh.vertex(e, 0)), part.number(mesh.vertex(e, 1))});
  result.polygons.reserve(part.faces().size(), 3 * part.faces().size());
  for(const auto f : part.faces()) {
    for(const auto h : CGAL::halfedges_around_face(part.side_to_first_corner(f), mesh))
      result.polygons.add_corner(part.number(mesh.target(h)));
    result.polygons.close();
  }
}

// Adds to edges and polygons the numbers of the elements of `side` that contain them, or -1 for
// none. `number(parent)` returns the numbers.
template <class Part, class Side, class Number>
void add_parents(const Part& part, Side side, const std::string& name, const Number& number,
                 Output_mesh& result)
{
  const auto edge = [=](auto e) { return number(part.subdivision().parent_edge(side, e)); };
  const auto face = [=](auto f) { return number(part.subdivision().parent_face(side, f)); };
  add_attribute(result.edge_data, name + "_edge", part, &Part::edges, edge);
  add_attribute(result.polygon_data, name + "_face", part, &Part::faces, face);
}

// Adds the positions of the points and polygons: `weights(v)` in vertices of the input, and its
// face `face(f)`.
template <class Part, class Weights, class Face>
void set_placement(const Part& part, const Weights& weights, const Face& face, Output_mesh& result)
{
  result.placement = {part.vertices().size(),
                      [=](std::size_t i) { return weights(element(part.vertices(), i)); },
                      [=](std::size_t i, std::size_t) { return face(part.faces()[i]); }};
}

#endif // INTRINSIC_SUBDIVISION_ELEMENTS_H
