// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "bindings.h"
#include "reading/Soup_repair.h"
#include "reading/close_points.h"

#include <CGAL/Intrinsic_triangulations/diagnose.h>

#include <pybind11/stl.h>

#include <algorithm>

namespace {

py::array rows_of(const std::vector<Point>& points)
{
  return array_over(points, [](const Point& p) -> std::array<double, 3> {
    return {p.x(), p.y(), p.z()};
  });
}

// Returns the vertices on the boundary, in increasing order.
py::array border_vertices(const Surface& surface)
{
  std::vector<std::int64_t> result;
  for(const IT::Vertex_index v : surface.mesh.vertices())
    if(!surface.mesh.is_isolated(v) && surface.mesh.is_border(v))
      result.push_back(v.idx());
  return array_of(std::move(result));
}

std::size_t number_of_isolated_vertices(const Surface& surface)
{
  const auto vertices = surface.mesh.vertices();
  return static_cast<std::size_t>(
    std::count_if(vertices.begin(), vertices.end(),
                  [&](IT::Vertex_index v) { return surface.mesh.is_isolated(v); }));
}

py::tuple repaired(const Number_array& points, const Index_array& faces, double weld_distance)
{
  Repair_report report;
  const Polygon_soup soup = released([&] {
    Polygon_soup result = soup_of(points, faces);
    report = repair(result, weld_distance);
    return result;
  });
  std::vector<std::array<std::int64_t, 3>> corners;
  for(const Polygons::Polygon p : soup.polygons)
    if(p.size() == 3)
      corners.push_back({p[0], p[1], p[2]});
  return py::make_tuple(rows_of(soup.points), array_of(std::move(corners)), report);
}

py::list defects_of(const IT::Input_diagnosis& diagnosis)
{
  py::list result;
  if(diagnosis.statistics().faces == 0)
    result.append(py::dict(py::arg("kind") = "no faces", py::arg("is_fatal") = true,
                           py::arg("count") = 1, py::arg("message") = "there are no faces"));
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(diagnosis.count(d.kind) > 0 && d.kind != IT::Defect_kind::SEVERAL_COMPONENTS)
      result.append(py::dict(py::arg("kind") = d.name, py::arg("is_fatal") = d.is_fatal,
                             py::arg("count") = diagnosis.count(d.kind),
                             py::arg("message") = diagnosis.message(d.kind)));
  return result;
}

py::dict diagnosed(const Number_array& points, const Index_array& faces)
{
  Cracks found;
  const IT::Input_diagnosis diagnosis = released([&] {
    const Polygon_soup soup = soup_of(points, faces);
    IT::Input_diagnosis result = IT::diagnose_polygon_soup(soup.points, soup.polygons);
    if(result.is_valid())
      found = cracks(mesh_of(soup));
    return result;
  });
  const IT::Input_diagnosis::Statistics& s = diagnosis.statistics();
  return py::dict(
    py::arg("vertices") = s.vertices, py::arg("edges") = s.edges, py::arg("faces") = s.faces,
    py::arg("euler_characteristic") = s.euler_characteristic,
    py::arg("boundary_loops") = s.boundary_loops, py::arg("components") = s.components,
    py::arg("min_angle_degrees") = s.min_angle, py::arg("min_edge_length") = s.min_edge_length,
    py::arg("max_edge_length") = s.max_edge_length,
    py::arg("is_valid") = diagnosis.is_valid() && s.faces > 0,
    py::arg("defects") = defects_of(diagnosis), py::arg("coincident_points") = found.coincident,
    py::arg("close_points") = found.close);
}

} // namespace

void bind_surface(py::module_& module)
{
  py::class_<Surface, std::shared_ptr<Surface>>(module, "Surface")
    .def_static("of_points",
                [](const Number_array& points, const Index_array& faces, bool allows_zero) {
                  return std::make_shared<Surface>(surface_of_points(points, faces, allows_zero));
                })
    .def_static("of_lengths",
                [](const Number_array& lengths, const Index_array& faces) {
                  return std::make_shared<Surface>(surface_of_lengths(lengths, faces));
                })
    .def("has_positions", &Surface::has_positions)
    .def("positions", [](const Surface& s) { return rows_of(s.points); })
    .def("faces", [](const Surface& s) { return array_of(corners_of(s.mesh)); })
    .def("border_vertices", &border_vertices)
    .def("number_of_isolated_vertices", &number_of_isolated_vertices)
    .def("number_of_vertices", [](const Surface& s) { return s.mesh.number_of_vertices(); })
    .def("number_of_faces", [](const Surface& s) { return s.mesh.number_of_faces(); });
  module.def("repair", &repaired);
  module.def("diagnose", &diagnosed);
}
