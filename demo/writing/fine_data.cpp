// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/fine_data.h"

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

typedef Mesh::size_type Size;

Point_weights point_weights(std::size_t i, const Input_mesh& input, const Fine_level& level)
{
  const std::size_t first = level.mesh.number_of_vertices() - level.sources.size();
  if(i >= first) // copies are where their originals are
    return point_weights(level.sources[i - first].front(), input, level);
  const IT::Vertex_index v(static_cast<Size>(i));
  if(level.refined == nullptr || !level.refined->is_inserted(v))
    return input.weights({1, {v}, {1}});
  return input.weights(
    IT::vertex_weights(level.refined->inserted_vertex(v), level.refined->input_mesh()));
}

// The centers of disks are described by means.
void set_means(const Fine_level& level, std::vector<double>& values)
{
  const std::size_t first = level.mesh.number_of_vertices() - level.sources.size();
  for(std::size_t i = 0; i < level.sources.size(); ++i) {
    double sum = 0;
    for(const Mesh::Vertex_index v : level.sources[i])
      sum += values[v];
    values[first + i] = sum / static_cast<double>(level.sources[i].size());
  }
}

} // namespace

Triangle_data fine_data(const Input_mesh& input, const Fine_level& level)
{
  if(input.data.empty() || (level.refined == nullptr && level.sources.empty()))
    return input.data;
  const Polygons triangles = polygons_of(level.mesh, level.mesh.faces());
  const auto weights = [&](std::size_t i) { return point_weights(i, input, level); };
  const auto triangle = [&](std::size_t i, std::size_t) {
    return input.triangle(level.input_face(Mesh::Face_index(static_cast<Size>(i))));
  };
  Triangle_data result{
    carried(input.data, {level.mesh.number_of_vertices(), triangles, weights, triangle}),
    triangles};
  for(Point_function& f : result.functions)
    set_means(level, f.values);
  return result;
}
