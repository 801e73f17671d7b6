// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_FLAT_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_FLAT_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Layout.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Cone_tree.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Least_squares_shift.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Plane_vector.h>
#include <CGAL/Discrete_conformal_maps/internal/layout/Spectral_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Flat_triangle.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// The faces of a flat surface with cones, unfolded into the plane one after the other. Directions
// are turned by the angles of faces, so that small faces beside large ones do not suffer from
// differences of positions. What does not fit for rounding, where faces meet that were reached on
// different ways, is then distributed such that the edges of all faces change least, in proportion
// to their lengths.
template <typename FT>
class Flat_layout
{
  typedef Plane_vector<FT> Vector;

public:
  // `length` has the lengths of all edges, `order` is that of the vertices
  Flat_layout(const Delta_complex& mesh, const std::vector<FT>& length, const Cut_graph& cut,
              const Shared_order& order, Layout layout = Layout::least_squares)
    : m_mesh(mesh),
      m_length(length),
      m_position(mesh.num_halfedges(), Vector{FT(0), FT(0)}),
      m_direction(mesh.num_halfedges()),
      m_point(mesh.num_halfedges())
  {
    for(const Cut_graph::Step& step : cut.steps()) {
      const Halfedge_index h = step.entry.is_valid() ? step.entry : mesh.halfedge(step.face);
      start(h, step.entry.is_valid());
      place(h);
    }
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v))
        unite_corners(v, cut);
    std::vector<Vector>().swap(m_position);
    if(layout == Layout::spectral)
      improve_charts(cut, order);
    if(layout == Layout::least_squares)
      distribute_errors(cut, order);
  }

  // the position of the source of `h` in the face of `h`
  std::complex<double> position(Halfedge_index h) const { return to_complex(united(h)); }

  // in all digits
  const Vector& exact_position(Halfedge_index h) const { return united(h); }

  // the vector of `h` in its face, without the errors of positions \pre the layout is incremental
  Vector side(Halfedge_index h) const { return length(h) * m_direction[h.idx()]; }

  // of errors of `side(h)`
  double weight(Halfedge_index h) const { return static_cast<double>(1 / (length(h) * length(h))); }

private:
  const FT& length(Halfedge_index h) const { return m_length[Edge_index(h).idx()]; }

  // takes the place of the halfedge `h` from the face beyond it, or from nowhere
  void start(Halfedge_index h, bool is_entry)
  {
    const Halfedge_index o = m_mesh.opposite(h);
    m_position[h.idx()] = is_entry ? m_position[m_mesh.next(o).idx()] : Vector{FT(0), FT(0)};
    m_direction[h.idx()] = is_entry ? FT(-1) * m_direction[o.idx()] : Vector{FT(1), FT(0)};
  }

  // the rest of the face
  void place(Halfedge_index h)
  {
    const Halfedge_index n = m_mesh.next(h), p = m_mesh.prev(h);
    m_position[n.idx()] = m_position[h.idx()] + length(h) * m_direction[h.idx()];
    m_direction[n.idx()] = m_direction[h.idx()] * turn(n);
    m_direction[p.idx()] = m_direction[n.idx()] * turn(p);
    // along the shorter way
    m_position[p.idx()] = length(n) < length(p)
                            ? m_position[n.idx()] + length(n) * m_direction[n.idx()]
                            : m_position[h.idx()] + (-length(p)) * m_direction[p.idx()];
  }

  // how the boundary of a face turns at the source of `h`: by pi less the angle there
  Vector turn(Halfedge_index h) const
  {
    using std::sqrt;
    const std::array<FT, 3> side =
      in_range(std::array<FT, 3>{length(m_mesh.next(h)), length(h), length(m_mesh.prev(h))});
    const FT cosine = Intrinsic_triangulations::doubled_corner_product(side[0], side[1], side[2]);
    const FT sine =
      sqrt(Intrinsic_triangulations::squared_quadrupled_area(side[0], side[1], side[2]));
    const FT norm = sqrt(cosine * cosine + sine * sine);
    return {-cosine / norm, sine / norm};
  }

  // Corners between which there is no seam are one point: rounding has made them a little
  // different.
  void unite_corners(Vertex_index v, const Cut_graph& cut)
  {
    const Halfedge_index start = Intrinsic_triangulations::first_outgoing_halfedge(v, m_mesh);
    Halfedge_index first = start;
    do {
      if(cut.is_seam(Edge_index(first)))
        break;
      first = Intrinsic_triangulations::next_around_source(first, m_mesh);
    } while(first != start);
    Halfedge_index h = first;
    do {
      if(h == first || cut.is_seam(Edge_index(h))) {
        m_united.push_back(m_position[h.idx()]);
        m_vertex.push_back(v);
      }
      m_point[h.idx()] = static_cast<int>(m_united.size()) - 1;
      h = Intrinsic_triangulations::next_around_source(h, m_mesh);
    } while(h != first);
  }

  // The sum over all sides of faces of the squared change of the side, relative to its length, is
  // least.
  void distribute_errors(const Cut_graph& cut, const Shared_order& order)
  {
    Least_squares_shift shift(m_united.size(), 3 * cut.steps().size());
    for_each_side(cut,
                  [&](Halfedge_index h) { shift.add(point(h), point(m_mesh.next(h)), weight(h)); });
    for(const Cut_graph::Step& step : cut.steps())
      if(!step.entry.is_valid())
        shift.fix(point(m_mesh.halfedge(step.face)));
    const Eigen::VectorXd x = what_fits(cut, &Vector::x), y = what_fits(cut, &Vector::y);
    if(std::is_same<FT, double>::value)
      std::vector<Vector>().swap(m_direction); // the factor comes in its place
    shift.factorize(order.refined(m_vertex));
    move(shift.solve(x), &Vector::x);
    move(shift.solve(y), &Vector::y);
    // with more digits than shifts have, what the first has left
    if(!std::is_same<FT, double>::value)
      for(const auto coordinate : {&Vector::x, &Vector::y})
        move(shift.solve(what_fits(cut, coordinate)), coordinate);
  }

  // the right side for the changes that are missing
  Eigen::VectorXd what_fits(const Cut_graph& cut, FT Vector::*coordinate) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(Eigen::Index(m_united.size()));
    for_each_side(cut, [&](Halfedge_index h) {
      const Halfedge_index n = m_mesh.next(h);
      const FT present = united(n).*coordinate - united(h).*coordinate;
      Least_squares_shift::add_to_right_side(result, point(h), point(n), weight(h),
                                             static_cast<double>(side(h).*coordinate - present));
    });
    return result;
  }

  void move(const Eigen::VectorXd& by, FT Vector::*coordinate)
  {
    for(std::size_t i = 0; i < m_united.size(); ++i)
      m_united[i].*coordinate += FT(by[Eigen::Index(i)]);
  }

  template <typename Function>
  void for_each_side(const Cut_graph& cut, const Function& function) const
  {
    for(const Cut_graph::Step& step : cut.steps())
      for(Halfedge_index h : Intrinsic_triangulations::sides(step.face, m_mesh))
        function(h);
  }

  void improve_charts(const Cut_graph& cut, const Shared_order& order)
  {
    m_number.assign(m_united.size(), none);
    const auto& steps = cut.steps();
    for(auto root = steps.begin(); root != steps.end();) {
      const auto end = std::find_if(
        root + 1, steps.end(), [](const Cut_graph::Step& step) { return !step.entry.is_valid(); });
      improve_chart(root, end, cut, order);
      root = end;
    }
  }

  template <typename Iterator>
  void improve_chart(Iterator begin, Iterator end, const Cut_graph& cut, const Shared_order& order)
  {
    Spectral_layout<FT> spectral;
    std::vector<std::size_t> points;
    for(Iterator step = begin; step != end; ++step) {
      const auto sides = Intrinsic_triangulations::sides(step->face, m_mesh);
      for(Halfedge_index h : sides)
        number(h, points);
      spectral.add_face(
        {number(sides[0], points), number(sides[1], points), number(sides[2], points)},
        {side(sides[0]), side(sides[1]), side(sides[2])});
      for(Halfedge_index h : sides)
        if(cut.is_seam(Edge_index(h)))
          spectral.add_boundary_edge(number(h, points), number(m_mesh.next(h), points),
                                     static_cast<double>(length(h)));
    }
    std::vector<Vector> position;
    std::vector<Vertex_index> vertex;
    for(std::size_t i : points) {
      position.push_back(m_united[i]);
      vertex.push_back(m_vertex[i]);
    }
    spectral.improve(position, *order.refined(vertex));
    for(std::size_t k = 0; k < points.size(); ++k)
      m_united[points[k]] = position[k];
  }

  // the number in its chart of the point at the source of `h`, the next if it has none
  std::size_t number(Halfedge_index h, std::vector<std::size_t>& points)
  {
    const std::size_t i = static_cast<std::size_t>(point(h));
    if(m_number[i] == none) {
      m_number[i] = points.size();
      points.push_back(i);
    }
    return m_number[i];
  }

  const Vector& united(Halfedge_index h) const { return m_united[std::size_t(point(h))]; }

  int point(Halfedge_index h) const { return m_point[h.idx()]; }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Delta_complex& m_mesh;
  const std::vector<FT>& m_length;
  std::vector<Vector> m_position;     // of the source of each halfedge, until they are united
  std::vector<Vector> m_direction;    // of each halfedge
  std::vector<int> m_point;           // the number of the point at the source of each halfedge
  std::vector<Vector> m_united;       // the points
  std::vector<Vertex_index> m_vertex; // of which each point is a corner
  std::vector<std::size_t> m_number;  // of each point in its chart
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_FLAT_LAYOUT_H
