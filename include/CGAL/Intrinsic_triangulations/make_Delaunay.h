// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELAUNAY_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Edge_stack.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Exact_flipping.h>
#include <CGAL/Intrinsic_triangulations/internal/flipping/Flipped_lengths.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/reinsert_vertices.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/thin_faces.h>
#include <CGAL/Intrinsic_triangulations/tolerances.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// a visitor that does nothing. A class derived from it redefines only the functions that it needs.
///
/// \cgalModels `FlipVisitor`
struct Default_flip_visitor
{
  /// is called after the edge of `h` has been flipped.
  void after_flip(Halfedge_index /* h */) {}
  /// is called if edges were bent, before flipping restarts: \f$T_2\f$ is \f$T_1\f$ again, with
  /// the inserted vertices.
  void before_exact_flips() {}
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// returns whether every edge of `tri` that could be flipped is Delaunay (Equation 2.6). With
/// floating point numbers the tolerance is one-sided. `false` means that an edge with the stored
/// lengths is not Delaunay. `true` means that all are Delaunay with lengths within
/// `rounding_unit()` of the stored ones.
/// Complexity: linear.
template <typename Traits>
bool is_Delaunay(const Intrinsic_triangulation<Traits>& tri)
{
  for(Edge_index e : tri.mesh().edges())
    if(!tri.is_Delaunay(e))
      return false;
  return true;
}

namespace internal {

// Returns whether an operation succeeds in spite of rounding. If not, exact decisions must follow.
template <typename Traits, typename Operation>
bool succeeds(const Operation& operation)
{
  try {
    operation();
  } catch(const Numerical_error&) {
    if(!has_exact_decisions<Traits>())
      throw;
    return false;
  }
  return true;
}

// Decides about flips by the stored lengths.
template <typename Traits>
class Flipping_by_lengths
{
  typedef Intrinsic_triangulation<Traits> Triangulation;

public:
  explicit Flipping_by_lengths(Triangulation& tri) : m_tri(tri) {}

  // Returns whether the lengths around `e` certainly satisfy the Delaunay condition. Lengths beyond
  // the boundary are unspecified.
  bool is_certainly_Delaunay(Edge_index e) const
  {
    const auto condition = m_tri.traits().is_locally_Delaunay_object();
    return of_diamond([&](const auto& around) { return condition.is_certain(around); },
                      m_tri.traits(), m_tri.length_map(), m_tri.mesh().halfedge(e), m_tri.mesh());
  }

  bool is_Delaunay(Edge_index e) const { return m_tri.is_Delaunay(e); }

  // Flips an edge, and returns whether this was possible. The new edge is Delaunay, up to rounding
  // of lengths.
  bool flip(Halfedge_index h)
  {
    if(!succeeds<Traits>([&] { m_tri.flip(h); }))
      return false;
    m_has_failed =
      m_has_failed || (is_rounded<typename Traits::FT>() && !is_Delaunay(m_tri.mesh().edge(h)));
    return true;
  }

  bool has_failed() const { return m_has_failed; }

private:
  Triangulation& m_tri;
  bool m_has_failed = false;
};

// Returns the edges that lengths do not decide.
template <typename Flipping>
Edge_stack doubtful_edges(const Delta_complex& mesh, const Flipping& flipping,
                          Concurrency concurrency)
{
  Edge_stack stack(mesh.num_edges());
  if(!concurrency.is_parallel()) {
    for(Edge_index e : mesh.edges())
      stack.push_if(!flipping.is_certainly_Delaunay(e), e);
    return stack;
  }
  std::vector<unsigned char> is_doubtful(mesh.num_edges());
  for_each_in_chunks<Edge_index>(concurrency, mesh, [&](Edge_index e) {
    is_doubtful[e.idx()] = !flipping.is_certainly_Delaunay(e);
  });
  for(Edge_index e : mesh.edges())
    stack.push_if(is_doubtful[e.idx()], e);
  return stack;
}

// Flips as the decisions of `flipping` require.
template <typename Flipping, typename Visitor>
Flipping_result flip_to_Delaunay(const Delta_complex& mesh, Flipping& flipping, std::size_t limit,
                                 Visitor& visitor, Concurrency concurrency = Concurrency())
{
  Edge_stack stack = doubtful_edges(mesh, flipping, concurrency);
  return flip_within_limit(
    mesh, stack, limit, [&](Edge_index e) { return flipping.is_certainly_Delaunay(e); },
    [&](Edge_index e) { return flipping.is_Delaunay(e); },
    [&](Halfedge_index h) {
      const bool is_flipped = flipping.flip(h);
      if(is_flipped)
        visitor.after_flip(h);
      return is_flipped;
    });
}

// Recomputes lengths and flips again, if edges have been flipped more than once on average, or if a
// flip failed. Rounding errors may then have accumulated. With recomputed lengths a second round
// usually suffices, without a guarantee. Each round makes its decisions by `make_flipping()`.
template <typename Traits, typename Make_flipping, typename Visitor>
Flipping_result flip_in_rounds(Intrinsic_triangulation<Traits>& tri,
                               const Make_flipping& make_flipping, std::size_t limit, int rounds,
                               Visitor& visitor, Concurrency concurrency)
{
  typedef Flipping_result::End End;
  Flipping_result result;
  for(int round = 0; round < rounds && result.is_Delaunay(); ++round) {
    auto flipping = make_flipping();
    const Flipping_result flips =
      flip_to_Delaunay(tri.mesh(), flipping, limit - result.flips, visitor, concurrency);
    const bool is_good = !is_rounded<typename Traits::FT>() ||
                         (flips.flips <= tri.mesh().number_of_edges() && !flipping.has_failed());
    result += flips;
    if(result.is_Delaunay() && is_good)
      return result;
    if(result.is_Delaunay() && !succeeds<Traits>([&] { tri.recompute_lengths(); }))
      result.end = End::doubt;
  }
  return {result.flips, result.flips == limit ? End::limit : End::doubt};
}

template <typename Traits, typename Visitor>
Flipping_result flip_by_lengths(Intrinsic_triangulation<Traits>& tri, std::size_t limit, int rounds,
                                Visitor& visitor, Concurrency concurrency = Concurrency())
{
  return flip_in_rounds(
    tri, [&] { return Flipping_by_lengths<Traits>(tri); }, limit, rounds, visitor, concurrency);
}

// Returns the number of flips that named parameters allow.
template <typename NamedParameters>
std::size_t flip_limit(const Delta_complex& mesh, const NamedParameters& np)
{
  return static_cast<std::size_t>(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::number_of_iterations),
    default_flip_limit(mesh.number_of_edges())));
}

// Returns whether exact decisions are requested, which is an error if they are not possible.
template <typename Traits, typename NamedParameters>
bool are_exact_decisions_wanted(const NamedParameters& np)
{
  static_assert(!has_parameter<NamedParameters, internal_np::exact_decisions_t>() ||
                  has_exact_decisions<Traits>() || !is_rounded<typename Traits::FT>(),
                "exact_decisions: the traits must be Euclidean_geometry_traits<double> or be "
                "derived from them, without another strip, length, distance, convexity or "
                "Delaunay condition");
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::exact_decisions), false);
}

// Flips with decisions about the surface of T1, in two attempts with limited effort. The second one
// starts from certain lengths.
template <typename Traits, typename Visitor>
Flipping_result flip_filtered(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                              Flipping_effort effort, Visitor& visitor, Concurrency concurrency)
{
  typedef Flipping_result::End End;
  Flipping_result result;
  for(double steps : {effort.first, effort.second}) {
    Exact_flipping<Traits> flipping(tri, steps, effort.kept_error);
    if(flipping.has_unknown_lengths() &&
       (flipping.has_too_many_crossings() || !flipping.find_lengths()))
      break;
    result += flip_to_Delaunay(tri.mesh(), flipping, limit - result.flips, visitor, concurrency);
    if(result.end == End::limit)
      return result;
    if(!flipping.has_unknown_lengths()) {
      flipping.sharpen_lengths();
      return result;
    }
  }
  return {result.flips, End::doubt};
}

// Returns the number of flips beyond which lengths of type `double` are not reliable.
inline std::size_t flips_by_lengths(std::size_t number_of_edges)
{
  return 10000000 + 1000 * number_of_edges;
}

// Returns the number of flips that are first made with decisions in the exact metric. After many
// flips, edges cross so many edges that each flip takes long.
inline std::size_t flips_in_exact_metric(std::size_t number_of_edges)
{
  return 1000 + 100 * number_of_edges;
}

// Returns whether T2 can be reset to T1: constrained edges must be edges of T1, or parts of them.
template <typename Traits>
bool can_be_reset(const Intrinsic_triangulation<Traits>& tri)
{
  const auto edges = tri.mesh().edges();
  return std::all_of(edges.begin(), edges.end(), [&](Edge_index e) {
    return !tri.is_constrained(e) || tri.coordinates().is_shared(e);
  });
}

// Resets T2 to T1 with the inserted vertices.
// \throws Numerical_error if this is not possible
template <typename Traits, typename Visitor>
void restart_from_input(Intrinsic_triangulation<Traits>& tri, Visitor& visitor)
{
  if(!can_be_reset(tri))
    throw Numerical_error(
      "an edge is bent, and constrained edges that are not in the input prevent a restart");
  reset_with_vertices(tri, tri.number_of_inserted_vertices());
  visitor.before_exact_flips();
}

// Decides exactly which edges are Delaunay, and restarts from T1 if edges are bent. If lengths of
// type `double` bend edges while effort is limited, lengths with more digits follow.
template <typename Traits, typename Visitor>
Flipping_result flip_exactly(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                             Visitor& visitor, Concurrency concurrency)
{
  typedef Flipping_result::End End;
  Flipping_result result;
  const auto flip = [&](const Flipping_effort& effort) {
    result += flip_filtered(tri, limit - result.flips, effort, visitor, concurrency);
  };
  const auto restart_if_in_doubt = [&](const auto& flip_again) {
    if(result.end != End::doubt)
      return;
    restart_from_input(tri, visitor);
    result.is_exact = true;
    flip_again();
  };
  flip(exact_effort());
  restart_if_in_doubt([&] { flip(exact_effort()); });
  restart_if_in_doubt([&] {
    Precise_flipping<Traits> precise(tri);
    result += flip_to_Delaunay(tri.mesh(), precise, limit - result.flips, visitor, concurrency);
    if(result.is_Delaunay())
      flip(unlimited_effort());
  });
  restart_if_in_doubt([&] { flip(unlimited_effort()); });
  check_flip_limit(result.end == End::limit);
  return result;
}

// Decides in the exact metric which edges are Delaunay, and recomputes all lengths to nearly all
// digits. Fails after too many flips, or if edges cross too many other edges.
template <typename Traits, typename Visitor>
Flipping_result flip_in_exact_metric(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                                     Visitor& visitor, Concurrency concurrency)
{
  const std::size_t most = flips_in_exact_metric(tri.mesh().number_of_edges());
  Flipping_result result =
    flip_filtered(tri, (std::min)(limit, most), exact_metric_effort(), visitor, concurrency);
  if(result.is_Delaunay()) {
    Exact_flipping<Traits>(tri).recompute_lengths(rounding_unit<double>() / 2);
    result.is_exact = true;
  }
  return result;
}

// Decides in the exact metric first if lengths of type `double` do not determine the angles of T1.
// Continues by lengths, and then with exact decisions from T1, if lengths do not suffice. They do
// not suffice after `flips_by_lengths()`, or if edges are still not Delaunay after two rounds. By
// then edges of T2 may be bent.
template <typename Traits, typename Visitor>
Flipping_result make_Delaunay(Intrinsic_triangulation<Traits>& tri, std::size_t limit,
                              Visitor& visitor, Concurrency concurrency = Concurrency())
{
  const bool can_be_exact = has_exact_decisions<Traits>() && can_be_reset(tri);
  Flipping_result result;
  if constexpr(has_exact_decisions<Traits>())
    if(can_be_exact && has_unresolved_angles(tri.input())) {
      try {
        result = flip_in_exact_metric(tri, limit, visitor, concurrency);
      } catch(const Numerical_error&) { // such as for vertices that coincide
        restart_from_input(tri, visitor);
      }
      if(result.is_Delaunay() && result.is_exact)
        return result;
      check_flip_limit(result.flips == limit);
    }
  const std::size_t rest = limit - result.flips;
  const std::size_t carried = flips_by_lengths(tri.mesh().number_of_edges());
  result += flip_by_lengths(tri, can_be_exact ? (std::min)(rest, carried) : rest,
                            can_be_exact ? rounds_before_exact_flips() : rounds_of_flips(), visitor,
                            concurrency);
  if(result.is_Delaunay())
    return result;
  check_flip_limit(result.flips == limit);
  if constexpr(has_exact_decisions<Traits>())
    if(can_be_exact) {
      restart_from_input(tri, visitor);
      result.is_exact = true;
      return result += flip_exactly(tri, limit - result.flips, visitor, concurrency);
    }
  throw Numerical_error("rounding of the lengths prevents a Delaunay triangulation");
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// flips edges of `tri` until it is Delaunay (Section 2.3.3). Boundary and constrained edges stay.
///
/// Decisions are exact with `Exact_Euclidean_geometry_traits`, and with lengths of type `double`
/// and the parameter `exact_decisions`. They are also exact if such lengths do not determine the
/// angles of \f$T_1\f$ (`has_unresolved_angles()`). Then an edge counts as Delaunay if 1024 binary
/// digits do not distinguish it from a tie. Stored lengths decide if the bounds of their errors
/// allow it, otherwise the surface of \f$T_1\f$. `certify_Delaunay()` confirms the result. If an
/// edge of \f$T_2\f$ is bent at the beginning, flipping restarts from \f$T_1\f$ with the inserted
/// vertices.
///
/// Otherwise rounded lengths decide, up to `rounding_unit()`. They are recomputed from \f$T_1\f$,
/// and flipping continues, if flips outnumber edges or rounding has left a flipped edge
/// non-Delaunay. Flipping with lengths of type `double` restarts from \f$T_1\f$ with exact
/// decisions if that does not suffice. It also restarts after more than ten million flips plus a
/// thousand for each edge.
///
/// \tparam Traits a model of `IntrinsicGeometryTraits`
/// \tparam NamedParameters a sequence of named parameters
/// \param tri the triangulation
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the number of flips that are allowed}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{a hundred million plus a thousand for each edge}
///   \cgalParamNEnd
///   \cgalParamNBegin{exact_decisions}
///     \cgalParamDescription{whether all decisions are exact, with lengths of type `double`, too;
///       lengths are then correct to a relative error of \f$2^{-40}\f$. An edge that depends on
///       more than two square roots, and that 1024 bits leave undecided, counts as a tie, and is
///       kept. `certify_Delaunay()` decides it. Traits that are derived from
///       `Euclidean_geometry_traits<double>` must inherit its strip, its lengths and distances, its
///       convexity and its Delaunay condition: otherwise this does not compile}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads find the edges to start from; flips are
///                           sequential. See \ref it_parallel.}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag` or
///                    `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is notified of every flip; an exception that it throws stops the
///                           flipping and leaves `tri` valid}
///     \cgalParamType{a model of `FlipVisitor`; it is copied unless `std::ref()` refers to it}
///     \cgalParamDefault{`Default_flip_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: linear in the edges and flips. Real meshes take at most about as many flips as
/// edges; no function of the number of edges bounds them. Memory: a mark for each edge and a stack
/// of edges.
/// \returns the number of flips
/// \throws Flip_limit_exceeded if more flips than allowed were needed
/// \throws Numerical_error in these cases:
/// - A flipped length is not positive and finite.
/// - An exact decision involves too many square roots (see `certify_Delaunay()`).
/// - Rounding of the lengths prevents the postcondition, and exact decisions are not possible. They
///   are not if a constrained edge is neither an edge of \f$T_1\f$ nor a part of one.
/// \throws Overflow_error if a normal coordinate is out of range
///
/// After an exception `tri` is a valid triangulation of the same surface.
/// \post `is_Delaunay(tri)`
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::size_t make_Delaunay(Intrinsic_triangulation<Traits>& tri,
                          const NamedParameters& np = CGAL::parameters::default_values())
{
  const std::size_t limit = internal::flip_limit(tri.mesh(), np);
  const Concurrency concurrency = concurrency_of(np);
  Default_flip_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  [[maybe_unused]] const bool are_exact = internal::are_exact_decisions_wanted<Traits>(np);
  if constexpr(internal::has_exact_decisions<Traits>())
    if(internal::Is_exact<Traits>::value || are_exact)
      return internal::flip_exactly(tri, limit, visitor, concurrency).flips;
  return internal::make_Delaunay(tri, limit, visitor, concurrency).flips;
}

} // namespace CGAL::Intrinsic_triangulations

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Flipping_result
make_Delaunay(Intrinsic_triangulation<>&, std::size_t, Default_flip_visitor&, Concurrency);
CGAL_INTRINSIC_TRIANGULATIONS_COMPILED template Flipping_result
flip_exactly(Intrinsic_triangulation<>&, std::size_t, Default_flip_visitor&, Concurrency);

} // namespace CGAL::Intrinsic_triangulations::internal
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MAKE_DELAUNAY_H
