// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_VERTEX_VALUES_H
#define INTRINSIC_VERTEX_VALUES_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

// Calls `use(words, line)` for each line of a file that has words. What follows a # is not read.
// Throws Program_error if the file cannot be read.
void for_each_line(const std::string& path,
                   const std::function<void(const std::vector<std::string>&, std::size_t)>& use);

// What a line of a file says of a vertex.
struct Vertex_value
{
  std::size_t vertex;
  double value;
  std::size_t line;
};

// Reads lines "index value", with indices from 0 to less than `number_of_vertices`, none twice.
// Throws Program_error with the line if there is anything else.
std::vector<Vertex_value> read_vertex_values(const std::string& path,
                                             std::size_t number_of_vertices);

#endif // INTRINSIC_VERTEX_VALUES_H
