// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_REINSERT_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_REINSERT_VERTICES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/Exact_decisions.h>
#include <CGAL/Intrinsic_triangulations/internal/certificates/exact_squares.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Inserts vertices into T2, exactly at their positions. T2 is T1 with inserted vertices and without
// flips: every edge of T2 lies in one triangle of T1.
template <typename Traits>
class Vertex_reinserter
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Triangulation::Integer Integer;
  typedef std::array<double, 3> Weights; // barycentric coordinates

public:
  explicit Vertex_reinserter(Triangulation& tri) : m_tri(tri), m_mesh(tri.mesh()) {}

  // Inserts a vertex at `p`.
  // \throws Numerical_error if `p` is the position of a vertex
  void insert(const Surface_point<double>& p)
  {
    const auto* inside = std::get_if<Face_location<double>>(&p);
    const Vertex_index m = inside ? insert_in_face(*inside) : insert_on_edge(*on_edge(p));
    m_tri.measured(m, exact_decisions(m_tri), [] {});
  }

private:
  static Sign orientation(const Weights& a, const Weights& b, const Weights& c)
  {
    typedef Exact_ring R;
    const auto minor = [&](std::size_t i, std::size_t j) {
      return R(R(b[i]) * R(c[j]) - R(b[j]) * R(c[i]));
    };
    return CGAL::sign(R(R(a[0]) * minor(1, 2) + R(a[1]) * minor(2, 0) + R(a[2]) * minor(0, 1)));
  }

  // Returns on which side of the side `h` of a face of T2 the point lies.
  Sign side_of(const Weights& point, Halfedge_index h) const
  {
    return orientation(point, m_tri.input_location(h).second,
                       m_tri.input_location(m_mesh.next(h)).second);
  }

  // Returns a side of the face that contains the point. If the point lies on a side, returns this
  // side. The walk begins in the face with index `f`, which lies in the same face of T1. Random
  // turns prevent cycles.
  Halfedge_index locate(const Weights& point, Face_index f)
  {
    Halfedge_index h = m_mesh.halfedge(f);
    for(int passed = 0; passed < 3; ++passed, h = m_mesh.next(h))
      if(side_of(point, h) == NEGATIVE) {
        h = m_random() % 2 == 0 ? m_mesh.next(opposite(h)) : opposite(h);
        passed = -1;
      }
    for(Halfedge_index side : sides(m_mesh.face(h), m_mesh))
      if(side_of(point, side) == ZERO)
        return side;
    return h;
  }

  Vertex_index insert_in_face(const Face_location<double>& p)
  {
    const Halfedge_index h = locate(p.second, p.first);
    if(side_of(p.second, h) != ZERO)
      return m_tri.insert_into_face(m_mesh.face(h), {}, p, {});
    if(side_of(p.second, m_mesh.next(h)) == ZERO || side_of(p.second, m_mesh.prev(h)) == ZERO)
      throw Numerical_error("two inserted vertices have one position");
    return m_tri.insert_into_edge(h, {}, {}, p, {});
  }

  // Compares the ratios of two pairs of weights.
  static Comparison_result compare(const std::array<double, 2>& v, const std::array<double, 2>& w)
  {
    typedef Exact_ring R;
    return CGAL::compare(R(R(v[1]) * R(w[0])), R(R(w[1]) * R(v[0])));
  }

  // Stores a part of an edge of T1, in the direction of its first halfedge, with the weights of its
  // ends.
  struct Part
  {
    Halfedge_index halfedge;
    std::array<double, 2> end;
  };

  Vertex_index insert_on_edge(const Edge_location<double>& p)
  {
    const auto [first, w] = is_first_halfedge(p.halfedge) ? p : reversed(p);
    std::vector<Part>& parts = m_parts[Edge_index(first)];
    if(parts.empty())
      parts.push_back({first, {0, 1}});
    const auto part = std::find_if(parts.begin(), parts.end(), [&, w = w](const Part& p) {
      return compare(w, p.end) != LARGER;
    });
    if(compare(w, part->end) == EQUAL)
      throw Numerical_error("two inserted vertices have one position");
    const auto forward = m_tri.number_of_inserted_outgoing(first), back = 1 - forward;
    const Vertex_index m =
      m_tri.insert_into_edge(part->halfedge, {Integer(-1), Integer(-1), Integer(0), Integer(0)},
                             {back, forward, back, forward}, p, {});
    parts.insert(part, {first_part(part->halfedge, m_mesh), w});
    return m;
  }

  Triangulation& m_tri;
  const Delta_complex& m_mesh;
  std::unordered_map<Edge_index, std::vector<Part>> m_parts;
  std::minstd_rand m_random;
};

// Resets T2 to T1 with its first `number` inserted vertices, which keep their indices. Afterwards
// all edges are straight, for any state of T2 before.
template <typename Traits>
void reset_with_vertices(Intrinsic_triangulation<Traits>& tri, std::size_t number)
{
  const auto points = tri.inserted_vertices();
  tri.reset_to_input();
  Vertex_reinserter<Traits> reinserter(tri);
  for(std::size_t i = 0; i < number; ++i)
    reinserter.insert(points[i]);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_REINSERT_VERTICES_H
