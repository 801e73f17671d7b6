// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How often three ways to keep the correspondence survive flips to Delaunay, and refinement, on
// near-degenerate meshes, as Table 3.1 has it: the explicit overlay, which cannot be refined,
// signposts, and integer coordinates. Refined are meshes without boundary. The number of meshes can
// be given; meshes are those of the tests. A subdivision counts as found if its connectivity is
// that of a subdivision of T1 by curves with the connectivity of T2.

#include "../../test/Intrinsic_triangulations/near_degenerate_meshes.h"
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

// What happened to one method.
struct Score
{
  std::size_t changed = 0, subdivided = 0;
  double milliseconds_to_change = 0, milliseconds_to_subdivide = 0;
  std::map<std::string, std::size_t> reasons;
  std::map<std::string, std::size_t> subdivided_in_family;
};

// `change(method)` flips or refines.
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
    ++score.subdivided_in_family[m.name];
  } catch(const Methods::Failure& failure) {
    ++score.reasons[failure.what()];
  } catch(const CGAL::Intrinsic_triangulations::Error& error) {
    ++score.reasons[error.what()];
  }
}

template <typename Method, typename Change>
Score run(const char* name, const std::vector<Named_mesh>& meshes, const Change& change)
{
  Score score;
  for(const Named_mesh& m : meshes)
    run<Method>(m, change, score);
  const double whole = static_cast<double>(meshes.size());
  std::printf("%-20s%9.1f %%%11.1f %%%13.1f%13.1f\n", name,
              100 * static_cast<double>(score.changed) / whole,
              100 * static_cast<double>(score.subdivided) / whole,
              1000 * score.milliseconds_to_change / static_cast<double>(score.changed),
              1000 * score.milliseconds_to_subdivide / static_cast<double>(score.subdivided));
  for(const auto& [reason, count] : score.reasons)
    std::printf("  %4zu: %s\n", count, reason.c_str());
  return score;
}

// The last score is that of the integer coordinates.
void print_families(const std::vector<Named_mesh>& meshes, const std::vector<const char*>& names,
                    const std::vector<Score>& scores)
{
  std::map<std::string, std::size_t> sizes;
  for(const Named_mesh& m : meshes)
    ++sizes[m.name];
  std::printf("\n%-28s%8s", "subdivided, by family", "meshes");
  for(const char* name : names)
    std::printf("%11s", name);
  for(const auto& [family, size] : sizes) {
    std::printf("\n%-28s%8zu", family.c_str(), size);
    for(const Score& score : scores)
      std::printf("%11zu", score.subdivided_in_family.count(family)
                             ? score.subdivided_in_family.at(family)
                             : 0);
  }
  std::printf("\n\n");
}

void print_head(std::size_t count, const char* change)
{
  std::printf("%zu meshes, microseconds per success\n%-20s%11s%13s%13s%13s\n", count, "method",
              change, "subdivided", "us for that", "us to subdiv.");
}

void flip(const std::vector<Named_mesh>& meshes)
{
  const auto make_Delaunay = [](auto& method) { return method.make_Delaunay(); };
  print_head(meshes.size(), "flipped");
  print_families(
    meshes, {"overlay", "signposts", "integers"},
    {run<Methods::Overlay_baseline>("explicit overlay", meshes, make_Delaunay),
     run<Methods::Signpost_baseline>("signposts", meshes, make_Delaunay),
     run<Methods::Integer_coordinate_method>("integer coordinates", meshes, make_Delaunay)});
}

void refine(const std::vector<Named_mesh>& meshes)
{
  const auto refine = [](auto& method) { return method.refine(); };
  print_head(meshes.size(), "refined");
  print_families(meshes, {"signposts", "integers"},
                 {run<Methods::Signpost_refinement>("signposts", meshes, refine),
                  run<Methods::Integer_coordinate_method>("integer coordinates", meshes, refine)});
}

int main(int argc, char** argv)
{
  const unsigned count = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1000;
  std::vector<Named_mesh> all, closed;
  for(unsigned seed = 0; seed < count; ++seed) {
    all.push_back(Test_surfaces::near_degenerate_mesh(seed));
    if(CGAL::is_closed(all.back().mesh))
      closed.push_back(all.back());
  }
  flip(all);
  refine(closed);
}
