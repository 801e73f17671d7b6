// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/joined_components.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

namespace {

constexpr double texture_distance = 0.02; // relative to the width of a texture

std::vector<std::size_t> counted_from(std::size_t first, std::size_t n)
{
  std::vector<std::size_t> result(n);
  std::iota(result.begin(), result.end(), first);
  return result;
}

template <class Index>
std::int64_t number_in(const std::vector<Index>& elements, std::int64_t i)
{
  return i >= 0 && i < std::int64_t(elements.size())
           ? static_cast<std::int64_t>(elements[std::size_t(i)].idx())
           : -1;
}

// Zero, or -1 where it stands for none.
template <class Number>
constexpr Number missing = std::is_integral<Number>::value ? Number(-1) : Number(0);

// The attribute with this name and kind of values, which comes to be if there is none.
Attribute& attribute_like(const Attribute& a, std::vector<Attribute>& all)
{
  const auto found =
    std::find_if(all.begin(), all.end(), [&](const Attribute& b) { return b.name == a.name; });
  if(found != all.end())
    return *found;
  all.push_back(std::visit(
    [&](const auto& v) {
      typedef typename std::decay_t<decltype(v.kept())>::value_type Number;
      return Attribute{a.name, std::vector<Number>()};
    },
    a.values));
  return all.back();
}

void resize(Attribute& a, std::size_t size)
{
  std::visit(
    [&](auto& v) {
      typedef typename std::decay_t<decltype(v.kept())>::value_type Number;
      v.kept().resize(size, missing<Number>);
    },
    a.values);
}

// Puts value i of one at place i of the other. Precondition: both have values of one kind.
void scatter(const Attribute& from, const std::vector<std::size_t>& places, Attribute& to)
{
  std::visit(
    [&](const auto& values) {
      auto& kept = std::get<std::decay_t<decltype(values)>>(to.values).kept();
      for(std::size_t i = 0; i < places.size(); ++i)
        kept[places[i]] = values[i];
    },
    from.values);
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

void Joined_components::add(const Component_mesh& component, const Map_front& front,
                            Output_mesh part, double shift)
{
  for(auto* data : {&part.point_data, &part.edge_data, &part.polygon_data})
    for(Attribute& a : *data)
      a.keep();
  const std::size_t edges = m_result.edges.size(), polygons = m_result.polygons.size();
  add_points(component, front, part, shift);
  for(const auto& e : part.edges)
    m_result.edges.push_back({m_point[e[0]], m_point[e[1]]});
  for(const Polygons::Polygon polygon : part.polygons) {
    for(const Polygons::Index p : polygon)
      m_result.polygons.add_corner(m_point[p]);
    m_result.polygons.close();
  }
  for(const Map_front::Face_index f : front.faces())
    m_face.push_back(
      number_in(component.faces,
                front.subdivision().parent_face(CGAL::Discrete_conformal_maps::Layer::A, f).idx()));
  add_texture(part);
  add_attributes(component, part.point_data, {m_point.begin(), m_point.end()},
                 m_result.points.size(), m_result.point_data);
  add_attributes(component, part.edge_data, counted_from(edges, part.edges.size()),
                 m_result.edges.size(), m_result.edge_data);
  add_attributes(component, part.polygon_data, counted_from(polygons, part.polygons.size()),
                 m_result.polygons.size(), m_result.polygon_data);
}

void Joined_components::add_points(const Component_mesh& component, const Map_front& front,
                                   const Output_mesh& part, double shift)
{
  m_point.clear();
  for(std::size_t i = 0; i < part.points.size(); ++i) {
    const Point p = part.points[i] + Kernel::Vector_3(shift, 0, 0);
    if(i < component.vertices.size()) {
      m_point.push_back(component.vertices[i]);
      m_result.points[component.vertices[i]] = p;
      continue;
    }
    m_point.push_back(static_cast<Polygons::Index>(m_result.points.size()));
    m_result.points.push_back(p);
    Weights w = front.input_weights(front.vertices()[i]);
    for(std::size_t c = 0; c < w.size; ++c)
      w.vertex[c] = component.vertices[w.vertex[c]];
    m_weights.push_back(w);
  }
}

double Joined_components::texture_shift(const Corner_data& texture)
{
  double left = std::numeric_limits<double>::infinity(), right = -left;
  for(const auto& z : texture.coordinates)
    if(z[2] > 0) {
      left = (std::min)(left, z[0] / z[2]);
      right = (std::max)(right, z[0] / z[2]);
    }
  // the first stays
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

// The indices of elements, as they are in the whole; values that are none stay.
std::vector<std::int64_t> Joined_components::parents(const Attribute& a,
                                                     const Component_mesh& component)
{
  std::vector<std::int64_t> result = std::get<0>(a.values).kept();
  const auto replace = [&](const auto& number) {
    std::transform(result.begin(), result.end(), result.begin(), number);
  };
  if(a.name == "input_vertex")
    replace([&](std::int64_t i) { return number_in(component.vertices, i); });
  else if(a.name == "input_edge")
    replace([&](std::int64_t i) { return number_in(component.edges, i); });
  else if(a.name == "input_face")
    replace([&](std::int64_t i) { return number_in(component.faces, i); });
  else if(const std::size_t n = a.name.size();
          n > 5 && (a.name.substr(n - 5) == "_edge" || a.name.substr(n - 5) == "_face")) {
    std::int64_t& before = m_number_of_parents[a.name];
    const std::int64_t greatest =
      result.empty() ? -1 : *std::max_element(result.begin(), result.end());
    replace([&](std::int64_t i) { return i < 0 ? i : i + before; });
    before += greatest + 1;
  }
  return result;
}

void Joined_components::add_attributes(const Component_mesh& component,
                                       std::vector<Attribute>& from,
                                       const std::vector<std::size_t>& places, std::size_t size,
                                       std::vector<Attribute>& to)
{
  for(Attribute& a : from) {
    if(a.values.index() == 0)
      a.values = Values<std::int64_t>(parents(a, component));
    Attribute& all = attribute_like(a, to);
    resize(all, size);
    scatter(a, places, all);
  }
  for(Attribute& a : to)
    resize(a, size);
}

// Of all points, if those of spheres have them.
void Joined_components::set_input_places()
{
  const char* const names[] = {"input_x", "input_y", "input_z"};
  for(Attribute& a : m_result.point_data)
    for(int k = 0; k < 3; ++k)
      if(a.name == names[k])
        for(std::size_t i = 0; i < m_weights.size(); ++i) {
          double& x = std::get<1>(a.values).kept()[i] = 0;
          for(std::size_t c = 0; c < m_weights[i].size; ++c)
            x += m_weights[i].weight[c] * m_input.mesh.point(m_weights[i].vertex[c])[k];
        }
}

void Joined_components::add_input_data()
{
  if(m_input.data.empty())
    return;
  const auto weights = [&](std::size_t i) { return m_input.weights(m_weights[i]); };
  const auto triangle = [&](std::size_t i, std::size_t) {
    return m_input.triangle(Mesh::Face_index(static_cast<Mesh::size_type>(m_face[i])));
  };
  add_data(m_result,
           carried(m_input.data, {m_result.points.size(), m_result.polygons, weights, triangle}));
}

Output_mesh Joined_components::finish()
{
  if(m_result.texture.dimension == 0)
    m_result.texture = Corner_data();
  set_input_places();
  add_input_data();
  return std::move(m_result);
}
