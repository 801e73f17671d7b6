// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-o

#include "reading/vertex_values.h"

#include "Program_error.h"
#include "reading/Scanner.h"

#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>

namespace {

std::optional<std::int64_t> integer(const std::string& word)
{
  std::int64_t result = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), result);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(result)
                                                                  : std::nullopt;
}

} // namespace

void for_each_line(const std::string& path,
                   const std::function<void(const std::vector<std::string>&, std::size_t)>& use)
{
  std::istringstream file(file_content(path));
  std::size_t line = 0;
  for(std::string text; std::getline(file, text);) {
    std::istringstream in(text.substr(0, text.find('#')));
    std::vector<std::string> words;
    for(std::string word; in >> word;)
      words.push_back(word);
    ++line;
    if(!words.empty())
      use(words, line);
  }
}

std::vector<Vertex_value> read_vertex_values(const std::string& path,
                                             std::size_t number_of_vertices)
{
  std::vector<Vertex_value> result;
  std::map<std::int64_t, std::size_t> line_of;
  for_each_line(path, [&](const std::vector<std::string>& words, std::size_t line) {
    const auto check = [&](bool condition, const std::string& what) {
      if(!condition)
        throw Program_error(path + ": line " + std::to_string(line) + ": " + what);
    };
    const auto vertex = integer(words[0]);
    check(vertex && words.size() == 2, "is not \"index value\"");
    const auto value = finite_number(words[1]);
    check(value.has_value(), "'" + words[1] + "' is not a finite number");
    const std::string name = std::to_string(*vertex);
    check(*vertex >= 0 && std::uint64_t(*vertex) < number_of_vertices,
          "there is no vertex " + name + "; the vertices are 0 to " +
            std::to_string(number_of_vertices - 1));
    const auto [previous, is_new] = line_of.emplace(*vertex, line);
    check(is_new, "vertex " + name + " is in line " + std::to_string(previous->second) +
                    " already; keep one of both");
    result.push_back({std::size_t(*vertex), *value, line});
  });
  return result;
}

std::vector<double> vertex_numbers(const std::string& option, const std::string& source,
                                   const Input_mesh& input)
{
  std::vector<double> result(input.mesh.number_of_vertices(), 0.);
  if(source.empty())
    return result;
  if(!input.repairs.empty())
    throw Program_error(option + ": the mesh had to be repaired, and its vertices differ from the "
                                 "file; give a mesh that needs no repair");
  if(const Point_function* property = input.data.function(source))
    return property->values;
  for(const Vertex_value& x : read_vertex_values(source, result.size()))
    result[x.vertex] = x.value;
  return result;
}
