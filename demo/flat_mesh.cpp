// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "flat_mesh.h"

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

using CM::Edge_index;
using CM::Face_index;
using CM::Halfedge_index;
using CM::Layer;
using CM::Vertex_index;

std::complex<double> position(const CM::Planar_conformal_map&, const std::array<double, 3>& z)
{
  return {z[0] / z[2], z[1] / z[2]};
}

std::complex<double> position(const CM::Hyperbolic_conformal_map& map,
                              const std::array<double, 3>& z)
{
  return map.to_disk(z);
}

template <class Map>
class Flat_mesh_builder
{
public:
  Flat_mesh_builder(const Map& map, const Mesh& input, bool is_homogeneous)
    : m_map(map),
      m_subdivision(map.subdivision()),
      m_mesh(m_subdivision.mesh()),
      m_input(input),
      m_number(m_mesh.number_of_vertices(), none),
      m_corner(m_mesh.number_of_halfedges(), none)
  {
    m_result.texture.dimension = is_homogeneous ? 3 : 2;
    choose_elements();
  }

  Output_mesh build(const std::vector<Mesh::Vertex_index>& cones)
  {
    for(const Vertex_index v : m_vertices)
      m_result.points.push_back(point(v));
    for(const Face_index f : m_faces)
      add_polygon(f);
    for(const Edge_index e : m_edges)
      m_result.edges.push_back(
        {m_number[m_mesh.vertex(e, 0).idx()], m_number[m_mesh.vertex(e, 1).idx()]});
    add_point_data(cones);
    add_edge_data();
    for(const auto& [name, layer] :
        {std::pair("input_face", Layer::A), {"intrinsic_face", Layer::B}, {"flat_face", Layer::C}})
      m_result.polygon_data.push_back(attribute(name, m_faces, [&, layer = layer](Face_index f) {
        return number_of(m_subdivision.parent_face(layer, f));
      }));
    return std::move(m_result);
  }

  Eigen::SparseMatrix<double> interpolation_matrix() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for(std::size_t row = 0; row < m_vertices.size(); ++row) {
      const auto add = [&](Mesh::Vertex_index v, double weight) {
        if(weight != 0)
          entries.emplace_back(int(row), int(v.idx()), weight);
      };
      if(is_of_input(m_vertices[row]))
        add(Mesh::Vertex_index(m_vertices[row].idx()), 1);
      else
        for_each_corner(m_vertices[row], add);
    }
    Eigen::SparseMatrix<double> result(Eigen::Index(m_vertices.size()),
                                       Eigen::Index(m_input.number_of_vertices()));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // ---- The part that belongs to the input ----

  bool is_front(Halfedge_index h) const
  {
    return m_map.is_front(m_subdivision.parent_face(Layer::A, m_mesh.face(h)));
  }

  void choose_elements()
  {
    std::vector<char> is_used(m_mesh.number_of_vertices(), 0);
    for(const Halfedge_index h : m_mesh.halfedges())
      is_used[m_mesh.target(h).idx()] |= is_front(h);
    for(const Vertex_index v : m_mesh.vertices())
      if(is_used[v.idx()] || is_of_input(v)) {
        m_number[v.idx()] = m_vertices.size();
        m_vertices.push_back(v);
      }
    for(const Edge_index e : m_mesh.edges())
      if(is_front(m_mesh.halfedge(e)) || is_front(m_mesh.opposite(m_mesh.halfedge(e))))
        m_edges.push_back(e);
    for(const Face_index f : m_mesh.faces())
      if(is_front(m_mesh.halfedge(f)))
        m_faces.push_back(f);
  }

  // The second copy of a vertex has a greater number.
  bool is_of_input(Vertex_index v) const { return v.idx() < m_input.number_of_vertices(); }

  // ---- Points ----

  // Calls `function` with the vertices of the face of the input in which `v` is, and their weights.
  template <class Function>
  void for_each_corner(Vertex_index v, const Function& function) const
  {
    const auto& [face, weight] = m_subdivision.place_on_A(v);
    const auto& a = m_map.Delaunay().input_mesh();
    Halfedge_index h = a.halfedge(face);
    for(const double w : weight) {
      const Vertex_index corner = m_map.input_vertex(a.source(h));
      function(Mesh::Vertex_index(corner.idx()), w);
      h = a.next(h);
    }
  }

  Point point(Vertex_index v) const
  {
    if(is_of_input(v))
      return m_input.point(Mesh::Vertex_index(v.idx()));
    Kernel::Vector_3 result = CGAL::NULL_VECTOR;
    for_each_corner(
      v, [&](Mesh::Vertex_index x, double w) { result += w * (m_input.point(x) - CGAL::ORIGIN); });
    return CGAL::ORIGIN + result;
  }

  double log_scale(Vertex_index v) const
  {
    if(is_of_input(v))
      return m_map.log_scale(v);
    double result = 0;
    for_each_corner(v, [&](Mesh::Vertex_index x, double w) {
      result += w * m_map.log_scale(Vertex_index(x.idx()));
    });
    return result;
  }

  void add_point_data(const std::vector<Mesh::Vertex_index>& cones)
  {
    std::vector<char> is_cone(m_mesh.number_of_vertices(), 0);
    for(const Mesh::Vertex_index v : cones)
      is_cone[v] = 1;
    const auto number = [&](Vertex_index v) { return is_of_input(v) ? number_of(v) : -1; };
    m_result.point_data = {
      attribute("input_vertex", m_vertices, number),
      attribute("is_cone", m_vertices,
                [&](Vertex_index v) { return std::int64_t(is_cone[v.idx()]); }),
      attribute("log_scale", m_vertices, [&](Vertex_index v) { return log_scale(v); })};
  }

  // ---- Polygons ----

  void add_polygon(Face_index f)
  {
    m_result.polygons.emplace_back();
    m_result.texture.polygons.emplace_back();
    for(const Halfedge_index h : CGAL::halfedges_around_face(m_mesh.halfedge(f), m_mesh)) {
      m_result.polygons.back().push_back(m_number[m_mesh.target(h).idx()]);
      if(m_corner[h.idx()] == none)
        add_coordinates(h);
      m_result.texture.polygons.back().push_back(m_corner[h.idx()]);
    }
  }

  // Of the corner at the target of `h` and those beside it, up to seams: rounding has made them a little
  // different.
  void add_coordinates(Halfedge_index h)
  {
    Halfedge_index first = h;
    while(!is_open(first) && m_mesh.prev(m_mesh.opposite(first)) != h)
      first = m_mesh.prev(m_mesh.opposite(first));
    for(Halfedge_index x = first; m_corner[x.idx()] == none; x = m_mesh.opposite(m_mesh.next(x))) {
      m_corner[x.idx()] = m_result.texture.coordinates.size();
      if(is_open(m_mesh.next(x)))
        break;
    }
    m_result.texture.coordinates.push_back(coordinates(m_subdivision.place_on_C(first)));
  }

  // whether the faces of `h` are not beside each other in the plane
  bool is_open(Halfedge_index h) const
  {
    const Edge_index e = m_mesh.edge(h);
    return is_seam(e) || !is_front(h) || !is_front(m_mesh.opposite(h));
  }

  std::array<double, 3> coordinates(const CM::Discrete_conformal_map::Face_location& on_C) const
  {
    const std::array<double, 3> z = m_map.homogeneous_coordinates(on_C);
    if(m_result.texture.dimension == 3)
      return z;
    const std::complex<double> p = position(m_map, z);
    return {p.real(), p.imag(), 1};
  }

  // ---- Edges ----

  bool is_seam(Edge_index e) const
  {
    const Edge_index c = m_subdivision.parent_edge(Layer::C, e);
    const Halfedge_index h = m_mesh.halfedge(e);
    return c.is_valid() && m_map.is_seam(c) && is_front(h) && is_front(m_mesh.opposite(h));
  }

  void add_edge_data()
  {
    for(const auto& [name, layer] :
        {std::pair("input_edge", Layer::A), {"intrinsic_edge", Layer::B}, {"flat_edge", Layer::C}})
      m_result.edge_data.push_back(attribute(name, m_edges, [&, layer = layer](Edge_index e) {
        return number_of(m_subdivision.parent_edge(layer, e));
      }));
    m_result.edge_data.push_back(
      attribute("is_seam", m_edges, [&](Edge_index e) { return std::int64_t(is_seam(e)); }));
  }

  const Map& m_map;
  const CM::Discrete_conformal_map::Subdivision& m_subdivision;
  const CM::Discrete_conformal_map::Subdivision::Mesh& m_mesh;
  const Mesh& m_input;
  std::vector<std::size_t> m_number; // in the result, of each vertex
  std::vector<std::size_t> m_corner; // coordinates at the target of each halfedge
  std::vector<Vertex_index> m_vertices;
  std::vector<Edge_index> m_edges;
  std::vector<Face_index> m_faces;
  Output_mesh m_result;
};

// Whether the height of the triangle is more than rounding of the coordinates of its points.
bool has_area(const Point& p, const Point& q, const Point& r)
{
  const double longest = std::sqrt((std::max)(
    {CGAL::squared_distance(p, q), CGAL::squared_distance(q, r), CGAL::squared_distance(r, p)}));
  double greatest = 0;
  for(const Point& x : {p, q, r})
    for(int i = 0; i < 3; ++i)
      greatest = (std::max)(greatest, std::abs(x[i]));
  // each of three points may be wrong by some roundings
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * greatest;
  return 2 * std::sqrt(CGAL::squared_area(p, q, r)) > rounding * longest;
}

} // namespace

Output_mesh flat_mesh(const CM::Planar_conformal_map& map, const Mesh& input,
                      const std::vector<Mesh::Vertex_index>& cones, bool is_homogeneous)
{
  return Flat_mesh_builder(map, input, is_homogeneous).build(cones);
}

Output_mesh flat_mesh(const CM::Hyperbolic_conformal_map& map, const Mesh& input,
                      const std::vector<Mesh::Vertex_index>& cones, bool is_homogeneous)
{
  return Flat_mesh_builder(map, input, is_homogeneous).build(cones);
}

Eigen::SparseMatrix<double> interpolation_matrix(const CM::Planar_conformal_map& map,
                                                 const Mesh& input)
{
  return Flat_mesh_builder(map, input, false).interpolation_matrix();
}

void describe_triangles(Statistics& statistics, const Output_mesh& mesh)
{
  std::size_t flipped = 0, degenerate = 0;
  const auto place = [&](std::size_t c) {
    const std::array<double, 3>& z = mesh.texture.coordinates[c];
    return Kernel::Point_2(z[0] / z[2], z[1] / z[2]);
  };
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    const auto &p = mesh.polygons[i], &t = mesh.texture.polygons[i];
    for(std::size_t k = 2; k < p.size(); ++k) {
      if(!has_area(mesh.points[p[0]], mesh.points[p[k - 1]], mesh.points[p[k]]))
        continue;
      const CGAL::Orientation turn = CGAL::orientation(place(t[0]), place(t[k - 1]), place(t[k]));
      flipped += turn == CGAL::RIGHT_TURN;
      degenerate += turn == CGAL::COLLINEAR;
    }
  }
  statistics["flipped_triangles"] = flipped;
  statistics["degenerate_triangles"] = degenerate;
}

void describe_scales(Statistics& statistics, const CM::Discrete_conformal_map& map,
                     const Mesh& input)
{
  std::vector<double> u;
  for(const Mesh::Vertex_index v : input.vertices())
    if(!input.is_isolated(v))
      u.push_back(map.log_scale(Vertex_index(v.idx())));
  double sum = 0, square_sum = 0;
  for(const double x : u)
    sum += x;
  for(const double x : u)
    square_sum += (x - sum / double(u.size())) * (x - sum / double(u.size()));
  statistics["log_scale_min"] = *std::min_element(u.begin(), u.end());
  statistics["log_scale_max"] = *std::max_element(u.begin(), u.end());
  statistics["log_scale_square_sum"] = square_sum;
  statistics["flips"] = map.number_of_flips(Layer::B);
  statistics["ptolemy_flips"] = map.number_of_flips(Layer::C);
}
