// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_WITH_INSERTED_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_WITH_INSERTED_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Cuts the edges of T1 at inserted vertices, and fills each face of T1 with a triangulation in the
// plane. In this plane the corners of the face have the positions (0, 0), (1, 0) and (0, 1), and
// all computations are exact.
template <typename Traits>
class Input_splitter
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Triangulation::FT FT;
  typedef typename Triangulation::size_type size_type;
  typedef Exact_predicates_exact_constructions_kernel Kernel;
  typedef Triangulation_data_structure_2<Triangulation_vertex_base_with_info_2<std::size_t, Kernel>>
    Data_structure;
  typedef Delaunay_triangulation_2<Kernel, Data_structure> Plane_triangulation;
  typedef Kernel::Point_2 Point;

  // Stores a vertex on an edge of T1, at `t` on its first halfedge.
  struct Mark
  {
    Edge_index edge;
    FT t;
    Vertex_index vertex;
  };

public:
  explicit Input_splitter(const Triangulation& tri) : m_tri(tri), m_input(tri.input_mesh()) {}

  Triangulation split()
  {
    collect_vertices();
    m_mesh.resize(m_tri.mesh().num_vertices(), m_numbers.number_of_pieces(), 0);
    for(Halfedge_index h : m_input.halfedges())
      set_targets(h);
    for(Face_index f : m_input.faces())
      fill(f);
    link_border();
    return with_coordinates();
  }

private:
  void collect_vertices()
  {
    for(Vertex_index v : m_tri.mesh().vertices())
      if(m_tri.is_inserted(v)) {
        const Surface_point<FT>& m = m_tri.inserted_vertex(v);
        if(on_edge(m)) {
          const Edge_index e(halfedge_of(m));
          m_marks.push_back({e, m_tri.place_along(first_halfedge(e), v), v});
        } else
          m_inside.emplace_back(std::get<Face_location<FT>>(m).first, v);
      }
    std::stable_sort(m_inside.begin(), m_inside.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    std::sort(m_marks.begin(), m_marks.end(), [](const Mark& x, const Mark& y) {
      return std::tie(x.edge, x.t) < std::tie(y.edge, y.t);
    });
    std::vector<size_type> count(m_input.num_edges(), 0);
    for(std::size_t i = 0; i < m_marks.size(); ++i) {
      ++count[m_marks[i].edge.idx()];
      if(i > 0 && m_marks[i - 1].edge == m_marks[i].edge && m_marks[i - 1].t == m_marks[i].t)
        fail(m_marks[i].vertex);
    }
    m_numbers = Edge_marks(std::move(count));
  }

  [[noreturn]] static void fail(Vertex_index v)
  {
    throw Numerical_error("rounding has moved inserted vertex " + std::to_string(v.idx()) +
                          " to another vertex or edge");
  }

  // ---- Edges of T1 ----

  size_type number_of_marks(Halfedge_index h) const { return m_numbers.size(Edge_index(h)); }

  // Returns mark `p` on the halfedge `h`, counted from its source.
  const Mark& mark(Halfedge_index h, size_type p) const { return m_marks[m_numbers(h, p)]; }

  Halfedge_index piece(Halfedge_index h, size_type p) const { return m_numbers.piece(h, p); }

  void set_targets(Halfedge_index h)
  {
    const size_type n = number_of_marks(h);
    for(size_type p = 0; p < n; ++p)
      m_mesh.set_target(piece(h, p), mark(h, p).vertex);
    m_mesh.set_target(m_numbers.last_piece(h), m_input.target(h));
  }

  // ---- Faces of T1 ----

  // Stores the pieces around a face and the vertices at which they begin. The vertices inside the
  // face follow.
  struct Polygon
  {
    std::vector<Halfedge_index> pieces;
    std::vector<Vertex_index> vertices;
    std::vector<Point> points;
  };

  void fill(Face_index f)
  {
    Polygon polygon;
    for(std::size_t s = 0; s < 3; ++s)
      add_side(s, sides(f, m_input)[s], polygon);
    const auto inside =
      std::equal_range(m_inside.begin(), m_inside.end(), std::pair(f, Vertex_index()),
                       [](const auto& x, const auto& y) { return x.first < y.first; });
    for(auto i = inside.first; i != inside.second; ++i)
      add_inside(i->second, polygon);
    if(polygon.vertices.size() == 3)
      add_face({polygon.pieces[0], polygon.pieces[1], polygon.pieces[2]});
    else
      add_faces(polygon);
  }

  static Point corner(std::size_t s) { return {s == 1 ? 1 : 0, s == 2 ? 1 : 0}; }

  void add_side(std::size_t s, Halfedge_index h, Polygon& polygon) const
  {
    const Point from = corner(s), to = corner((s + 1) % 3);
    polygon.vertices.push_back(m_input.source(h));
    polygon.points.push_back(from);
    polygon.pieces.push_back(piece(h, 0));
    for(size_type p = 0; p < number_of_marks(h); ++p) {
      const Kernel::FT t(static_cast<double>(mark(h, p).t));
      polygon.vertices.push_back(mark(h, p).vertex);
      polygon.points.push_back(from + edge_point(h, t).t * (to - from));
      polygon.pieces.push_back(piece(h, p + 1));
    }
  }

  void add_inside(Vertex_index v, Polygon& polygon) const
  {
    std::array<Kernel::FT, 3> b;
    for(std::size_t s = 0; s < 3; ++s) {
      b[s] = static_cast<double>(std::get<Face_location<FT>>(m_tri.inserted_vertex(v)).second[s]);
      if(!(b[s] > 0))
        fail(v);
    }
    const Kernel::FT sum = b[0] + b[1] + b[2];
    polygon.vertices.push_back(v);
    polygon.points.emplace_back(b[1] / sum, b[2] / sum);
  }

  void add_faces(const Polygon& polygon)
  {
    Plane_triangulation plane;
    typename Plane_triangulation::Face_handle hint;
    for(std::size_t i = 0; i < polygon.points.size(); ++i) {
      const auto vertex = plane.insert(polygon.points[i], hint);
      if(plane.number_of_vertices() == i)
        fail(polygon.vertices[i]);
      vertex->info() = i;
      hint = vertex->face();
    }
    std::map<std::array<std::size_t, 2>, Halfedge_index> inner; // starts at the smaller number
    for(auto f = plane.finite_faces_begin(); f != plane.finite_faces_end(); ++f) {
      std::array<Halfedge_index, 3> h;
      for(int s = 0; s < 3; ++s)
        h[std::size_t(s)] = side(f->vertex(s)->info(),
                                 f->vertex(Plane_triangulation::ccw(s))->info(), polygon, inner);
      add_face(h);
    }
  }

  Halfedge_index side(std::size_t i, std::size_t j, const Polygon& polygon,
                      std::map<std::array<std::size_t, 2>, Halfedge_index>& inner)
  {
    if(i < polygon.pieces.size() && j == (i + 1) % polygon.pieces.size())
      return polygon.pieces[i];
    const auto [entry, is_new] =
      inner.emplace(std::array{(std::min)(i, j), (std::max)(i, j)}, Halfedge_index());
    Halfedge_index& h = entry->second;
    if(is_new) {
      h = m_mesh.add_edge();
      m_mesh.set_target(h, polygon.vertices[(std::max)(i, j)]);
      m_mesh.set_target(m_mesh.opposite(h), polygon.vertices[(std::min)(i, j)]);
    }
    return i < j ? h : m_mesh.opposite(h);
  }

  void add_face(const std::array<Halfedge_index, 3>& h)
  {
    const Face_index f = m_mesh.add_face();
    m_mesh.set_halfedge(f, h[0]);
    for(std::size_t s = 0; s < 3; ++s) {
      m_mesh.set_next(h[s], h[(s + 1) % 3]);
      m_mesh.set_face(h[s], f);
    }
  }

  void link_border()
  {
    for(Halfedge_index h : m_input.halfedges())
      if(m_input.is_border(h)) {
        const size_type n = number_of_marks(h);
        for(size_type p = 0; p < n; ++p)
          m_mesh.set_next(piece(h, p), piece(h, p + 1));
        m_mesh.set_next(m_numbers.last_piece(h), piece(m_input.next(h), 0));
      }
    set_halfedges_of_vertices(m_mesh);
    for(Vertex_index v : m_input.vertices())
      if(const Halfedge_index h = m_input.halfedge(v); h.is_valid())
        m_mesh.set_halfedge(v, m_numbers.last_piece(h));
  }

  // ---- The result ----

  Triangulation with_coordinates()
  {
    Triangulation result(m_tri);
    result.m_mesh = std::move(m_mesh);
    result.attach();
    for(Vertex_index v : m_input.vertices())
      for(size_type r = 0; r < m_tri.outgoing_halfedges().degree(v); ++r)
        set_roundabouts(piece(m_tri.outgoing_halfedges().halfedge(v, r), 0), r, result);
    for(Edge_index e : m_input.edges())
      for(Halfedge_index h : {m_input.halfedge(e, 0), m_input.halfedge(e, 1)})
        for(size_type p = 0; p < number_of_marks(h); ++p)
          set_roundabouts(piece(h, p + 1), m_tri.number_of_inserted_outgoing(h), result);
    for(Edge_index e : result.m_mesh.edges())
      if(!is_piece(first_halfedge(e)))
        result.m_coordinates.set(e, 0);
    result.recompute_lengths();
    return result;
  }

  // Returns whether `h` is part of an edge of T1.
  bool is_piece(Halfedge_index h) const
  {
    return Edge_index(h).idx() < m_numbers.number_of_pieces();
  }

  // Sets the roundabouts of `h`, which is along outgoing halfedge `r`, and of the halfedges
  // clockwise from it in the face of T1.
  void set_roundabouts(Halfedge_index h, size_type r, Triangulation& result) const
  {
    const Delta_complex& mesh = result.m_mesh;
    do {
      result.m_coordinates.set(h, r);
      h = mesh.next(mesh.opposite(h));
    } while(!is_piece(h));
  }

  const Triangulation& m_tri;
  const Delta_complex& m_input;
  Delta_complex m_mesh;
  std::vector<Mark> m_marks;                                 // in the order of edges and along them
  Edge_marks m_numbers;                                      // of the marks
  std::vector<std::pair<Face_index, Vertex_index>> m_inside; // in the order of faces
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// returns \f$T_1\f$ of `tri` with the vertices of \f$T_2\f$: edges are cut at inserted vertices,
/// and faces are triangulated. So no edge of the result crosses an edge of \f$T_1\f$. Each face
/// lies in a face of \f$T_1\f$, and is flat in space if the input is. Flipped to be Delaunay, it is
/// a refined triangulation again.
///
/// Vertices keep their indices and positions, and so do edges and faces if nothing has been
/// inserted. No edge is constrained. Complexity: linear, and \f$O(n \log n)\f$ in the vertices in a
/// face.
/// \throws Numerical_error if an inserted vertex cannot be distinguished from another vertex or
///   from an edge
/// \pre \f$T_2\f$ has no garbage, see `Intrinsic_triangulation::collect_garbage()`
/// \tparam Traits a model of `IntrinsicGeometryTraitsWithDistance` whose number type is a floating
///   point type
template <typename Traits>
Intrinsic_triangulation<Traits>
input_with_inserted_vertices(const Intrinsic_triangulation<Traits>& tri)
{
  CGAL_precondition(!tri.mesh().has_garbage());
  return internal::Input_splitter<Traits>(tri).split();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_WITH_INSERTED_VERTICES_H
