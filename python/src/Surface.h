// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_SURFACE_H
#define INTRINSIC_PYTHON_SURFACE_H

#include "arrays.h"
#include "reading/Polygon_soup.h"

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <complex>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

using Triangulation = IT::Intrinsic_triangulation<>;
using Location = IT::Face_location<double>;

// Represents an exception of `intrinsic.errors`, by its name, with the indices of elements as
// attributes.
class Element_error : public std::runtime_error
{
public:
  typedef std::vector<std::pair<std::string, std::vector<std::size_t>>> Elements;

  Element_error(std::string type, const std::string& message, Elements elements)
    : std::runtime_error(message), m_type(std::move(type)), m_elements(std::move(elements))
  {}

  const std::string& type() const { return m_type; }
  const Elements& elements() const { return m_elements; }

private:
  std::string m_type;
  Elements m_elements;
};

// Represents a mesh of arrays. Vertices and faces keep their indices, and faces their first
// corners. It has either points or lengths.
struct Surface
{
  IT::Delta_complex mesh;
  std::vector<Point> points;  // of the vertices
  std::vector<double> length; // of the edges

  bool has_positions() const { return length.empty(); }
  auto point_map() const
  {
    return boost::make_iterator_property_map(
      points.data(), boost::typed_identity_property_map<IT::Vertex_index>());
  }
};

// Returns positions (n, 3) and corners (m, 3), unchecked. Negative indices name no point.
Polygon_soup soup_of(const Number_array& points, const Index_array& faces);

// Returns positions (n, 3) and corners (m, 3) that need not form a surface. With
// `are_zero_lengths_allowed`, sides may have the length zero.
// Throws Element_error that names an element if an index, a position or a length is wrong.
Polygon_soup checked_soup_of(const Number_array& points, const Index_array& faces,
                             bool are_zero_lengths_allowed);

// Makes a surface of positions (n, 3) and corners (m, 3). With `are_zero_lengths_allowed`, edges
// may have the length zero.
// Throws Element_error that names an element if the arrays are no surface.
Surface surface_of_points(const Number_array& points, const Index_array& faces,
                          bool are_zero_lengths_allowed);

// Makes a surface of lengths (m, 3) of the sides opposite to the corners (m, 3).
// Throws Element_error as `surface_of_points()` does, and if the two faces of an edge disagree.
Surface surface_of_lengths(const Number_array& lengths, const Index_array& faces);

// Calls `use(parameters)` with the named parameters that have the points or the lengths of the
// surface.
template <class Parameters, class Use>
auto with_lengths(const Surface& surface, const Parameters& np, const Use& use)
{
  if(surface.has_positions())
    return use(np.vertex_point_map(surface.point_map()));
  return use(np.edge_length_map(boost::make_iterator_property_map(
    surface.length.begin(), get(boost::edge_index, surface.mesh))));
}

Triangulation triangulation_of(const Surface& surface, double mollification);

// Returns the same triangulation, and leaves the surface without its mesh, which is not copied.
Triangulation triangulation_from(Surface& surface, double mollification);

// Returns factors for the tangent vectors at each vertex. They turn the frame of the intrinsic
// triangulation to the frame of the input, see `IT::angle_on_input()`.
std::vector<std::complex<double>> rotations_to_input(const Triangulation& triangulation);

// Returns points on a surface: faces (k) and barycentric coordinates (k, 3), in the order of
// corners. Sums are normalized to one.
// Throws Element_error if they are not on a surface with so many faces.
std::vector<Location> locations_of(const Index_array& faces, const Number_array& coordinates,
                                   std::size_t number_of_faces);

// Returns faces and barycentric coordinates.
py::tuple arrays_of(const std::vector<Location>& points);

// Returns the corners of a face, in the order of barycentric coordinates.
template <class P>
std::array<std::int64_t, 3> corners_of(IT::Face_index f, const CGAL::Surface_mesh<P>& mesh)
{
  const auto h = IT::sides(f, mesh);
  return {std::int64_t(mesh.source(h[0]).idx()), std::int64_t(mesh.source(h[1]).idx()),
          std::int64_t(mesh.source(h[2]).idx())};
}

template <class P>
std::vector<std::array<std::int64_t, 3>> corners_of(const CGAL::Surface_mesh<P>& mesh)
{
  std::vector<std::array<std::int64_t, 3>> result;
  result.reserve(mesh.number_of_faces());
  for(const IT::Face_index f : mesh.faces())
    result.push_back(corners_of(f, mesh));
  return result;
}

// Returns the edges of the faces of a triangulation, from the first corner on.
template <class P>
py::array face_edges_of(const CGAL::Surface_mesh<P>& mesh)
{
  return array_over(mesh.faces(), [&](IT::Face_index f) -> std::array<std::int64_t, 3> {
    const auto h = IT::sides(f, mesh);
    return {std::int64_t(mesh.edge(h[0]).idx()), std::int64_t(mesh.edge(h[1]).idx()),
            std::int64_t(mesh.edge(h[2]).idx())};
  });
}

template <class Any_surface>
py::array lengths_of(const Any_surface& surface)
{
  return array_over(surface.mesh().edges(),
                    [&](IT::Edge_index e) -> double { return surface.length_map()[e]; });
}

#endif // INTRINSIC_PYTHON_SURFACE_H
