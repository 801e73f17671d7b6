// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/develop_faces.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

typedef std::complex<double> Complex;

constexpr std::size_t most_crossings = 512; // of the edges of a face

class Developer
{
public:
  explicit Developer(const Triangulation& triangulation)
    : m_correspondence(triangulation,
                       IT::parameters::concurrency_tag(CGAL::Parallel_if_available_tag())),
      m_tri(triangulation),
      m_mesh(triangulation.mesh()),
      m_numbers(m_mesh.num_halfedges(), -1)
  {}

  std::optional<Developed_faces> operator()(std::vector<Point> points)
  {
    const IT::Delta_complex& input = m_tri.input_mesh();
    for(const IT::Face_index f : input.faces())
      if(const IT::Halfedge_index h = input.halfedge(f);
         crossings_at_corner(h) + crossings(input.next(h)) > most_crossings)
        return std::nullopt;
    number_halfedges();
    for(const IT::Face_index f : m_mesh.faces())
      add_face(first(f));
    m_result.number_of_edges = {input.number_of_edges(), m_mesh.number_of_edges()};
    m_result.input.points = std::move(points);
    for(const IT::Face_index f : input.faces())
      add_input_face(f);
    m_result.input.placement = {input.number_of_vertices(), as_vertex, as_face};
    return std::move(m_result);
  }

private:
  static Placement::Weights as_vertex(std::size_t i)
  {
    return {1, {IT::Vertex_index(static_cast<Mesh::size_type>(i))}, {1}};
  }

  static IT::Face_index as_face(std::size_t i, std::size_t)
  {
    return IT::Face_index(static_cast<Mesh::size_type>(i));
  }

  IT::Halfedge_index first(IT::Face_index f) const
  {
    const IT::Halfedge_index h = m_mesh.halfedge(f);
    return (std::max)({h, m_mesh.next(h), m_mesh.prev(h)},
                      [&](IT::Halfedge_index g, IT::Halfedge_index k) {
                        return m_tri.length(IT::Edge_index(g)) < m_tri.length(IT::Edge_index(k));
                      });
  }

  void number_halfedges()
  {
    std::int64_t n = 0;
    for(const IT::Face_index f : m_mesh.faces())
      for(const IT::Halfedge_index h : {first(f), m_mesh.next(first(f)), m_mesh.prev(first(f))})
        m_numbers[h.idx()] = n++;
  }

  void add_face(IT::Halfedge_index h)
  {
    for(const IT::Halfedge_index g : {h, m_mesh.next(h), m_mesh.prev(h)}) {
      m_result.opposites.push_back(m_numbers[m_mesh.opposite(g).idx()]);
      m_result.sources.push_back(static_cast<std::int64_t>(m_mesh.source(g).idx()));
    }
    const Complex z = apex(h);
    m_result.shapes.insert(m_result.shapes.end(), {z.real(), z.imag()});
  }

  // Returns the third corner of the face of `h`, if `h` leads from 0 to 1.
  Complex apex(IT::Halfedge_index h) const
  {
    const double l = m_tri.length(IT::Edge_index(h));
    const double a = m_tri.length(IT::Edge_index(m_mesh.next(h)));
    const double b = m_tri.length(IT::Edge_index(m_mesh.prev(h)));
    return {.5 + IT::scaled_foot(a, b) / l / l / 2, IT::quadrupled_area(l, a, b) / l / l / 2};
  }

  // Adds a face of the input. Development starts at a corner whose first edge is intrinsic, too, if
  // one exists, and whose edges have the fewest crossings.
  void add_input_face(IT::Face_index f)
  {
    const IT::Delta_complex& input = m_tri.input_mesh();
    const IT::Halfedge_index h0 = input.halfedge(f);
    const IT::Halfedge_index h = (std::min)(
      {h0, input.next(h0), input.prev(h0)},
      [&](IT::Halfedge_index g, IT::Halfedge_index k) { return cost_of(g) < cost_of(k); });
    m_result.input.polygons.push_back(std::array<std::size_t, 3>{
      input.source(h).idx(), input.target(h).idx(), input.target(input.next(h)).idx()});
    add_start(h);
  }

  std::pair<bool, std::size_t> cost_of(IT::Halfedge_index h) const
  {
    return {!m_correspondence.is_shared(IT::Side::input, IT::Edge_index(h)),
            crossings_at_corner(h)};
  }

  std::size_t crossings_at_corner(IT::Halfedge_index h) const
  {
    return crossings(h) + crossings(m_tri.input_mesh().prev(h));
  }

  std::size_t crossings(IT::Halfedge_index h) const
  {
    return m_correspondence.number_of_crossings(IT::Side::input, IT::Edge_index(h));
  }

  void add_start(IT::Halfedge_index h)
  {
    const IT::Halfedge_index outgoing = m_correspondence.outgoing_before(IT::Side::input, h);
    const bool is_shared = m_correspondence.is_shared(IT::Side::input, IT::Edge_index(h));
    m_result.starts.push_back(2 * m_numbers[outgoing.idx()] + (is_shared ? 0 : 1));
    if(is_shared)
      return;
    const Complex z = direction_of(h, outgoing) * (m_tri.input_length(IT::Edge_index(h)) /
                                                   m_tri.length(IT::Edge_index(outgoing)));
    m_result.first_edges.insert(m_result.first_edges.end(), {z.real(), z.imag()});
  }

  // Returns the direction of the input halfedge `h` from the outgoing halfedge at or clockwise
  // before it.
  Complex direction_of(IT::Halfedge_index h, IT::Halfedge_index outgoing) const
  {
    const IT::Edge_index e(h);
    const auto& part = m_correspondence.part(
      e, IT::is_first_halfedge(h) ? 0 : m_correspondence.number_of_parts(e) - 1);
    if(part.is_shared)
      return 1;
    const auto crossing = m_correspondence.crossing(IT::Side::input, h, 0).across;
    const IT::Halfedge_index side = m_mesh.next(outgoing);
    const double t = crossing.halfedge == side ? crossing.t : 1 - crossing.t;
    const Complex z = (1 - t) + t * apex(outgoing);
    return z / std::abs(z);
  }

  const IT::Correspondence<> m_correspondence;
  const Triangulation& m_tri;
  const IT::Delta_complex& m_mesh;
  std::vector<std::int64_t> m_numbers;
  Developed_faces m_result;
};

} // namespace

std::optional<Developed_faces> develop_faces(const Triangulation& triangulation,
                                             std::vector<Point> points,
                                             const std::vector<Attribute>& input_data,
                                             std::vector<Attribute> vertex_data)
{
  std::optional<Developed_faces> result = Developer(triangulation)(std::move(points));
  if(!result)
    return result;
  std::vector<Attribute>& on_points = result->input.point_data;
  on_points.insert(on_points.end(), input_data.begin(), input_data.end());
  for(const Attribute& a : vertex_data) {
    on_points.push_back(a);
    resize(on_points.back(), result->input.points.size());
  }
  result->vertex_data = std::move(vertex_data);
  return result;
}
