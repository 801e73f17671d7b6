// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_COMMON_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_COMMON_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/coordinates_over.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Returns whether vertices can be inserted in this geometry.
template <typename Traits>
constexpr bool can_have_inserted_vertices()
{
  return Has_distance<Traits>::value && std::is_floating_point_v<typename Traits::FT>;
}

// Inserts vertices into two triangulations over one T1, so that both have the same vertices. A
// vertex inserted into the first one, T2, is also inserted into T2 over itself. So one
// triangulation has the vertices of both over the original T2.
template <typename Traits>
class Common_vertices
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;
  typedef Vertex_inserter<Traits> Inserter;

public:
  Common_vertices(const Triangulation& base, const Triangulation& tri)
    : m_base(unconstrained(base)), m_tri(unconstrained(tri)), m_over(over_itself(base))
  {
    CGAL_precondition(!base.mesh().has_garbage() && !tri.mesh().has_garbage());
    for(Vertex_index v : base.input_mesh().vertices())
      m_vertex.push_back(v);
    const Vertices missing_in_tri = missing(m_base, m_tri, true);
    const Vertices missing_in_base = missing(m_tri, m_base, false);
    insert_all(missing_in_tri, m_base, m_tri, nullptr);
    insert_all(missing_in_base, m_tri, m_base, &m_over);
    if(!has_same_faces(m_base.mesh(), m_over.mesh()))
      throw Numerical_error("by rounding, vertices cannot be inserted into both triangulations");
  }

  Triangulation& base() { return m_base; }
  const Triangulation& base() const { return m_base; }
  Triangulation& tri() { return m_tri; }
  const Triangulation& tri() const { return m_tri; }
  // Returns T2 with the vertices that only T3 has, over T2.
  Triangulation& over() { return m_over; }

  // Returns the vertex of base() that is the vertex `v` of tri().
  Vertex_index vertex(Vertex_index v) const { return m_vertex[v]; }

private:
  typedef std::tuple<std::size_t, std::size_t, FT, FT, FT> Key;
  typedef std::vector<Vertex_index> Vertices;

  static Triangulation unconstrained(Triangulation tri)
  {
    for(Edge_index e : tri.mesh().edges())
      tri.set_constrained(e, false);
    return tri;
  }

  static Triangulation over_itself(const Triangulation& tri)
  {
    return Triangulation(without_maps(tri.mesh()),
                         parameters::edge_length_map(tri.length_map()).geom_traits(tri.traits()));
  }

  // Returns a key that is equal for equal points, whichever side of an edge they have been inserted
  // from.
  static Key key(Vertex_index v, const Triangulation& tri)
  {
    const Surface_point<FT>& m = tri.inserted_vertex(v);
    if(on_edge(m)) {
      const Edge_index e(halfedge_of(m));
      return {1, e.idx(), tri.place_along(first_halfedge(e), v), FT(0), FT(0)};
    }
    const auto& [f, b] = std::get<Face_location<FT>>(m);
    return {0, f.idx(), b[0], b[1], b[2]};
  }

  static bool are_in_one_element(const Key& p, const Key& q)
  {
    return std::get<0>(p) == std::get<0>(q) && std::get<1>(p) == std::get<1>(q);
  }

  typedef std::vector<std::pair<Key, Vertex_index>> Keys;

  static Keys keys_of_inserted(const Triangulation& tri)
  {
    Keys result;
    for(Vertex_index v : tri.mesh().vertices())
      if(tri.is_inserted(v))
        result.emplace_back(key(v, tri), v);
    std::sort(result.begin(), result.end());
    return result;
  }

  // Returns the vertex at `p` up to rounding, or null if none is near.
  static Vertex_index vertex_at(const Key& p, const Keys& keys)
  {
    const FT tolerance = region_tolerance<FT>();
    const auto is_near = [&](const FT& x, const FT& y) { return CGAL::abs(x - y) <= tolerance; };
    const auto& [kind, element, x, y, z] = p;
    const std::pair least(Key(kind, element, x - tolerance, FT(-1), FT(-1)), Vertex_index(0));
    for(auto q = std::lower_bound(keys.begin(), keys.end(), least);
        q != keys.end() && are_in_one_element(p, q->first) &&
        is_near(std::get<2>(q->first), std::get<2>(p));
        ++q)
      if(is_near(std::get<3>(q->first), std::get<3>(p)) &&
         is_near(std::get<4>(q->first), std::get<4>(p)))
        return q->second;
    return Vertex_index();
  }

  // Returns the vertices that have been inserted into `from` and not into `to`. Records the
  // vertices of both.
  Vertices missing(const Triangulation& from, const Triangulation& to, bool from_base)
  {
    const Keys there = keys_of_inserted(to);
    Vertices result;
    for(const auto& [p, v] : keys_of_inserted(from))
      if(const Vertex_index w = vertex_at(p, there); w.is_valid())
        note(v, w, !from_base);
      else
        result.push_back(v);
    return result;
  }

  // Inserts at most one vertex per face in every round, because all keys are computed at once.
  void insert_all(Vertices vertices, const Triangulation& from, Triangulation& to,
                  Triangulation* follower)
  {
    while(!vertices.empty()) {
      std::vector<std::pair<Vertex_index, Face_location<FT>>> located;
      const Correspondence<Traits> correspondence(to);
      for(Vertex_index v : vertices)
        located.emplace_back(
          v, point_across(correspondence, Side::input,
                          face_location(from.inserted_vertex(v), from.input_mesh())));
      vertices = insert_round(located, from, to, follower);
    }
  }

  template <typename Located>
  Vertices insert_round(const Located& located, const Triangulation& from, Triangulation& to,
                        Triangulation* follower)
  {
    Vertices rest;
    std::vector<bool> is_touched(to.mesh().num_faces(), false);
    Inserter inserter(to);
    std::optional<Inserter> following;
    if(follower != nullptr)
      following.emplace(*follower);
    for(const auto& [v, p] : located) {
      const auto faces = faces_around(p, to.mesh());
      if(std::any_of(faces.begin(), faces.end(),
                     [&](Face_index f) { return f.idx() >= is_touched.size() || is_touched[f]; })) {
        rest.push_back(v);
        continue;
      }
      for(Face_index f : faces)
        is_touched[f] = true;
      if(following)
        following->insert(p);
      note(v, insert(v, p, from, inserter), follower != nullptr);
    }
    return rest;
  }

  static std::vector<Face_index> faces_around(const Face_location<FT>& p, const Delta_complex& mesh)
  {
    std::vector<Face_index> result;
    for_each_location(surface_point(p, mesh), mesh,
                      [&](const Face_location<FT>& q) { result.push_back(q.first); });
    return result;
  }

  static Vertex_index insert(Vertex_index v, const Face_location<FT>& p, const Triangulation& from,
                             Inserter& inserter)
  {
    const Triangulation& to = inserter.triangulation();
    const auto before = to.mesh().number_of_vertices();
    const bool is_on_edge = on_edge(from.inserted_vertex(v)) != nullptr;
    FT closeness(0);
    for(Halfedge_index h : sides(p.first, to.mesh()))
      closeness = (std::max)(closeness, FT(is_on_edge ? inserted_edge_tolerance() : 0) *
                                          to.length(Edge_index(h)));
    const Vertex_index result = inserter.insert(p, closeness);
    if(to.mesh().number_of_vertices() == before ||
       !are_in_one_element(key(result, to), key(v, from)))
      throw Numerical_error("rounding has moved inserted vertex " + std::to_string(v.idx()) +
                            " to another element of the other triangulation");
    return result;
  }

  void note(Vertex_index v, Vertex_index inserted, bool into_base)
  {
    const Vertex_index in_base = into_base ? inserted : v, in_tri = into_base ? v : inserted;
    if(m_vertex.size() <= in_tri.idx())
      m_vertex.resize(in_tri.idx() + 1);
    m_vertex[in_tri] = in_base;
  }

  Triangulation m_base, m_tri, m_over;
  std::vector<Vertex_index> m_vertex;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPPING_COMMON_VERTICES_H
