// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "bindings.h"

#include <CGAL/Intrinsic_triangulations/convex_polyhedron.h>

#include <optional>

#include <pybind11/stl.h>

namespace {

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

void bind_polyhedron(py::module_& module) { module.def("convex_polyhedron", &convex_polyhedron); }
