// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include "reading/close_points.h"

#include <CGAL/Intrinsic_triangulations/angle_on_input.h>
#include <CGAL/Intrinsic_triangulations/diagnose.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

namespace {

using IT::Defect_kind;
using IT::Input_diagnosis;

typedef IT::Delta_complex::size_type Index;

std::vector<std::size_t> known(std::initializer_list<std::size_t> indices)
{
  std::vector<std::size_t> result;
  for(const std::size_t i : indices)
    if(i != Input_diagnosis::none)
      result.push_back(i);
  return result;
}

Element_error::Elements elements_of(const Input_diagnosis::Occurrence& place,
                                    IT::Defect_element element)
{
  const auto [v, w] = place.vertices;
  Element_error::Elements result;
  if(element == IT::Defect_element::EDGE)
    result.emplace_back("edge", known({v, w}));
  if(element == IT::Defect_element::VERTEX)
    result.emplace_back("vertex", known({v}));
  if(place.face != Input_diagnosis::none)
    result.emplace_back("face", known({place.face}));
  return result;
}

bool is_about_manifolds(Defect_kind kind)
{
  return kind == Defect_kind::NON_MANIFOLD_EDGE || kind == Defect_kind::NON_MANIFOLD_VERTEX ||
         kind == Defect_kind::NON_ORIENTABLE_COMPONENT ||
         kind == Defect_kind::INCONSISTENT_ORIENTATION;
}

std::string advice(Defect_kind kind)
{
  return kind == Defect_kind::ZERO_LENGTH_EDGE
           ? "; repair() merges equal points, and mollify=1e-8 lengthens the edge"
           : "";
}

// Throws the first fatal defect, unless `is_ignored(kind)`.
template <class Predicate>
void check(const Input_diagnosis& diagnosis, const Predicate& is_ignored)
{
  for(const IT::Defect_description& d : IT::defect_descriptions)
    if(d.is_fatal && diagnosis.count(d.kind) > 0 && !is_ignored(d.kind))
      throw Element_error(is_about_manifolds(d.kind) ? "NotAManifoldError" : "InputError",
                          diagnosis.message(d.kind) + " - " + d.sentence + advice(d.kind),
                          elements_of(diagnosis.occurrences(d.kind).front(), d.element));
}

bool is_of_lengths(Defect_kind kind)
{
  return kind == Defect_kind::ZERO_LENGTH_EDGE || kind == Defect_kind::INVALID_LENGTH ||
         kind == Defect_kind::LENGTH_OUT_OF_RANGE ||
         kind == Defect_kind::TRIANGLE_INEQUALITY_VIOLATED;
}

// Throws if a position is not finite, also of a vertex without edges.
void check_finite(const Number_array& points)
{
  const double* const x = points.data();
  double sum = 0; // of zeros, unless a number is not finite
  for(py::ssize_t i = 0; i < points.size(); ++i)
    sum += x[i] - x[i];
  for(py::ssize_t i = 0; i < points.size() && sum != 0; ++i)
    if(!std::isfinite(x[i])) {
      const auto row = std::size_t(i / 3);
      throw Element_error("InputError", "row " + std::to_string(row) + " of V is not finite",
                          {{"row", {row}}});
    }
}

// Throws if two points of a cloud coincide: copies would count as neighbors.
void check_different(const std::vector<Point>& points)
{
  const std::vector<std::size_t> first = first_equal_points(points);
  for(std::size_t i = 0; i < first.size(); ++i)
    if(first[i] != i)
      throw Element_error("InputError",
                          "points " + std::to_string(first[i]) + " and " + std::to_string(i) +
                            " are at the same position; np.unique(V, axis=0) leaves one of each",
                          {{"row", {i}}});
}

Polygons triangles_of(const Index_array& faces)
{
  return Polygons::of_triangles(faces.data(), faces.data() + faces.size());
}

// Returns whether the squares of lengths are in the range of numbers, and far from its ends.
bool has_good_lengths(const IT::Delta_complex& mesh, const std::vector<Point>& points)
{
  constexpr double least = 0x1p-200, greatest = 0x1p200; // squared
  for(std::size_t e = 0; e < mesh.num_edges(); ++e) {
    const IT::Halfedge_index h = IT::first_halfedge(IT::Edge_index(Index(e)));
    const double square = CGAL::squared_distance(points[mesh.source(h)], points[mesh.target(h)]);
    if(!(square > least && square < greatest))
      return false;
  }
  return true;
}

// Returns the length of the side opposite to the corner at which the side before `h` starts.
class Side_lengths
{
public:
  Side_lengths(const Number_array& lengths, const IT::Delta_complex& mesh)
    : m_lengths(lengths), m_mesh(mesh)
  {}

  double operator()(IT::Halfedge_index h) const
  {
    const std::size_t corner = (IT::side_number(h, m_mesh) + 2) % 3;
    return m_lengths.data()[3 * m_mesh.face(h).idx() + corner];
  }

private:
  const Number_array& m_lengths;
  const IT::Delta_complex& m_mesh;
};

double edge_length(IT::Edge_index e, const IT::Delta_complex& mesh, const Side_lengths& length)
{
  const IT::Halfedge_index h = mesh.halfedge(e), o = mesh.opposite(h);
  if(mesh.is_border(h) || mesh.is_border(o))
    return length(mesh.is_border(h) ? o : h);
  if(length(h) != length(o)) {
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << "the faces " << mesh.face(h).idx() << " and " << mesh.face(o).idx()
         << " give different lengths to their common edge: " << length(h) << " and " << length(o);
    throw Element_error(
      "InputError", text.str(),
      {{"edge", {mesh.source(h).idx(), mesh.target(h).idx()}}, {"face", {mesh.face(h).idx()}}});
  }
  return length(h);
}

[[noreturn]] void refuse_point(std::size_t row, const std::string& what)
{
  throw Element_error("InputError", "row " + std::to_string(row) + " of the points: " + what,
                      {{"row", {row}}});
}

} // namespace

Polygon_soup soup_of(const Number_array& points, const Index_array& faces)
{
  Polygon_soup result;
  result.points.reserve(static_cast<std::size_t>(points.size()) / 3);
  for(const double* p = points.data(); p != points.data() + points.size(); p += 3)
    result.points.emplace_back(p[0], p[1], p[2]);
  result.polygons = triangles_of(faces);
  return result;
}

Polygon_soup checked_soup_of(const Number_array& points, const Index_array& faces,
                             bool are_zero_lengths_allowed)
{
  check_finite(points);
  Polygon_soup soup = soup_of(points, faces);
  if(faces.size() == 0)
    check_different(soup.points);
  check(IT::diagnose_polygon_soup(soup.points, soup.polygons), [&](Defect_kind kind) {
    return is_about_manifolds(kind) ||
           (are_zero_lengths_allowed && kind == Defect_kind::ZERO_LENGTH_EDGE);
  });
  return soup;
}

Surface surface_of_points(const Number_array& points, const Index_array& faces,
                          bool are_zero_lengths_allowed)
{
  return released([&] {
    check_finite(points);
    Polygon_soup soup = soup_of(points, faces);
    std::optional<IT::Delta_complex> mesh = complex_of(soup.points.size(), soup.polygons);
    if(!mesh || !has_good_lengths(*mesh, soup.points))
      check(IT::diagnose_polygon_soup(soup.points, soup.polygons), [&](Defect_kind kind) {
        return are_zero_lengths_allowed && kind == Defect_kind::ZERO_LENGTH_EDGE;
      });
    return Surface{std::move(mesh.value()), std::move(soup.points), {}};
  });
}

Surface surface_of_lengths(const Number_array& lengths, const Index_array& faces)
{
  return released([&] {
    Polygon_soup soup;
    const std::int64_t* const end = faces.data() + faces.size();
    const std::int64_t last = faces.size() == 0 ? -1 : *std::max_element(faces.data(), end);
    soup.points.resize(static_cast<std::size_t>(last + 1), Point(0, 0, 0));
    soup.polygons = triangles_of(faces);
    check(IT::diagnose_polygon_soup(soup.points, soup.polygons), is_of_lengths);
    Surface result{complex_of(soup.points.size(), soup.polygons).value(), {}, {}};
    const IT::Delta_complex& mesh = result.mesh;
    const Side_lengths length(lengths, mesh);
    for(const IT::Edge_index e : mesh.edges())
      result.length.push_back(edge_length(e, mesh, length));
    check(IT::diagnose(mesh, IT::parameters::edge_length_map(boost::make_iterator_property_map(
                               result.length.begin(), get(boost::edge_index, mesh)))),
          [](Defect_kind) { return false; });
    return result;
  });
}

Triangulation triangulation_of(const Surface& surface, double mollification)
{
  return with_lengths(surface, IT::parameters::mollification(mollification),
                      [&](const auto& np) { return Triangulation(surface.mesh, np); });
}

Triangulation triangulation_from(Surface& surface, double mollification)
{
  return with_lengths(surface, IT::parameters::mollification(mollification),
                      [&](const auto& np) { return Triangulation(std::move(surface.mesh), np); });
}

std::vector<std::complex<double>> rotations_to_input(const Triangulation& triangulation)
{
  const IT::Delta_complex& mesh = triangulation.mesh();
  std::vector<std::complex<double>> result(mesh.num_vertices(), 1.);
  for(const IT::Vertex_index v : mesh.vertices())
    if(!mesh.is_isolated(v))
      result[v.idx()] =
        std::polar(1., IT::angle_on_input(triangulation, IT::first_outgoing_halfedge(v, mesh)));
  return result;
}

std::vector<Location> locations_of(const Index_array& faces, const Number_array& coordinates,
                                   std::size_t number_of_faces)
{
  constexpr double greatest_error = 1e-6; // of a sum of coordinates
  const auto n = static_cast<std::size_t>(faces.size());
  std::vector<Location> result;
  result.reserve(n);
  for(std::size_t i = 0; i < n; ++i) {
    const std::int64_t f = faces.data()[i];
    const double* const b = coordinates.data() + 3 * i;
    if(f < 0 || f >= static_cast<std::int64_t>(number_of_faces))
      refuse_point(i, "there is no face " + std::to_string(f) + "; the faces are 0 to " +
                        std::to_string(std::ptrdiff_t(number_of_faces) - 1));
    const double sum = b[0] + b[1] + b[2];
    if(!(b[0] >= 0 && b[1] >= 0 && b[2] >= 0) || !(std::abs(sum - 1) <= greatest_error))
      refuse_point(i, "barycentric coordinates are not negative and sum up to one");
    result.push_back(
      {IT::Face_index(static_cast<Mesh::size_type>(f)), {b[0] / sum, b[1] / sum, b[2] / sum}});
  }
  return result;
}

py::tuple arrays_of(const std::vector<Location>& points)
{
  std::vector<std::int64_t> faces;
  std::vector<std::array<double, 3>> coordinates;
  for(const Location& p : points) {
    faces.push_back(p.first.is_valid() ? std::int64_t(p.first.idx()) : -1);
    coordinates.push_back(p.second);
  }
  return py::make_tuple(array_of(std::move(faces)), array_of(std::move(coordinates)));
}
