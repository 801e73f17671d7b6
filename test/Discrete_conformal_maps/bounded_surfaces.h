// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_BOUNDED_SURFACES_H
#define DISCRETE_CONFORMAL_MAPS_TEST_BOUNDED_SURFACES_H

#include "flat_maps.h"

// This file generates surfaces with boundary of any genus, and their doubles, glued without the
// library.
namespace Test_surfaces {

inline int side_of(Halfedge_index h)
{
  const int e = static_cast<int>(h.idx() / 2) + 1;
  return h.idx() % 2 == 0 ? e : -e;
}

// Returns the same faces with the labels 1, 2, ...
inline Sides renumbered(Sides faces)
{
  std::map<int, int> label;
  for(auto& face : faces)
    for(int& side : face) {
      const auto entry = label.emplace(std::abs(side), static_cast<int>(label.size()) + 1).first;
      side = side > 0 ? entry->second : -entry->second;
    }
  return faces;
}

// Returns some faces of a mesh without common vertices, in random order.
inline std::vector<Mesh::Face_index> separate_faces(const Mesh& mesh, CGAL::Random& random)
{
  std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end()), result;
  for(std::size_t i = faces.size(); i > 1; --i)
    std::swap(faces[i - 1], faces[std::size_t(random.get_int(0, int(i)))]);
  std::vector<char> is_used(mesh.number_of_vertices(), 0);
  for(const auto f : faces) {
    bool is_free = true;
    for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      is_free = is_free && !is_used[v];
    if(is_free)
      result.push_back(f);
    if(is_free)
      for(const auto v : mesh.vertices_around_face(mesh.halfedge(f)))
        is_used[v] = 1;
  }
  return result;
}

// Returns a sphere of two poles and rings of vertices between them.
inline Mesh sphere_of_rings(std::size_t rings, std::size_t n)
{
  std::vector<Point> points{Point(0, 0, 1), Point(0, 0, -1)};
  Triangles triangles;
  const auto at = [&](std::size_t ring, std::size_t i) { return 2 + ring * n + i % n; };
  for(std::size_t ring = 0; ring < rings; ++ring)
    for(std::size_t i = 0; i < n; ++i) {
      const double polar = pi * double(ring + 1) / double(rings + 1), turn = 2 * pi / double(n);
      points.emplace_back(std::sin(polar) * std::cos(turn * double(i)),
                          std::sin(polar) * std::sin(turn * double(i)), std::cos(polar));
      if(ring > 0) {
        triangles.push_back({at(ring - 1, i), at(ring, i), at(ring, i + 1)});
        triangles.push_back({at(ring - 1, i), at(ring, i + 1), at(ring - 1, i + 1)});
      }
    }
  for(std::size_t i = 0; i < n; ++i) {
    triangles.push_back({0, at(0, i), at(0, i + 1)});
    triangles.push_back({1, at(rings - 1, i + 1), at(rings - 1, i)});
  }
  return make_mesh(points, triangles);
}

// Returns a sphere with handles and triangular holes. Pairs of its faces are removed and their
// sides glued to each other; others are only removed.
inline Sides surface_with_holes(std::size_t genus, std::size_t holes, unsigned int seed)
{
  CGAL::Random random(seed);
  const Mesh mesh = sphere_of_rings(6 + 2 * genus + holes, 16);
  const std::vector<Mesh::Face_index> removed = separate_faces(mesh, random);
  std::vector<char> is_removed(mesh.number_of_faces(), 0);
  std::map<int, int> glued;
  for(std::size_t i = 0; i < 2 * genus + holes; ++i)
    is_removed[removed.at(i)] = 1;
  for(std::size_t i = 0; i < genus; ++i) {
    const auto h = mesh.halfedge(removed[2 * i]), k = mesh.halfedge(removed[2 * i + 1]);
    glued[-side_of(k)] = side_of(h);
    glued[-side_of(mesh.next(k))] = side_of(mesh.prev(h));
    glued[-side_of(mesh.prev(k))] = side_of(mesh.next(h));
  }
  Sides result;
  for(const auto f : mesh.faces()) {
    if(is_removed[f])
      continue;
    const auto h = mesh.halfedge(f);
    result.push_back({side_of(h), side_of(mesh.next(h)), side_of(mesh.prev(h))});
    for(int& side : result.back())
      if(const auto other = glued.find(side); other != glued.end())
        side = other->second;
  }
  return renumbered(result);
}

// Returns a plate with a long boundary, and with square holes of eight sides.
inline Sides plate_with_square_holes(std::size_t holes)
{
  const std::size_t m = 4 * holes + 3, n = 9;
  const Mesh mesh = grid(m, n, [](double x, double y) { return Point(x, y, 0); });
  const auto is_hole = [&](Mesh::Vertex_index v) {
    const Point& p = mesh.point(v);
    return p.y() == 4 && std::fmod(p.x(), 4) == 3 && p.x() < double(4 * holes);
  };
  Sides result;
  for(const auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto corners = mesh.vertices_around_face(h);
    if(std::none_of(corners.begin(), corners.end(), is_hole))
      result.push_back({side_of(h), side_of(mesh.next(h)), side_of(mesh.prev(h))});
  }
  return renumbered(result);
}

// Stores a surface with boundary and its double. Edges of the surface keep their numbers.
struct Bounded_surface
{
  explicit Bounded_surface(const Sides& faces, unsigned int seed)
    : half(glue(faces)), half_length(random_lengths(half, seed)), whole(glue(doubled(faces)))
  {
    for(std::size_t e = 0; e < whole.number_of_edges(); ++e)
      whole_length.push_back(half_length[original[e]]);
    whole_vertex.resize(half.number_of_vertices());
    front.resize(whole.number_of_vertices());
    for(const auto& face : faces)
      for(const int side : face) {
        const Halfedge_index h = halfedge_of(side), m = halfedge_of(-mirrored(side));
        whole_vertex[half.target(h)] = whole.target(h);
        front[whole.target(h)] = front[whole.source(m)] = half.target(h);
      }
  }

  bool is_on_boundary(Vertex_index v) const { return half.is_border(v); }

  // Returns the conditions prescribed on the double.
  Conditions doubled(const Conditions& condition) const
  {
    Conditions result;
    for(Vertex_index v : whole.vertices()) {
      Vertex_condition c = condition[front[v]];
      if(c.quantity == Vertex_condition::Quantity::curvature && is_on_boundary(front[v]))
        c.value *= 2;
      result.push_back(c);
    }
    return result;
  }

  Delta_complex half;
  std::vector<double> half_length;
  std::vector<std::size_t> original; // for each edge of the double
  std::map<int, int> copy;           // labels of edges inside
  Delta_complex whole;
  std::vector<double> whole_length;
  std::vector<Vertex_index> whole_vertex, front;

private:
  int mirrored(int side) const
  {
    const auto entry = copy.find(std::abs(side));
    const int label = entry == copy.end() ? std::abs(side) : entry->second;
    return side > 0 ? label : -label;
  }

  Sides doubled(const Sides& faces)
  {
    std::map<int, int> uses;
    for(const auto& face : faces)
      for(int side : face)
        ++uses[std::abs(side)];
    for(std::size_t e = 0; e < uses.size(); ++e)
      original.push_back(e);
    for(const auto& [label, count] : uses)
      if(count == 2) {
        original.push_back(static_cast<std::size_t>(label - 1));
        copy[label] = static_cast<int>(original.size());
      }
    Sides result = faces;
    for(const auto& face : faces)
      result.push_back({-mirrored(face[2]), -mirrored(face[1]), -mirrored(face[0])});
    return result;
  }
};

// Returns scale factors and exterior angles on the boundary, and some of both inside. Other
// vertices are flat.
inline Conditions mixed_conditions(const Bounded_surface& s, double bound, unsigned int seed)
{
  CGAL::Random random(seed);
  Conditions result(s.half.number_of_vertices());
  for(Vertex_index v : s.half.vertices()) {
    const double choice = random.get_double(0, 1);
    if(choice < (s.is_on_boundary(v) ? 0.5 : 0.04) || v.idx() < 5)
      result[v] = Vertex_condition::log_scale(random.get_double(-bound, bound));
    else if(s.is_on_boundary(v) || choice > 0.95)
      result[v] = Vertex_condition::curvature(random.get_double(-1, 1));
  }
  return result;
}

// Returns exterior angles on the boundary and curvatures of some cones, with the sum required by
// Gauss and Bonnet.
inline Conditions balanced_curvatures(const Bounded_surface& s, unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<double> curvature(s.half.number_of_vertices(), 0);
  double rest = 2 * pi *
                (double(s.half.number_of_vertices()) - double(s.half.number_of_edges()) +
                 double(s.half.number_of_faces()));
  std::size_t boundary = 0;
  for(Vertex_index v : s.half.vertices()) {
    boundary += s.is_on_boundary(v);
    if(s.is_on_boundary(v) || random.get_double(0, 1) < 0.05)
      rest -= curvature[v] = random.get_double(-0.5, 0.5);
  }
  for(Vertex_index v : s.half.vertices())
    if(s.is_on_boundary(v))
      curvature[v] += rest / double(boundary);
  return as_curvatures(curvature);
}

} // namespace Test_surfaces

#endif // DISCRETE_CONFORMAL_MAPS_TEST_BOUNDED_SURFACES_H
