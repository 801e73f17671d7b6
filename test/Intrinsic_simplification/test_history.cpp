// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// These tests check the records of a history for each kind of operation.

#include "simplified_surfaces.h"

namespace Test_history {

using namespace Test_surfaces;

static_assert(sizeof(IS::Surface_operation) == 32);
static_assert(sizeof(IS::Face_corner) == 4);

// Returns the operation at time `t`, which must be of this type.
template <typename Operation>
const Operation operation(const IS::Surface_history& history, std::size_t t)
{
  Operation result{};
  history[t].visit([&](const auto& o) {
    if constexpr(std::is_same_v<decltype(o), const Operation&>)
      result = o;
    else
      ADD_FAILURE() << "an operation of another type";
  });
  return result;
}

void expect_corner(const IS::Face_corner& c, Halfedge_index h, const Delta_complex& mesh)
{
  EXPECT_EQ(c.face(), mesh.face(h));
  EXPECT_EQ(IT::sides(c.face(), mesh)[c.index()], h);
}

TEST(Surface_history, keeps_the_faces_of_each_operation)
{
  const Mesh closed = octahedron();
  const Evolving_surface s(closed);
  const Delta_complex& mesh = s.mesh();
  IS::Surface_history history;
  const Halfedge_index h = mesh.halfedge(mesh.face(Halfedge_index(4)));
  history.add_scaling(Vertex_index(1), 1.5, true, mesh);
  history.add_scaling(Vertex_index(1), 1, false, mesh);
  history.add_flip(h, mesh, 0.25, 0.75);
  history.add_removal(h, mesh, 0.125, 0.5);
  ASSERT_EQ(history.size(), 4u);

  const auto scaling = operation<IS::Scaling>(history, 0);
  EXPECT_EQ(scaling.vertex, Vertex_index(1));
  EXPECT_EQ(scaling.factor, 1.5);
  EXPECT_EQ(scaling.number_of_corners, 4u);
  for(const IS::Face_corner& c : history.corners(scaling))
    EXPECT_EQ(mesh.source(IT::sides(c.face(), mesh)[c.index()]), Vertex_index(1));
  EXPECT_TRUE(history.corners(operation<IS::Scaling>(history, 1)).empty());

  const auto flip = operation<IS::Flip>(history, 2);
  EXPECT_EQ(flip.halfedge, h);
  expect_corner(flip.corners[0], h, mesh);
  expect_corner(flip.corners[1], mesh.opposite(h), mesh);
  EXPECT_EQ(flip.crossing_before, 0.25);
  EXPECT_EQ(flip.crossing_after, 0.75);

  const auto removal = operation<IS::Vertex_change>(history, 3);
  EXPECT_FALSE(removal.is_insertion);
  EXPECT_FALSE(removal.is_border);
  Halfedge_index outgoing = h;
  for(const IS::Face_corner& c : removal.corners) {
    expect_corner(c, outgoing, mesh);
    outgoing = IT::next_around_source(outgoing, mesh);
  }
  expect_corner(removal.whole, mesh.halfedge(mesh.face(h)), mesh);
  EXPECT_EQ(removal.weight, (std::array<double, 2>{0.125, 0.5}));
}

// A removal and an insertion store the first corner of the whole face at the boundary.
TEST(Surface_history, keeps_the_faces_of_changes_at_the_boundary)
{
  const Mesh strip = grid(1, 1, [](double x, double y) { return Point(x, y, 0); });
  const Evolving_surface s(strip);
  const Delta_complex& mesh = s.mesh();
  IS::Surface_history history;
  for(Vertex_index v : mesh.vertices()) {
    if(mesh.degree(v) != 3)
      continue;
    const Halfedge_index a = IT::first_outgoing_halfedge(v, mesh),
                         b = IT::next_around_source(a, mesh);
    const IS::Face_corner whole(mesh.face(b), 2);
    history.add_removal(a, mesh, 0.375, 0);
    history.add_insertion(a, mesh, whole, 0.25, 0);
    for(IS::Surface_history::Time t = history.size() - 2; t < history.size(); ++t) {
      const auto change = operation<IS::Vertex_change>(history, t);
      EXPECT_EQ(change.is_insertion, t % 2 == 1);
      EXPECT_TRUE(change.is_border);
      ASSERT_EQ(history.corners(change).size(), 2u);
      expect_corner(change.corners[0], a, mesh);
      expect_corner(change.corners[1], b, mesh);
      EXPECT_EQ(change.whole.face(), t % 2 == 1 ? mesh.face(b) : mesh.face(a));
      EXPECT_EQ(change.whole.index(), t % 2 == 1 ? 2u : 1u);
      EXPECT_EQ(change.weight, (std::array<double, 2>{t % 2 == 1 ? 0.25 : 0.375, 0}));
    }
  }
  EXPECT_EQ(history.size(), 4u);
}

TEST(Surface_history, can_be_truncated)
{
  const Evolving_surface s(octahedron());
  IS::Surface_history history;
  history.add_scaling(Vertex_index(0), 2, true, s.mesh());
  history.add_flip(Halfedge_index(0), s.mesh(), 0.5, 0.5);
  history.add_scaling(Vertex_index(1), 2, true, s.mesh());
  history.truncate(1);
  ASSERT_EQ(history.size(), 1u);
  history.add_scaling(Vertex_index(2), 3, true, s.mesh());
  const auto scaling = operation<IS::Scaling>(history, 1);
  EXPECT_EQ(scaling.first_corner, 4u);
  for(const IS::Face_corner& c : history.corners(scaling))
    EXPECT_EQ(s.mesh().source(IT::sides(c.face(), s.mesh())[c.index()]), Vertex_index(2));
}

TEST(Surface_history, refuses_faces_beyond_its_codes)
{
  EXPECT_NO_THROW(IS::Face_corner(Face_index((1U << 30U) - 1), 2));
  EXPECT_THROW(IS::Face_corner(Face_index(1U << 30U), 0), IT::Overflow_error);
}

} // namespace Test_history
