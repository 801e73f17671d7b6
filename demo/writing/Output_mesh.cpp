// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Output_mesh.h"

#include "reading/Input_mesh.h"

#include <algorithm>
#include <set>
#include <unordered_set>

namespace {

template <class Faces>
Output_mesh points_and_polygons(const Mesh& mesh, const Faces& faces)
{
  Output_mesh result;
  result.points.assign(mesh.points().begin(), mesh.points().end());
  result.polygons = polygons_of(mesh, faces);
  return result;
}

std::string untaken(std::string name, std::set<std::string>& taken)
{
  while(!taken.insert(name).second)
    name = "input_" + name;
  return name;
}

} // namespace

const char* name_of(const Corner_data& data)
{
  if(!data.name.empty())
    return data.name.c_str();
  return data.dimension == 3 ? "homogeneous_texcoord" : "texcoord";
}

std::vector<std::array<Polygons::Index, 2>> edges_of(const Polygons& polygons)
{
  std::vector<std::array<Polygons::Index, 2>> result;
  for(const Polygons::Polygon& p : polygons)
    for(std::size_t k = 0; k < p.size(); ++k) {
      const Polygons::Index a = p[k], b = p[(k + 1) % p.size()];
      result.push_back({(std::min)(a, b), (std::max)(a, b)});
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<std::int64_t> parts_of(const std::vector<std::int64_t>& values, const std::string& name,
                                   const Output_mesh& mesh)
{
  const Attribute& owners = *find_attribute(mesh.polygon_data, name);
  const std::unordered_set<std::int64_t> wanted(values.begin(), values.end());
  std::vector<std::int64_t> result;
  for(std::size_t i = 0; i < owners.size(); ++i)
    if(wanted.count(owners.integer(i)) > 0)
      result.push_back(std::int64_t(i));
  return result;
}

const Attribute* find_attribute(const std::vector<Attribute>& data, const std::string& name)
{
  const auto found =
    std::find_if(data.begin(), data.end(), [&](const Attribute& a) { return a.name == name; });
  return found == data.end() ? nullptr : &*found;
}

void resize(Attribute& a, std::size_t n)
{
  a.kept().resize(n, a.are_integers() ? 0 : std::numeric_limits<double>::quiet_NaN());
}

Output_mesh output_mesh(const Mesh& mesh) { return points_and_polygons(mesh, mesh.faces()); }

Output_mesh output_mesh(const Polygon_soup& soup)
{
  Output_mesh result;
  result.points = soup.points;
  result.polygons = soup.polygons;
  return result;
}

Output_mesh output_mesh_with_edges(const Mesh& mesh, const std::vector<Mesh::Face_index>& faces)
{
  Output_mesh result = points_and_polygons(mesh, faces);
  result.edges.reserve(mesh.number_of_edges());
  for(const Mesh::Edge_index e : mesh.edges())
    result.edges.push_back({mesh.vertex(e, 0), mesh.vertex(e, 1)});
  return result;
}

void add_data(Output_mesh& mesh, Mesh_data data)
{
  mesh.groups = std::move(data.groups);
  std::set<std::string> taken;
  for(const Attribute& a : mesh.point_data)
    taken.insert(a.name);
  if(mesh.texture.dimension > 0)
    taken.insert(name_of(mesh.texture));
  for(Corner_data& corners : data.corners) {
    corners.name = untaken(corners.name, taken);
    mesh.corner_data.push_back(std::move(corners));
  }
  for(Point_function& f : data.functions) {
    const std::string name = untaken(f.name, taken);
    if(f.is_color)
      mesh.point_data.push_back(
        {name, std::vector<std::int64_t>(f.values.begin(), f.values.end())});
    else
      mesh.point_data.push_back({name, std::move(f.values)});
  }
}

Mesh_data data_at(const Input_mesh& input, const Polygons& polygons, const Placement& placement)
{
  const auto weights = [&](std::size_t i) { return input.weights(placement.weights(i)); };
  const auto triangle = [&](std::size_t i, std::size_t k) {
    return input.triangle(placement.face(i, k));
  };
  return carried(input.data, {placement.number_of_points, polygons, weights, triangle});
}

void add_input_data(const Input_mesh& input, Output_mesh& mesh)
{
  if(!input.data.empty())
    add_data(mesh, data_at(input, mesh.polygons, mesh.placement));
}
