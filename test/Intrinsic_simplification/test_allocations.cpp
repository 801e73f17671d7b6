// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A removal allocates only memory for the history, which doubles from time to time.

#include "evolving_surfaces.h"

#include <CGAL/Intrinsic_simplification/simplify.h>

std::size_t number_of_allocations(); // counted_new.cpp

namespace Test_allocations {

using namespace Test_surfaces;

struct Counting_visitor : IS::Default_simplification_visitor
{
  std::size_t removals = 0, first = 0, last = 0;

  void after_removal(Vertex_index)
  {
    last = number_of_allocations();
    if(++removals == 100) // the memory of one star is large enough by then
      first = last;
  }
};

TEST(Allocations, a_removal_allocates_nothing)
{
  Evolving_surface s(random_sphere(3000, 1));
  Counting_visitor visitor;
  simplify(s, IS::parameters::number_of_vertices(std::size_t(1000)).visitor(std::ref(visitor)));
  EXPECT_EQ(visitor.removals, 2000u);
  // Allocations are two vectors of the history, with four to five doublings each, and a few stars
  // of higher degree.
  EXPECT_LE(visitor.last - visitor.first, 40u);
}

} // namespace Test_allocations
