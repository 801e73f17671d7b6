// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_PROBLEM_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_PROBLEM_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Penner_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/minimization/Shared_order.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Doubled_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Prescribed_curvatures.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Search_work.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Vertex_circles.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/copied_faces.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/input_rounding.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/number_conversion.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/symmetric_lengths.h>
#include <CGAL/Discrete_conformal_maps/internal/verification/metric_error.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Precise_lengths.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Core>
#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Stores the surface that is uniformized, and the conditions at its vertices. A surface with
// boundary is doubled (Section 4.3.4). Conditions are symmetric, so the result is symmetric, and
// only vertices of the surface are unknowns. Only the part of the second copy that edges across the
// boundary reach exists. Beyond it, the copy is the mirror image of the first.
class Doubled_problem : public Prescribed_curvatures
{
public:
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Triangulation;

  // `half` is the surface, without flips. Only its connectivity, lengths and positions are kept.
  // `condition` has one entry for each of its vertices.
  Doubled_problem(Triangulation half, const std::vector<Vertex_condition>& condition,
                  Flipping flipping, Exactness exactness = Exactness::none,
                  Vertex_circles circles = Vertex_circles())
    : Prescribed_curvatures(half.mesh(), condition),
      m_flipping(flipping),
      m_is_measured(exactness == Exactness::errors),
      m_is_exact(exactness == Exactness::decisions),
      m_has_exact_flips(m_is_exact || exactness == Exactness::lengths),
      m_has_needles(m_has_exact_flips && has_exact_metric(half) &&
                    (exactness == Exactness::lengths || has_unknown_angles(half))),
      m_half(Intrinsic_triangulations::internal::without_maps(half.mesh())),
      m_point(half.input_metric().points),
      m_circles(std::move(circles)),
      m_has_copy(m_half.num_faces(), 0)
  {
    if(m_point.empty())
      for(Edge_index e : m_half.edges())
        m_length.push_back(half.length(e));
    std::vector<Vertex_index> boundary;
    for(Vertex_index v : m_half.vertices())
      if(is_on_boundary(v))
        boundary.push_back(v);
    mark_faces_around(std::move(boundary), 1, m_half, m_has_copy);
    build();
  }

  // Returns whether T_2 and T_3 are Delaunay, or equal to T_1.
  Flipping flipping() const { return m_flipping; }

  // Returns whether functions that solve the problem use several threads.
  Intrinsic_triangulations::Concurrency concurrency() const { return m_concurrency; }
  void set_concurrency(Intrinsic_triangulations::Concurrency c) { m_concurrency = c; }

  // Returns the work of all searches for a map, which problems on the same surface may share.
  Search_work& work() const { return *m_work; }
  void share_work(std::shared_ptr<Search_work> work) { m_work = std::move(work); }

  // Returns T_1 and T_2.
  const Triangulation& triangulation() const { return m_triangulation; }
  Triangulation& triangulation() { return m_triangulation; }

  // Returns a number that changes whenever T_1 and T_2 are built again.
  std::size_t version() const { return m_version; }

  // Returns the elimination order of the vertices of the surface, wherever they are variables.
  const std::shared_ptr<Shared_order>& order() const { return m_order; }

  // Returns the elimination order of the vertices of the triangulation.
  std::shared_ptr<Shared_order> expanded_order() const { return m_order->refined(m_original); }

  // Returns the number of flips from T_1 to T_2.
  std::size_t number_of_flips() const { return m_number_of_flips; }

  // Returns whether errors of the map are measured on the exact surface, for rounded lengths of
  // T_2.
  bool is_measured() const { return m_is_measured; }

  // Returns whether the flips to T_3 are decided exactly, too.
  bool is_exact() const { return m_is_exact && has_precise_lengths(); }

  // Returns whether rounding changes angles, so that lengths of T_2 need more digits.
  bool has_needles() const { return m_has_needles && has_precise_lengths(); }

  // Returns whether the lengths of T_2 are exact, with more digits than `double` has.
  bool has_precise_lengths() const { return !m_precise_length.empty(); }

  // Returns whether T_2 on the exact surface may have lengths with more digits.
  bool may_gain_digits() const { return !m_has_exact_flips && !has_radii(); }

  // Computes T_2 by exact decisions, and its lengths on the exact surface, from now on. Returns
  // whether the problem has gained such lengths.
  bool make_precise()
  {
    if(m_has_exact_flips || m_flipping == Flipping::none || has_radii())
      return false;
    m_has_exact_flips = true;
    try {
      build();
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      m_has_exact_flips = false;
      build();
    }
    return has_precise_lengths();
  }

  // Uses the lengths of T_2 on the exact surface until they are dropped. Returns the distance of
  // T_2 and its rounded lengths from the exact surface.
  double take_exact_lengths()
  {
    m_precise_length = exact_lengths<Double_double>(m_triangulation);
    return metric_error(m_triangulation, m_precise_length);
  }
  void drop_exact_lengths() { m_precise_length.clear(); }

  // Returns whether vertices have circles.
  bool has_radii() const { return m_circles.exist(); }

  // Returns the problem with the same T_2 but without circles. Another T_2 has another ideal
  // polyhedron, because Ptolemy flips change lengths.
  // \pre `complete()` has been called, so T_2 is final
  Doubled_problem without_circles() const
  {
    Doubled_problem result(*this);
    result.m_circles = Vertex_circles();
    return result;
  }

  // Returns the radii of the circles at the vertices of the triangulation, if they have circles.
  template <typename FT>
  std::vector<FT> radii() const
  {
    return m_circles.radii<FT>(m_original);
  }

  // Returns the lengths of T_2 with the digits of `FT`, or the lengths of the tangents of circles.
  // `t` is the triangulation of the problem, which may have been moved.
  template <typename FT>
  auto lengths(const Triangulation& t) const
  {
    constexpr bool is_most_precise =
      std::is_same_v<FT, Decimal_115> || std::is_same_v<FT, Decimal_1500>;
    if(is_most_precise && has_precise_lengths() && m_most_precise_length.empty())
      m_most_precise_length = exact_lengths<Decimal_115>(t);
    return boost::make_function_property_map<Edge_index>([this, &t](Edge_index e) {
      if(!has_precise_lengths())
        return without_radii(FT(t.length(e)), e, t);
      if constexpr(is_most_precise)
        return converted<FT>(without_radii(m_most_precise_length[e.idx()], e, t));
      else
        return converted<FT>(without_radii(m_precise_length[e.idx()], e, t));
    });
  }

  // Returns the lengths of T_2 such that mirror images have the same length, with all digits of
  // `FT`. Lengths in `double`, and lengths on the exact surface, are returned unchanged.
  // \pre vertices have no circles
  template <typename FT>
  auto symmetric_lengths(const Triangulation& t) const
  {
    const bool is_unchanged =
      has_precise_lengths() || has_no_copies() || std::is_same_v<FT, double>;
    if(!is_unchanged && m_equal_edge.empty())
      m_equal_edge = edges_of_equal_length(t, m_original);
    return boost::make_function_property_map<Edge_index>(
      [this, &t, is_unchanged, length = lengths<FT>(t)](Edge_index e) {
        return is_unchanged ? FT(get(length, e))
                            : symmetric_length<FT>(e, t, m_original, m_equal_edge);
      });
  }

  // Returns the surface itself.
  const Delta_complex& surface() const { return m_half; }

  // Returns the original on the surface of each vertex of the triangulation.
  const std::vector<Vertex_index>& originals() const { return m_original; }
  Vertex_index original(Vertex_index v) const { return m_original[v.idx()]; }

  // Returns for each vertex another one with the same original, until the last one. From a vertex
  // of the surface, they lead to all its copies.
  std::vector<Vertex_index> next_copies() const
  {
    std::vector<Vertex_index> result(m_original.size());
    for(std::size_t v = size(); v < m_original.size(); ++v) {
      result[v] = result[m_original[v].idx()];
      result[m_original[v].idx()] = Vertex_index(Delta_complex::size_type(v));
    }
    return result;
  }

  using Prescribed_curvatures::part;

  // Returns the share of a face, a half if the face and its copy are in this triangulation.
  double part(Face_index f) const
  {
    return f.idx() < m_half.num_faces() && !m_has_copy[f.idx()] ? 1 : 0.5;
  }

  // Returns the component of a vertex of the triangulation.
  std::size_t component(Vertex_index v) const { return components()[m_original[v.idx()].idx()]; }

  bool has_no_copies() const { return m_original_face.size() == m_half.num_faces(); }

  // Returns values at the vertices of the triangulation: at vertices of the surface and at copies.
  Vector expanded(const Vector& value) const
  {
    return Vector::NullaryExpr(Eigen::Index(m_original.size()), [&](Eigen::Index v) {
      return value[Eigen::Index(m_original[std::size_t(v)].idx())];
    });
  }
  template <typename T>
  std::vector<T> expanded(const std::vector<T>& value) const
  {
    std::vector<T> result;
    result.reserve(m_original.size());
    for(Vertex_index v : m_original)
      result.push_back(value[v.idx()]);
    return result;
  }

  // Returns for each vertex whether faces need not close up at it: a scale factor is prescribed, or
  // a curvature other than zero.
  std::vector<char> cones() const
  {
    std::vector<char> result = expanded(is_fixed());
    const Vector target = expanded(target_defect());
    for(std::size_t v = 0; v < result.size(); ++v)
      result[v] |= target[Eigen::Index(v)] != 0;
    return result;
  }

  // Returns whether the second copy is not deep enough for these flips, starting from T_2. Beyond a
  // seam, the triangulation is the mirror image of the triangulation of the surface. Seams and
  // their mirror images bound a symmetric region, so it suffices that no seam must be flipped.
  bool has_exceeded(const std::vector<Halfedge_index>& flips)
  {
    m_exceeded.clear();
    if(m_seams.empty())
      return false;
    std::vector<char> is_flipped(m_triangulation.input_mesh().num_edges(), 0);
    for(Halfedge_index h : flips)
      is_flipped[Edge_index(h).idx()] = 1;
    for(Edge_index e : m_seams)
      if(is_flipped[e.idx()])
        m_exceeded.push_back(e);
    return !m_exceeded.empty();
  }

  // Returns the edges of T_2 between faces with and without copies.
  const std::vector<Edge_index>& seams() const { return m_seams; }

  // Makes the second copy deeper, and T_1 and T_2 with it, if it was not deep enough for these
  // flips.
  void extend(const std::vector<Halfedge_index>& flips)
  {
    extend(m_width, flips);
    m_width *= 2;
  }

  // Returns the surface in T_3 of these scale factors, with their digits. The copy is made deep
  // enough for it.
  template <typename FT>
  Penner_surface<FT> scaled(const std::vector<FT>& scale)
  {
    for(;;) {
      Penner_surface<FT> result(m_triangulation.mesh(), lengths<FT>(m_triangulation), m_flipping,
                                radii<FT>());
      result.scale(expanded(scale));
      if(!has_exceeded(result.flips()))
        return result;
      extend(result.flips());
    }
  }

  // Copies the whole surface. Returns whether this copies more faces than before.
  bool complete()
  {
    for(Face_index f : m_half.faces())
      m_has_copy[f.idx()] = has_boundary(component(m_half.target(m_half.halfedge(f))));
    if(m_seams.empty())
      return false;
    build();
    return true;
  }

  // Frees the memory of the surface: from now on only prescribed curvatures exist.
  void drop_surface()
  {
    m_half = Delta_complex();
    m_point = std::vector<std::array<double, 3>>();
    m_length = std::vector<double>();
  }

private:
  // Returns the length of the tangent of an edge if vertices have circles, otherwise its length.
  template <typename FT>
  FT without_radii(const FT& length, Edge_index e, const Triangulation& t) const
  {
    return has_radii() ? m_circles.tangent_length(length, e, t, m_original) : length;
  }

  void extend(std::size_t width, const std::vector<Halfedge_index>& flips)
  {
    std::vector<Vertex_index> start;
    for(Edge_index e : m_exceeded)
      for(unsigned end : {0u, 1u})
        start.push_back(m_half.vertex(e, end));
    mark_faces_around(std::move(start), width, m_half, m_has_copy);
    mark_flipped_regions(m_triangulation.input_mesh(), {&m_flips, &flips}, m_original_face,
                         m_has_copy);
    build();
  }

  // Rebuilds T_1 and T_2.
  void build()
  {
    const Doubled_surface surface(m_half, m_has_copy);
    m_equal_edge.clear();
    ++m_version;
    m_triangulation =
      m_point.empty() ? surface.triangulation(m_length) : surface.triangulation(m_point);
    m_original = surface.originals();
    m_original_face = surface.original_faces();
    m_seams = surface.seams();
    if(m_flipping == Flipping::to_Delaunay)
      flip_to_Delaunay();
    if(has_radii())
      m_circles.check(m_triangulation, m_original, [this](Edge_index e) {
        return has_precise_lengths() ? m_precise_length[e.idx()].high() : m_triangulation.length(e);
      });
  }

  struct Flip_record
  {
    void after_flip(Halfedge_index h) { flips.push_back(h); }
    void before_exact_flips() { flips.clear(); } // they start from T_1
    std::vector<Halfedge_index>& flips;
  };

  void flip_to_Delaunay()
  {
    m_flips.clear();
    Flip_record record{m_flips};
    if(has_radii())
      m_number_of_flips = m_circles.flip(m_triangulation, m_original, m_has_exact_flips, record);
    else if(m_has_exact_flips)
      m_number_of_flips = flip_exactly(m_triangulation, record);
    else
      m_number_of_flips = Intrinsic_triangulations::make_Delaunay(
        m_triangulation, Intrinsic_triangulations::parameters::visitor(std::ref(record)));
    m_most_precise_length.clear();
    if(has_exceeded(m_flips))
      extend(0, {});
    else if(m_has_exact_flips)
      find_precise_lengths();
  }

  // Computes precise lengths. If 1024 bits do not suffice, rounded lengths are kept, unless exact
  // lengths are requested.
  void find_precise_lengths()
  {
    try {
      m_precise_length = exact_lengths<Double_double>(m_triangulation);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
      if(m_is_exact)
        throw;
      m_precise_length.clear();
    }
  }

  Flipping m_flipping;
  Intrinsic_triangulations::Concurrency m_concurrency;
  bool m_is_measured, m_is_exact, m_has_exact_flips, m_has_needles;
  Delta_complex m_half;
  std::vector<std::array<double, 3>> m_point; // of the vertices of the surface, if there are any
  std::vector<double> m_length;               // otherwise of its edges
  Vertex_circles m_circles;
  std::vector<char> m_has_copy; // for each face of the surface
  std::size_t m_width = 1;      // that are copied the next time
  Triangulation m_triangulation;
  std::vector<Double_double> m_precise_length;            // of T_2, if flips are exact
  mutable std::vector<Decimal_115> m_most_precise_length; // where these have too few digits
  mutable std::vector<Edge_index> m_equal_edge; // see `edges_of_equal_length()`, where it is needed
  std::size_t m_version = 0, m_number_of_flips = 0;
  std::vector<Vertex_index> m_original;
  std::vector<Face_index> m_original_face;
  std::vector<Halfedge_index> m_flips; // to T_2
  std::vector<Edge_index> m_seams;     // between faces with and without copies
  std::vector<Edge_index> m_exceeded;  // where the copy is not deep enough
  std::shared_ptr<Shared_order> m_order = std::make_shared<Shared_order>();
  std::shared_ptr<Search_work> m_work = std::make_shared<Search_work>();
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_SCALE_FACTORS_DOUBLED_PROBLEM_H
