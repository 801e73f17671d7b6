// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FLIPPED_PATHS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FLIPPED_PATHS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_path.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPaths
/// a path that has been shortened by flips.
template <typename FT>
struct Flipped_path
{
  Shortening_status status;    ///< how shortening has ended
  std::size_t number_of_flips; ///< how many edges have been flipped
  Surface_path<FT> path;       ///< the path on \f$T_1\f$
  FT length_along_edges;       ///< its length before it was shortened
};

/// \ingroup PkgIntrinsicTriangulationsPaths
/// geodesics between pairs of vertices: for each pair, the shortest path along edges of \f$T_2\f$
/// is shortened by flips (`Edge_paths`), which are taken back afterwards. So no path depends on
/// earlier paths. Except for the search along edges, the time of a path does not depend on the size
/// of the triangulation.
///
/// \tparam Traits a model of `IntrinsicGeometryTraits`, Euclidean
template <typename Traits>
class Flipped_paths
{
public:
  /// the triangulation.
  typedef Intrinsic_triangulation<Traits> Triangulation;
  /// the number type of lengths.
  typedef typename Traits::FT FT;

  /// prepares for paths on a copy of `tri`. Complexity: linear.
  /// \throws Numerical_error if a length is not positive and finite
  explicit Flipped_paths(const Triangulation& tri)
    : m_tri(tri), m_paths(m_tri), m_search(m_tri.intrinsic())
  {}

  Flipped_paths(const Flipped_paths&) = delete;
  Flipped_paths& operator=(const Flipped_paths&) = delete;

  /// returns a geodesic from `source` to `target`. It has no points if the two are equal; if there
  /// is no path, its length is infinite, too.
  /// \throws Numerical_error, Overflow_error as `Edge_paths::shorten()` and `path_on_input()`
  ///
  /// After an exception other paths can be computed.
  Flipped_path<FT> path(Vertex_index source, Vertex_index target)
  {
    const std::vector<Halfedge_index> start = m_search.path(source, target);
    if(start.empty())
      return without_points(source == target ? FT(0) : std::numeric_limits<FT>::infinity());
    return shortened([&] { m_paths.add_path(start); });
  }

  /// returns the closed geodesic to which a loop along edges of \f$T_2\f$ is shortened. It has no
  /// points if the loop contracts.
  /// \param loop halfedges of \f$T_2\f$; each begins where the one before it ends, and the first
  ///   one where the last one ends
  /// \throws Numerical_error, Overflow_error as `path()`
  ///
  /// Complexity: `Edge_paths::shorten()` and `path_on_input()`.
  Flipped_path<FT> loop(const std::vector<Halfedge_index>& loop)
  {
    return shortened([&] { m_paths.add_loop(loop); });
  }

private:
  struct Rewinding
  {
    ~Rewinding() { paths.rewind(); }
    Edge_paths<Traits>& paths;
  };

  static Flipped_path<FT> without_points(const FT& length)
  {
    return {Shortening_status::geodesic, 0, {length, {}}, length};
  }

  // Shortens the path that `add()` adds, and takes its flips back.
  template <typename Add>
  Flipped_path<FT> shortened(const Add& add)
  {
    const Rewinding rewinding{m_paths};
    add();
    const FT before = m_paths.length(0);
    const Shortening_status status = m_paths.shorten();
    const std::vector<Halfedge_index> path = m_paths.halfedges(0);
    return {status, m_paths.number_of_flips(),
            path.empty() ? Surface_path<FT>{FT(0), {}} : path_on_input(m_tri, path), before};
  }

  typedef Surface_view<typename Triangulation::Edge_length_map> Surface;

  Triangulation m_tri;
  Edge_paths<Traits> m_paths;
  Shortest_edge_paths<Surface> m_search;
};

namespace internal {

// Lends objects to threads. It makes no more objects than are used at the same time.
template <typename T>
class Object_pool
{
public:
  // Calls `f(object)` with one of the objects, or with a new one of `make()` if all are used.
  template <typename Make, typename F>
  void use(const Make& make, const F& f)
  {
    std::unique_ptr<T> object = take();
    if(!object)
      object = make();
    f(*object);
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_objects.push_back(std::move(object));
  }

private:
  std::unique_ptr<T> take()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if(m_objects.empty())
      return nullptr;
    std::unique_ptr<T> object = std::move(m_objects.back());
    m_objects.pop_back();
    return object;
  }

  std::mutex m_mutex;
  std::vector<std::unique_ptr<T>> m_objects;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// returns geodesics between many pairs of vertices, see `Flipped_paths`.
///
/// \param tri the triangulation; it is not changed
/// \param pairs the sources and targets
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used, each with a copy of `tri`}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
///       `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the path of each pair. The result does not depend on the number of threads.
/// \throws Numerical_error, Overflow_error as `Flipped_paths::path()`, for the first such pair
///
/// Complexity: linear in the size of `tri` for each thread, and `Flipped_paths::path()` for each
/// pair.
template <typename Traits, typename NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<Flipped_path<typename Traits::FT>>
flipped_paths(const Intrinsic_triangulation<Traits>& tri,
              const std::vector<std::pair<Vertex_index, Vertex_index>>& pairs,
              const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef Flipped_paths<Traits> Paths;
  constexpr std::size_t pairs_at_once = 8;
  std::vector<Flipped_path<typename Traits::FT>> result(pairs.size());
  internal::Object_pool<Paths> pool;
  const auto compute = [&](std::size_t begin, std::size_t end) {
    pool.use([&] { return std::make_unique<Paths>(tri); },
             [&](Paths& paths) {
               for(std::size_t i = begin; i < end; ++i)
                 result[i] = paths.path(pairs[i].first, pairs[i].second);
             });
  };
  for_each_chunk(concurrency_of(np), pairs.size(), compute, pairs_at_once);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FLIPPED_PATHS_H
