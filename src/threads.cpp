// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/internal/threads.h>

namespace CGAL::Intrinsic_triangulations::internal {

template void for_each_at_once(std::size_t, const std::function<void(std::size_t)>&);
template void run_both(const std::function<void(std::size_t)>&);

} // namespace CGAL::Intrinsic_triangulations::internal
