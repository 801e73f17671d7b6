// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_EQUALITY_H
#define INTRINSIC_TRIANGULATIONS_TEST_EQUALITY_H

#include "more_generators.h"

#include <CGAL/Intrinsic_triangulations/io.h>

#include <locale>

// This file checks that triangulations are bitwise equal.
namespace Test_surfaces {

template <typename Traits>
std::string text_of(const IT::Intrinsic_triangulation<Traits>& t)
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  EXPECT_TRUE(IT::write_intrinsic_triangulation(os, t));
  return os.str();
}

inline Triangulation triangulation_of(const std::string& text)
{
  std::istringstream is(text);
  return IT::read_intrinsic_triangulation(is);
}

inline void expect_equal(const Delta_complex& a, const Delta_complex& b)
{
  ASSERT_EQ(a.number_of_vertices(), b.number_of_vertices());
  ASSERT_EQ(a.number_of_edges(), b.number_of_edges());
  ASSERT_EQ(a.number_of_faces(), b.number_of_faces());
  for(Halfedge_index h : a.halfedges()) {
    EXPECT_EQ(a.next(h), b.next(h));
    EXPECT_EQ(a.target(h), b.target(h));
    EXPECT_EQ(a.face(h), b.face(h));
  }
  for(Vertex_index v : a.vertices())
    EXPECT_EQ(a.halfedge(v), b.halfedge(v));
  for(Face_index f : a.faces())
    EXPECT_EQ(a.halfedge(f), b.halfedge(f));
}

inline void expect_equal(const Triangulation& a, const Triangulation& b)
{
  expect_equal(a.input_mesh(), b.input_mesh());
  expect_equal(a.mesh(), b.mesh());
  for(Edge_index e : a.mesh().edges()) {
    EXPECT_EQ(a.length(e), b.length(e));
    EXPECT_EQ(a.coordinates().normal_coordinate(e), b.coordinates().normal_coordinate(e));
    EXPECT_EQ(a.is_constrained(e), b.is_constrained(e));
  }
  for(Halfedge_index h : a.mesh().halfedges())
    EXPECT_EQ(a.coordinates().roundabout(h), b.coordinates().roundabout(h));
  for(Edge_index e : a.input_mesh().edges())
    EXPECT_EQ(a.input_length(e), b.input_length(e));
  for(Vertex_index v : a.mesh().vertices())
    if(a.is_inserted(v)) {
      EXPECT_EQ(IT::halfedge_of(a.inserted_vertex(v)), IT::halfedge_of(b.inserted_vertex(v)));
      EXPECT_EQ(IT::face_location(a.inserted_vertex(v), a.input_mesh()),
                IT::face_location(b.inserted_vertex(v), b.input_mesh()));
    }
}

inline void expect_equal_to_input(const Triangulation& t)
{
  std::vector<bool> is_image(t.mesh().number_of_halfedges(), false);
  for(Halfedge_index h : t.mesh().halfedges()) {
    const Edge_index e = t.mesh().edge(h);
    ASSERT_EQ(t.coordinates().normal_coordinate(e), -1);
    const Halfedge_index image = t.input_halfedge(h);
    EXPECT_FALSE(is_image[image.idx()]);
    is_image[image.idx()] = true;
    EXPECT_EQ(t.input_mesh().target(image), t.mesh().target(h));
    EXPECT_EQ(t.input_mesh().next(image), t.input_halfedge(t.mesh().next(h)));
    EXPECT_EQ(t.input_mesh().opposite(image), t.input_halfedge(t.mesh().opposite(h)));
    EXPECT_EQ(t.input_length(t.input_mesh().edge(image)), t.length(e));
  }
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_EQUALITY_H
