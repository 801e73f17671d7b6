// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_MARKED_EDGES_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_MARKED_EDGES_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_marks.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::Correspondence;
using Intrinsic_triangulations::Edge_location;
using Intrinsic_triangulations::Edge_marks;
using Intrinsic_triangulations::edge_point;
using Intrinsic_triangulations::Face_location;
using Intrinsic_triangulations::first_halfedge;
using Intrinsic_triangulations::is_first_halfedge;
using Intrinsic_triangulations::oriented_like;
using Intrinsic_triangulations::Side;
using Intrinsic_triangulations::Surface_point;
using Intrinsic_triangulations::Vertex_location;

// Returns whether two meshes have the same connectivity, with the same indices.
inline bool is_same_complex(const Delta_complex& a, const Delta_complex& b)
{
  if(a.num_vertices() != b.num_vertices() || a.num_halfedges() != b.num_halfedges() ||
     a.num_faces() != b.num_faces())
    return false;
  for(Halfedge_index h : a.halfedges())
    if(a.next(h) != b.next(h) || a.face(h) != b.face(h) || a.target(h) != b.target(h))
      return false;
  return true;
}

template <typename FT, std::size_t n>
std::array<FT, n> between(const std::array<FT, n>& a, const std::array<FT, n>& b, const FT& t)
{
  std::array<FT, n> result;
  for(std::size_t i = 0; i < n; ++i)
    result[i] = (1 - t) * a[i] + t * b[i];
  return result;
}

// Stores a point where an edge of triangulation A (family 0) or C (family 1) crosses a halfedge of
// B.
template <typename FT>
struct Mark
{
  Vertex_index vertex; // of the subdivision
  std::size_t family;
  // `across` is the position on the halfedge of A or C that leaves the face. The sum of the
  // weighted vectors of the ends is the point on B.
  Edge_location<FT> across;
  FT here;                 // the position on the halfedge of B
  Surface_point<FT> other; // in the other family's triangulation
};

// Stores the marks of both families on the edges of B, in one order. The order of each family is
// exact. Positions decide between the two families. If they are equal, A comes first along the
// first halfedge.
//
// A double has a symmetry. Its line consists of edges of A between original faces and copies. If an
// edge of C crosses the same edges of B, it is on this line, too. The reason is that its mirror
// image is in the same class, which has only one geodesic. So both have marks at equal positions,
// up to rounding. The marks of C come on the side of the copies.
template <typename FT>
class Marked_edges
{
public:
  typedef Delta_complex::size_type size_type;

  template <typename Traits_AB, typename Traits_BC>
  Marked_edges(const Correspondence<Traits_AB>& ab, const Correspondence<Traits_BC>& bc,
               std::size_t number_of_original_faces = 0)
    : m_mesh(ab.mesh(Side::intrinsic)),
      m_other{&ab.mesh(Side::input), &bc.mesh(Side::intrinsic)},
      m_number_of_original_faces(number_of_original_faces)
  {
    find_twins(ab, bc);
    set_outgoing_halfedges(0, Side::intrinsic, ab);
    set_outgoing_halfedges(1, Side::input, bc);
    m_marks.reserve(ab.number_of_crossings() + bc.number_of_crossings());
    std::vector<size_type> count_of_both;
    for(Edge_index e : m_mesh.edges()) {
      m_count_of_A.push_back(ab.number_of_crossings(Side::intrinsic, e));
      count_of_both.push_back(m_count_of_A.back() + bc.number_of_crossings(Side::input, e));
      merge(e, ab, bc);
    }
    m_numbers = Edge_marks(std::move(count_of_both));
    for(Edge_index e : m_mesh.edges())
      for(std::size_t family = 0; family < 2; ++family)
        if(count(family, e) > 0)
          locate_others(family, e);
  }

  // Returns the connectivity of B, and of A or C.
  const Delta_complex& mesh() const { return m_mesh; }
  const Delta_complex& mesh(std::size_t family) const { return *m_other[family]; }

  const Edge_marks& numbers() const { return m_numbers; }
  size_type count(std::size_t family, Edge_index e) const
  {
    return family == 0 ? m_count_of_A[e] : m_numbers.size(e) - m_count_of_A[e];
  }

  // Returns mark `p` on the halfedge `h`, counted from its source.
  Mark<FT> mark(Halfedge_index h, size_type p) const
  {
    Mark<FT> m = m_marks[m_numbers(h, p)];
    m.here = edge_point(h, m.here).t;
    if(!is_first_halfedge(h))
      m.across = reversed(m.across);
    if(count(1 - m.family, Edge_index(h)) == 0)
      m.other = on_shared(1 - m.family, h, m.here);
    return m;
  }

  // Returns the last halfedge of the family's triangulation at or clockwise from `h` around its
  // source.
  Halfedge_index outgoing(std::size_t family, Halfedge_index h) const
  {
    return m_outgoing[family][h];
  }

private:
  struct Node
  {
    FT here;
    Face_location<FT> location;
    Vertex_index vertex = {}; // of the subdivision; null at an end of the edge
  };

  static constexpr size_type no_twin = static_cast<size_type>(-1);

  template <typename Traits>
  void set_outgoing_halfedges(std::size_t family, Side side,
                              const Correspondence<Traits>& correspondence)
  {
    m_outgoing[family].reserve(m_mesh.num_halfedges());
    for(Halfedge_index h : m_mesh.halfedges())
      m_outgoing[family].push_back(correspondence.outgoing_before(side, h));
  }

  bool is_original(Face_index f_of_A) const { return f_of_A.idx() < m_number_of_original_faces; }

  // Finds the crossings of edges of C that are the same line as edges of A between an original face
  // and a copy.
  template <typename Traits_AB, typename Traits_BC>
  void find_twins(const Correspondence<Traits_AB>& ab, const Correspondence<Traits_BC>& bc)
  {
    if(m_number_of_original_faces == 0)
      return;
    const Delta_complex& a = mesh(0);
    for(Edge_index e : a.edges()) {
      const Halfedge_index h = first_halfedge(e);
      if(is_original(a.face(h)) == is_original(a.face(opposite(h))))
        continue;
      const Halfedge_index twin = halfedge_of_C_with_course_of(h, ab, bc);
      const size_type n = twin.is_valid() ? ab.number_of_crossings(Side::input, e) : 0;
      if(n > 0 && m_twin.empty())
        m_twin.assign(ab.number_of_crossings(), no_twin);
      for(size_type p = 0; p < n; ++p)
        m_twin[ab.crossing(Side::input, h, p).id] = bc.crossing(Side::intrinsic, twin, p).id;
    }
  }

  // Returns the halfedge of C that crosses the same edges of B as the halfedge `h` of A, or null.
  template <typename Traits_AB, typename Traits_BC>
  Halfedge_index halfedge_of_C_with_course_of(Halfedge_index h, const Correspondence<Traits_AB>& ab,
                                              const Correspondence<Traits_BC>& bc) const
  {
    const size_type n = ab.number_of_crossings(Side::input, Edge_index(h));
    const auto has_same_course = [&](Halfedge_index x) {
      bool result = mesh(1).source(x) == mesh(0).source(h) &&
                    bc.number_of_crossings(Side::intrinsic, Edge_index(x)) == n;
      for(size_type p = 0; result && p < n; ++p)
        result = bc.crossing(Side::intrinsic, x, p).across.halfedge ==
                 ab.crossing(Side::input, h, p).across.halfedge;
      return result;
    };
    if(n == 0)
      return {};
    const Halfedge_index crossed = ab.crossing(Side::input, h, 0).across.halfedge;
    const size_type candidates = bc.number_of_crossings(Side::input, Edge_index(crossed));
    for(size_type q = 0; q < candidates; ++q) {
      const Halfedge_index x = bc.crossing(Side::input, crossed, q).across.halfedge;
      for(Halfedge_index y : {x, opposite(x)})
        if(has_same_course(y))
          return y;
    }
    return {};
  }

  bool are_twins(size_type crossing_of_A, size_type crossing_of_C) const
  {
    return !m_twin.empty() && m_twin[crossing_of_A] == crossing_of_C;
  }

  bool are_twins(const Mark<FT>& mark, const Node& other) const
  {
    if(m_twin.empty() || !other.vertex.is_valid())
      return false;
    const auto [a, c] = std::minmax(mark.vertex, other.vertex); // crossings of A come first
    const size_type first = m_mesh.num_vertices();
    return are_twins(a.idx() - first, c.idx() - first - size_type(m_twin.size()));
  }

  // Returns whether `a` comes before `c` on a halfedge of B. This halfedge leads to the left of the
  // halfedge of A.
  template <typename Crossing_of_A, typename Crossing_of_C>
  bool is_before(const Crossing_of_A& a, const Crossing_of_C& c) const
  {
    return are_twins(a.id, c.id) ? !is_original(mesh(0).face(a.across.halfedge))
                                 : !(c.here.t < a.here.t);
  }

  template <typename Traits_AB, typename Traits_BC>
  void merge(Edge_index e, const Correspondence<Traits_AB>& ab, const Correspondence<Traits_BC>& bc)
  {
    const Halfedge_index h = first_halfedge(e);
    const size_type n = ab.number_of_crossings(Side::intrinsic, e);
    const size_type m = bc.number_of_crossings(Side::input, e);
    for(size_type p = 0, q = 0; p < n || q < m;) {
      const bool is_A = q == m || (p < n && is_before(ab.crossing(Side::intrinsic, h, p),
                                                      bc.crossing(Side::input, h, q)));
      if(is_A)
        add(0, Side::intrinsic, h, p++, ab, m_mesh.num_vertices());
      else
        add(1, Side::input, h, q++, bc, m_mesh.num_vertices() + ab.number_of_crossings());
    }
  }

  template <typename Traits>
  void add(std::size_t family, Side side, Halfedge_index h, size_type p,
           const Correspondence<Traits>& correspondence, size_type first_vertex)
  {
    const auto c = correspondence.crossing(side, h, p);
    const FT scale = correspondence.scale(c.id);
    const FT factor = side == Side::input ? scale : FT(1 / scale);
    m_marks.push_back({Vertex_index(first_vertex + c.id),
                       family,
                       {c.across.halfedge, {factor * (1 - c.across.t), factor * c.across.t}},
                       c.here.t,
                       {}});
  }

  // Locates marks of the other family. Between two marks of one family, or an end of the edge, the
  // edge is straight in the triangulation of this family.
  void locate_others(std::size_t family, Edge_index e)
  {
    const Halfedge_index h = first_halfedge(e);
    const Delta_complex& other = mesh(family);
    size_type first = m_numbers.before(e);
    const size_type end = first + m_numbers.size(e);
    const auto corner = [&](Halfedge_index x) {
      return face_location(Surface_point<FT>(Vertex_location{outgoing(family, x)}), other);
    };
    Node left{FT(0), corner(h)};
    for(size_type i = first; i < end; ++i) {
      const Mark<FT>& m = m_marks[i];
      if(m.family != family)
        continue;
      locate(first, i, left, {m.here, face_location(reversed(m.across), other), m.vertex});
      left = {m.here, face_location(m.across, other), m.vertex};
      first = i + 1;
    }
    locate(first, end, left, {FT(1), corner(opposite(h))});
  }

  void locate(size_type first, size_type last, const Node& left, const Node& right)
  {
    for(size_type i = first; i < last; ++i)
      m_marks[i].other =
        Face_location<FT>(left.location.first, between(left.location.second, right.location.second,
                                                       position(m_marks[i], left, right)));
  }

  // Returns the position of a mark between two nodes of the other family. Twins are the same point,
  // even if rounding makes them different.
  FT position(const Mark<FT>& mark, const Node& left, const Node& right) const
  {
    const FT width = right.here - left.here;
    return are_twins(mark, left)    ? FT(0)
           : are_twins(mark, right) ? FT(1)
           : width > 0              ? std::clamp(FT((mark.here - left.here) / width), FT(0), FT(1))
                                    : FT(0);
  }

  Edge_location<FT> on_shared(std::size_t family, Halfedge_index h, const FT& t) const
  {
    return {outgoing(family, h), {1 - t, t}};
  }

  const Delta_complex& m_mesh;
  std::array<const Delta_complex*, 2> m_other;
  std::size_t m_number_of_original_faces;
  std::vector<size_type> m_twin; // crossings of C that are crossings of A, too, or `no_twin`
  std::array<std::vector<Halfedge_index>, 2> m_outgoing;
  Edge_marks m_numbers;                // of the marks of both families
  std::vector<size_type> m_count_of_A; // of each edge
  std::vector<Mark<FT>> m_marks;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SUBDIVISION_MARKED_EDGES_H
