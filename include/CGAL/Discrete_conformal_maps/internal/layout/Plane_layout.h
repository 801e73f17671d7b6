// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Cone_tree.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Half_plane_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Least_squares_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Computes the positions of the vertices of a sphere in the plane, with one vertex at infinity.
// `length` contains the lengths of edges in the plane. The surface without the vertex at infinity
// is flat (Section 4.4.5). If the surface is a doubled disk, its axis is the real line, and the
// disk lies above this line.
template <typename FT>
class Plane_layout
{
  typedef Plane_vector<FT> Vector;

public:
  typedef std::array<FT, 2> Point;

  Plane_layout(const Delta_complex& mesh, const std::vector<FT>& length, Vertex_index at_infinity,
               const Doubled_problem& problem)
    : m_mesh(mesh),
      m_length(length),
      m_at_infinity(at_infinity),
      m_problem(problem),
      m_position(mesh.num_vertices())
  {
    const std::vector<char> is_used = faces_in_plane();
    if(std::count(is_used.begin(), is_used.end(), 1) > 0)
      lay_out_faces(is_used);
    else
      lay_out_edges();
  }

  // Returns the positions. The position of the vertex at infinity is unspecified.
  std::vector<Point> positions() const
  {
    std::vector<Point> result;
    for(const std::optional<Vector>& p : m_position)
      result.push_back(p ? Point{p->x, p->y} : Point{FT(0), FT(0)});
    return result;
  }

private:
  // The weights of sides for the distribution of errors are squares in `double`. If the sizes of
  // faces exceed the range of `double`, positions do not change, because they have enough digits.
  static constexpr bool distributes_errors = !std::is_same<FT, Decimal_1500>::value;

  // Returns the finite faces that can be reached from an interior vertex of the surface itself.
  // The result lacks copies of faces that only further copies lead to.
  std::vector<char> faces_in_plane() const
  {
    std::vector<char> is_finite(m_mesh.num_faces(), 1), is_reached(is_finite.size(), 0);
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_mesh.target(h) == m_at_infinity && !m_mesh.is_border(h))
        is_finite[m_mesh.face(h).idx()] = 0;
    std::vector<Face_index> waiting;
    const auto reach = [&](Face_index f) {
      if(is_finite[f.idx()] && !std::exchange(is_reached[f.idx()], 1))
        waiting.push_back(f);
    };
    for(Halfedge_index h : m_mesh.halfedges())
      if(m_problem.is_inside(m_mesh.target(h)))
        reach(m_mesh.face(h));
    if(waiting.empty())
      return is_finite;
    while(!waiting.empty()) {
      const Face_index f = waiting.back();
      waiting.pop_back();
      for(Halfedge_index h : sides(f, m_mesh))
        if(const Halfedge_index o = m_mesh.opposite(h); !m_mesh.is_border(o))
          reach(m_mesh.face(o));
    }
    return is_reached;
  }

  void lay_out_faces(const std::vector<char>& is_used)
  {
    std::vector<char> is_cut_edge(m_mesh.num_edges()), is_terminal(m_mesh.num_vertices(), 0);
    std::vector<double> rounded(m_mesh.num_edges());
    for(Edge_index e : m_mesh.edges()) {
      rounded[e.idx()] = static_cast<double>(m_length[e.idx()]);
      for(const Halfedge_index h : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
        is_cut_edge[e.idx()] |= m_mesh.is_border(h) || !is_used[m_mesh.face(h).idx()];
      if(is_cut_edge[e.idx()])
        is_terminal[m_mesh.vertex(e, 0).idx()] = is_terminal[m_mesh.vertex(e, 1).idx()] = 1;
    }
    const Cut_graph cut =
      cut_to_pieces(m_mesh, rounded, crossing_order(m_length), is_cut_edge, is_used, is_terminal);
    Unfolded_faces<FT> faces(m_mesh, m_length, cut);
    if(m_problem.has_no_copies() && distributes_errors)
      Least_squares_layout()(faces, *m_problem.order());
    for(Halfedge_index h : m_mesh.halfedges())
      if(!m_mesh.is_border(h) && is_used[m_mesh.face(h).idx()])
        m_position[m_mesh.source(h).idx()] = faces.position(h);
    if(!m_problem.has_no_copies()) {
      Half_plane_layout<FT> symmetric(m_mesh, m_problem, m_position);
      if(distributes_errors)
        symmetric.distribute_errors(faces);
      store_layout(symmetric);
    }
  }

  void store_layout(const Half_plane_layout<FT>& layout)
  {
    for(Vertex_index v : m_mesh.vertices())
      m_position[v.idx()] = layout.position(v);
  }

  // Lays out a surface without finite faces. It is a path of edges on a line.
  void lay_out_edges()
  {
    FT x(0);
    Halfedge_index h = first_edge_of_path();
    while(h.is_valid()) {
      m_position[m_mesh.source(h).idx()] = Vector{x, FT(0)};
      x += m_length[Edge_index(h).idx()];
      m_position[m_mesh.target(h).idx()] = Vector{x, FT(0)};
      h = after_on_path(h);
    }
    if(!m_problem.has_no_copies())
      store_layout(Half_plane_layout<FT>(m_mesh, m_problem, m_position));
  }

  Halfedge_index first_edge_of_path() const
  {
    for(Halfedge_index h : m_mesh.halfedges())
      if(is_on_path(h) && !after_on_path(m_mesh.opposite(h)).is_valid())
        return h;
    return Halfedge_index();
  }

  bool is_on_path(Halfedge_index h) const
  {
    return m_mesh.source(h) != m_at_infinity && m_mesh.target(h) != m_at_infinity;
  }

  // Returns the next halfedge of the path, or null at its end.
  Halfedge_index after_on_path(Halfedge_index h) const
  {
    Halfedge_index result;
    for_each_outgoing_halfedge(m_mesh.target(h), m_mesh, [&](Halfedge_index x) {
      if(is_on_path(x) && x != m_mesh.opposite(h))
        result = x;
    });
    return result;
  }

  const Delta_complex& m_mesh;
  const std::vector<FT>& m_length;
  Vertex_index m_at_infinity;
  const Doubled_problem& m_problem;
  std::vector<std::optional<Vector>> m_position;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_PLANE_LAYOUT_H
