// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Does in C++ what calls of Python do, from the same arrays: the other side of overhead.py.
// Usage: calls ARRAYS
// ARRAYS has the numbers of vertices and faces, positions, and corners as binary 64-bit numbers.
// The program reads names of calls and numbers of repetitions. It prints the least time, in ms.

#include "reading/Polygon_soup.h"

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_surface.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/operators.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace DCM = CGAL::Discrete_conformal_maps;
namespace IS = CGAL::Intrinsic_simplification;

namespace {

typedef IT::Intrinsic_triangulation<> Triangulation;

template <class Number>
std::vector<Number> numbers(std::istream& in, std::size_t n)
{
  std::vector<Number> result(n);
  in.read(reinterpret_cast<char*>(result.data()), std::streamsize(n * sizeof(Number)));
  return result;
}

struct Arrays
{
  std::vector<Point> points;
  std::vector<std::int64_t> corners;

  explicit Arrays(const char* file)
  {
    std::ifstream in(file, std::ios::binary);
    in.exceptions(std::ios::failbit);
    const auto sizes = numbers<std::int64_t>(in, 2);
    const auto coordinates = numbers<double>(in, 3 * std::size_t(sizes[0]));
    for(std::size_t i = 0; i < coordinates.size(); i += 3)
      points.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    corners = numbers<std::int64_t>(in, 3 * std::size_t(sizes[1]));
  }

  IT::Delta_complex mesh() const
  {
    const auto triangles = Polygons::of_triangles(corners.data(), corners.data() + corners.size());
    return complex_of(points.size(), triangles).value();
  }

  auto point_map() const
  {
    return boost::make_iterator_property_map(
      points.data(), boost::typed_identity_property_map<IT::Vertex_index>());
  }

  Triangulation triangulation() const
  {
    return Triangulation(mesh(), IT::parameters::vertex_point_map(point_map()));
  }

  Triangulation Delaunay() const
  {
    Triangulation result = triangulation();
    IT::make_Delaunay(result, IT::parameters::exact_decisions(false));
    return result;
  }
};

IT::Geodesic_distances<double> distances(const Arrays& arrays, IT::Distance_method method)
{
  const Triangulation triangulation = arrays.Delaunay();
  IT::Distance_sources<Triangulation> sources(triangulation);
  sources.add(IT::Vertex_index(0));
  return IT::geodesic_distances(
    triangulation, sources,
    IT::parameters::distance_method(method).vertex_point_map(arrays.point_map()));
}

IT::Surface_path<double> path(const Arrays& arrays)
{
  const Triangulation triangulation = arrays.triangulation();
  const IT::Delta_complex& mesh = triangulation.input_mesh();
  const auto vertex = [&](unsigned v) {
    const auto h = IT::first_outgoing_halfedge(IT::Vertex_index(v), mesh);
    return IT::face_location(IT::Edge_point<double>{h, 0}, mesh);
  };
  return IT::shortest_path(triangulation.input(), vertex(0), vertex(1));
}

void simplify(const Arrays& arrays)
{
  IS::Evolving_surface surface(arrays.triangulation());
  const IS::Surface_level fine(surface);
  IS::Transport_cost cost = IS::default_cost(surface);
  IS::simplify(
    surface, cost,
    IS::parameters::number_of_vertices(1000).maximum_cost(std::numeric_limits<double>::infinity()));
  const IS::Surface_level coarse(surface);
  const IS::Surface_map map(surface, fine, coarse);
}

std::map<std::string, std::function<void()>> calls(const Arrays& arrays)
{
  const auto matrix = [&] {
    return IT::with_resolved_areas(arrays.Delaunay(), [](const auto& surface) {
      return IT::rounded_values(IT::cotan_laplacian(surface));
    });
  };
  return {
    {"delaunay", [&] { arrays.Delaunay(); }},
    {"laplacian", [matrix] { matrix(); }},
    {"exact", [&] { distances(arrays, IT::Distance_method::exact); }},
    {"heat", [&] { distances(arrays, IT::Distance_method::heat); }},
    {"path", [&] { path(arrays); }},
    {"flatten",
     [&] {
       DCM::flatten(arrays.mesh(), DCM::parameters::cones(DCM::Cones::greedy)
                                     .maximum_log_scale(5.0)
                                     .vertex_point_map(arrays.point_map()));
     }},
    {"to_sphere",
     [&] {
       DCM::map_to_sphere(arrays.mesh(), DCM::parameters::vertex_point_map(arrays.point_map()));
     }},
    {"simplify", [&] { simplify(arrays); }},
  };
}

double milliseconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc != 2)
    return 1;
  const Arrays arrays(argv[1]);
  const auto all = calls(arrays);
  int repetitions = 0;
  for(std::string name; std::cin >> name >> repetitions;) {
    double least = std::numeric_limits<double>::infinity();
    for(; repetitions > 0; --repetitions) {
      const double start = milliseconds();
      all.at(name)();
      least = std::min(least, milliseconds() - start);
    }
    std::cout << least << std::endl;
  }
}
