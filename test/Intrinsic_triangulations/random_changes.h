// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_RANDOM_CHANGES_H
#define INTRINSIC_TRIANGULATIONS_TEST_RANDOM_CHANGES_H

#include "generators.h"

#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

// This file generates triangulations of all test surfaces with vertices inserted at random.
namespace Test_surfaces {

// Changes a triangulation at random: inserts and removes vertices, and flips it towards Delaunay.
class Random_changes
{
public:
  Random_changes(Triangulation& t, unsigned int seed) : m_t(t), m_inserter(t), m_random(seed) {}

  const IT::Vertex_inserter<>& inserter() const { return m_inserter; }
  std::size_t inserted() const { return m_vertices.size(); }

  void step()
  {
    const int kind = m_random.get_int(0, 10);
    if(kind < 3)
      flip_to_Delaunay();
    else if(kind < 6)
      insert(kind == 5 ? 0.05 : 0);
    else if(kind < 8)
      split(kind == 7 ? 0.1 : 0);
    else
      remove();
  }

  void remove_all()
  {
    flip_to_Delaunay();
    while(!m_vertices.empty()) {
      EXPECT_TRUE(m_inserter.remove(m_vertices.back()).is_valid());
      m_vertices.pop_back();
      flip_to_Delaunay();
    }
  }

private:
  void flip_to_Delaunay()
  {
    for(bool changed = true; changed;) {
      changed = false;
      for(Edge_index e : m_t.mesh().edges())
        if(!m_t.is_Delaunay(e)) {
          m_inserter.flip(m_t.mesh().halfedge(e));
          changed = true;
        }
    }
  }

  void insert(double closeness)
  {
    const auto f = random_index<Face_index>(m_t.mesh().num_faces(), m_random);
    if(m_t.mesh().is_removed(f))
      return;
    const double a = m_random.get_double(0.1, 1), b = m_random.get_double(0.1, 1),
                 c = m_random.get_double(0.1, 1), sum = a + b + c;
    const double scale = m_t.length(m_t.mesh().edge(m_t.mesh().halfedge(f)));
    m_vertices.push_back(
      m_inserter.insert({f, {1 - b / sum - c / sum, b / sum, c / sum}}, closeness * scale));
  }

  void split(double closeness)
  {
    const auto h = random_index<Halfedge_index>(m_t.mesh().num_halfedges(), m_random);
    if(m_t.mesh().is_removed(h) || !m_inserter.can_be_split(h))
      return;
    m_vertices.push_back(m_inserter.split_edge(h, m_random.get_double(0.2, 0.8),
                                               closeness * m_t.length(m_t.mesh().edge(h))));
  }

  void remove()
  {
    if(m_vertices.empty())
      return;
    const auto i =
      static_cast<std::size_t>(m_random.get_int(0, static_cast<int>(m_vertices.size())));
    if(m_inserter.remove(m_vertices[i]).is_valid())
      m_vertices.erase(m_vertices.begin() + std::ptrdiff_t(i));
  }

  Triangulation& m_t;
  IT::Vertex_inserter<> m_inserter;
  CGAL::Random m_random;
  std::vector<Vertex_index> m_vertices;
};

inline Triangulation changed(Triangulation t, unsigned int seed, int steps)
{
  Random_changes changes(t, seed);
  for(int step = 0; step < steps; ++step)
    changes.step();
  t.collect_garbage();
  t.recompute_lengths();
  IT::make_Delaunay(t);
  return t;
}

// Calls `check(t)` for triangulations of all test surfaces.
template <typename Check>
void for_each_triangulation(const Check& check)
{
  for(const auto& [m, seed] : traced(meshes(), 3))
    check(Triangulation(m.mesh), seed);
  for(const auto& [c, seed] : traced(complexes(), 3))
    check(triangulation(c.mesh, random_lengths(c.mesh, seed)), seed);
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_RANDOM_CHANGES_H
