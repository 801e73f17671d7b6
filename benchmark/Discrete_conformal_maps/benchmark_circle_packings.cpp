// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Packs circles for random triangulations of the sphere. Prints how many succeed, how far circles
// at the ends of edges are from touching, steps and CPU time. Arguments are a number of
// triangulations and a greatest number of vertices. The table has a row for each kind and power of
// ten.

#include "../Table.h"
#include "random_spheres.h"

#include <CGAL/Discrete_conformal_maps/pack_circles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

// Returns the greatest difference between the distance of two centers on the sphere and the sum of
// radii, from chords of unit vectors.
double tangency_error(const DCM::Circle_packing& packing, const Mesh& mesh)
{
  double result = 0;
  for(const auto e : mesh.edges()) {
    const auto circle = [&](unsigned end) {
      return packing.spherical_circle(DCM::Vertex_index(mesh.vertex(e, end).idx()));
    };
    const auto a = circle(0), b = circle(1);
    const double chord =
      std::hypot(a.center[0] - b.center[0], a.center[1] - b.center[1], a.center[2] - b.center[2]);
    const double error = std::abs(2 * std::asin((std::min)(1., chord / 2)) - (a.angle + b.angle));
    result = error <= result ? result : error; // NaN is kept
  }
  return result;
}

// Stores the results of triangulations of a kind and size.
struct Record
{
  std::size_t number = 0, successes = 0, within = 0;
  double worst = 0;
  std::vector<std::size_t> steps;
  double seconds = 0;

  void add(const Mesh& mesh)
  {
    const std::clock_t start = std::clock();
    const DCM::Circle_packing packing = DCM::pack_circles(mesh);
    seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
    ++number;
    successes += packing.status() == DCM::Map_status::success;
    const double error = tangency_error(packing, mesh);
    within += error <= 1e-10;
    worst = error <= worst ? worst : error;
    steps.push_back(packing.minimization().iterations);
  }
};

// Returns the least power of ten that is not less than `n`.
std::size_t next_power_of_ten(std::size_t n)
{
  std::size_t result = 1;
  while(result < n)
    result *= 10;
  return result;
}

int main(int argc, char** argv)
{
  const std::size_t number = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000;
  const double greatest = argc > 2 ? std::strtod(argv[2], nullptr) : 10000;
  std::map<std::pair<std::size_t, std::size_t>, Record> records; // by kind and most vertices
  for(std::size_t i = 0; i < number; ++i) {
    CGAL::Random random(static_cast<unsigned int>(i));
    const auto n = std::size_t(4 * std::pow(greatest / 4, double(i + 1) / double(number)));
    const std::size_t kind = i % random_sphere_names.size();
    records[{kind, next_power_of_ten(n)}].add(random_sphere(kind, n, random));
  }
  const Table table({"triangulations", "up to vertices", "number", "success", "within 1e-10",
                     "greatest error", "median steps", "most steps", "seconds for all"});
  for(auto& [key, r] : records) {
    std::sort(r.steps.begin(), r.steps.end());
    Table::print({random_sphere_names[key.first],
                  Table::text((std::min)(std::size_t(greatest), key.second)), Table::text(r.number),
                  Table::text(r.successes), Table::text(r.within), Table::text(r.worst),
                  Table::text(r.steps[r.steps.size() / 2]), Table::text(r.steps.back()),
                  Table::text(r.seconds)});
  }
}
