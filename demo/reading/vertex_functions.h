// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_VERTEX_FUNCTIONS_H
#define INTRINSIC_VERTEX_FUNCTIONS_H

#include <string>
#include <vector>

// The function `name` on the vertices of the mesh in a file, in their order there: "color" in a
// .ply or .off file, which has three components, or a property of vertices in a .ply file, which
// has one. Throws Program_error if the file has no such function, or a value is not finite.
std::vector<std::vector<double>> read_vertex_function(const std::string& path,
                                                      const std::string& name);

#endif // INTRINSIC_VERTEX_FUNCTIONS_H
