// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_FLAT_CHANGES_H
#define INTRINSIC_TRIANGULATIONS_TEST_FLAT_CHANGES_H

#include "flat_insertion.h"

// This file changes flat surfaces by random operations.
namespace Test_flat_changes {

using namespace Test_surfaces;

inline std::vector<Named_surface> surfaces()
{
  std::vector<Named_surface> result = flat_surfaces();
  result.push_back({"polygon", flat_polygon(random_points(12, 5000, 3))});
  result.push_back({"torus with five vertices", flat_torus(5, 1, 2)});
  return result;
}

enum Operation
{
  flip,
  insert_into_face,
  insert_on_input,
  split,
  remove_vertex,
  number_of_operations
};

using Counts = std::array<std::size_t, number_of_operations>;

inline bool operate(Operation operation, Flat_insertion& flat, CGAL::Random& random)
{
  const Delta_complex& mesh = flat.triangulation().mesh();
  const auto h = random_index<Halfedge_index>(mesh.num_halfedges(), random);
  if(operation == remove_vertex)
    return flat.remove(random_index<Vertex_index>(mesh.num_vertices(), random));
  if(mesh.is_removed(h) || (mesh.is_border(h) && operation != split))
    return false;
  switch(operation) {
    case flip: return flat.flip(h);
    case insert_into_face: return flat.insert_into_face(mesh.face(h), random);
    case insert_on_input: {
      bool is_done = false; // few places on T1 are in one face
      for(int attempt = 0; attempt < 30 && !is_done; ++attempt)
        is_done = flat.insert_on_input(mesh.face(h), random);
      return is_done;
    }
    default: return flat.split(h, random);
  }
}

// Applies random operations, with twelve flips for each of the others.
inline void operate_at_random(Flat_insertion& flat, int tries, unsigned int seed, Counts& counts)
{
  CGAL::Random random(seed);
  for(int i = 0; i < tries && !testing::Test::HasFailure(); ++i) {
    const int n = random.get_int(0, 16);
    const auto operation = static_cast<Operation>((std::max)(0, n - 11));
    if(flat.triangulation().number_of_inserted_vertices() > 25 && operation != flip &&
       operation != remove_vertex)
      continue;
    counts[operation] += operate(operation, flat, random);
    if(i % 10 == 0) {
      EXPECT_TRUE(flat.triangulation().is_valid(true));
      flat.check_courses();
      flat.recompute_lengths();
    }
  }
}

// Calls `check(surface, flat)` after random operations on every flat surface.
inline Counts for_each_flat(int tries, const std::function<void(Flat_insertion&)>& check)
{
  Counts counts{};
  for(const Named_surface& s : surfaces())
    for(unsigned int constrained : {0u, 4u})
      for(unsigned int seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(s.name + ", seed " + std::to_string(seed) + ", every " +
                     std::to_string(constrained) + "th edge constrained");
        Flat_insertion flat(s.surface, constrained);
        operate_at_random(flat, tries, seed, counts);
        check(flat);
        if(testing::Test::HasFailure())
          return counts;
      }
  return counts;
}

} // namespace Test_flat_changes

#endif // INTRINSIC_TRIANGULATIONS_TEST_FLAT_CHANGES_H
