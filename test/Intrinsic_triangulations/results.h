// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_RESULTS_H
#define INTRINSIC_TRIANGULATIONS_TEST_RESULTS_H

#include "testing.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <tbb/global_control.h>

#include <cstring>

namespace Test_surfaces {

namespace IT = CGAL::Intrinsic_triangulations;

// Stores all numbers of a result, to be compared bitwise.
class Results
{
public:
  template <typename Number>
  void add(const Number& x)
  {
    if constexpr(std::is_floating_point_v<Number>) {
      const double y = static_cast<double>(x);
      std::uint64_t bits;
      std::memcpy(&bits, &y, sizeof bits);
      m_numbers.push_back(bits);
    } else
      m_numbers.push_back(static_cast<std::uint64_t>(x));
  }

  template <typename FT>
  void add_place(const IT::Surface_point<FT>& p, const IT::Delta_complex& mesh)
  {
    add(IT::halfedge_of(p).idx());
    add_location(IT::face_location(p, mesh));
  }

  template <typename FT>
  void add_location(const IT::Face_location<FT>& p)
  {
    add(p.first.idx());
    for(const FT& x : p.second)
      add(x);
  }

  template <typename FT>
  void add_locations(const std::vector<IT::Face_location<FT>>& locations)
  {
    for(const auto& p : locations)
      add_location(p);
  }

  template <typename Mesh>
  void add_mesh(const Mesh& mesh)
  {
    for(auto h : mesh.halfedges()) {
      add(mesh.next(h).idx());
      add(mesh.target(h).idx());
      add(mesh.face(h).idx());
    }
    for(auto v : mesh.vertices())
      add(mesh.halfedge(v).idx());
    for(auto f : mesh.faces())
      add(mesh.halfedge(f).idx());
  }

  template <typename Subdivision, typename Sides>
  void add_subdivision(const Subdivision& s, const Sides& sides)
  {
    add_mesh(s.mesh());
    for(auto side : sides) {
      for(auto f : s.mesh().faces())
        add(s.parent_face(side, f).idx());
      for(auto e : s.mesh().edges())
        add(s.parent_halfedge(side, s.mesh().halfedge(e)).idx());
      for(auto v : s.mesh().vertices())
        add_place(s.place(side, v), s.mesh(side));
    }
  }

  template <typename Matrix>
  void add_matrix(const Matrix& m)
  {
    ASSERT_TRUE(m.isCompressed());
    add(m.rows());
    for(Eigen::Index k = 0; k <= m.outerSize(); ++k)
      add(m.outerIndexPtr()[k]);
    for(Eigen::Index k = 0; k < m.nonZeros(); ++k) {
      add(m.innerIndexPtr()[k]);
      add(m.valuePtr()[k]);
    }
  }

  std::size_t size() const { return m_numbers.size(); }
  bool operator==(const Results& other) const { return m_numbers == other.m_numbers; }

private:
  std::vector<std::uint64_t> m_numbers;
};

// Checks that `compute(tag)` has bitwise the results of one thread with any number of threads.
template <typename Compute>
void expect_same_results(const Compute& compute)
{
  const Results expected = compute(CGAL::Sequential_tag());
  ASSERT_GT(expected.size(), 0u);
  for(std::size_t threads : {1u, 2u, 3u, 7u}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    EXPECT_TRUE(compute(CGAL::Parallel_tag()) == expected) << threads << " threads";
  }
}

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_RESULTS_H
