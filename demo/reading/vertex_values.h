// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_VERTEX_VALUES_H
#define INTRINSIC_VERTEX_VALUES_H

#include "reading/Input_mesh.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Calls `use(words, line)` for each line of a file that has words. Text after a # is skipped.
// Throws Program_error if the file cannot be read.
void for_each_line(const std::string& path,
                   const std::function<void(const std::vector<std::string>&, std::size_t)>& use);

// Stores the data of a line about a vertex.
struct Vertex_value
{
  std::size_t vertex;
  double value;
  std::size_t line;
};

// Reads lines "index value", with different indices from 0 to less than `number_of_vertices`.
// Throws Program_error with the line for any other content.
std::vector<Vertex_value> read_vertex_values(const std::string& path,
                                             std::size_t number_of_vertices);

// Returns the numbers of `option` for all vertices, from a property of vertices or a file. They are
// zero at vertices that the file does not contain, and everywhere if `source` is empty.
// Throws Program_error if the file is wrong.
std::vector<double> vertex_numbers(const std::string& option, const std::string& source,
                                   const Input_mesh& input);

#endif // INTRINSIC_VERTEX_VALUES_H
