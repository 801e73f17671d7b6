// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_THREADS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_THREADS_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/for_each_in_chunks.h>

#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores the exception of the first chunk that throws one. All earlier chunks have been run.
class First_exception
{
public:
  explicit First_exception(std::size_t chunks) : m_chunk(chunks) {}

  void run(std::size_t chunk, const std::function<void(std::size_t)>& f)
  {
    if(chunk > m_chunk.load(std::memory_order_relaxed))
      return;
    try {
      f(chunk);
    } catch(...) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if(chunk < m_chunk.load(std::memory_order_relaxed)) {
        m_chunk.store(chunk, std::memory_order_relaxed);
        m_exception = std::current_exception();
      }
    }
  }

  void rethrow() const
  {
    if(m_exception)
      std::rethrow_exception(m_exception);
  }

private:
  std::atomic<std::size_t> m_chunk;
  std::mutex m_mutex;
  std::exception_ptr m_exception;
};

template <typename Index>
void for_each_at_once(Index n, const std::function<void(Index)>& f)
{
  First_exception exception(n);
  tbb::parallel_for(Index(0), n, [&](Index i) { exception.run(i, f); });
  exception.rethrow();
}

template <typename Index>
void run_both(const std::function<void(Index)>& f)
{
  First_exception exception(2);
  tbb::task_group group;
  group.run([&] { exception.run(0, f); });
  exception.run(1, f);
  group.wait();
  exception.rethrow();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_THREADS_H
