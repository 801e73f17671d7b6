// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "bindings.h"

#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/glue_boundary.h>

#include <optional>
#include <string>

#include <pybind11/stl.h>

namespace {

// Returns the surface whose sides are glued by rows of four vertices. The first two are the ends of
// one side, the last two of the other.
template <class Length_map>
IT::Glued_surface glued(const IT::Delta_complex& mesh, const Length_map& length,
                        const Index_array& rows)
{
  IT::Paired_sides sides(mesh, length);
  for(py::ssize_t i = 0; i < rows.shape(0); ++i)
    try {
      const std::int64_t* const v = rows.data() + 4 * i;
      const auto vertex = [&](int k) { return IT::Vertex_index(Mesh::size_type(v[k])); };
      sides.add(vertex(0), vertex(1), vertex(2), vertex(3));
    } catch(const IT::Invalid_input& error) {
      const auto row = std::size_t(i);
      throw Element_error("InputError", "row " + std::to_string(row) + " of glue: " + error.what(),
                          {{"row", {row}}});
    }
  return IT::glue_boundary(mesh, length, sides.complete_pairs());
}

// Returns the net `surface` with its sides glued, and the vertices that its vertices have become.
py::tuple glued_surface(const Surface& surface, const Index_array& rows)
{
  IT::Glued_surface result = released([&] {
    if(!surface.has_positions())
      return glued(surface.mesh,
                   boost::make_iterator_property_map(surface.length.begin(),
                                                     get(boost::edge_index, surface.mesh)),
                   rows);
    std::vector<double> length(surface.mesh.number_of_edges());
    const auto map =
      boost::make_iterator_property_map(length.begin(), get(boost::edge_index, surface.mesh));
    IT::compute_edge_lengths(surface.mesh, map,
                             IT::parameters::vertex_point_map(surface.point_map()));
    return glued(surface.mesh, map, rows);
  });
  const auto length = IT::stored_length_map<double>(result.mesh);
  auto on = std::make_shared<Surface>();
  for(const IT::Edge_index e : result.mesh.edges())
    on->length.push_back(length[e]);
  const py::array vertices = array_over(
    result.vertices, [](IT::Vertex_index v) { return v.is_valid() ? std::int64_t(v.idx()) : -1; });
  on->mesh = std::move(result.mesh);
  on->mesh.remove_all_property_maps();
  return py::make_tuple(on, vertices);
}

IT::Convex_polyhedron polyhedron_of(const Surface& surface, std::optional<double> flatness)
{
  return with_lengths(surface, IT::parameters::mollification(0.), [&](const auto& np) {
    return flatness ? IT::convex_polyhedron(surface.mesh, np.curvature_tolerance(*flatness))
                    : IT::convex_polyhedron(surface.mesh, np);
  });
}

py::dict convex_polyhedron(const std::shared_ptr<Surface>& surface, std::optional<double> flatness)
{
  const IT::Convex_polyhedron polyhedron =
    released([&] { return polyhedron_of(*surface, flatness); });
  std::vector<std::array<double, 3>> points;
  for(const Point& p : polyhedron.points())
    points.push_back({p.x(), p.y(), p.z()});
  std::vector<std::int64_t> flat;
  for(const IT::Vertex_index v : polyhedron.flat_vertices())
    flat.push_back(v.idx());
  py::dict result;
  result["points"] = array_of(std::move(points));
  result["faces"] = array_of(corners_of(polyhedron.triangulation().mesh()));
  result["flat_vertices"] = array_of(std::move(flat));
  result["kind"] = IT::to_string(polyhedron.kind());
  result["max_edge_error"] = polyhedron.max_edge_error();
  result["triangulation"] =
    py::cast(std::make_unique<Bound_triangulation>(surface, polyhedron.triangulation()));
  return result;
}

} // namespace

void bind_polyhedron(py::module_& module)
{
  module.def("convex_polyhedron", &convex_polyhedron);
  module.def("glued_surface", &glued_surface);
}
