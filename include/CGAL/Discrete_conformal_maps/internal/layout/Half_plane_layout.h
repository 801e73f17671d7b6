// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_HALF_PLANE_LAYOUT_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_HALF_PLANE_LAYOUT_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Discrete_conformal_maps/internal/planar_layouts/Least_squares_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_problem.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

using Intrinsic_triangulations::internal::Plane_vector;

// Computes the positions of the vertices of a doubled disk in the plane, with one vertex of the
// boundary at infinity. All other boundary vertices lie on the real line, and the disk lies above
// this line. Copies are mirror images, so only the positions of vertices of the disk are unknowns.
template <typename FT>
class Half_plane_layout
{
public:
  typedef Plane_vector<FT> Vector;

  // `unfolded` contains the positions in the plane up to a motion. Some copies may have no
  // position. The layout preserves distances.
  Half_plane_layout(const Delta_complex& mesh, const Doubled_problem& problem,
                    const std::vector<std::optional<Vector>>& unfolded)
    : m_mesh(mesh), m_problem(problem), m_position(problem.size(), Vector{FT(0), FT(0)})
  {
    find_axis(unfolded);
    for(std::size_t v = 0; v < m_position.size(); ++v)
      if(unfolded[v])
        m_position[v] = turned(*unfolded[v] - m_origin);
    FT height(0);
    for(const Vector& p : m_position)
      height += p.y;
    if(height < 0)
      turn_around();
    if(std::is_same<FT, Decimal_1500>::value)
      shift_to_axis(unfolded);
    for(Vertex_index v : problem.surface().vertices())
      if(problem.is_on_boundary(v))
        m_position[v.idx()].y = 0;
  }

  // Minimizes a sum over all sides of faces of the double among symmetric positions. The term of a
  // side is its squared change from `unfolded`, divided by its squared length.
  void distribute_errors(const Unfolded_faces<FT>& unfolded)
  {
    for(const auto coordinate : {&Vector::x, &Vector::y})
      fit(unfolded, coordinate);
  }

  Vector position(Vertex_index v) const
  {
    const Vector& p = m_position[m_problem.original(v).idx()];
    return is_copy(v) ? conj(p) : p;
  }

private:
  bool is_copy(Vertex_index v) const { return v.idx() >= m_problem.size(); }

  Vector turned(const Vector& v) const { return conj(m_direction) * v; }

  void turn_around()
  {
    m_direction = FT(-1) * m_direction;
    for(Vector& p : m_position)
      p = FT(-1) * p;
  }

  // Finds the axis from two distant points on it, or from a vertex and its mirror image.
  void find_axis(const std::vector<std::optional<Vector>>& unfolded)
  {
    std::vector<Vector> on_axis;
    for(std::size_t v = 0; v < m_problem.size(); ++v)
      if(unfolded[v] && m_problem.is_on_boundary(Vertex_index(Delta_complex::size_type(v))))
        on_axis.push_back(*unfolded[v]);
    if(on_axis.size() > 1) {
      m_origin = farthest(on_axis, on_axis.front());
      set_direction(farthest(on_axis, m_origin) - m_origin);
      return;
    }
    Vector across{FT(0), FT(0)};
    for(std::size_t w = m_problem.size(); w < unfolded.size(); ++w)
      if(const auto& p = unfolded[m_problem.originals()[w].idx()], &q = unfolded[w];
         p && q && norm(*p - *q) > norm(across)) {
        across = *p - *q;
        m_origin = FT(0.5) * (*p + *q);
      }
    set_direction({across.y, -across.x});
  }

  static const Vector& farthest(const std::vector<Vector>& points, const Vector& from)
  {
    return *std::max_element(points.begin(), points.end(), [&](const Vector& p, const Vector& q) {
      return norm(p - from) < norm(q - from);
    });
  }

  void set_direction(const Vector& v)
  {
    using std::sqrt;
    if(const FT length = sqrt(norm(v)); length > 0)
      m_direction = FT(1 / length) * v;
  }

  // Stores the shift of a vertex, and the greatest length on the path from the axis to it.
  struct Shift
  {
    FT size; // the square of the greatest length on the path
    std::size_t vertex;
    FT by;

    bool operator<(const Shift& other) const // compares for a queue
    {
      return size != other.size ? size > other.size : vertex > other.vertex;
    }
  };
  typedef std::priority_queue<Shift> Shifts;

  // Shifts every vertex together with a vertex on the axis. The error of a position is
  // proportional to the greatest length on the path to it. Faces beside the axis may be smaller
  // than such errors. So each vertex gets the shift of the axis vertex that it reaches by the
  // shortest edges.
  void shift_to_axis(const std::vector<std::optional<Vector>>& unfolded)
  {
    Shifts queue = shifts_of_axis(unfolded);
    std::vector<char> is_shifted(m_position.size(), 0);
    const std::vector<Vector> before = m_position;
    while(!queue.empty()) {
      const Shift shift = queue.top();
      queue.pop();
      if(std::exchange(is_shifted[shift.vertex], 1))
        continue;
      m_position[shift.vertex].y += shift.by;
      const Vertex_index v(Delta_complex::size_type(shift.vertex));
      for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
        const std::size_t w = m_mesh.target(h).idx();
        if(w < before.size() && unfolded[w] && !is_shifted[w])
          queue.push({(std::max)(shift.size, norm(before[w] - before[v.idx()])), w, shift.by});
      });
    }
  }

  // Returns the shifts that move boundary vertices to the axis. For each other point, the shift
  // moves the midpoint between the vertex and its copy.
  Shifts shifts_of_axis(const std::vector<std::optional<Vector>>& unfolded) const
  {
    Shifts result;
    for(std::size_t v = 0; v < m_position.size(); ++v)
      if(unfolded[v] && m_problem.is_on_boundary(Vertex_index(Delta_complex::size_type(v))))
        result.push({FT(0), v, -m_position[v].y});
    for(std::size_t w = m_problem.size(); w < unfolded.size(); ++w)
      if(const std::size_t v = m_problem.originals()[w].idx(); unfolded[v] && unfolded[w]) {
        const Vector copy = turned(*unfolded[w] - m_origin);
        result.push({norm(m_position[v] - copy), v, (m_position[v].y + copy.y) / -2});
      }
    return result;
  }

  // Returns the sign of a coordinate under the reflection. Mirror images have equal abscissas and
  // opposite ordinates.
  int sign(Vertex_index v, FT Vector::*coordinate) const
  {
    return is_copy(v) && coordinate == &Vector::y ? -1 : 1;
  }

  // Fits a coordinate by least squares. If the coordinate has more digits than a shift, a second
  // shift follows.
  void fit(const Unfolded_faces<FT>& unfolded, FT Vector::*coordinate)
  {
    const auto for_each_side = [&](const auto& visit) {
      for(const Cut_graph::Step& step : unfolded.cut().steps())
        for(Halfedge_index h : sides(step.face, m_mesh)) {
          const Vertex_index v = m_mesh.source(h), w = m_mesh.target(h);
          const int at_source = sign(v, coordinate), at_target = sign(w, coordinate);
          const FT change = (turned(unfolded.side(h)) - (position(w) - position(v))).*coordinate;
          visit(Side_change{original(v), original(w), at_source * at_target,
                            m_problem.part(step.face) * side_weight(unfolded.length(h)),
                            at_target * static_cast<double>(change)});
        }
    };
    const auto& steps = unfolded.cut().steps();
    Least_squares_shift shift(m_position.size(), 3 * steps.size(), for_each_side);
    if(coordinate == &Vector::x)
      shift.fix(original(m_mesh.source(m_mesh.halfedge(steps.front().face))));
    else
      for(Vertex_index v : m_problem.surface().vertices())
        if(m_problem.is_on_boundary(v))
          shift.fix(original(v));
    shift.factorize(m_problem.order());
    for(int i = 0; i < (std::is_same<FT, double>::value ? 1 : 2); ++i)
      shift.shift(shift.right_side(for_each_side), m_position, coordinate);
  }

  int original(Vertex_index v) const { return static_cast<int>(m_problem.original(v).idx()); }

  const Delta_complex& m_mesh;
  const Doubled_problem& m_problem;
  Vector m_origin{FT(0), FT(0)}, m_direction{FT(1), FT(0)}; // origin and direction of the real line
  std::vector<Vector> m_position;                           // positions of vertices of the disk
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_LAYOUT_HALF_PLANE_LAYOUT_H
