// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "bindings.h"

#include <CGAL/Discrete_conformal_maps/pack_circles.h>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

// Returns the centers, in the unit disk or on the unit sphere, and the radii.
py::dict packed(const std::shared_ptr<Surface>& surface)
{
  const DCM::Circle_packing packing = released([&] { return DCM::pack_circles(surface->mesh); });
  if(packing.status() != DCM::Map_status::success)
    throw IT::Numerical_error(std::string("circles do not touch: ") +
                              DCM::message(packing.status()));
  const auto vertices = surface->mesh.vertices();
  py::dict result;
  result["is_disk"] = packing.is_disk();
  result["max_tangency_error"] = packing.max_tangency_error();
  if(packing.is_disk()) {
    result["centers"] = array_over(vertices, [&](DCM::Vertex_index v) -> std::array<double, 2> {
      const std::complex<double>& z = packing.circle(v).center;
      return {z.real(), z.imag()};
    });
    result["radii"] =
      array_over(vertices, [&](DCM::Vertex_index v) { return packing.circle(v).radius; });
  } else {
    result["centers"] =
      array_over(vertices, [&](DCM::Vertex_index v) { return packing.spherical_circle(v).center; });
    result["radii"] =
      array_over(vertices, [&](DCM::Vertex_index v) { return packing.spherical_circle(v).angle; });
  }
  return result;
}

} // namespace

void bind_packing(py::module_& module) { module.def("pack_circles", &packed); }
