// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_PREFETCH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_PREFETCH_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>

namespace CGAL {
namespace Intrinsic_simplification {
namespace internal {

// asks for a byte of memory that will be read soon; no effect but on time
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

// the same for some bytes, no more than two lines of the cache
inline void prefetch(const void* address, std::size_t size)
{
  prefetch(address);
  prefetch(static_cast<const char*>(address) + size - 1);
}

// what a cost has for a vertex; of a cost that is not known nothing is
inline void prefetch_vertex(Intrinsic_triangulations::Vertex_index, const void*) {}

} // namespace internal
} // namespace Intrinsic_simplification
} // namespace CGAL

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTERNAL_OPERATIONS_PREFETCH_H
