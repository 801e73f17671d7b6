// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Where the time of flattening goes, in seconds of CPU time, and how it grows: with the number of vertices to
// the power printed last. Arguments are names of meshes, or numbers of vertices of the largest spheres and tori
// to be generated.

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;

// ---- Surfaces ----

// An m times n grid over the torus; `place` takes the angles.
template <typename Place>
Mesh torus(unsigned m, unsigned n, const Place& place)
{
  Mesh mesh;
  mesh.reserve(m * n, 3 * m * n, 2 * m * n);
  for(unsigned i = 0; i < m; ++i)
    for(unsigned j = 0; j < n; ++j)
      mesh.add_vertex(place(2 * CGAL_PI * i / m, 2 * CGAL_PI * j / n));
  const auto vertex = [&](unsigned i, unsigned j) { return Mesh::Vertex_index(i % m * n + j % n); };
  for(unsigned i = 0; i < m; ++i)
    for(unsigned j = 0; j < n; ++j) {
      mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
      mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  return mesh;
}

// with bumps
Mesh torus(unsigned vertices)
{
  const auto n = static_cast<unsigned>(std::sqrt(vertices / 3.));
  return torus(3 * n, n, [](double s, double t) {
    const double r = 1 + 0.2 * std::sin(5 * s) * std::cos(3 * t);
    return Point((3 + r * std::cos(t)) * std::cos(s), (3 + r * std::cos(t)) * std::sin(s),
                 r * std::sin(t));
  });
}

// The sides of a cube, n times n squares each, blown up to a sphere with bumps.
class Sphere
{
public:
  explicit Sphere(unsigned vertices) : m_size(static_cast<unsigned>(std::sqrt(vertices / 6.)))
  {
    m_number.assign((m_size + 1) * (m_size + 1) * 6, Mesh::null_vertex());
    for(unsigned side = 0; side < 6; ++side)
      for(unsigned i = 0; i < m_size; ++i)
        for(unsigned j = 0; j < m_size; ++j)
          add_square(side, i, j);
  }

  const Mesh& mesh() const { return m_mesh; }

private:
  typedef std::array<unsigned, 3> Place; // on the surface of a cube of `m_size` steps

  Place place(unsigned side, unsigned i, unsigned j) const
  {
    const unsigned axis = side / 2;
    Place p{};
    p[axis] = side % 2 == 0 ? 0 : m_size;
    p[(axis + 1) % 3] = side % 2 == 0 ? j : i;
    p[(axis + 2) % 3] = side % 2 == 0 ? i : j;
    return p;
  }

  Mesh::Vertex_index vertex(unsigned side, unsigned i, unsigned j)
  {
    const Place p = place(side, i, j);
    // the first side on which the place lies
    unsigned first = 0;
    while(p[first / 2] != (first % 2 == 0 ? 0 : m_size))
      ++first;
    Mesh::Vertex_index& v =
      m_number[(first * (m_size + 1) + p[(first / 2 + 1) % 3]) * (m_size + 1) +
               p[(first / 2 + 2) % 3]];
    if(v == Mesh::null_vertex())
      v = m_mesh.add_vertex(blown_up(p));
    return v;
  }

  Point blown_up(const Place& p) const
  {
    std::array<double, 3> x;
    for(unsigned k = 0; k < 3; ++k)
      x[k] = std::tan(CGAL_PI / 4 * (2. * p[k] / m_size - 1));
    const double norm = std::hypot(x[0], x[1], x[2]);
    const double r = (1 + 0.1 * std::sin(9 * x[0] / norm) * std::sin(8 * x[1] / norm)) / norm;
    return Point(r * x[0], r * x[1], r * x[2]);
  }

  void add_square(unsigned side, unsigned i, unsigned j)
  {
    const auto a = vertex(side, i, j), b = vertex(side, i + 1, j), c = vertex(side, i + 1, j + 1),
               d = vertex(side, i, j + 1);
    m_mesh.add_face(a, b, c);
    m_mesh.add_face(a, c, d);
  }

  unsigned m_size;
  std::vector<Mesh::Vertex_index> m_number;
  Mesh m_mesh;
};

// ---- Times ----

constexpr std::size_t number_of_stages = 5;

struct Stopwatch : DCM::Default_flattening_visitor
{
  std::array<double, number_of_stages + 1> seconds{}; // the last before the first stage
  std::size_t stage = number_of_stages;
  std::clock_t since = std::clock();

  void start(DCM::Flattening_stage next)
  {
    stop();
    stage = static_cast<std::size_t>(next);
  }
  void stop()
  {
    const std::clock_t now = std::clock();
    seconds[stage] += double(now - since) / CLOCKS_PER_SEC;
    since = now;
  }
  double total() const
  {
    double sum = 0;
    for(double s : seconds)
      sum += s;
    return sum;
  }
};

double benchmark(const std::string& name, const Mesh& mesh)
{
  Stopwatch watch;
  const DCM::Planar_conformal_map map =
    DCM::flatten(mesh, CGAL::parameters::visitor(std::ref(watch)));
  watch.stop();
  std::printf("%-20s%9u%7zu%6d%9.3f", name.c_str(), mesh.number_of_vertices(), map.cones().size(),
              map.minimization().iterations, watch.seconds[number_of_stages]);
  for(std::size_t s = 0; s < number_of_stages; ++s)
    std::printf("%9.3f", watch.seconds[s]);
  std::printf("%9.3f%9.1e", watch.total(), map.max_curvature_error());
  return watch.total();
}

// ever larger surfaces
template <typename Make>
void benchmark_growth(const char* name, unsigned largest, const Make& make)
{
  double last_time = 0, last_size = 0;
  for(unsigned n = largest / 64; n <= largest; n *= 4) {
    const Mesh mesh = make(n);
    const double time = benchmark(name, mesh), size = mesh.number_of_vertices();
    if(last_time > 0)
      std::printf("%9.2f", std::log(time / last_time) / std::log(size / last_size));
    std::printf("\n");
    std::fflush(stdout);
    last_time = time;
    last_size = size;
  }
}

void benchmark_file(const std::string& file)
{
  Mesh mesh;
  if(!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::printf("%s: cannot be read\n", file.c_str());
    return;
  }
  benchmark(file.substr(file.find_last_of('/') + 1), mesh);
  std::printf("\n");
  std::fflush(stdout);
}

int main(int argc, char** argv)
{
  std::printf("%-20s%9s%7s%6s%9s%9s%9s%9s%9s%9s%9s%9s%9s\n", "mesh", "vertices", "cones", "steps",
              "Delaunay", "cones", "optimize", "trace", "subdiv.", "layout", "total", "error",
              "growth");
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if(arguments.empty()) {
    for(const char* name : {"cow", "camel", "armadillo", "bunny00"})
      arguments.push_back(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    arguments.push_back("100000");
  }
  for(const std::string& argument : arguments)
    if(const int largest = std::atoi(argument.c_str()); largest > 0) {
      benchmark_growth("sphere", unsigned(largest), [](unsigned n) { return Sphere(n).mesh(); });
      benchmark_growth("torus", unsigned(largest), [](unsigned n) { return torus(n); });
    } else
      benchmark_file(argument);
}
