// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/joined_components.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace {

constexpr double texture_distance = 0.02; // relative to the width of a texture

std::vector<std::size_t> counted_from(std::size_t first, std::size_t n)
{
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), first);
  return result;
}

// Returns the attribute with the name of `a`, which is added if it does not exist.
Attribute& attribute_like(const Attribute& a, std::vector<Attribute>& all)
{
  const auto found =
    std::find_if(all.begin(), all.end(), [&](const Attribute& b) { return b.name == a.name; });
  if(found != all.end())
    return *found;
  all.push_back(a);
  all.back().kept().clear();
  return all.back();
}

bool ends_with(const std::string& text, const std::string& end)
{
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

Joined_components::Joined_components(const Input_mesh& input) : m_input(input)
{
  std::vector<std::int64_t> number;
  for(const Mesh::Vertex_index v : input.mesh.vertices()) {
    m_result.points.push_back(input.mesh.point(v));
    m_weights.push_back({1, {v}, {1}});
    number.push_back(v.idx());
  }
  m_result.point_data.push_back({"input_vertex", std::move(number)});
}

void Joined_components::add(const Component_mesh& component, Output_mesh part, double shift)
{
  part.keep();
  const std::size_t edges = m_result.edges.size(), polygons = m_result.polygons.size();
  const std::vector<std::size_t> points = add_points(component, part, shift);
  const auto point = [&](Polygons::Index p) { return static_cast<Polygons::Index>(points[p]); };
  for(const auto& [v, w] : part.edges)
    m_result.edges.push_back({point(v), point(w)});
  for(const Polygons::Polygon polygon : part.polygons) {
    for(const Polygons::Index p : polygon)
      m_result.polygons.add_corner(point(p));
    m_result.polygons.close();
  }
  for(std::size_t i = 0; i < part.polygons.size(); ++i)
    m_faces.push_back(part.placement.face(i, 0));
  add_texture(part);
  add_attributes(part.point_data, points, m_result.points.size(), m_result.point_data);
  add_attributes(part.edge_data, counted_from(edges, part.edges.size()), m_result.edges.size(),
                 m_result.edge_data);
  add_attributes(part.polygon_data, counted_from(polygons, part.polygons.size()),
                 m_result.polygons.size(), m_result.polygon_data);
}

std::vector<std::size_t> Joined_components::add_points(const Component_mesh& component,
                                                       const Output_mesh& part, double shift)
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < part.points.size(); ++i) {
    const Point p = part.points[i] + Kernel::Vector_3(shift, 0, 0);
    if(i < component.vertices.size()) {
      result.push_back(component.vertices[i]);
      m_result.points[result.back()] = p;
      continue;
    }
    result.push_back(m_result.points.size());
    m_result.points.push_back(p);
    m_weights.push_back(part.placement.weights(i));
  }
  return result;
}

double Joined_components::texture_shift(const Corner_data& texture)
{
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for(const auto& z : texture.coordinates)
    if(z[2] > 0) {
      left = (std::min)(left, z[0] / z[2]);
      right = (std::max)(right, z[0] / z[2]);
    }
  // The first texture is not shifted.
  const bool is_first = m_result.texture.coordinates.empty();
  const double shift = is_first ? 0 : m_right + texture_distance * (right - left) - left;
  m_right = right + shift;
  return shift;
}

void Joined_components::add_texture(const Output_mesh& part)
{
  Corner_data& texture = m_result.texture;
  if(part.texture.dimension == 0) {
    for(const Polygons::Polygon polygon : part.polygons)
      texture.polygons.push_back(std::vector<Polygons::Index>(polygon.size(), Polygons::none));
    return;
  }
  const double shift = texture_shift(part.texture);
  const std::size_t first = texture.coordinates.size();
  for(const auto& [x, y, w] : part.texture.coordinates)
    texture.coordinates.push_back({x + shift * w, y, w});
  for(const Polygons::Polygon polygon : part.texture.polygons) {
    for(const Polygons::Index c : polygon)
      texture.polygons.add_corner(c == Polygons::none ? std::size_t(c) : first + c);
    texture.polygons.close();
  }
  texture.dimension = (std::max)(texture.dimension, part.texture.dimension);
}

// Continues the numbering of elements of triangulations other than the input.
void Joined_components::count_on(Attribute& a)
{
  if(a.name.compare(0, 6, "input_") == 0 ||
     !(ends_with(a.name, "_edge") || ends_with(a.name, "_face")))
    return;
  double& before = m_number_of_parents[a.name];
  double greatest = -1;
  for(double& i : a.kept()) {
    greatest = (std::max)(greatest, i);
    i += i < 0 ? 0 : before;
  }
  before += greatest + 1;
}

// Resizes an attribute. Points without data are at their positions in the input. Other missing
// values are -1.
void Joined_components::resize(Attribute& a, std::size_t size) const
{
  std::vector<double>& values = a.kept();
  const std::size_t before = values.size();
  values.resize(size, a.are_integers() ? -1 : 0);
  for(int k = 0; k < 3; ++k)
    if(a.name == std::string("input_") + "xyz"[k])
      for(std::size_t i = before; i < size; ++i)
        values[i] = m_result.points[i][k];
}

void Joined_components::add_attributes(std::vector<Attribute>& from,
                                       const std::vector<std::size_t>& places, std::size_t size,
                                       std::vector<Attribute>& to)
{
  for(Attribute& a : from) {
    count_on(a);
    Attribute& all = attribute_like(a, to);
    resize(all, size);
    for(std::size_t i = 0; i < places.size(); ++i)
      all.kept()[places[i]] = a[i];
  }
  for(Attribute& a : to)
    resize(a, size);
}

Output_mesh Joined_components::finish()
{
  if(m_result.texture.dimension == 0)
    m_result.texture = Corner_data();
  m_result.placement = {m_result.points.size(), [this](std::size_t i) { return m_weights[i]; },
                        [this](std::size_t i, std::size_t) { return m_faces[i]; }};
  ::add_input_data(m_input, m_result);
  return std::move(m_result);
}
