// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How often three ways to keep the correspondence survive flips to Delaunay on near-degenerate
// meshes, as Table 3.1 has it: the explicit overlay, signposts, and integer coordinates. The number
// of meshes can be given; meshes are those of the tests. A subdivision counts as found if its
// connectivity is that of a subdivision of T1 by curves with the connectivity of T2.

#include "../../test/Intrinsic_triangulations/near_degenerate_meshes.h"
#include "Integer_coordinate_method.h"
#include "Overlay_baseline.h"
#include "Signpost_baseline.h"
#include "measure.h"

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
  std::size_t flipped = 0, subdivided = 0;
  double milliseconds_to_flip = 0, milliseconds_to_subdivide = 0;
  std::map<std::string, std::size_t> reasons;
  std::map<std::string, std::size_t> subdivided_in_family;
};

template <typename Method>
void run(const Named_mesh& m, Score& score)
{
  Samples flip, subdivide;
  try {
    Method method{CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>(m.mesh)};
    flip.time([&] { return method.make_Delaunay(); });
    score.milliseconds_to_flip += flip.median();
    ++score.flipped;
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

template <typename Method>
Score run(const char* name, const std::vector<Named_mesh>& meshes)
{
  Score score;
  for(const Named_mesh& m : meshes)
    run<Method>(m, score);
  const double whole = static_cast<double>(meshes.size());
  std::printf("%-20s%9.1f %%%11.1f %%%13.1f%13.1f\n", name,
              100 * static_cast<double>(score.flipped) / whole,
              100 * static_cast<double>(score.subdivided) / whole,
              1000 * score.milliseconds_to_flip / static_cast<double>(score.flipped),
              1000 * score.milliseconds_to_subdivide / static_cast<double>(score.subdivided));
  for(const auto& [reason, count] : score.reasons)
    std::printf("  %4zu: %s\n", count, reason.c_str());
  return score;
}

int main(int argc, char** argv)
{
  const unsigned count = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1000;
  std::vector<Named_mesh> meshes;
  std::map<std::string, std::size_t> family_sizes;
  for(unsigned seed = 0; seed < count; ++seed) {
    meshes.push_back(Test_surfaces::near_degenerate_mesh(seed));
    ++family_sizes[meshes.back().name];
  }
  std::printf("%u meshes, microseconds per success\n", count);
  std::printf("%-20s%11s%13s%13s%13s\n", "method", "flipped", "subdivided", "us to flip",
              "us to subdiv.");
  const std::vector<Score> scores{
    run<Methods::Overlay_baseline>("explicit overlay", meshes),
    run<Methods::Signpost_baseline>("signposts", meshes),
    run<Methods::Integer_coordinate_method>("integer coordinates", meshes)};
  std::printf("\n%-28s%8s%10s%11s%10s\n", "subdivided, by family", "meshes", "overlay", "signposts",
              "integers");
  for(const auto& [family, size] : family_sizes) {
    std::printf("%-28s%8zu", family.c_str(), size);
    for(const Score& score : scores)
      std::printf("%10zu", score.subdivided_in_family.count(family)
                             ? score.subdivided_in_family.at(family)
                             : 0);
    std::printf("\n");
  }
}
