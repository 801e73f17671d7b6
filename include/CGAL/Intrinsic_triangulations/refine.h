// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REFINE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REFINE_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/refinement/Delaunay_refinement.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/number_of_insertions.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// a visitor that does nothing. A class derived from it redefines only the functions that it needs.
///
/// \cgalModels `RefinementVisitor`
struct Default_refinement_visitor : Default_flip_visitor
{
  /// is called after the vertex `v` has been inserted.
  template <typename Traits>
  void after_insertion(Vertex_index /* v */, const Vertex_inserter<Traits>& /* inserter */)
  {}
  /// is called after the vertex `v` has been removed.
  void after_removal(Vertex_index /* v */, Face_index /* f */) {}
  /// is called after elements have been renumbered.
  void after_renumbering() {}
  /// is called if rounding leaves too many decisions undecided. \f$T_2\f$ has been reset to
  /// \f$T_1\f$, with the vertices that it had at the start, and refinement restarts with exact
  /// decisions.
  void before_exact_refinement() {}
};

namespace internal {

// Stores the bounds that faces must satisfy.
template <typename Traits, typename Predicate>
class Face_bounds
{
  typedef Intrinsic_triangulation<Traits> Triangulation;
  typedef typename Traits::FT FT;

public:
  Face_bounds(const Triangulation& tri, const FT& degrees, const FT& circumradius,
              bool is_simplicial, const Predicate& predicate)
    : m_tri(tri),
      m_sine(std::sin(degrees * pi<FT>() / 180)),
      m_circumradius(circumradius),
      m_is_simplicial(is_simplicial),
      m_predicate(predicate)
  {}

  // Returns whether `f` violates the bound on angles. With sides a <= b <= c, the sine of the
  // least angle is a * quadrupled_area / (2 abc).
  bool is_too_thin(Face_index f) const
  {
    const Face_metric<FT> face(f, m_tri.intrinsic());
    return face.quadrupled_area() * (std::min)({face.length(0), face.length(1), face.length(2)}) <
           2 * face.product() * m_sine;
  }

  // Returns whether `f` violates the bound on the circumradius, or the predicate requires its
  // refinement.
  bool is_too_large(Face_index f) const
  {
    const Face_metric<FT> face(f, m_tri.intrinsic());
    return face.product() > m_circumradius * face.quadrupled_area() || m_predicate(f);
  }

  // Returns the least angle around a vertex at which faces can have 30 degrees. Three of them are
  // necessary in a simplicial triangulation.
  FT small_angle() const { return m_is_simplicial ? pi<FT>() / 2 : pi<FT>() / 3; }

  // Returns whether `f` prevents the triangulation from being simplicial, if this is required.
  bool is_not_simplicial(Face_index f) const
  {
    return m_is_simplicial && !is_simplicial(f, m_tri.mesh());
  }

private:
  const Triangulation& m_tri;
  FT m_sine, m_circumradius;
  bool m_is_simplicial;
  const Predicate& m_predicate;
};

struct No_face
{
  bool operator()(Face_index) const { return false; }
};

// Returns why a face without excuse has not been refined.
template <typename Traits>
Remaining_reason reason_left(const Intrinsic_triangulation<Traits>& tri, Face_index f,
                             const Refinement_result& result)
{
  if(result.status == Refinement_status::insertion_limit)
    return Remaining_reason::insertion_limit;
  if constexpr(has_exact_decisions<Traits>())
    if(result.is_exact)
      return exact_decisions(tri).orientation(tri.mesh().halfedge(f)) == POSITIVE
               ? Remaining_reason::at_rounding
               : Remaining_reason::no_area;
  return Remaining_reason::no_room;
}

// Returns the faces that violate the bounds after a refinement with the result `result`.
template <typename Traits, typename Bounds>
std::vector<Remaining_face> remaining_faces(const Intrinsic_triangulation<Traits>& tri,
                                            const Bounds& bounds, const Refinement_result& result)
{
  const Small_angle_vertices<Traits> vertices(tri, bounds.small_angle(), result.is_exact);
  std::optional<Edge_courses<Traits>> made;
  const auto courses = [&]() -> const auto&
  {
    return made ? *made : made.emplace(tri, Concurrency());
  };
  std::vector<Remaining_face> remaining;
  const auto unexcused = [&](Face_index f) {
    return Remaining_face{f, reason_left(tri, f, result), tri.mesh().null_vertex()};
  };
  for(Face_index f : tri.mesh().faces()) {
    if(bounds.is_too_large(f) || bounds.is_not_simplicial(f))
      remaining.push_back(unexcused(f));
    else if(bounds.is_too_thin(f)) {
      const auto excuse = vertices.excuse(f, courses);
      remaining.push_back(excuse ? *excuse : unexcused(f));
    }
  }
  return remaining;
}

// Sets the faces that remain, and returns whether one of them has no excuse.
template <typename Traits, typename Bounds>
bool note_remaining(const Intrinsic_triangulation<Traits>& tri, const Bounds& bounds,
                    Refinement_result& result)
{
  result.remaining = remaining_faces(tri, bounds, result);
  const bool all_excused =
    std::all_of(result.remaining.begin(), result.remaining.end(), is_excused);
  if(result.status != Refinement_status::insertion_limit)
    result.status = result.remaining.empty() ? Refinement_status::bounds_met
                    : all_excused            ? Refinement_status::bounds_met_but_excused
                                             : Refinement_status::no_room;
  return !all_excused;
}

// Inserts vertices and leaves no garbage, not even after an exception. Returns whether no decision
// was left undecided by rounding.
template <typename Traits, typename Bounds, typename Visitor>
bool insert_vertices(Intrinsic_triangulation<Traits>& tri, const Bounds& bounds,
                     const Refinement_limits& limits, Visitor& visitor, bool stops_if_filter_fails,
                     Refinement_result& result)
{
  bool is_certain = false;
  Delaunay_refinement<Traits, Bounds, Visitor> refinement(tri, bounds, limits, visitor,
                                                          result.is_exact);
  change_or_undo([&] { is_certain = refinement.run(stops_if_filter_fails, result); },
                 [&] { tri.collect_garbage(); });
  if(tri.mesh().has_garbage()) {
    tri.collect_garbage();
    visitor.after_renumbering();
  }
  return is_certain;
}

// Flips to Delaunay with certain decisions, or else with recomputed lengths.
template <typename Traits, typename Visitor>
Flipping_result flip_afresh(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                            Visitor& visitor)
{
  if constexpr(has_exact_decisions<Traits>())
    return flip_filtered(tri, limit, refinement_effort(), visitor, Concurrency());
  tri.recompute_lengths();
  return flip_by_lengths(tri, limit, rounds_of_flips(), visitor);
}

// Recomputes lengths that have many roundings. Edges and faces that violate their conditions are
// flipped and refined again. Returns whether all decisions are certain. If not, and with
// `stops_if_filter_fails`, this can end at any step.
template <typename Traits, typename Bounds, typename Visitor>
bool refine_by_lengths(Intrinsic_triangulation<Traits>& tri, const Bounds& bounds,
                       const Refinement_limits& limits, Visitor& visitor,
                       bool stops_if_filter_fails, Refinement_result& result)
{
  for(int round = 0; round < 20; ++round) {
    const std::size_t before = result.insertions + result.flips;
    if(!insert_vertices(tri, bounds, limits, visitor, stops_if_filter_fails, result) &&
       stops_if_filter_fails)
      return false;
    const Flipping_result flips = flip_afresh(tri, limits.flips, visitor);
    result.flips += flips.flips;
    if(!flips.is_Delaunay()) {
      if(stops_if_filter_fails)
        return false;
      check_flip_limit(flips.end == Flipping_result::End::limit);
      throw Numerical_error("rounding of the lengths prevents a Delaunay refinement");
    }
    if(!note_remaining(tri, bounds, result) || result.insertions + result.flips == before ||
       result.status == Refinement_status::insertion_limit)
      break;
  }
  return result.status != Refinement_status::no_room;
}

// Continues from `tri` with exact decisions.
template <typename Traits, typename Bounds, typename Visitor>
Refinement_result refine_exactly(Intrinsic_triangulation<Traits>& tri, const Bounds& bounds,
                                 const Refinement_limits& limits, Visitor& visitor,
                                 Refinement_result result = {})
{
  result.is_exact = true;
  result.status = Refinement_status::bounds_met;
  result.flips += flip_exactly(tri, limits.flips, visitor, Concurrency()).flips;
  insert_vertices(tri, bounds, limits, visitor, false, result);
  note_remaining(tri, bounds, result);
  return result;
}

// Flips to Delaunay before refinement. If edges are bent now, faces around inserted vertices could
// overlap later although all edges are straight.
template <typename Traits, typename Visitor>
Flipping_result flip_before_refinement(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                                       Visitor& visitor)
{
  if constexpr(has_exact_decisions<Traits>())
    if(tri.number_of_inserted_vertices() > 0)
      return flip_exactly(tri, limit, visitor, Concurrency());
  return make_Delaunay(tri, limit, visitor);
}

// Restarts with exact decisions if rounding leaves decisions undecided. The restart begins with T1
// and the vertices that had been inserted before.
template <typename Traits, typename Bounds, typename Visitor>
Refinement_result refine_until_filter_fails(Intrinsic_triangulation<Traits>& tri,
                                            const Bounds& bounds, const Refinement_limits& limits,
                                            Visitor& visitor)
{
  [[maybe_unused]] const std::size_t given = tri.number_of_inserted_vertices();
  const bool can_be_exact = has_exact_decisions<Traits>() && can_be_reset(tri);
  const Flipping_result flips = flip_before_refinement(tri, limits.flips, visitor);
  Refinement_result result;
  result.flips = flips.flips;
  [[maybe_unused]] const bool is_certain =
    !flips.is_exact && refine_by_lengths(tri, bounds, limits, visitor, can_be_exact, result);
  if constexpr(has_exact_decisions<Traits>())
    if(!is_certain && can_be_exact) {
      reset_with_vertices(tri, given);
      visitor.before_exact_refinement();
      return refine_exactly(tri, bounds, limits, visitor);
    }
  return result;
}

// Returns the maximal number of vertices to insert.
template <typename Traits, typename NamedParameters>
std::size_t insertion_limit(const Intrinsic_triangulation<Traits>& tri,
                            const typename Traits::FT& degrees,
                            const typename Traits::FT& circumradius, const NamedParameters& np)
{
  typedef internal_np::maximum_number_of_insertions_t Tag;
  if constexpr(has_parameter<NamedParameters, Tag>())
    return static_cast<std::size_t>(CGAL::parameters::get_parameter(np, Tag()));
  else
    return default_maximum_number_of_insertions(tri, degrees, circumradius);
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRefinement
/// inserts vertices into `tri` and flips it to Delaunay until every face obeys the bounds or is
/// excused (Chew's second algorithm, Algorithm 5, \cgalCite{Che93}). The surface and the vertices
/// of the input do not change. After any status, \f$T_2\f$ is Delaunay, and the result names every
/// face that violates a bound.
///
/// Excused faces. A small-angle vertex has an angle sum of less than 60 degrees, or two boundary or
/// constrained edges that enclose less than 60 degrees. If \f$T_2\f$ is to be simplicial, the sum
/// must be 90 degrees, since three faces are needed. No triangulation has large angles at such a
/// vertex. A face that violates the bound on angles, and only this one, is excused in two cases:
/// - Exactly one of its corners is a small-angle vertex.
/// - It lies in faces of \f$T_1\f$ at one small-angle vertex \f$v\f$, and all edges of \f$T_1\f$
///   that cross it end at \f$v\f$.
///
/// Termination is proven in exact arithmetic for angles of up to 30 degrees, on closed surfaces
/// without small-angle vertices and constrained edges (Theorem 3). Otherwise only
/// `maximum_number_of_insertions` guarantees an end.
///
/// Decisions are exact if lengths of type `double` do not determine the angles of \f$T_1\f$
/// (`has_unresolved_angles()`). Otherwise lengths decide at first. Refinement restarts from
/// \f$T_1\f$, with the vertices inserted at the start, and with exact decisions in these cases:
/// - A face remains after the insertion of its circumcenter.
/// - A position or a length cannot be computed.
/// - Edges are bent at the end.
/// - A face violates a bound without an excuse.
///
/// With exact decisions, a new vertex lies exactly at its coordinates of type `double` on
/// \f$T_1\f$. It is inserted only if its edges are then straight and its faces positive. Otherwise
/// points farther inside the face are tried. If none of them is possible, the bad face is left,
/// with the reason `at_rounding`.
///
/// \tparam Traits a model of `IntrinsicGeometryTraitsWithDistance` whose number type is a floating
///   point type
/// \tparam NamedParameters a sequence of named parameters
/// \param tri the triangulation
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_angle}
///     \cgalParamDescription{the least angle, from 0 to 60 degrees; 0 for no bound}
///     \cgalParamDefault{25}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_circumradius}
///     \cgalParamDescription{the greatest circumradius, which is positive}
///     \cgalParamDefault{infinite}
///   \cgalParamNEnd
///   \cgalParamNBegin{simplicial}
///     \cgalParamDescription{whether \f$T_2\f$ is to be simplicial, see `is_simplicial()`: without
///       loops, and with one edge at most between two vertices}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_predicate}
///     \cgalParamDescription{a function that returns whether a face of \f$T_2\f$ is to be refined}
///     \cgalParamType{callable with a `Face_index`, returns `bool`}
///     \cgalParamDefault{no face}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_insertions}
///     \cgalParamDescription{the number of vertices that may be inserted}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`default_maximum_number_of_insertions()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{exact_decisions}
///     \cgalParamDescription{whether all decisions are exact from the beginning, with lengths of
///       type `double`, too}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the number of flips that are allowed before the first insertion, and
///       after each insertion. After an insertion it is a thousand for each edge at most}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{as for `make_Delaunay()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of every change of `tri`; an exception that it throws
///                           stops the refinement and leaves `tri` valid}
///     \cgalParamType{a model of `RefinementVisitor`; it is copied unless
///       `std::ref()` refers to it}
///     \cgalParamDefault{`Default_refinement_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the elements and crossings, and for each insertion in the faces around the
/// new vertex and the crossings on them.
/// \returns the numbers of operations, the status, and the faces that violate the bounds, with the
///   reason
/// \throws Flip_limit_exceeded, Numerical_error, Overflow_error as `make_Delaunay()`
/// \throws Invalid_input if a bound is out of its range, or if the bound on circumradii needs more
///   insertions than the default
///
/// After an exception `tri` is a valid triangulation of the same surface without garbage.
/// \post `tri` is Delaunay and has no garbage; with exact traits, and with lengths of type
///   `double`, exactly: `certify_Delaunay()` confirms it
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Refinement_result refine(Intrinsic_triangulation<Traits>& tri,
                         const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef typename Traits::FT FT;
  const FT degrees(choose_parameter(get_parameter(np, internal_np::minimum_angle), FT(25)));
  const FT circumradius(choose_parameter(get_parameter(np, internal_np::maximum_circumradius),
                                         std::numeric_limits<FT>::infinity()));
  if(!(degrees >= 0 && degrees <= 60))
    throw Invalid_input("the least angle is not between 0 and 60 degrees");
  if(!(circumradius > 0))
    throw Invalid_input("the greatest circumradius is not positive");
  const bool simplicial = choose_parameter(get_parameter(np, internal_np::simplicial), false);
  const auto predicate =
    choose_parameter(get_parameter(np, internal_np::face_predicate), internal::No_face());
  Default_refinement_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  const internal::Face_bounds<Traits, decltype(predicate)> bounds(tri, degrees, circumradius,
                                                                  simplicial, predicate);
  const internal::Refinement_limits limits{
    internal::insertion_limit(tri, degrees, circumradius, np),
    internal::flip_limit(tri.mesh(), np)};
  [[maybe_unused]] const bool are_exact = internal::are_exact_decisions_wanted<Traits>(np);
  if constexpr(internal::has_exact_decisions<Traits>())
    if(internal::Is_exact<Traits>::value || are_exact)
      return internal::refine_exactly(tri, bounds, limits, visitor);
  if constexpr(!internal::Is_exact<Traits>::value)
    return internal::refine_until_filter_fails(tri, bounds, limits, visitor);
}

} // namespace CGAL::Intrinsic_triangulations

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
namespace CGAL::Intrinsic_triangulations::internal {

typedef Face_bounds<Euclidean_geometry_traits<double>, const No_face> Default_face_bounds;

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Refinement_result
refine_until_filter_fails(Intrinsic_triangulation<>&, const Default_face_bounds&,
                          const Refinement_limits&, Default_refinement_visitor&);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Refinement_result
refine_exactly(Intrinsic_triangulation<>&, const Default_face_bounds&, const Refinement_limits&,
               Default_refinement_visitor&, Refinement_result);

} // namespace CGAL::Intrinsic_triangulations::internal
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REFINE_H
