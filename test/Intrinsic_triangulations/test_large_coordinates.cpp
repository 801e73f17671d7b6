// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measuring.h"

#include <CGAL/Intrinsic_triangulations/Exact_Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/flip_to.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <boost/multiprecision/cpp_int.hpp>

#ifdef CGAL_USE_MPFR
#include <CGAL/Gmpfr.h>
#endif

namespace Test_large_coordinates {

using namespace Test_surfaces;
using boost::multiprecision::cpp_int;

// ---- Exact decisions ----

template <typename Integer>
using Exact_triangulation =
  IT::Intrinsic_triangulation<IT::Exact_Euclidean_geometry_traits<CGAL::Exact_rational, Integer>>;

// All computations with integers are repeated with two types of them.
TEST(Large_coordinates, exact_traits_agree_with_64_bits)
{
  const Mesh mesh = perturbed(embedded_torus(12, 8), 0.1, 1);
  Exact_triangulation<std::int64_t> narrow(mesh);
  Exact_triangulation<cpp_int> wide(mesh);
  EXPECT_EQ(IT::make_Delaunay(narrow), IT::make_Delaunay(wide));
  EXPECT_TRUE(IT::certify_Delaunay(wide).is_Delaunay());
  for(Edge_index e : narrow.mesh().edges()) {
    EXPECT_EQ(wide.coordinates().normal_coordinate(e), narrow.coordinates().normal_coordinate(e));
    EXPECT_EQ(wide.length(e), narrow.length(e));
  }
  EXPECT_EQ(IT::Common_subdivision(IT::Correspondence(wide)).mesh().number_of_faces(),
            IT::Common_subdivision(IT::Correspondence(narrow)).mesh().number_of_faces());
  Exact_triangulation<cpp_int> wide_input = wide;
  Exact_triangulation<std::int64_t> narrow_input = narrow;
  EXPECT_EQ(flip_to_input(wide_input), flip_to_input(narrow_input));
  EXPECT_EQ(IT::refine(wide).insertions, IT::refine(narrow).insertions);
  EXPECT_TRUE(wide.is_valid(true));
}

#ifdef CGAL_USE_MPFR

// ---- A flat torus with one vertex and very long edges ----

struct Wide_vector
{
  cpp_int x, y;

  friend Wide_vector operator+(const Wide_vector& v, const Wide_vector& w)
  {
    return {v.x + w.x, v.y + w.y};
  }
  friend cpp_int det(const Wide_vector& v, const Wide_vector& w) { return v.x * w.y - v.y * w.x; }
};

// Returns the number of crossings. Curves on the torus meet as often as the determinant, once of it
// at the vertex.
cpp_int crossings(const Wide_vector& v, const std::array<Wide_vector, 3>& edges)
{
  cpp_int sum = 0;
  for(const Wide_vector& w : edges) {
    const cpp_int meetings = abs(det(v, w));
    if(meetings == 0)
      return -1;
    sum += meetings - 1;
  }
  return sum;
}

using CGAL::Gmpfr;
using Traits = IT::Euclidean_geometry_traits<Gmpfr, cpp_int>;

// Represents a torus whose edges of T1 are v, w and v + w, where v and w have been added to each
// other `steps` times.
struct Long_torus
{
  std::array<Wide_vector, 3> edges;
  Delta_complex mesh = glue({{1, 2, -3}, {-1, -2, 3}});

  explicit Long_torus(int steps)
  {
    Wide_vector v{1, 0}, w{0, 1};
    for(int i = 0; i < steps; ++i)
      (i % 2 == 0 ? v : w) = v + w;
    edges = {v, w, v + w};
  }

  // Returns the length of a vector of the lattice of (7, 1) and (2, 9).
  static Gmpfr length(const Wide_vector& v)
  {
    const cpp_int x = 7 * v.x + 2 * v.y, y = v.x + 9 * v.y;
    return CGAL::sqrt(Gmpfr(CGAL::Gmpz(cpp_int(x * x + y * y).str())));
  }

  IT::Intrinsic_triangulation<Traits> triangulation() const
  {
    const auto map = boost::make_function_property_map<Edge_index>(
      [this](Edge_index e) { return length(edges[e.idx()]); });
    return IT::Intrinsic_triangulation<Traits>(mesh, IT::parameters::edge_length_map(map));
  }
};

TEST(Large_coordinates, Delaunay_triangulation_far_from_the_input)
{
  const auto before = Gmpfr::set_default_precision(1000);
  for(int steps : traced({10, 95, 200})) {
    const Long_torus torus(steps);
    auto t = torus.triangulation();
    const std::size_t flips = IT::make_Delaunay(t);
    EXPECT_GE(flips, static_cast<std::size_t>(steps - 2));
    EXPECT_TRUE(IT::is_Delaunay(t));
    // The shortest vectors of the lattice are (7, 1), (2, 9) and their difference.
    const std::array<Wide_vector, 3> shortest{{{1, 0}, {0, 1}, {-1, 1}}};
    cpp_int sum = 0;
    for(const Wide_vector& v : shortest) {
      std::size_t found = 0;
      for(Edge_index e : t.mesh().edges())
        if(CGAL::abs(t.length(e) / Long_torus::length(v) - 1) < 1e-100) {
          ++found;
          EXPECT_EQ(t.coordinates().normal_coordinate(e), crossings(v, torus.edges));
          sum += crossings(v, torus.edges);
        }
      EXPECT_EQ(found, 1u);
    }
    EXPECT_TRUE(t.coordinates().is_valid(t.mesh(), t.outgoing_halfedges()));
    if(steps > 90) {
      EXPECT_GT(sum, (std::numeric_limits<std::uint64_t>::max)());
      EXPECT_THROW(IT::Correspondence<Traits>{t}, IT::Overflow_error);
    }
    EXPECT_GE(flip_to_input(t), static_cast<std::size_t>(steps - 2));
    for(Edge_index e : t.mesh().edges())
      EXPECT_TRUE(t.coordinates().is_shared(e));
  }
  Gmpfr::set_default_precision(before);
}

#endif // CGAL_USE_MPFR

} // namespace Test_large_coordinates
