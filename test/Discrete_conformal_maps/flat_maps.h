// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DISCRETE_CONFORMAL_MAPS_TEST_FLAT_MAPS_H
#define DISCRETE_CONFORMAL_MAPS_TEST_FLAT_MAPS_H

#include "../Intrinsic_triangulations/known_surfaces.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Intrinsic_triangulations/Mesh_components.h>

// This file generates surfaces to flatten, and checks flat surfaces.
namespace Test_surfaces {

namespace DCM = CGAL::Discrete_conformal_maps;
using DCM::Layer;
using DCM::Planar_conformal_map;
using DCM::Vertex_condition;
using Conditions = std::vector<Vertex_condition>;

// ---- Surfaces ----

inline std::vector<double> lengths_of(const Triangulation& t)
{
  std::vector<double> result;
  for(Edge_index e : t.mesh().edges())
    result.push_back(t.length(e));
  return result;
}

// Returns curvatures of vertices inside, and exterior angles of vertices on the boundary.
inline std::vector<double> curvatures(const Triangulation& t)
{
  const Delta_complex& mesh = t.mesh();
  std::vector<double> result = angle_sums(mesh, t.length_map());
  for(Vertex_index v : mesh.vertices())
    result[v] = (mesh.is_isolated(v) ? 0 : mesh.is_border(v) ? pi : 2 * pi) - result[v];
  return result;
}

inline Conditions as_curvatures(const std::vector<double>& values)
{
  Conditions result;
  for(double x : values)
    result.push_back(Vertex_condition::curvature(x));
  return result;
}

inline Conditions as_log_scales(const std::vector<double>& values)
{
  Conditions result;
  for(double x : values)
    result.push_back(Vertex_condition::log_scale(x));
  return result;
}

// Returns conditions that are flat inside, and unscaled on the boundary.
inline Conditions default_conditions(const Delta_complex& mesh)
{
  Conditions result(mesh.number_of_vertices());
  for(Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v) && mesh.is_border(v))
      result[v] = Vertex_condition::log_scale(0);
  return result;
}

// ---- Flattening ----

inline auto as_map(const Conditions& condition)
{
  return boost::make_function_property_map<Vertex_index>(
    [&](Vertex_index v) { return condition[v]; });
}

inline auto length_parameter(const std::vector<double>& length)
{
  return DCM::parameters::edge_length_map(
    boost::make_function_property_map<Edge_index>([&](Edge_index e) { return length[e]; }));
}

inline Planar_conformal_map flatten(const Delta_complex& mesh, const std::vector<double>& length)
{
  return DCM::flatten(mesh, length_parameter(length));
}

inline Planar_conformal_map flatten(const Delta_complex& mesh, const std::vector<double>& length,
                                    const Conditions& condition)
{
  return DCM::flatten(mesh, length_parameter(length).vertex_condition_map(as_map(condition)));
}

inline Planar_conformal_map flatten(const Triangulation& t, const Conditions& condition)
{
  return flatten(t.mesh(), lengths_of(t), condition);
}

// ---- The flat surface ----

inline const Delta_complex& mesh_C(const Planar_conformal_map& map)
{
  return map.surface(DCM::Layer::C).mesh();
}
inline const Delta_complex& mesh_A(const DCM::Discrete_conformal_map& map)
{
  return map.surface(DCM::Layer::A).mesh();
}

inline std::vector<double> scaled_lengths(const Planar_conformal_map& map)
{
  std::vector<double> result;
  const Delta_complex& mesh = mesh_C(map);
  for(Edge_index e : mesh.edges())
    result.push_back(
      map.ideal().length(e) *
      std::exp((map.log_scale(mesh.vertex(e, 0)) + map.log_scale(mesh.vertex(e, 1))) / 2));
  return result;
}

// Determines which faces of T_3 have a part of the input. No part is beyond a border.
class Used_faces
{
public:
  explicit Used_faces(const Planar_conformal_map& map)
    : m_is_used(mesh_C(map).number_of_faces(), false)
  {
    const auto& s = map.subdivision();
    for(Face_index f : s.mesh().faces())
      if(map.is_original(s.parent_face(Layer::A, f)))
        m_is_used[s.parent_face(Layer::C, f)] = true;
  }

  bool operator[](Face_index f) const { return f.is_valid() && m_is_used[f]; }

private:
  std::vector<bool> m_is_used;
};

inline Used_faces used_faces(const Planar_conformal_map& map) { return Used_faces(map); }

// Returns the greatest distance from the origin.
inline double size_of(const Planar_conformal_map& map)
{
  double result = 0;
  for(Halfedge_index h : mesh_C(map).halfedges())
    result = (std::max)(result, std::abs(map.position(h)));
  return result;
}

inline double log_scale(const Planar_conformal_map& map, std::size_t v)
{
  return map.log_scale(Vertex_index(static_cast<Delta_complex::size_type>(v)));
}

// Checks that the flat surface has the prescribed conditions on `input`, by the cosine law, and
// twice the exterior angle on the boundary. Copies of vertices inside may not have all of their
// faces.
inline void check_conditions(const Planar_conformal_map& map, const Delta_complex& input,
                             const Conditions& condition, double tolerance)
{
  const Delta_complex& mesh = mesh_C(map);
  const std::vector<double> length = scaled_lengths(map);
  const std::vector<double> angle = angle_sums(mesh, length);
  for(Vertex_index v : mesh.vertices()) {
    const Vertex_index front = map.input_vertex(v);
    const auto& [quantity, value] = condition[front];
    if(quantity == Vertex_condition::Quantity::log_scale) {
      EXPECT_EQ(map.log_scale(v), value) << v;
    } else if(!mesh.is_isolated(v) && (v == front || !mesh.is_border(v))) {
      EXPECT_NEAR(2 * pi - angle[v], (input.is_border(front) ? 2 : 1) * value, tolerance) << v;
    }
  }
}

// Checks that faces in the plane have the prescribed lengths, lie side by side except at seams, and
// are not reversed.
inline void check_layout(const Planar_conformal_map& map, double tolerance = 1e-9)
{
  const Delta_complex& mesh = mesh_C(map);
  const std::vector<double> length = scaled_lengths(map);
  const Used_faces is_used = used_faces(map);
  for(Face_index f : mesh.faces()) {
    if(!is_used[f])
      continue;
    const Halfedge_index h = mesh.halfedge(f), n = mesh.next(h), p = mesh.prev(h);
    for(Halfedge_index x : {h, n, p}) {
      const double side = std::abs(map.position(mesh.next(x)) - map.position(x));
      EXPECT_NEAR(side, length[mesh.edge(x)],
                  tolerance * length[mesh.edge(x)] + 1e-13 * std::abs(map.position(x)))
        << f;
      const Halfedge_index o = mesh.opposite(x);
      if(!map.is_seam(mesh.edge(x)) && is_used[mesh.face(o)]) {
        EXPECT_EQ(map.position(x), map.position(mesh.next(o))) << x;
        EXPECT_EQ(map.position(n == x ? p : x == h ? n : h), map.position(o)) << x;
      }
    }
    EXPECT_GT(
      (std::conj(map.position(n) - map.position(h)) * (map.position(p) - map.position(h))).imag(),
      0)
      << f;
  }
}

inline bool has_no_seam(const Planar_conformal_map& map)
{
  const Delta_complex& mesh = mesh_C(map);
  const Used_faces is_used = used_faces(map);
  for(Edge_index e : mesh.edges()) {
    const Halfedge_index h = mesh.halfedge(e);
    if(map.is_seam(e) && is_used[mesh.face(h)] && is_used[mesh.face(mesh.opposite(h))])
      return false;
  }
  return true;
}

// ---- The map ----

// Returns the position of a vertex of the subdivision in a face of T_1, a simplicial complex.
inline Location on_face(const DCM::Discrete_conformal_map& map, Face_index f, const Location& p)
{
  const Delta_complex& mesh = mesh_A(map);
  std::map<Vertex_index, double> weight;
  std::size_t s = 0;
  for(Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(p.first), mesh))
    weight[mesh.source(h)] = p.second[s++];
  Location result{f, {0, 0, 0}};
  s = 0;
  for(Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
    result.second[s++] = weight[mesh.source(h)];
  return result;
}

inline Location corner(const Delta_complex& mesh, Vertex_index v)
{
  Halfedge_index h = mesh.opposite(mesh.halfedge(v)); // from v
  if(mesh.is_border(h))
    h = mesh.next(mesh.opposite(h));
  Location result{mesh.face(h), {0, 0, 0}};
  std::size_t s = 0;
  for(Halfedge_index x : CGAL::halfedges_around_face(mesh.halfedge(mesh.face(h)), mesh))
    result.second[s++] = x == h ? 1 : 0;
  return result;
}

inline Location random_front_location(const Planar_conformal_map& map, CGAL::Random& random)
{
  for(;;)
    if(const Location p = random_location(mesh_A(map), random); map.is_original(p.first))
      return p;
}

} // namespace Test_surfaces

#endif // DISCRETE_CONFORMAL_MAPS_TEST_FLAT_MAPS_H
