// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures how often scale factors exist with flips, and in the triangulation of the input (Figure
// 4.20). It uses near-degenerate meshes, with cones of the greedy choice, and hard cones. Both
// methods get the same cones. Arguments are the numbers of meshes and of sets of cones, by default
// the numbers of the tests.

#include "../../test/Discrete_conformal_maps/hard_cones.h"
#include "../Intrinsic_triangulations/measure.h"
#include "../Table.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <vector>

using namespace Test_surfaces;
namespace DCM = CGAL::Discrete_conformal_maps;
using Conditions = std::vector<DCM::Vertex_condition>;

// Counts the outcomes of one method.
struct Score
{
  std::size_t refused = 0;
  std::array<std::size_t, 5> ended{}; // by status
  double milliseconds = 0;            // of all

  std::size_t ended_with(DCM::Map_status status) const
  {
    return ended[static_cast<std::size_t>(status)];
  }
};

struct Scores
{
  std::size_t problems = 0;
  Score with_flips, fixed;
};

// Returns the map, or nothing if the input is rejected.
template <typename NamedParameters>
std::optional<DCM::Planar_conformal_map> flatten(const Mesh& mesh, const NamedParameters& np,
                                                 Score& score)
{
  try {
    Samples samples;
    auto map = samples.time([&] { return DCM::flatten(mesh, np); });
    score.milliseconds += samples.median();
    ++score.ended[static_cast<std::size_t>(map.status())];
    return map;
  } catch(const CGAL::Intrinsic_triangulations::Error&) {
    ++score.refused;
    return std::nullopt;
  }
}

// `conditions` must outlive the result.
auto fixed_with(const Conditions& conditions)
{
  const auto map =
    boost::make_function_property_map<Vertex_index>([&](Vertex_index v) { return conditions[v]; });
  return DCM::parameters::flipping(DCM::Flipping::none).vertex_condition_map(map);
}

void run_near_degenerate(unsigned int seed, std::map<std::string, Scores>& table)
{
  const Named_mesh m = near_degenerate_mesh(seed);
  Scores& scores = table[m.name];
  ++scores.problems;
  Conditions conditions(m.mesh.number_of_vertices());
  for(Vertex_index v : m.mesh.vertices())
    if(m.mesh.is_border(v))
      conditions[v] = DCM::Vertex_condition::log_scale(0);
  if(const auto map = flatten(m.mesh, CGAL::parameters::default_values(), scores.with_flips))
    for(Vertex_index v : map->cones())
      conditions[v] = DCM::Vertex_condition::log_scale(0);
  flatten(m.mesh, fixed_with(conditions), scores.fixed);
}

void run_hard_cones(unsigned int seed, std::map<std::string, Scores>& table)
{
  const unsigned int genus = seed % 5;
  const Mesh mesh = coarse_surface(genus, seed);
  Scores& scores = table["hard cones, genus " + std::to_string(genus)];
  ++scores.problems;
  Conditions conditions;
  for(double defect : hard_cones(mesh, seed))
    conditions.push_back(DCM::Vertex_condition::curvature(defect));
  const auto map =
    boost::make_function_property_map<Vertex_index>([&](Vertex_index v) { return conditions[v]; });
  flatten(mesh, DCM::parameters::vertex_condition_map(map), scores.with_flips);
  flatten(mesh, fixed_with(conditions), scores.fixed);
}

void print(const Table& table, const std::string& name, const Scores& s)
{
  using Status = DCM::Map_status;
  const auto each = [&](const Score& score) { return score.milliseconds / double(s.problems); };
  table.row(name, s.problems, s.with_flips.ended_with(Status::success), each(s.with_flips),
            s.fixed.ended_with(Status::success), each(s.fixed),
            s.fixed.ended_with(Status::triangle_inequality), s.fixed.ended_with(Status::no_minimum),
            s.fixed.ended_with(Status::not_converged), s.fixed.refused);
}

int main(int argc, char** argv)
{
  const auto argument = [&](int i, unsigned int otherwise) {
    return argc > i ? static_cast<unsigned int>(std::atoi(argv[i])) : otherwise;
  };
  std::map<std::string, Scores> table;
  for(unsigned int seed = 0; seed < argument(1, 120); ++seed)
    run_near_degenerate(seed, table);
  for(unsigned int seed = 0; seed < argument(2, 150); ++seed)
    run_hard_cones(seed, table);
  const Table out({"problem", "maps", "found with flips", "ms for each",
                   "found in a fixed triangulation", "ms for each", "triangle inequality",
                   "no minimum", "not converged", "refused"});
  for(const auto& [name, scores] : table)
    print(out, name, scores);
}
