// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_CIRCUMCENTER_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_CIRCUMCENTER_WALK_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>
#include <CGAL/Intrinsic_triangulations/triangle_formulas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out faces in the plane by their side lengths.
template <typename EdgeLengthMap>
class Layout_by_lengths
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef std::complex<FT> Vector;

public:
  explicit Layout_by_lengths(const Surface_view<EdgeLengthMap>& surface) : m_surface(surface) {}

  // Returns the side from which a face is laid out.
  Halfedge_index first_side(Face_index f) const { return m_surface.mesh().halfedge(f); }

  FT circumradius(Face_index f) const { return Face_metric<FT>(f, m_surface).circumradius(); }

  // Returns the third corner of the face of `h` if its side lies between the others.
  Vector apex(Halfedge_index h, const Vector& source, const Vector& target) const
  {
    return source - normalized(target - source) * Flat_face<FT>(h, m_surface).side(2);
  }

  // Returns the circumcenter if `h` lies on the x-axis and starts at the origin.
  Vector circumcenter(Halfedge_index h) const
  {
    const auto [base, left, right] = side_lengths(h, m_surface);
    return Vector(base, doubled_corner_product(base, left, right) * base /
                          quadrupled_area(base, left, right)) /
           FT(2);
  }

  // Returns the foot of the height over `h`, as a fraction of this side.
  FT foot(Halfedge_index h) const
  {
    const auto [base, left, right] = side_lengths(h, m_surface);
    return doubled_corner_product(left, base, right) / (2 * base * base);
  }

  // Returns the barycentric coordinates of `p` in the face of `h`. All are zero if they are
  // unknown.
  std::array<FT, 3> coordinates(Halfedge_index, const std::array<Vector, 3>& corner,
                                const Vector& p) const
  {
    std::array<FT, 3> weight;
    FT sum(0);
    for(std::size_t k = 0; k < 3; ++k) {
      const Vector &source = corner[(k + 1) % 3], &target = corner[(k + 2) % 3];
      sum += weight[k] = (std::max)(cross(target - source, p - source), FT(0));
    }
    if(!(sum > *std::max_element(weight.begin(), weight.end())))
      return {FT(0), FT(0), FT(0)};
    for(FT& w : weight)
      w /= sum;
    return weight;
  }

private:
  Surface_view<EdgeLengthMap> m_surface;
};

// Lays out faces in the plane by corners that are accurate in the thinnest faces.
template <typename Decisions, typename Surface>
class Layout_by_decisions
{
  typedef std::complex<double> Vector;

public:
  Layout_by_decisions(const Decisions& decisions, const Surface& surface)
    : m_decisions(decisions), m_surface(surface)
  {}

  Halfedge_index first_side(Face_index f) const { return m_decisions.shortest_side(f); }

  double circumradius(Face_index f) const { return m_decisions.rounded_circumradius(f); }

  // Returns the third corner of the face of `h`, computed from the nearer end.
  Vector apex(Halfedge_index h, const Vector& source, const Vector& target) const
  {
    const auto [base, left, right] = side_lengths(h, m_surface);
    return right < left
             ? source + (target - source) * m_decisions.rounded_corner(h)
             : target + (source - target) / m_decisions.rounded_corner(m_surface.mesh().next(h));
  }

  Vector circumcenter(Halfedge_index h) const
  {
    const Vector k = m_decisions.rounded_corner(h);
    return edge_length(h, m_surface) / 2 * Vector(1, (std::norm(k) - k.real()) / k.imag());
  }

  double foot(Halfedge_index h) const { return m_decisions.rounded_corner(h).real(); }

  // Returns the barycentric coordinates of `p` in the face of `h`, computed from the nearest
  // corner.
  std::array<double, 3> coordinates(Halfedge_index h, const std::array<Vector, 3>& corner,
                                    const Vector& p) const
  {
    const Delta_complex& mesh = m_surface.mesh();
    const std::size_t i =
      static_cast<std::size_t>(std::min_element(corner.begin(), corner.end(),
                                                [&](const Vector& a, const Vector& b) {
                                                  return std::norm(p - a) < std::norm(p - b);
                                                }) -
                               corner.begin());
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Vector apex = m_decisions.rounded_corner(i == 0   ? h
                                                   : i == 1 ? mesh.next(h)
                                                            : mesh.prev(h));
    const Vector place = (p - corner[i]) / (corner[j] - corner[i]);
    std::array<double, 3> weight;
    weight[k] = (std::max)(place.imag() / apex.imag(), 0.);
    weight[j] = (std::max)(place.real() - weight[k] * apex.real(), 0.);
    weight[i] = (std::max)(1 - weight[j] - weight[k], 0.);
    const double sum = weight[0] + weight[1] + weight[2];
    for(double& w : weight)
      w /= sum;
    return weight[i] < 1 ? weight : std::array<double, 3>{0, 0, 0};
  }

private:
  const Decisions& m_decisions;
  Surface m_surface;
};

// Walks from the barycenter of a face straight to its circumcenter (Figure 3.10, right), in the
// plane of the triangles passed.
template <typename EdgeLengthMap>
class Circumcenter_walk
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef std::complex<FT> Vector;

public:
  enum class End
  {
    inside,  // of the face of halfedge(), with coordinates()
    on_edge, // of halfedge(), at along()
    blocked, // by the edge of halfedge()
    lost     // the face has no area, or the circumcenter is too far away or a corner
  };

  explicit Circumcenter_walk(const Surface_view<EdgeLengthMap>& surface)
    : m_surface(surface), m_mesh(surface.mesh())
  {}

  // Walks until an edge satisfies `is_fixed(h)`, or the number of steps reaches the number of
  // faces. A circumcenter farther away belongs to a face that is not Delaunay, because no empty
  // circle is that large.
  template <typename Is_fixed, typename Layout>
  End walk(Face_index f, const Is_fixed& is_fixed, const Layout& layout)
  {
    const Halfedge_index h = layout.first_side(f);
    set_first_face(h, layout, layout.circumcenter(h));
    return walk_from((m_corner[0] + m_corner[1] + m_corner[2]) / FT(3), is_fixed, layout);
  }

  // Walks from the source of `h` to the point at `direction` from it, and does not move this point
  // onto edges. The x-axis lies along `h`, and the walk begins in the face of `h`.
  template <typename Is_fixed, typename Layout>
  End walk(Halfedge_index h, const Vector& direction, const Is_fixed& is_fixed,
           const Layout& layout)
  {
    set_first_face(h, layout, direction);
    m_radius = 0;
    return walk_from(Vector(0), is_fixed, layout);
  }

  Halfedge_index halfedge() const { return m_halfedge; }

  // Returns the location in the face of `halfedge()`. The end on an edge has not been moved here.
  Face_location<FT> location() const
  {
    const std::size_t first = side_number(m_halfedge, m_mesh);
    std::array<FT, 3> b;
    for(std::size_t k = 0; k < 3; ++k)
      b[(first + k) % 3] = m_weight[k];
    return {m_mesh.face(m_halfedge), b};
  }

  const FT& along() const { return m_along; }
  Face_location<FT> location_on_edge() const
  {
    return face_location(Edge_point<FT>{m_halfedge, m_along}, m_mesh);
  }

  // Returns the distance by which the end may be moved onto an edge.
  FT closeness() const { return m_radius * circumcenter_tolerance<FT>(); }

private:
  template <typename Is_fixed, typename Layout>
  End walk_from(const Vector& start, const Is_fixed& is_fixed, const Layout& layout)
  {
    if(!std::isfinite(m_center.imag()))
      return End::lost;
    std::size_t exit = first_exit(start);
    for(std::size_t steps = 0; !is_left_of_side(exit); ++steps) {
      m_halfedge = side(exit);
      if(is_fixed(m_halfedge))
        return End::blocked;
      if(steps > m_mesh.number_of_faces())
        return End::lost;
      cross_side(exit, layout);
      exit = cross(m_center - start, m_corner[2] - start) > 0 ? 1 : 2;
    }
    return place(is_fixed, layout);
  }

  // Places corner 0 at the origin and corner 1 on the real axis.
  template <typename Layout>
  void set_first_face(Halfedge_index h, const Layout& layout, const Vector& center)
  {
    const FT base = edge_length(h, m_surface);
    m_halfedge = h;
    m_corner = {Vector(0), Vector(base), layout.apex(h, Vector(0), Vector(base))};
    m_center = center;
    m_radius = CGAL::sqrt(dot(m_center, m_center));
  }

  Halfedge_index side(std::size_t s) const
  {
    return s == 0 ? m_halfedge : s == 1 ? m_mesh.next(m_halfedge) : m_mesh.prev(m_halfedge);
  }

  // Returns the side whose source is to the right of the line from `start` to the center, and its
  // target to the left.
  std::size_t first_exit(const Vector& start) const
  {
    std::array<FT, 3> left;
    for(std::size_t k = 0; k < 3; ++k)
      left[k] = cross(m_center - start, m_corner[k] - start);
    for(std::size_t s = 0; s < 2; ++s)
      if(left[s] <= 0 && left[s + 1] > 0)
        return s;
    return 2;
  }

  FT area_at_side(std::size_t s) const
  {
    const Vector& source = m_corner[s];
    return cross(m_corner[(s + 1) % 3] - source, m_center - source);
  }

  bool is_left_of_side(std::size_t s) const { return area_at_side(s) >= 0; }

  // Continues in the face beyond side `s`, which becomes its side 0.
  template <typename Layout>
  void cross_side(std::size_t s, const Layout& layout)
  {
    const Vector source = m_corner[(s + 1) % 3], target = m_corner[s];
    m_halfedge = m_mesh.opposite(m_halfedge); // already that of the side
    m_corner = {source, target, layout.apex(m_halfedge, source, target)};
  }

  // Snaps a circumcenter close to an edge to this edge. Otherwise it would leave a face without
  // area and, on an edge of T1, a piece without length.
  template <typename Is_fixed, typename Layout>
  End place(const Is_fixed& is_fixed, const Layout& layout)
  {
    m_weight = layout.coordinates(m_halfedge, m_corner, m_center);
    if(m_weight[0] == 0 && m_weight[1] == 0 && m_weight[2] == 0)
      return End::lost;
    for(std::size_t s = 0; s < 3; ++s)
      if(height_over_side(s) <= closeness() && is_fixed(side(s))) {
        m_halfedge = side(s);
        return End::blocked;
      }
    const std::size_t s = nearest_side();
    return height_over_side(s) <= closeness() ? move_to_side(s, layout.foot(side(s))) : End::inside;
  }

  std::size_t nearest_side() const
  {
    std::size_t result = 0;
    for(std::size_t s = 1; s < 3; ++s)
      if(height_over_side(s) < height_over_side(result))
        result = s;
    return result;
  }

  // Moves the center along the height, not towards the opposite corner. In a face thinner than its
  // distance from the side, that corner can be anywhere along the side.
  End move_to_side(std::size_t s, const FT& foot)
  {
    const FT along = m_weight[(s + 1) % 3] + m_weight[(s + 2) % 3] * foot;
    if(!(along > 0 && along < 1))
      return End::inside;
    m_halfedge = side(s);
    std::rotate(m_weight.begin(), m_weight.begin() + s, m_weight.end());
    m_along = along;
    return End::on_edge;
  }

  FT height_over_side(std::size_t s) const
  {
    return area_at_side(s) / edge_length(side(s), m_surface);
  }

  Surface_view<EdgeLengthMap> m_surface;
  const Delta_complex& m_mesh;
  Halfedge_index m_halfedge; // side 0 of the current face
  std::array<Vector, 3> m_corner;
  Vector m_center;
  FT m_radius{};
  std::array<FT, 3> m_weight{};
  FT m_along{};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REFINEMENT_CIRCUMCENTER_WALK_H
