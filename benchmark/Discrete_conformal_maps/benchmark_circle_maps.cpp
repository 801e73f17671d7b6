// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps surfaces with circles at the vertices to the plane and, if they have a negative Euler
// characteristic, to the hyperbolic plane. Radii are random parts of the greatest ones, half of the
// distance to the nearest vertex of the surface or its mirror image. In a second set, half of the
// radii are the greatest ones, so that circles touch. Each scale factor is found again from random
// starts. A search in the plane that a start leads to no map begins again at zero. Prints how many
// maps succeed, their greatest errors, and the greatest difference of scale factors by the start,
// relative to 1 + |u|. Failures are printed as they occur. Arguments are a number of starts and
// files of meshes. The table has a row for the surfaces of each family, which precedes the number
// in the name of a file.

#include "../Table.h"

#include <CGAL/Discrete_conformal_maps/cross_ratios.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Hyperbolic_scale_factors.h>
#include <CGAL/Discrete_conformal_maps/uniformize_hyperbolic.h>

#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace DCM = CGAL::Discrete_conformal_maps;

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef std::vector<double> Numbers;
typedef std::vector<DCM::Vertex_condition> Conditions;

template <typename Values>
auto as_map(const Values& values)
{
  return boost::make_function_property_map<Mesh::Vertex_index>(
    [&values](Mesh::Vertex_index v) { return values[v.idx()]; });
}

// Returns conditions on the boundary, and zero curvature inside.
Conditions conditions(const Mesh& mesh, const DCM::Vertex_condition& on_boundary)
{
  Conditions result;
  for(const Mesh::Vertex_index v : mesh.vertices())
    result.push_back(mesh.is_border(v) ? on_boundary : DCM::Vertex_condition::curvature(0));
  return result;
}

DCM::internal::Doubled_problem hyperbolic_problem(const Mesh& mesh, DCM::internal::Exactness exact,
                                                  const Numbers& radii = {})
{
  return DCM::internal::Doubled_problem(
    IT::Intrinsic_triangulation<>(mesh), conditions(mesh, DCM::Vertex_condition::curvature(0)),
    DCM::Flipping::to_Delaunay, exact, DCM::internal::Vertex_circles(radii));
}

// ---- Radii ----

// Returns half of the distances to the nearest vertices, by the exact Delaunay triangulation.
Numbers greatest_radii(const Mesh& mesh)
{
  const auto problem = hyperbolic_problem(mesh, DCM::internal::Exactness::lengths);
  const auto& t = problem.triangulation();
  const auto length = problem.lengths<double>(t);
  Numbers result(mesh.number_of_vertices(), std::numeric_limits<double>::infinity());
  for(const IT::Edge_index e : t.mesh().edges())
    for(const unsigned end : {0u, 1u}) {
      double& r = result[problem.original(t.mesh().vertex(e, end)).idx()];
      r = (std::min)(r, get(length, e) / 2);
    }
  return result;
}

Numbers random_radii(const Numbers& greatest, bool do_touch)
{
  Numbers result = greatest;
  std::mt19937 random(static_cast<unsigned>(greatest.size()));
  std::uniform_real_distribution<double> part(0, 1);
  for(double& r : result) {
    const bool is_greatest = random() % 2 == 0 && do_touch;
    const double p = part(random);
    r = !std::isfinite(r) ? 0 : is_greatest ? r : p * r;
  }
  return result;
}

// ---- Maps ----

struct Outcome
{
  std::string status;
  double curvature = 0, cross_ratio = 0, difference = 0;
  std::size_t starts = 0; // that led to a map
};

template <typename Map>
Numbers log_scales(const Map& map, std::size_t n)
{
  Numbers result;
  for(std::size_t v = 0; v < n; ++v)
    result.push_back(map.log_scale(IT::Vertex_index(IT::Delta_complex::size_type(v))));
  return result;
}

// Records that another start has led to the scale factors `v`.
void compare(const Numbers& u, const Numbers& v, Outcome& outcome)
{
  ++outcome.starts;
  for(std::size_t i = 0; i < u.size(); ++i) {
    const double difference = std::abs(u[i] - v[i]) / (1 + std::abs(u[i]));
    if(!(difference <= outcome.difference)) // NaN is kept
      outcome.difference = difference;
  }
}

Numbers random_start(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-2, 2);
  Numbers result(n);
  for(double& u : result)
    u = number(random);
  return result;
}

// Flattens a surface, and again from random starts with the cones of the first map.
Outcome flatten(const Mesh& mesh, const Numbers& radii, unsigned starts)
{
  const auto first = DCM::flatten(mesh, DCM::parameters::vertex_radius_map(as_map(radii)));
  Outcome result{to_string(first.status()), first.max_curvature_error(),
                 DCM::max_cross_ratio_error(first)};
  Conditions with_cones = conditions(mesh, DCM::Vertex_condition::log_scale(0));
  for(const IT::Vertex_index v : first.cones())
    with_cones[v.idx()] = DCM::Vertex_condition::log_scale(0);
  for(unsigned seed = 1; seed <= starts && first.status() == DCM::Map_status::success; ++seed) {
    const Numbers start = random_start(radii.size(), seed);
    const auto map = DCM::flatten(mesh, DCM::parameters::vertex_radius_map(as_map(radii))
                                          .vertex_condition_map(as_map(with_cones))
                                          .initial_log_scale_map(as_map(start)));
    if(map.status() == DCM::Map_status::success)
      compare(log_scales(first, radii.size()), log_scales(map, radii.size()), result);
  }
  return result;
}

// Returns random variables for which circles lie in the hyperbolic plane.
Numbers hyperbolic_start(const DCM::internal::Doubled_problem& problem, const Numbers& radii,
                         unsigned seed)
{
  const Eigen::VectorXd middle = DCM::internal::hyperbolic_start(problem);
  Numbers result = random_start(radii.size(), seed);
  for(std::size_t v = 0; v < radii.size(); ++v) {
    result[v] += middle[Eigen::Index(v)];
    if(radii[v] > 0)
      result[v] = (std::min)(result[v], -std::log(1.1 * radii[v]));
  }
  return result;
}

Outcome uniformize(const Mesh& mesh, const Numbers& radii, unsigned starts)
{
  const auto first =
    DCM::uniformize_hyperbolic(mesh, DCM::parameters::vertex_radius_map(as_map(radii)));
  Outcome result{to_string(first.status()), first.max_curvature_error()};
  for(unsigned seed = 1; seed <= starts && first.status() == DCM::Map_status::success; ++seed) {
    auto problem = hyperbolic_problem(mesh, DCM::internal::Exactness::none, radii);
    DCM::internal::Hyperbolic_scale_factors scale(problem);
    scale.start_from(hyperbolic_start(problem, radii, seed));
    DCM::Default_flattening_visitor silent;
    auto visitor = DCM::internal::Any_visitor::of(silent);
    scale.minimize(DCM::Newton_minimizer(), DCM::internal::tolerance::curvature, visitor);
    const Eigen::VectorXd u = scale.values();
    if(scale.status() == DCM::Map_status::success)
      compare(log_scales(first, radii.size()), Numbers(u.begin(), u.end()), result);
  }
  return result;
}

// ---- Table ----

// Stores the results of all surfaces of a family, for one target and kind of radii.
struct Record
{
  std::size_t maps = 0, successes = 0, within = 0, unique = 0;
  double curvature = 0, cross_ratio = 0, difference = 0, seconds = 0;

  void add(const Outcome& outcome, unsigned starts)
  {
    ++maps;
    if(outcome.status != to_string(DCM::Map_status::success))
      return;
    ++successes;
    within += outcome.curvature <= 1e-10;
    unique += outcome.starts == starts && outcome.difference <= 1e-8;
    curvature = (std::max)(curvature, outcome.curvature);
    cross_ratio = (std::max)(cross_ratio, outcome.cross_ratio);
    difference = (std::max)(difference, outcome.difference);
  }
};

typedef std::array<std::string, 3> Key; // family, target and radii

std::string family_of(const std::string& file)
{
  const std::string name = name_of(file);
  const std::size_t end = name.find_last_of('_');
  const bool is_numbered =
    end != std::string::npos && name.find_first_not_of("0123456789", end + 1) == std::string::npos;
  return is_numbered ? name.substr(0, end) : "others";
}

template <typename Find>
void measure(const std::string& file, const Key& key, unsigned starts, const Find& find,
             std::map<Key, Record>& records)
{
  Outcome outcome;
  const std::clock_t start = std::clock();
  try {
    outcome = find();
  } catch(const IT::Error& error) {
    outcome.status = error.what();
  }
  Record& record = records[key];
  record.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
  const std::size_t before = record.unique;
  record.add(outcome, starts);
  if(record.unique == before)
    std::printf("%s, %s, %s: %s, %zu starts, difference %.1e\n", file.c_str(), key[1].c_str(),
                key[2].c_str(), outcome.status.c_str(), outcome.starts, outcome.difference);
}

void measure(const std::string& file, unsigned starts, std::map<Key, Record>& records)
{
  Mesh mesh;
  if(!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(file, mesh) ||
     mesh.number_of_faces() == 0)
    return void(std::printf("%s cannot be read\n", file.c_str()));
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  const bool is_negative =
    mesh.number_of_vertices() + mesh.number_of_faces() < mesh.number_of_edges();
  const Numbers greatest = greatest_radii(mesh);
  for(const bool do_touch : {false, true}) {
    const Numbers radii = random_radii(greatest, do_touch);
    const std::string family = family_of(file), kind = do_touch ? "touching" : "random";
    measure(
      file, {family, "plane", kind}, starts, [&] { return flatten(mesh, radii, starts); }, records);
    if(is_negative)
      measure(
        file, {family, "hyperbolic plane", kind}, starts,
        [&] { return uniformize(mesh, radii, starts); }, records);
  }
}

int main(int argc, char** argv)
{
  const auto starts = static_cast<unsigned>(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 0);
  std::map<Key, Record> records;
  for(int i = 2; i < argc; ++i)
    measure(argv[i], starts, records);
  const Table table({"surfaces", "target", "radii", "maps", "success", "within 1e-10", "unique",
                     "greatest curvature", "cross-ratio error", "difference by starts", "seconds"},
                    3);
  for(const auto& [key, r] : records)
    table.row(key[0], key[1], key[2], r.maps, r.successes, r.within, r.unique, r.curvature,
              r.cross_ratio, r.difference, r.seconds);
}
