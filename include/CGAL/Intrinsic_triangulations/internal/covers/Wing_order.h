// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_WING_ORDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_WING_ORDER_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// Orders triangles with a common side by their angles around it. The order is counterclockwise,
// seen against the direction of the side. The angle is zero at a reference. All decisions are
// exact. Triangles with one angle lie in one plane. They are stacked by their indices, in the
// direction of the normal whose first nonzero component is positive. So equal triangles have the
// same order around all their sides. Triangles without a plane come last.
template <typename Point_>
class Wing_order
{
  typedef typename Kernel_traits<Point_>::Kernel Own_kernel;
  static constexpr bool is_floating = std::is_floating_point_v<typename Own_kernel::FT>;
  typedef std::conditional_t<is_floating, Exact_predicates_inexact_constructions_kernel, Own_kernel>
    Kernel;
  typedef typename Kernel::Point_3 Point;

public:
  // Stores an apex of a triangle, with the index of the triangle.
  struct Wing
  {
    Point apex;
    std::size_t index;
    int section; // of the angle: at the reference, less than pi, pi, more, without a plane
  };

  Wing_order(const Point_& from, const Point_& to)
    : m_from(converted(from)), m_to(converted(to)), m_reference(m_from)
  {}

  void set_reference(const Point_& apex) { m_reference = converted(apex); }

  bool has_plane(const Point_& apex) const
  {
    return !typename Kernel::Collinear_3()(m_from, m_to, converted(apex));
  }

  Wing wing(const Point_& apex, std::size_t index) const
  {
    const Point p = converted(apex);
    return {p, index, section(p)};
  }

  bool operator()(const Wing& a, const Wing& b) const
  {
    if(a.section != b.section)
      return a.section < b.section;
    const Orientation turn = a.section == 1 || a.section == 3
                               ? typename Kernel::Orientation_3()(m_from, m_to, a.apex, b.apex)
                               : COPLANAR;
    if(turn != COPLANAR)
      return turn == POSITIVE;
    return is_stacked_upwards(a.apex) ? a.index < b.index : b.index < a.index;
  }

private:
  static Point converted(const Point_& p)
  {
    if constexpr(is_floating)
      return Point(double(p.x()), double(p.y()), double(p.z()));
    else
      return p;
  }

  int section(const Point& apex) const
  {
    if(typename Kernel::Collinear_3()(m_from, m_to, apex))
      return 4;
    const Orientation turn = typename Kernel::Orientation_3()(m_from, m_to, m_reference, apex);
    if(turn != COPLANAR)
      return turn == POSITIVE ? 1 : 3;
    return typename Kernel::Coplanar_orientation_3()(m_from, m_to, m_reference, apex) == POSITIVE
             ? 0
             : 2;
  }

  // Returns whether the normal of the triangle has the chosen direction. Without a normal, returns
  // true.
  bool is_stacked_upwards(const Point& apex) const
  {
    for(int x = 0; x < 3; ++x) {
      const auto flat = [&](const Point& p) {
        return typename Kernel::Point_2(p[(x + 1) % 3], p[(x + 2) % 3]);
      };
      const Orientation turn =
        typename Kernel::Orientation_2()(flat(m_from), flat(m_to), flat(apex));
      if(turn != COLLINEAR)
        return turn == LEFT_TURN;
    }
    return true;
  }

  Point m_from, m_to, m_reference;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVERS_WING_ORDER_H
