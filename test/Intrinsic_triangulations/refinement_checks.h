// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_REFINEMENT_CHECKS_H
#define INTRINSIC_TRIANGULATIONS_TEST_REFINEMENT_CHECKS_H

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Refinement_result.h>

// This file checks the angles after a refinement, and its excuses. It is independent of the
// library: it measures in long double, by the law of cosines, on the input and on the common
// subdivision.

namespace Test_surfaces {

// Returns the angle at the source of `h`.
template <typename LengthMap>
double angle_in_degrees(Halfedge_index h, const Delta_complex& mesh, const LengthMap& length)
{
  return angle_at(h, mesh, length) * 180 / pi;
}

inline double least_angle(Face_index f, const Triangulation& t)
{
  double least = 180;
  for(Halfedge_index h : IT::sides(f, t.mesh()))
    least = (std::min)(least, angle_in_degrees(h, t.mesh(), t.length_map()));
  return least;
}

// Returns the edges of the input that are constrained or on the border.
inline std::vector<char> fixed_edges(const Triangulation& t)
{
  std::vector<char> result(t.input_mesh().num_edges(), 0);
  for(Edge_index e : t.input_mesh().edges())
    result[e.idx()] = t.input_mesh().is_border(e);
  for(Edge_index e : t.mesh().edges())
    if(t.is_constrained(e))
      result[t.input_mesh().edge(t.input_halfedge(t.mesh().halfedge(e))).idx()] = 1;
  return result;
}

// Returns the least angle between two of the input edges at `v` that are `fixed`, or the angle sum
// if fewer exist.
inline Real least_sector(Vertex_index v, const Triangulation& t, const std::vector<char>& fixed)
{
  const Delta_complex& mesh = t.input_mesh();
  std::vector<Real> place;
  Real sum = 0;
  IT::for_each_outgoing_halfedge(v, mesh, [&](Halfedge_index h) {
    if(fixed[mesh.edge(h).idx()])
      place.push_back(sum);
    if(!mesh.is_border(h))
      sum += angle_in_degrees(h, mesh, t.input_length_map());
  });
  if(place.empty())
    return sum;
  Real least = mesh.is_border(v) ? 360 : sum - place.back() + place.front();
  for(std::size_t i = 1; i < place.size(); ++i)
    least = (std::min)(least, place[i] - place[i - 1]);
  return least;
}

inline std::set<Vertex_index> small_angle_vertices(const Triangulation& t)
{
  const std::vector<char> fixed = fixed_edges(t);
  std::set<Vertex_index> result;
  for(Vertex_index v : t.input_mesh().vertices())
    if(!t.input_mesh().is_isolated(v) && least_sector(v, t, fixed) < 60)
      result.insert(v);
  return result;
}

// Determines the small-angle vertices for each face of T2. The face lies in faces of T1 at the
// vertex, and only edges of T1 that end at the vertex cross it.
class Faces_beside_small_angle_vertices
{
public:
  explicit Faces_beside_small_angle_vertices(const Triangulation& t)
    : m_vertices(Test_surfaces::small_angle_vertices(t)),
      m_candidates(t.mesh().num_faces(), m_vertices)
  {
    const Correspondence correspondence(t);
    const IT::Common_subdivision<> s(correspondence);
    for(Face_index g : s.mesh().faces()) {
      std::set<Vertex_index> corners;
      for(Halfedge_index h : IT::sides(s.parent_face(Side::input, g), t.input_mesh()))
        corners.insert(t.input_mesh().source(h));
      keep(s.parent_face(Side::intrinsic, g), corners);
    }
    for(Edge_index e : s.mesh().edges())
      if(const Edge_index input = s.parent_edge(Side::input, e);
         input.is_valid() && !s.parent_edge(Side::intrinsic, e).is_valid())
        keep(s.parent_face(Side::intrinsic, s.mesh().face(s.mesh().halfedge(e))),
             {t.input_mesh().vertex(input, 0), t.input_mesh().vertex(input, 1)});
  }

  const std::set<Vertex_index>& operator[](Face_index f) const { return m_candidates[f.idx()]; }
  const std::set<Vertex_index>& small_angle_vertices() const { return m_vertices; }

private:
  void keep(Face_index f, const std::set<Vertex_index>& vertices)
  {
    std::set<Vertex_index>& kept = m_candidates[f.idx()];
    for(auto v = kept.begin(); v != kept.end();)
      v = vertices.count(*v) ? std::next(v) : kept.erase(v);
  }

  std::set<Vertex_index> m_vertices;
  std::vector<std::set<Vertex_index>> m_candidates;
};

// Checks that a face that violates the bound is excused if and only if the rule allows it, by the
// correct vertex. A face without an excuse has the reason `otherwise`.
inline void check_excuse(const IT::Remaining_face& r, const Triangulation& t,
                         const Faces_beside_small_angle_vertices& beside,
                         IT::Remaining_reason otherwise)
{
  std::vector<Vertex_index> small_corners;
  for(Halfedge_index h : IT::sides(r.face, t.mesh()))
    if(beside.small_angle_vertices().count(t.mesh().source(h)))
      small_corners.push_back(t.mesh().source(h));
  if(small_corners.size() == 1) {
    EXPECT_EQ(r.reason, IT::Remaining_reason::at_small_angle_vertex) << r.face;
    EXPECT_EQ(r.vertex, small_corners[0]) << r.face;
  } else if(!beside[r.face].empty()) {
    EXPECT_EQ(r.reason, IT::Remaining_reason::beside_small_angle_vertex) << r.face;
    EXPECT_TRUE(beside[r.face].count(r.vertex)) << r.face;
  } else {
    EXPECT_EQ(r.reason, otherwise) << r.face;
    EXPECT_FALSE(r.vertex.is_valid()) << r.face;
  }
}

// Checks that every face satisfies the bound on angles, up to `tolerance` degrees, or is among the
// remaining faces. These violate it and have the correct reason.
inline void check_angles(const Triangulation& t, double degrees,
                         const IT::Refinement_result& result, double tolerance = 1e-9)
{
  const bool limited = result.status == IT::Refinement_status::insertion_limit;
  const auto otherwise =
    limited ? IT::Remaining_reason::insertion_limit : IT::Remaining_reason::no_room;
  const Faces_beside_small_angle_vertices beside(t);
  std::map<Face_index, IT::Remaining_face> remaining;
  std::size_t unexcused = 0;
  for(const IT::Remaining_face& r : result.remaining) {
    remaining[r.face] = r;
    unexcused += r.reason == otherwise;
    EXPECT_LT(least_angle(r.face, t), degrees + tolerance) << r.face;
    check_excuse(r, t, beside, otherwise);
  }
  for(Face_index f : t.mesh().faces())
    EXPECT_TRUE(remaining.count(f) || least_angle(f, t) > degrees - tolerance)
      << f << ": " << least_angle(f, t) << " degrees";
  if(!limited) {
    EXPECT_EQ(result.status, unexcused > 0       ? IT::Refinement_status::no_room
                             : remaining.empty() ? IT::Refinement_status::bounds_met
                                                 : IT::Refinement_status::bounds_met_but_excused);
  }
}

// Checks that each constrained edge of the input is a chain of shared, constrained edges of T2, in
// order and without gaps. Also checks each border edge.
inline void check_chains(const Triangulation& t, const std::set<std::size_t>& constrained)
{
  std::map<std::size_t, Real> covered;
  for(Edge_index e : t.mesh().edges())
    if(t.is_constrained(e) || t.mesh().is_border(e)) {
      ASSERT_TRUE(t.coordinates().is_shared(e));
      covered[t.input_mesh().edge(t.input_halfedge(t.mesh().halfedge(e))).idx()] += t.length(e);
    }
  EXPECT_EQ(covered.size(), constrained.size());
  for(const auto& [e, length] : covered) {
    EXPECT_EQ(constrained.count(e), 1u);
    EXPECT_NEAR(static_cast<double>(
                  length / t.input_length(Edge_index(static_cast<Edge_index::size_type>(e)))),
                1, 1e-14);
  }
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_REFINEMENT_CHECKS_H
