// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_SOUP_VIEW_H
#define INTRINSIC_SOUP_VIEW_H

#include "page/View_page.h"
#include "reading/Polygon_soup.h"

#include <string>

// Shows polygons as a file gives them, with all their defects in red. Those that name points that
// do not exist are left out.
void show(View_page& page, const std::string& name, const Polygon_soup& soup);

#endif // INTRINSIC_SOUP_VIEW_H
