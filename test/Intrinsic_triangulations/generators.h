// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_GENERATORS_H
#define INTRINSIC_TRIANGULATIONS_TEST_GENERATORS_H

#include "testing.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <CGAL/boost/graph/iterator.h>

#include <system_error>

// This file generates small surfaces for tests, all from a seed.
namespace Test_surfaces {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Vertex_index;

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangles = std::vector<std::array<std::size_t, 3>>;
const double pi = std::acos(-1.);

// ---- Embedded meshes ----

Mesh make_mesh(const std::vector<Point>& points, const Triangles& triangles);

Mesh tetrahedron();

Mesh octahedron();

// Returns the unit square.
Mesh square();

// Returns a cube with two triangles for each side.
Mesh cube();

// Returns the faces of a mesh by the indices of their corners in `points`, in increasing order.
template <typename P>
Triangles sorted_triangles(const CGAL::Surface_mesh<P>& mesh, const std::vector<P>& points)
{
  std::map<P, std::size_t> number;
  for(std::size_t n = 0; n < points.size(); ++n)
    number.emplace(points[n], n);
  Triangles result;
  for(auto f : mesh.faces()) {
    std::array<std::size_t, 3> corner;
    auto c = corner.begin();
    for(auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      *c++ = number.at(mesh.point(v));
    std::rotate(corner.begin(), std::min_element(corner.begin(), corner.end()), corner.end());
    result.push_back(corner);
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Returns the convex hull of points. Its elements have the order of the points, not the order in
// which CGAL finds them, which depends on addresses.
Mesh convex_hull(const std::vector<Point>& points);

// Returns the convex hull of random points on the unit sphere.
Mesh random_sphere(std::size_t n, unsigned int seed);

// Returns a ring of n points between two apexes, or a disk with two sides for height 0.
Mesh bipyramid(std::size_t n, double height);

// Returns m times n squares, each cut in two. The vertices have the numbers 0, 1, ..., n, ... row
// by row. The last rows or columns are joined to the first if these are closed.
Triangles lattice(std::size_t m, std::size_t n, bool has_closed_columns = false,
                  bool has_closed_rows = false);

Mesh grid(std::size_t m, std::size_t n, const std::function<Point(double, double)>& place);

Mesh embedded_torus(std::size_t m, std::size_t n);

Mesh perturbed(Mesh mesh, double amount, unsigned int seed);

// Returns the surface of a plate of square blocks with a row of square holes, whose number is the
// genus. The blocks between the holes are `strut` wide, the holes 1: small struts make it a wire
// frame.
Mesh frame(std::size_t holes, double strut);

// Returns the plate made of cubes.
Mesh straight_plate_with_holes(int genus);

// Returns that mesh slightly distorted.
Mesh plate_with_holes(int genus);

// Returns two spheres, a torus, and a separate point.
Mesh four_components();

// Returns these components and a disk.
Mesh five_components();

// Returns the mesh without the given faces. Each face leaves one boundary loop if they are apart.
Mesh punctured(Mesh mesh, const std::vector<std::size_t>& faces);

// ---- Delta-complexes ----

// Stores sides of triangles: 1, 2, ... are edges, -1, -2, ... the same edges backwards.
using Sides = std::vector<std::array<int, 3>>;

Halfedge_index halfedge_of(int side);

void close_border(Delta_complex& mesh);

void add_vertices(Delta_complex& mesh);

// Glues triangles along equal labels; halfedge_of(side) is the halfedge of a label.
Delta_complex glue(const Sides& faces);

// Returns one triangle with two sides glued: a disk with a vertex of degree 1 inside.
Delta_complex cone(bool mirrored);

// Returns two cones: a sphere with two vertices of degree 1 and one of degree 4.
inline Delta_complex spindle() { return glue({{1, -1, 2}, {-2, -3, 3}}); }

// Returns a disk with an interior vertex of degree 2 and two boundary edges.
inline Delta_complex bigon() { return glue({{1, 2, 3}, {-1, 4, -2}}); }

// Returns an octagon with its sides glued to the surface of genus 2 with one vertex.
Delta_complex double_torus();

// ---- Points of faces ----

using Location = IT::Face_location<double>;

std::array<double, 3> random_coordinates(CGAL::Random& random);

template <typename Index, typename Random>
Index random_index(std::size_t count, Random& random)
{
  return Index(static_cast<Delta_complex::size_type>(random.get_int(0, static_cast<int>(count))));
}

template <typename Random>
Halfedge_index random_halfedge(const Delta_complex& mesh, Random& random)
{
  return random_index<Halfedge_index>(mesh.number_of_halfedges(), random);
}

template <typename Random>
Vertex_index random_vertex(const Delta_complex& mesh, Random& random)
{
  return random_index<Vertex_index>(mesh.number_of_vertices(), random);
}

Location random_location(const Delta_complex& mesh, CGAL::Random& random);

// Returns a point in a face of a triangulation whose vertex v is at `position(v)`.
template <typename Any_mesh, typename Position>
Point place_in_space(const Location& p, const Any_mesh& mesh, const Position& position)
{
  Kernel::Vector_3 sum(0, 0, 0);
  Halfedge_index h = mesh.halfedge(p.first);
  for(double weight : p.second) {
    sum = sum + weight * (position(mesh.source(h)) - CGAL::ORIGIN);
    h = mesh.next(h);
  }
  return CGAL::ORIGIN + sum;
}

Point place_in_space(const Location& p, const Delta_complex& mesh, const Mesh& positions);

Point place_in_space(const Location& p, const Mesh& mesh);

// ---- Random numbers ----

std::vector<double> random_values(std::size_t n, double bound, unsigned int seed);

// Returns lengths between 1 and 1.9, so that no triangle inequality can fail.
std::vector<double> random_lengths(const Delta_complex& mesh, unsigned int seed);

template <typename Traits = IT::Euclidean_geometry_traits<>>
IT::Intrinsic_triangulation<Traits> triangulation(const Delta_complex& mesh,
                                                  const std::vector<double>& lengths)
{
  const auto map =
    boost::make_function_property_map<Edge_index>([&](Edge_index e) { return lengths[e.idx()]; });
  return IT::Intrinsic_triangulation<Traits>(mesh, IT::parameters::edge_length_map(map));
}

// Flips what can be flipped, and returns it.
template <typename Traits>
std::vector<Halfedge_index> random_flips(IT::Intrinsic_triangulation<Traits>& t, std::size_t tries,
                                         unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Halfedge_index> result;
  for(std::size_t i = 0; i < tries; ++i) {
    const Halfedge_index h = random_halfedge(t.mesh(), random);
    if(!t.is_flippable(h))
      continue;
    t.flip(h);
    result.push_back(h);
  }
  return result;
}

// ---- Flat surfaces with exact coordinates ----

struct Vector
{
  std::int64_t x, y;

  friend Vector operator+(const Vector& v, const Vector& w) { return {v.x + w.x, v.y + w.y}; }
  friend Vector operator-(const Vector& v, const Vector& w) { return {v.x - w.x, v.y - w.y}; }
  friend Vector operator-(const Vector& v) { return {-v.x, -v.y}; }
  friend Vector operator*(std::int64_t s, const Vector& v) { return {s * v.x, s * v.y}; }
  friend bool operator==(const Vector& v, const Vector& w) { return v.x == w.x && v.y == w.y; }
  friend std::int64_t dot(const Vector& v, const Vector& w) { return v.x * w.x + v.y * w.y; }
  friend std::int64_t det(const Vector& v, const Vector& w) { return v.x * w.y - v.y * w.x; }
};

std::complex<double> complex(const Vector& v);

inline double length(const Vector& v) { return std::sqrt(static_cast<double>(dot(v, v))); }

// Represents a triangulation of a part of the plane modulo the lattice of a and b. A lattice wider
// than this part changes nothing.
struct Flat_surface
{
  Delta_complex mesh;
  std::vector<Vector> vector; // of each halfedge
  std::vector<Vector> point;  // a lift of each vertex
  Vector a, b;

  std::vector<double> lengths() const
  {
    std::vector<double> result;
    for(Edge_index e : mesh.edges())
      result.push_back(length(vector[mesh.halfedge(e)]));
    return result;
  }
};

template <typename Traits = IT::Euclidean_geometry_traits<>>
IT::Intrinsic_triangulation<Traits> triangulation(const Flat_surface& surface)
{
  return triangulation<Traits>(surface.mesh, surface.lengths());
}

constexpr std::int64_t beyond = 1 << 20; // all planar coordinates

// Returns a flat surface, where `place(label)` is the pair of end points of an edge.
template <typename Place>
Flat_surface flat_surface(const Sides& sides, const Place& place, const Vector& a, const Vector& b)
{
  Flat_surface result{glue(sides), {}, {}, a, b};
  const Delta_complex& mesh = result.mesh;
  result.vector.resize(mesh.number_of_halfedges());
  result.point.resize(mesh.number_of_vertices());
  for(int label = 1; label <= static_cast<int>(mesh.number_of_edges()); ++label) {
    const auto [source, target] = place(label);
    const Halfedge_index h = halfedge_of(label), o = mesh.opposite(h);
    result.vector[h] = target - source;
    result.vector[o] = source - target;
    result.point[mesh.source(h)] = source;
    result.point[mesh.target(h)] = target;
  }
  return result;
}

// Returns m times n cells, each cut in two, with corners moved at random.
Flat_surface flat_torus(int m, int n, unsigned int seed, const Vector& right = {1000, 130},
                        const Vector& up = {-270, 900});

// Returns a cylinder with n points on each boundary; the edges across wind around it `twists`
// times. No four points that could be neighbors are on a circle.
Flat_surface flat_cylinder(int n, int twists, int height = 700);

// Returns the length of the shortest of the vectors that differ from this one by a few lattice
// vectors.
double shortest_lift(const Vector& v, const Flat_surface& s);

// Adds the points from left to right and joins each to all it sees: long slivers.
Triangles swept_triangles(const std::vector<Vector>& points);

// Returns points with different x from left to right, the first three not collinear.
std::vector<Vector> random_points(std::size_t n, int size, unsigned int seed);

Flat_surface flat_surface(const std::vector<Vector>& points, const Triangles& triangles);

Flat_surface flat_polygon(const std::vector<Vector>& points);

// Returns a planar mesh in space that keeps the order of the points.
Mesh planar_mesh(const std::vector<Vector>& points);

// ---- Angles and areas, by textbook formulas from the lengths once more ----

// Maps, vectors and functions of edges can be lengths.
template <typename Length>
long double length_of(Edge_index e, const Length& length)
{
  if constexpr(std::is_invocable_v<const Length&, Edge_index>)
    return length(e);
  else
    return length[e];
}

// Returns the angle at the source of `h`, or 0 or pi if rounding has made the face more than flat.
template <typename Length>
double angle_at(Halfedge_index h, const Delta_complex& mesh, const Length& length)
{
  const long double a = length_of(mesh.edge(h), length),
                    b = length_of(mesh.edge(mesh.prev(h)), length),
                    c = length_of(mesh.edge(mesh.next(h)), length);
  return static_cast<double>(
    std::acos(std::clamp((a * a + b * b - c * c) / (2 * a * b), -1.L, 1.L)));
}

// Returns the angle sum at each vertex.
template <typename Length>
std::vector<double> angle_sums(const Delta_complex& mesh, const Length& length)
{
  std::vector<double> result(mesh.num_vertices(), 0);
  for(Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      result[mesh.source(h)] += angle_at(h, mesh, length);
  return result;
}

// Returns the area by Heron's formula in Kahan's form.
long double area_of_triangle(std::array<long double, 3> l);

template <typename Length>
double area_of(Face_index f, const Delta_complex& mesh, const Length& length)
{
  const auto [a, b, c] = IT::sides(f, mesh);
  return static_cast<double>(
    area_of_triangle({length_of(mesh.edge(a), length), length_of(mesh.edge(b), length),
                      length_of(mesh.edge(c), length)}));
}

template <typename Length>
double area_of(const Delta_complex& mesh, const Length& length)
{
  double sum = 0;
  for(Face_index f : mesh.faces())
    sum += area_of(f, mesh, length);
  return sum;
}

// ---- Counts ----

template <typename Any_mesh>
int Euler_characteristic(const Any_mesh& mesh)
{
  return static_cast<int>(mesh.number_of_vertices()) - static_cast<int>(mesh.number_of_edges()) +
         static_cast<int>(mesh.number_of_faces());
}

// Returns the area of a flat polygon, which need not be convex.
double polygon_area(Face_index f, const Mesh& mesh);

template <typename Any_mesh>
std::int64_t number_of_border_edges(const Any_mesh& mesh)
{
  const auto e = mesh.edges();
  return std::count_if(e.begin(), e.end(), [&](Edge_index x) { return mesh.is_border(x); });
}

bool has_border(const Delta_complex& mesh);

std::size_t border_loops(const Delta_complex& mesh);

// Whether vertices determine edges and faces, by the definition: sets of vertices, all different.
template <typename Any_mesh>
bool has_distinct_simplices(const Any_mesh& mesh)
{
  std::set<std::set<Vertex_index>> edges, faces;
  for(Edge_index e : mesh.edges())
    edges.insert({mesh.vertex(e, 0), mesh.vertex(e, 1)});
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    faces.insert({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
  }
  const auto has_size = [](std::size_t n) { return [n](const auto& s) { return s.size() == n; }; };
  return edges.size() == mesh.number_of_edges() && faces.size() == mesh.number_of_faces() &&
         std::all_of(edges.begin(), edges.end(), has_size(2)) &&
         std::all_of(faces.begin(), faces.end(), has_size(3));
}

// ---- Collections ----

struct Named_mesh
{
  std::string name;
  Mesh mesh;
};

std::vector<Named_mesh> meshes();

struct Named_complex
{
  std::string name;
  Delta_complex mesh;
};

std::vector<Named_complex> glued_complexes();

// Returns the connectivity of all surfaces above, and surfaces with loops and parallel edges.
std::vector<Named_complex> complexes();

// Returns CGAL's own meshes, or none if they are not installed.
std::vector<std::string> data_meshes(std::uintmax_t largest_file);

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_GENERATORS_H
