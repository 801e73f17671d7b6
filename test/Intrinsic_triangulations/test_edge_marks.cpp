// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check numbers of marks and pieces along edges.

#include "testing.h"

#include <CGAL/Intrinsic_triangulations/Edge_marks.h>

namespace Test_edge_marks {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Edge_index;
using IT::Edge_marks;
using IT::Halfedge_index;
using size_type = Edge_marks::size_type;

const std::vector<size_type> counts{3, 0, 1, 5, 0};

TEST(Edge_marks, of_no_edges)
{
  EXPECT_EQ(Edge_marks().size(), 0u);
  EXPECT_EQ(Edge_marks().number_of_pieces(), 0u);
}

// Both halfedges of an edge see its marks, in opposite orders.
TEST(Edge_marks, are_mirrored)
{
  const Edge_marks marks(counts);
  std::set<size_type> seen;
  for(size_type i = 0; i < counts.size(); ++i) {
    const Edge_index e(i);
    const Halfedge_index h = IT::first_halfedge(e), o = IT::opposite(h);
    ASSERT_EQ(marks.size(e), counts[i]);
    for(size_type p = 0; p < counts[i]; ++p) {
      EXPECT_EQ(marks(h, p), marks.before(e) + p);
      EXPECT_EQ(marks(o, p), marks(h, counts[i] - 1 - p));
      for(Halfedge_index x : {h, o})
        EXPECT_EQ(marks.position(x, marks(x, p)), p);
      seen.insert(marks(h, p));
    }
  }
  EXPECT_EQ(seen.size(), marks.size());
  EXPECT_EQ(*seen.rbegin() + 1, marks.size());
}

// The pieces of a halfedge are the pieces of its opposite, reversed and from the other end.
TEST(Edge_marks, number_pieces)
{
  const Edge_marks marks(counts);
  std::set<Edge_index> seen;
  for(size_type i = 0; i < counts.size(); ++i) {
    const Halfedge_index h = IT::first_halfedge(Edge_index(i)), o = IT::opposite(h);
    EXPECT_EQ(marks.number_of_pieces(Edge_index(i)), counts[i] + 1);
    for(size_type p = 0; p <= counts[i]; ++p) {
      EXPECT_EQ(marks.piece(o, p), IT::opposite(marks.piece(h, counts[i] - p)));
      EXPECT_TRUE(IT::is_first_halfedge(marks.piece(h, p)));
      seen.insert(Edge_index(marks.piece(h, p)));
    }
    EXPECT_EQ(marks.last_piece(h), IT::opposite(marks.piece(o, 0)));
  }
  EXPECT_EQ(seen.size(), marks.number_of_pieces());
  EXPECT_EQ(seen.rbegin()->idx() + 1, marks.number_of_pieces());
}

TEST(Edge_marks, more_than_can_be_numbered)
{
  const size_type many = (std::numeric_limits<size_type>::max)() / 10;
  EXPECT_EQ(Edge_marks({many}).size(), many);
  EXPECT_THROW(Edge_marks({many, many}), IT::Overflow_error);
}

TEST(Edge_marks, directions)
{
  for(size_type i = 0; i < 4; ++i) {
    const Halfedge_index h(i), x(6), y(7);
    EXPECT_EQ(IT::is_first_halfedge(h), IT::first_halfedge(Edge_index(h)) == h);
    EXPECT_EQ(IT::oriented_like(h, x), IT::is_first_halfedge(h) ? x : y);
    EXPECT_EQ(IT::oriented_like(h, IT::oriented_like(h, y)), y);
  }
}

} // namespace Test_edge_marks
