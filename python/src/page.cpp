// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "Surface.h"
#include "bindings.h"
#include "page/View_page.h"
#include "page/show_angles.h"
#include "pictures/develop_faces.h"
#include "writing/subdivision_mesh.h"

#include <CGAL/Intrinsic_triangulations/interpolation.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

// Each function has a name and a value for each vertex, which the Python layer has checked.
typedef std::vector<std::pair<std::string, Number_array>> Functions;

std::string text_of(View_page& page, std::size_t points, std::size_t faces)
{
  page.set_statistics({{"points", points}, {"faces", faces}});
  Text text;
  page.write_html(text);
  return text.take();
}

std::string page_of(const Number_array& points, const Index_array& faces,
                    const Functions& functions)
{
  return released([&] {
    Polygon_soup soup = soup_of(points, faces);
    for(const auto& [name, values] : functions)
      soup.data.functions.push_back({name, vector_of(values)});
    clean(soup.data, soup.points.size());
    View_page page;
    show(page, "mesh", soup);
    return text_of(page, soup.points.size(), soup.polygons.size());
  });
}

// Returns whether the lengths of the input are distances of its points, up to rounding.
bool has_lengths_of_points(const Bound_triangulation& self)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  const std::vector<Point>& points = self.surface()->points;
  const auto edges = mesh.edges();
  return std::all_of(edges.begin(), edges.end(), [&](IT::Edge_index e) {
    const double distance =
      std::sqrt(CGAL::squared_distance(points[mesh.vertex(e, 0)], points[mesh.vertex(e, 1)]));
    const double length = self.triangulation().input_length(e);
    return std::abs(length - distance) <= 1e-12 * distance;
  });
}

// Returns the page of the common subdivision, with functions at the vertices of the input or of the
// triangulation.
// The page develops the intrinsic faces instead if the subdivision is large or `is_direct`.
std::string page_of_triangulation(const Bound_triangulation& self, const Functions& functions,
                                  bool is_direct)
{
  return released([&] {
    const Triangulation& triangulation = self.triangulation();
    Subdivision subdivision(self.correspondence());
    IT::interpolate(IT::Side::input, subdivision, self.surface()->point_map(),
                    subdivision.mesh().points());
    Output_mesh mesh = subdivision_mesh(subdivision);
    std::vector<Attribute> input_data, vertex_data;
    for(const auto& [name, values] : functions) {
      const bool is_on_input =
        std::size_t(values.size()) == triangulation.input_mesh().number_of_vertices();
      (is_on_input ? input_data : vertex_data).push_back({name, vector_of(values)});
      mesh.point_data.push_back(
        {name, interpolated(is_on_input ? IT::Side::input : IT::Side::intrinsic, vector_of(values),
                            subdivision)});
    }
    View_page page;
    page.add_surface("surface", mesh);
    if((is_direct || subdivision.mesh().number_of_faces() > most_polygons) &&
       has_lengths_of_points(self))
      if(auto faces =
           develop_faces(triangulation, self.surface()->points, input_data, std::move(vertex_data)))
        page.set_developed(std::move(*faces));
    show_angles(page, "input", triangulation.input_mesh(), triangulation.input_length_map());
    show_angles(page, "intrinsic", triangulation.mesh(), triangulation.length_map());
    return text_of(page, triangulation.mesh().number_of_vertices(),
                   triangulation.mesh().number_of_faces());
  });
}

Polygons polygons_of(const Index_array& starts, const Index_array& corners)
{
  Polygons result;
  for(py::ssize_t i = 0; i + 1 < starts.size(); ++i) {
    for(std::int64_t c = starts.data()[i]; c < starts.data()[i + 1]; ++c)
      result.add_corner(std::size_t(corners.data()[c]));
    result.close();
  }
  return result;
}

// Returns rows of two or three numbers.
std::vector<std::array<double, 3>> rows_of(const Number_array& array)
{
  std::vector<std::array<double, 3>> result(std::size_t(array.shape(0)), {0, 0, 0});
  for(std::size_t i = 0; i < result.size(); ++i)
    for(py::ssize_t k = 0; k < array.shape(1); ++k)
      result[i][std::size_t(k)] = array.data()[py::ssize_t(i) * array.shape(1) + k];
  return result;
}

// Returns the page of the pieces of a map, with their images in the plane, the Poincare disk, or on
// the sphere.
std::string page_of_map(const Number_array& points, const Index_array& starts,
                        const Index_array& corners, const Index_array& corner_image,
                        const Number_array& image, const Number_array& homogeneous,
                        const std::string& kind, const Functions& functions)
{
  return released([&] {
    Output_mesh mesh;
    for(const std::array<double, 3>& p : rows_of(points))
      mesh.points.emplace_back(p[0], p[1], p[2]);
    mesh.polygons = polygons_of(starts, corners);
    mesh.edges = edges_of(mesh.polygons);
    if(kind != "sphere")
      mesh.texture = {"", 3, rows_of(homogeneous), polygons_of(starts, corner_image)};
    for(const auto& [name, values] : functions)
      mesh.point_data.push_back({name, vector_of(values)});
    View_page page;
    page.add_surface("surface", mesh);
    page.set_image(kind == "sphere" ? Image_kind::sphere
                   : kind == "disk" ? Image_kind::disk
                                    : Image_kind::plane,
                   rows_of(image));
    return text_of(page, mesh.points.size(), mesh.polygons.size());
  });
}

} // namespace

void bind_page(py::module_& module)
{
  module.attr("has_pages") = View_page::is_available();
  module.def("page", &page_of);
  module.def("page_of_triangulation", &page_of_triangulation);
  module.def("page_of_map", &page_of_map);
}
