// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/surface_points.h"

#include "Program_error.h"
#include "reading/Scanner.h"

#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why)
{
  throw Program_error("'" + text + "' is not a point of the mesh: " + why);
}

// Returns the numbers between commas.
std::vector<double> numbers(const std::string& list, const std::string& text)
{
  std::vector<double> result;
  std::istringstream words(list);
  for(std::string word; std::getline(words, word, ',');) {
    const auto n = finite_number(word);
    if(!n)
      refuse(text, "'" + word + "' is not a number; give a vertex, FACE:a,b,c or x,y,z");
    result.push_back(*n);
  }
  return result;
}

std::size_t index(double n, std::size_t size, const char* what, const std::string& text)
{
  if(n != std::floor(n) || n < 0 || n >= static_cast<double>(size))
    refuse(text, std::string("the ") + what + " are 0 to " + std::to_string(size - 1));
  return static_cast<std::size_t>(n);
}

std::array<Point, 3> corners(Mesh::Face_index f, const Mesh& mesh)
{
  const auto h = mesh.halfedge(f);
  return {mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
          mesh.point(mesh.target(mesh.next(h)))};
}

Surface_location at_vertex(Mesh::Vertex_index v, const Mesh& mesh)
{
  for(const auto h : CGAL::halfedges_around_target(v, mesh))
    if(!mesh.is_border(h)) {
      const auto f = mesh.face(h);
      Surface_location result{f, {0, 0, 0}};
      result.second[h == mesh.halfedge(f) ? 1 : h == mesh.next(mesh.halfedge(f)) ? 2 : 0] = 1;
      return result;
    }
  throw Program_error("vertex " + std::to_string(v.idx()) + " has no face; choose another");
}

// Returns the point. Rounding must not leave a sum other than one.
Surface_location in_face(double f, const std::vector<double>& weights, std::size_t number_of_faces,
                         const std::string& text)
{
  const auto least = *std::min_element(weights.begin(), weights.end());
  const double sum = weights[0] + weights[1] + weights[2];
  if(least < 0 || std::abs(sum - 1) > 1e-6)
    refuse(text, "barycentric coordinates must not be negative, and must sum up to 1");
  const auto i = static_cast<Mesh::size_type>(index(f, number_of_faces, "faces", text));
  return {Mesh::Face_index(i), {weights[0] / sum, weights[1] / sum, weights[2] / sum}};
}

// Returns the point "FACE:a,b,c".
Surface_location in_face(const std::string& text, std::size_t colon, std::size_t number_of_faces,
                         const char* advice)
{
  const std::vector<double> list =
    numbers(colon == std::string::npos ? "" : text.substr(colon + 1), text);
  const auto face = finite_number(text.substr(0, colon));
  if(!face || list.size() != 3)
    refuse(text, advice);
  return in_face(*face, list, number_of_faces, text);
}

Surface_location nearest(const std::vector<double>& list, const Mesh& mesh, const std::string& text)
{
  const Point p(list[0], list[1], list[2]);
  const Point_finder find(mesh);
  const Surface_location result = find(p);
  const double distance = std::sqrt(CGAL::squared_distance(p, position(result, mesh)));
  if(!(distance <= find.tolerance()))
    refuse(text, "it is " + std::to_string(distance) + " away from it, more than " +
                   std::to_string(find.tolerance()) + "; choose one on it, or give FACE:a,b,c");
  return result;
}

// Returns the coordinates of the point of the segment from `a` to `b` that is nearest to `p`.
double nearest_on_segment(const Point& p, const Point& a, const Point& b)
{
  const auto d = b - a;
  const double square = d.squared_length();
  return square > 0 ? std::clamp((p - a) * d / square, 0., 1.) : 0;
}

} // namespace

std::array<double, 3> nearest_in_triangle(const Point& p, const std::array<Point, 3>& c)
{
  const auto u = c[1] - c[0], v = c[2] - c[0], d = p - c[0];
  const double uu = u * u, uv = u * v, vv = v * v, det = uu * vv - uv * uv;
  const double b1 = (vv * (u * d) - uv * (v * d)) / det, b2 = (uu * (v * d) - uv * (u * d)) / det;
  if(det > 0 && b1 >= 0 && b2 >= 0 && b1 + b2 <= 1)
    return {1 - b1 - b2, b1, b2};
  std::array<double, 3> best{};
  double least = std::numeric_limits<double>::infinity();
  for(std::size_t s = 0; s < 3; ++s) {
    const Point &a = c[s], &b = c[(s + 1) % 3];
    const double t = nearest_on_segment(p, a, b);
    if(const double square = CGAL::squared_distance(p, a + t * (b - a)); square < least) {
      least = square;
      best = IT::barycentric_coordinates(s, t);
    }
  }
  return best;
}

Point position(const Surface_location& p, const Mesh& mesh)
{
  const auto c = corners(p.first, mesh);
  return CGAL::barycenter(c[0], p.second[0], c[1], p.second[1], c[2], p.second[2]);
}

Point_finder::Point_finder(const Mesh& mesh) : m_mesh(mesh)
{
  CGAL::Bbox_3 box;
  m_balls.reserve(mesh.number_of_faces());
  for(Mesh::Face_index f : mesh.faces()) {
    const auto c = corners(f, mesh);
    const Point center = CGAL::centroid(c[0], c[1], c[2]);
    double radius = 0;
    for(const Point& p : c) {
      radius = (std::max)(radius, std::sqrt(CGAL::squared_distance(center, p)));
      box += p.bbox();
    }
    m_balls.push_back({center, radius});
  }
  m_tolerance =
    std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / 20;
}

Surface_location Point_finder::operator()(const Point& p) const
{
  Surface_location best;
  double least = std::numeric_limits<double>::infinity();
  for(Mesh::Face_index f : m_mesh.faces()) {
    const Ball& ball = m_balls[f.idx()];
    const double reach = std::sqrt(least) + ball.radius;
    if(CGAL::squared_distance(p, ball.center) > reach * reach * (1 + 1e-9))
      continue;
    const Surface_location q{f, nearest_in_triangle(p, corners(f, m_mesh))};
    if(const double square = CGAL::squared_distance(p, position(q, m_mesh)); square < least) {
      least = square;
      best = q;
    }
  }
  if(!best.first.is_valid()) // squares are out of range
    throw Program_error(
      "a point is too far away to have a nearest point of the mesh; choose one near to it");
  return best;
}

Surface_location surface_point(const std::string& text, const Input_mesh& input)
{
  constexpr const char* advice =
    "give a vertex, FACE:a,b,c or x,y,z, such as 7, 12:0.5,0.2,0.3 or 1,0,2.5";
  const Mesh& mesh = input.mesh;
  if(mesh.number_of_faces() == 0)
    refuse(text, "there are no faces");
  if(const std::size_t colon = text.find(':'); colon != std::string::npos)
    return input.as_read(in_face(text, colon, mesh.number_of_faces(), advice));
  const std::vector<double> list = numbers(text, text);
  if(list.size() == 3)
    return nearest(list, mesh, text);
  if(list.size() != 1 || text.find_first_of(".eE") != std::string::npos)
    refuse(text, advice);
  return at_vertex(Mesh::Vertex_index(static_cast<Mesh::size_type>(
                     index(list[0], mesh.number_of_vertices(), "vertices", text))),
                   mesh);
}

Surface_location face_point(const std::string& text, std::size_t number_of_faces)
{
  return in_face(text, text.find(':'), number_of_faces, "give FACE:a,b,c");
}

IT::Vertex_index vertex_at(const Surface_location& p, const std::string& text, const Mesh& mesh)
{
  const auto point = IT::surface_point(p, mesh);
  if(IT::is_at_vertex(point))
    return mesh.source(IT::halfedge_of(point));
  throw Program_error("'" + text +
                      "' is not a vertex: --flips and --loop go from vertex to vertex");
}
