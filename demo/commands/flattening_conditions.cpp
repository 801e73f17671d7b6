// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/flattening_conditions.h"

#include "Program_error.h"
#include "reading/vertex_values.h"

#include <CGAL/boost/graph/helpers.h>

#include <string>

using CGAL::Discrete_conformal_maps::Vertex_condition;

namespace {

bool is_on_boundary(Mesh::Vertex_index v, const Mesh& mesh)
{
  return !mesh.is_isolated(v) && mesh.is_border(v);
}

bool is_inside(Mesh::Vertex_index v, const Mesh& mesh)
{
  return !mesh.is_isolated(v) && !mesh.is_border(v);
}

// Turns each value into a condition by `make`; `is_allowed` returns whether a vertex may have one.
template <class Predicate>
void set_from_file(Conditions& conditions, const Mesh& mesh, const std::string& path,
                   Vertex_condition (*make)(double), const Predicate& is_allowed,
                   const std::string& place)
{
  for(const Vertex_value& x : read_vertex_values(path, conditions.size())) {
    if(!is_allowed(Mesh::Vertex_index(Mesh::size_type(x.vertex)), mesh))
      throw Program_error(path + ": line " + std::to_string(x.line) + ": vertex " +
                          std::to_string(x.vertex) + " is not " + place + "; remove the line");
    conditions[x.vertex] = make(x.value);
  }
}

void set_unscaled(Conditions& conditions, const Mesh& mesh)
{
  for(const Mesh::Vertex_index v : mesh.vertices())
    if(is_on_boundary(v, mesh))
      conditions[v] = Vertex_condition::log_scale(0);
}

bool has_values(const std::string& boundary)
{
  return boundary == "scale" || boundary == "curvature";
}

// Sets the conditions on the boundary. Shapes of `is_shape()` and a straight boundary need none.
void set_boundary(Conditions& conditions, const Flatten_options& options, const Mesh& mesh)
{
  if(options.boundary == "free")
    set_unscaled(conditions, mesh);
  else if(has_values(options.boundary))
    set_from_file(conditions, mesh, options.boundary_values,
                  options.boundary == "scale" ? Vertex_condition::log_scale
                                              : Vertex_condition::curvature,
                  is_on_boundary, "on the boundary");
}

} // namespace

bool is_shape(const std::string& boundary) { return boundary == "rectangle" || boundary == "disk"; }

bool places_cones(const std::string& cones) { return cones == "greedy" || cones == "exchanged"; }

void check_boundary(const Flatten_options& options)
{
  const std::string& what = options.boundary;
  if(!has_values(what) && !is_shape(what) && what != "free" && what != "straight")
    throw Program_error("--boundary: '" + what +
                        "' is none of free, straight, scale, curvature, rectangle and disk");
  if(has_values(what) && options.boundary_values.empty())
    throw Program_error("--boundary " + what + " needs a file of values: add --boundary-values");
  if(!has_values(what) && !options.boundary_values.empty())
    throw Program_error("--boundary-values is for --boundary scale and curvature");
}

void check_circles(const Flatten_options& options, bool is_exact)
{
  if(options.radii.empty())
    return;
  if(is_exact)
    throw Program_error("--radii: --exact cannot decide about circles; leave out one of them");
  if(options.solver == "ceres")
    throw Program_error("--radii: --solver ceres has no energy of circles; leave out one of them");
  if(options.boundary == "disk")
    throw Program_error("--radii: with --boundary disk, the centers of circles at the boundary do "
                        "not lie on a circle; use `intrinsic sphere`, or another --boundary");
}

Conditions flattening_conditions(const Flatten_options& options, const Mesh& mesh)
{
  const std::string& boundary = options.boundary;
  if(boundary != "free" && !is_shape(boundary) && CGAL::is_closed(mesh))
    throw Program_error("--boundary " + boundary + ": the mesh has no boundary; leave it out");
  Conditions result(mesh.number_of_vertices());
  if(!places_cones(options.cones) && options.cones != "none")
    set_from_file(result, mesh, options.cones, Vertex_condition::curvature, is_inside,
                  "inside the surface");
  set_boundary(result, options, mesh);
  return result;
}

void add_radii(CLI::App& command, Common_options& common, std::string& source)
{
  add_read_file(command, common, "--radii", source,
                "Circles at vertices: a file of radii, or a property of vertices in the mesh");
}

Conditions prescribed_curvatures(const std::string& path, const Mesh& mesh)
{
  Conditions result(mesh.number_of_vertices());
  const auto is_used = [](Mesh::Vertex_index v, const Mesh& m) { return !m.is_isolated(v); };
  set_from_file(result, mesh, path, Vertex_condition::curvature, is_used, "part of the surface");
  return result;
}
