// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FOR_EACH_IN_CHUNKS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FOR_EACH_IN_CHUNKS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// states whether loops may use several threads.
class Concurrency
{
public:
  /// selects one thread.
  Concurrency() = default;

  /// selects several threads if `Tag` is `CGAL::Parallel_tag`.
  template <typename Tag>
  explicit Concurrency(const Tag&) : m_is_parallel(std::is_convertible_v<Tag, Parallel_tag>)
  {
#ifndef CGAL_LINKED_WITH_TBB
    static_assert(!std::is_convertible_v<Tag, Parallel_tag>,
                  "Parallel_tag is enabled but TBB is unavailable.");
#endif
  }

  /// returns whether several threads are used.
  bool is_parallel() const { return m_is_parallel; }

private:
  bool m_is_parallel = false;
};

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns the value of the named parameter `concurrency_tag`.
template <typename NamedParameters>
Concurrency concurrency_of(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return Concurrency(
    choose_parameter(get_parameter(np, internal_np::concurrency_tag), Sequential_tag()));
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// the number of elements that a thread takes at once. Chunks do not depend on the number of
/// threads, and the result of one chunk depends on no other.
constexpr std::size_t chunk_size = 1024;

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// returns the number of chunks of `n` elements.
inline std::size_t number_of_chunks(std::size_t n, std::size_t size = chunk_size)
{
  return (n + size - 1) / size;
}

#ifdef CGAL_LINKED_WITH_TBB
namespace internal {

// Calls `f(i)` for i = 0, ..., n - 1, in any order and at the same time. If calls throw, rethrows
// the exception of the least i. `Index` is `std::size_t`, so that a library can hold this function.
template <typename Index>
void for_each_at_once(Index n, const std::function<void(Index)>& f);

// Calls `f(0)` on another thread and `f(1)` on the thread of the caller, at the same time.
// Exceptions are treated in the same way.
template <typename Index>
void run_both(const std::function<void(Index)>& f);

} // namespace internal
#endif

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// calls `f(begin, end)` for the chunks of 0, ..., n - 1. If `concurrency` is parallel, calls are
/// in any order and at the same time; otherwise one follows the other. If calls throw, the
/// exception of the first chunk is thrown. Chunks have `size` elements, which should be few if one
/// element takes long.
template <typename Function>
void for_each_chunk(Concurrency concurrency, std::size_t n, const Function& f,
                    std::size_t size = chunk_size)
{
  const auto run = [&](std::size_t chunk) { f(chunk * size, (std::min)(n, (chunk + 1) * size)); };
  const std::size_t chunks = number_of_chunks(n, size);
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency.is_parallel()) {
    internal::for_each_at_once<std::size_t>(chunks, run);
    return;
  }
#endif
  (void)concurrency;
  for(std::size_t chunk = 0; chunk < chunks; ++chunk)
    run(chunk);
}

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// calls `f()` and `g()`, at the same time if `concurrency` is parallel; `g()` on the thread of the
/// caller. If both throw, the exception of `f()` is thrown. Large vectors should be allocated by
/// `g()`, since other threads get new pages from the system.
template <typename F, typename G>
void run_together(Concurrency concurrency, const F& f, const G& g)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(concurrency.is_parallel()) {
    internal::run_both<std::size_t>([&](std::size_t i) { i == 0 ? void(f()) : void(g()); });
    return;
  }
#endif
  (void)concurrency;
  f();
  g();
}

namespace internal {

template <typename Index, typename Mesh>
std::size_t number_of_indices(const Mesh& mesh)
{
  if constexpr(std::is_same_v<Index, Vertex_index>)
    return mesh.num_vertices();
  else if constexpr(std::is_same_v<Index, Edge_index>)
    return mesh.num_edges();
  else if constexpr(std::is_same_v<Index, Halfedge_index>)
    return mesh.num_halfedges();
  else
    return mesh.num_faces();
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsBlocks
/// calls `f(x)` for the elements x of a type of a mesh, chunk by chunk.
template <typename Index, typename Mesh, typename Function>
void for_each_in_chunks(Concurrency concurrency, const Mesh& mesh, const Function& f)
{
  const bool has_garbage = mesh.has_garbage();
  const auto run = [&](std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; i < end; ++i) {
      const Index x(static_cast<typename Mesh::size_type>(i));
      if(!has_garbage || !mesh.is_removed(x))
        f(x);
    }
  };
  for_each_chunk(concurrency, internal::number_of_indices<Index>(mesh), run);
}

} // namespace CGAL::Intrinsic_triangulations

#if defined(CGAL_LINKED_WITH_TBB) && !defined(CGAL_INTRINSIC_TRIANGULATIONS_COMPILED)
#include <CGAL/Intrinsic_triangulations/internal/threads.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FOR_EACH_IN_CHUNKS_H
