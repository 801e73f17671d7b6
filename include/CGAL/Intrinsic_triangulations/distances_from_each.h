// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DISTANCES_FROM_EACH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DISTANCES_FROM_EACH_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Default_window_visitor.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Exact_distances.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <mutex>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Notifies a visitor that several threads share, from one thread at a time. Each thread counts its
// windows first, so that threads rarely wait for each other.
template <typename Visitor>
class Visitor_of_thread
{
public:
  Visitor_of_thread(Visitor& visitor, std::mutex& mutex) : m_visitor(visitor), m_mutex(mutex) {}

  void after_windows(std::size_t number)
  {
    m_number += number;
    if(m_number >= windows_at_once)
      notify();
  }

  void notify()
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_visitor.after_windows(m_number);
    m_number = 0;
  }

private:
  static constexpr std::size_t windows_at_once = 1024;

  Visitor& m_visitor;
  std::mutex& m_mutex;
  std::size_t m_number = 0;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsPaths
/// computes the exact distance of every vertex from each of some sources. `geodesic_distances()`
/// computes the distance from the nearest of them.
///
/// Complexity: for each source, linear for initialization, and as `Shortest_paths::run()`. Each
/// thread has memory that is linear in the size of the surface.
///
/// \param surface a model of `IntrinsicSurface` with floating point lengths
/// \param sources a random access range of sources, each of a type as for `geodesic_distances()`
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{concurrency_tag}
///     \cgalParamDescription{whether several threads are used, each for one source at a time}
///     \cgalParamType{`CGAL::Sequential_tag`, `CGAL::Parallel_tag`, or
///       `CGAL::Parallel_if_available_tag`}
///     \cgalParamDefault{`CGAL::Sequential_tag`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{follows the search, from one thread at a time, and can stop it by an
///       exception}
///     \cgalParamType{a model of `WindowVisitor`; it is copied unless `std::ref()` refers to it}
///     \cgalParamDefault{`Default_window_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns a matrix with a column for each source, and a row for each vertex; infinite if there is
///   no path. The result does not depend on the number of threads.
/// \throws Numerical_error as `geodesic_distances()`, for the first such source
template <typename Surface, typename SourceRange,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
Eigen::Matrix<Length_of<Surface>, Eigen::Dynamic, Eigen::Dynamic>
distances_from_each(const Surface& surface, const SourceRange& sources,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  Default_window_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  std::mutex mutex;
  const std::size_t n = surface.mesh().num_vertices();
  Eigen::Matrix<Length_of<Surface>, Eigen::Dynamic, Eigen::Dynamic> result(n, sources.size());
  const auto compute = [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i) {
      Distance_sources<Surface> source(surface);
      source.add(sources[i]);
      internal::Exact_distances<Surface> exact(surface, source);
      internal::Visitor_of_thread of_thread(visitor, mutex);
      exact.run((std::numeric_limits<std::size_t>::max)(), of_thread);
      of_thread.notify();
      for(std::size_t v = 0; v < n; ++v)
        result(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(i)) = exact.distance(v);
    }
  };
  for_each_chunk(concurrency_of(np), sources.size(), compute, 1);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DISTANCES_FROM_EACH_H
