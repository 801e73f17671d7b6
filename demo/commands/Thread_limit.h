// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_THREAD_LIMIT_H
#define INTRINSIC_THREAD_LIMIT_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <optional>

// For as long as it lives, no more threads are used; 0 for no limit. Without TBB there is one.
class Thread_limit
{
public:
  explicit Thread_limit([[maybe_unused]] std::size_t threads)
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(threads > 0)
      m_control.emplace(tbb::global_control::max_allowed_parallelism, threads);
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  std::optional<tbb::global_control> m_control;
#endif
};

#endif // INTRINSIC_THREAD_LIMIT_H
