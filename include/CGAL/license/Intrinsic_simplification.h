// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_INTRINSIC_SIMPLIFICATION_H
#define CGAL_LICENSE_INTRINSIC_SIMPLIFICATION_H

// The package is in the style of CGAL, not part of it: it is licensed under the GPL alone.

#endif // CGAL_LICENSE_INTRINSIC_SIMPLIFICATION_H
