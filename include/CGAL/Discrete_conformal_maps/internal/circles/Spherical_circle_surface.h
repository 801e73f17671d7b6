// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_SPHERICAL_CIRCLE_SURFACE_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_SPHERICAL_CIRCLE_SURFACE_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/circles/Spherical_circle_triangle.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Corner.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/spherical_gram_error.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores a point of the unit sphere and the direction of an edge at this point.
template <typename FT>
struct Spherical_frame
{
  typedef std::array<FT, 3> Vector;
  Vector position, direction;

  // Returns the frame of the edge that follows after a rotation by the angle of this corner.
  Spherical_frame turned(const Corner<FT>& corner) const
  {
    using std::sqrt;
    const auto &p = position, &d = direction;
    const Vector left{p[1] * d[2] - p[2] * d[1], p[2] * d[0] - p[0] * d[2],
                      p[0] * d[1] - p[1] * d[0]};
    const FT norm = sqrt(FT(corner.cosine * corner.cosine + corner.sine * corner.sine));
    return {p, sum(corner.cosine / norm, d, corner.sine / norm, left)};
  }

  // Returns the frame of the same edge at its other end. The edge has length x with sin(x/2) = l.
  Spherical_frame at_end(const FT& l) const
  {
    using std::sqrt;
    const FT cosine = 1 - 2 * l * l, sine = 2 * l * sqrt(FT(1 - l * l));
    return {sum(cosine, position, sine, direction), sum(sine, position, -cosine, direction)};
  }

private:
  static Vector sum(const FT& x, const Vector& a, const FT& y, const Vector& b)
  {
    return {x * a[0] + y * b[0], x * a[1] + y * b[1], x * a[2] + y * b[2]};
  }
};

// Stores a decorated sphere as spherical triangles between the centers of its circles. Computes
// the angle defects and their derivatives.
template <typename FT>
class Spherical_circle_surface
{
  typedef Spherical_circle_triangle<FT> Triangle;

public:
  typedef Eigen::VectorXd Vector;
  typedef Eigen::SparseMatrix<double> Matrix;

  // `tangent` is a property map of the lengths of tangents of `mesh`.
  template <typename EdgeLengthMap>
  Spherical_circle_surface(const Delta_complex& mesh, const EdgeLengthMap& tangent,
                           std::vector<FT> radius)
    : m_surface(mesh, tangent, Flipping::to_Delaunay, std::move(radius)),
      m_half_chord(mesh.num_edges()),
      m_depth(mesh.num_vertices())
  {}

  const Delta_complex& mesh() const { return m_surface.mesh(); }
  const std::vector<Halfedge_index>& flips() const { return m_surface.flips(); }
  const FT& scaled_radius(Vertex_index v) const { return m_surface.scaled_radius(v); }

  // Sets scale factors. Returns whether all scaled lengths exist.
  bool scale(const std::vector<Double_double>& u)
  {
    std::vector<FT> converted_u;
    for(const Double_double& x : u)
      converted_u.push_back(converted<FT>(x));
    try {
      m_surface.scale(converted_u);
    } catch(const Intrinsic_triangulations::Error&) {
      return false;
    }
    for(Edge_index e : mesh().edges())
      m_half_chord[e.idx()] =
        m_surface.scaled_decorated_length(mesh().halfedge(e)).spherical_length() / 2;
    for(Vertex_index v : mesh().vertices())
      m_depth[v.idx()] = Triangle::depth(scaled_radius(v));
    return true;
  }

  // Returns the angle defect of each vertex: 2 pi minus the sum of its angles. If a triangle does
  // not exist, all defects are NaN.
  Vector defects() const
  {
    std::vector<Angle_difference<FT>> sums(mesh().num_vertices(), Angle_difference<FT>(FT(0)));
    bool exist = true;
    for(Face_index f : mesh().faces()) {
      const auto side = sides(f, mesh());
      const Triangle t = triangle(side);
      exist = exist && t.exists();
      for(std::size_t s = 0; s < 3; ++s)
        sums[mesh().source(side[s]).idx()].subtract(t.corner(s), t.corner(s).rounded_angle());
    }
    Vector result = Vector::Zero(Eigen::Index(sums.size()));
    for(Vertex_index v : mesh().vertices())
      if(!mesh().is_isolated(v))
        result[Eigen::Index(v.idx())] =
          exist ? sums[v.idx()].value() : std::numeric_limits<double>::quiet_NaN();
    return result;
  }

  // Returns the negative derivatives of the sums of angles.
  Matrix matrix() const
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * mesh().num_faces());
    const auto add = [&](Vertex_index v, Vertex_index w, double x) {
      entries.emplace_back(int(v.idx()), int(w.idx()), x);
    };
    for(Face_index f : mesh().faces()) {
      const auto side = sides(f, mesh());
      const Triangle t = triangle(side);
      for(std::size_t s = 0; s < 3; ++s) {
        const Vertex_index i = mesh().source(side[s]), j = mesh().target(side[s]);
        const double d = static_cast<double>(t.derivative(s)),
                     own = static_cast<double>(t.cosine_of_side(s)) * d;
        add(i, j, -d);
        add(j, i, -d);
        add(i, i, own);
        add(j, j, own);
      }
    }
    const auto n = static_cast<Eigen::Index>(mesh().num_vertices());
    Matrix result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  // Returns the corners of the face whose shortest side is longest.
  std::array<Vertex_index, 3> corners_of_greatest_face() const
  {
    const auto shortest = [this](Face_index f) {
      const auto side = sides(f, mesh());
      return (std::min)({half_chord(side[0]), half_chord(side[1]), half_chord(side[2])});
    };
    const auto faces = mesh().faces();
    const auto side = sides(
      *std::max_element(faces.begin(), faces.end(),
                        [&](Face_index f, Face_index g) { return shortest(f) < shortest(g); }),
      mesh());
    return {mesh().source(side[0]), mesh().source(side[1]), mesh().source(side[2])};
  }

  // Returns the centers of the circles with the digits of `Position`. Each face is positioned
  // beside its predecessor. Directions are rotated from face to face, because directions computed
  // from positions would multiply errors. With the digits of `Decimal_1500`, the shortest edges are
  // crossed first. Then no path between small faces leads across large faces, and errors are
  // proportional to the sizes of the faces.
  template <typename Position>
  std::vector<std::array<Position, 3>> centers() const
  {
    std::vector<std::array<Position, 3>> result(mesh().num_vertices(), {0, 0, 1});
    std::vector<char> is_placed(mesh().num_vertices(), 0), is_done(mesh().num_faces(), 0);
    Crossings<Position> crossings;
    crossings.add(0, mesh().halfedge(*mesh().faces().begin()), {{0, 0, 1}, {1, 0, 0}});
    while(!crossings.empty()) {
      const auto [h, at_source] = crossings.next();
      if(std::exchange(is_done[mesh().face(h).idx()], char(1)))
        continue;
      const std::array<Halfedge_index, 3> side{h, mesh().next(h), mesh().prev(h)};
      const auto frame = frames_of_opposites(side, at_source);
      for(std::size_t s = 0; s < 3; ++s) {
        const Halfedge_index o = mesh().opposite(side[s]);
        if(!std::exchange(is_placed[mesh().source(o).idx()], char(1)))
          result[mesh().source(o).idx()] = frame[s].position;
        if(!is_done[mesh().face(o).idx()])
          crossings.add(priority<Position>(o), o, frame[s]);
      }
    }
    return result;
  }

  // Returns the greatest relative error of a distance between two of these centers.
  template <typename Position>
  double layout_error(const std::vector<std::array<Position, 3>>& center) const
  {
    using std::sqrt;
    typedef Distance_of<Position> Distance;
    double result = 0;
    for(Edge_index e : mesh().edges()) {
      const auto &p = center[mesh().vertex(e, 0).idx()], &q = center[mesh().vertex(e, 1).idx()];
      const Distance chord = 2 * converted<Distance>(m_half_chord[e.idx()]),
                     distance = sqrt(squared_chord<Distance>(p, q));
      result = greater_error(result, std::abs(static_cast<double>(distance / chord) - 1));
    }
    return result;
  }

private:
  // Stores halfedges with their frames, and returns them by priority. With equal priorities, the
  // first one comes first.
  template <typename Position>
  class Crossings
  {
    typedef std::pair<Halfedge_index, Spherical_frame<Position>> Crossing;

  public:
    bool empty() const { return m_next.empty(); }

    void add(int priority, Halfedge_index h, const Spherical_frame<Position>& frame)
    {
      m_next.emplace(priority, -std::ptrdiff_t(m_crossings.size()));
      m_crossings.emplace_back(h, frame);
    }

    Crossing next()
    {
      const auto i = static_cast<std::size_t>(-m_next.top().second);
      m_next.pop();
      return m_crossings[i];
    }

  private:
    std::vector<Crossing> m_crossings;
    std::priority_queue<std::pair<int, std::ptrdiff_t>> m_next; // with negative indices
  };

  // Returns the priority with which an edge is crossed.
  template <typename Position>
  int priority([[maybe_unused]] Halfedge_index h) const
  {
    if constexpr(std::is_same<Position, Decimal_1500>::value)
      return -exponent_of(converted<Position>(half_chord(h)));
    else
      return 0;
  }

  // Returns the frames of the opposites of the sides of a face at their sources. `first` is the
  // frame of the first side.
  template <typename Position>
  std::array<Spherical_frame<Position>, 3>
  frames_of_opposites(const std::array<Halfedge_index, 3>& side,
                      const Spherical_frame<Position>& first) const
  {
    const Triangle t = triangle(side);
    const auto length = [&](std::size_t s) { return converted<Position>(t.length(s)); };
    const auto corner = [&](std::size_t s) {
      const Corner<FT> unit = t.corner(s).scaled();
      return Corner<Position>{converted<Position>(unit.cosine), converted<Position>(unit.sine)};
    };
    const Spherical_frame<Position> last = first.turned(corner(0));
    return {first.at_end(length(0)), last.at_end(length(2)).turned(corner(2)), last};
  }

  const FT& half_chord(Halfedge_index h) const { return m_half_chord[Edge_index(h).idx()]; }

  Triangle triangle(const std::array<Halfedge_index, 3>& side) const
  {
    const auto depth = [&](std::size_t s) { return m_depth[mesh().source(side[s]).idx()]; };
    return {{half_chord(side[0]), half_chord(side[1]), half_chord(side[2])},
            {depth(0), depth(1), depth(2)}};
  }

  Penner_surface<FT> m_surface;
  std::vector<FT> m_half_chord, m_depth; // for edges and vertices, after scaling
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_SPHERICAL_CIRCLE_SURFACE_H
