// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Counts how often three methods keep the correspondence through flips to Delaunay, and through
// refinement, on near-degenerate meshes (Table 3.1). The methods are the explicit overlay, which
// cannot be refined, signposts, and integer coordinates. Only meshes without boundary are refined.
// Arguments are the numbers of meshes to flip and of meshes from which the refined ones are chosen;
// meshes are the meshes of the tests. A subdivision counts as found if its connectivity is the
// connectivity of a subdivision of T1 by curves with the connectivity of T2.

#include "../../test/Intrinsic_triangulations/near_degenerate_meshes.h"
#include "../Table.h"
#include "Integer_coordinate_method.h"
#include "Overlay_baseline.h"
#include "Signpost_baseline.h"
#include "Signpost_refinement.h"
#include "measure.h"

#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

using Test_surfaces::Named_mesh;

// Counts the outcomes of one method.
struct Score
{
  std::size_t changed = 0, subdivided = 0;
  double milliseconds_to_change = 0, milliseconds_to_subdivide = 0;
  std::map<std::string, std::size_t> reasons;
};

// Runs `change(method)`, which flips or refines.
template <typename Method, typename Change>
void run(const Named_mesh& m, const Change& change, Score& score)
{
  Samples first, subdivide;
  try {
    Method method{CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>(m.mesh)};
    first.time([&] { return change(method); });
    score.milliseconds_to_change += first.median();
    ++score.changed;
    subdivide.time([&] { return method.subdivide(); });
    score.milliseconds_to_subdivide += subdivide.median();
    ++score.subdivided;
  } catch(const Methods::Failure& failure) {
    ++score.reasons[failure.what()];
  } catch(const CGAL::Intrinsic_triangulations::Error& error) {
    ++score.reasons[error.what()];
  }
}

// Runs a method on all meshes. Prints reasons of failures to standard error.
template <typename Method, typename Change>
void run(const Table& table, const char* changed, const char* method,
         const std::vector<Named_mesh>& meshes, const Change& change)
{
  Score score;
  for(const Named_mesh& m : meshes)
    run<Method>(m, change, score);
  table.row(changed, method, meshes.size(), score.changed, score.subdivided,
            score.milliseconds_to_change / static_cast<double>(score.changed),
            score.milliseconds_to_subdivide / static_cast<double>(score.subdivided));
  for(const auto& [reason, count] : score.reasons)
    std::fprintf(stderr, "  %4zu: %s\n", count, reason.c_str());
}

void flip(const Table& table, const std::vector<Named_mesh>& meshes)
{
  const auto make_Delaunay = [](auto& method) { return method.make_Delaunay(); };
  run<Methods::Integer_coordinate_method>(table, "flips to Delaunay", "integer coordinates", meshes,
                                          make_Delaunay);
  run<Methods::Overlay_baseline>(table, "flips to Delaunay", "explicit overlay", meshes,
                                 make_Delaunay);
  run<Methods::Signpost_baseline>(table, "flips to Delaunay", "signposts", meshes, make_Delaunay);
}

void refine(const Table& table, const std::vector<Named_mesh>& meshes)
{
  const auto refine = [](auto& method) { return method.refine(); };
  run<Methods::Integer_coordinate_method>(table, "refinement", "integer coordinates", meshes,
                                          refine);
  run<Methods::Signpost_refinement>(table, "refinement", "signposts", meshes, refine);
}

int main(int argc, char** argv)
{
  const auto argument = [&](int i) {
    return argc > i ? static_cast<unsigned>(std::atoi(argv[i])) : 1000;
  };
  std::vector<Named_mesh> all, closed;
  for(unsigned seed = 0; seed < argument(1); ++seed) {
    all.push_back(Test_surfaces::near_degenerate_mesh(seed));
    if(seed < argument(2) && CGAL::is_closed(all.back().mesh))
      closed.push_back(all.back());
  }
  const Table table({"change", "method", "meshes", "changed", "with a common subdivision",
                     "ms for each change", "ms for each subdivision"},
                    2);
  flip(table, all);
  refine(table, closed);
}
