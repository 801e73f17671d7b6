// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/vertex_values.h"

#include "Program_error.h"
#include "reading/Scanner.h"
#include "reading/text_encoding.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>

namespace {

class Value_file
{
public:
  Value_file(const std::string& path, std::size_t number_of_vertices)
    : m_path(path), m_number_of_vertices(number_of_vertices)
  {}

  std::vector<Vertex_value> read()
  {
    std::ifstream file(m_path);
    if(!file)
      throw Program_error(m_path + ": cannot be opened; is there such a file?");
    std::string text;
    for(m_line = 1; std::getline(file, text); ++m_line)
      read_line(without_byte_order_mark(text.substr(0, text.find('#'))));
    if(file.bad())
      throw Program_error(m_path + ": cannot be read");
    return m_values;
  }

private:
  void read_line(const std::string& text)
  {
    if(text.find_first_not_of(" \t\r") == std::string::npos)
      return;
    std::istringstream words(text);
    std::int64_t vertex;
    std::string number, rest;
    if(!(words >> vertex >> number) || words >> rest)
      fail("is not \"index value\"");
    add(vertex, value(number));
  }

  double value(const std::string& number) const
  {
    const auto result = finite_number(number);
    if(!result)
      fail("'" + number + "' is not a finite number");
    return *result;
  }

  void add(std::int64_t vertex, double value)
  {
    if(vertex < 0 || std::uint64_t(vertex) >= m_number_of_vertices)
      fail("there is no vertex " + std::to_string(vertex) + "; the vertices are 0 to " +
           std::to_string(m_number_of_vertices - 1));
    const auto [previous, is_new] = m_line_of.emplace(vertex, m_line);
    if(!is_new)
      fail("vertex " + std::to_string(vertex) + " is in line " + std::to_string(previous->second) +
           " already; keep one of both");
    m_values.push_back({std::size_t(vertex), value, m_line});
  }

  [[noreturn]] void fail(const std::string& reason) const
  {
    throw Program_error(m_path + ": line " + std::to_string(m_line) + ": " + reason);
  }

  const std::string& m_path;
  std::size_t m_number_of_vertices;
  std::size_t m_line = 0;
  std::map<std::int64_t, std::size_t> m_line_of;
  std::vector<Vertex_value> m_values;
};

} // namespace

std::vector<Vertex_value> read_vertex_values(const std::string& path,
                                             std::size_t number_of_vertices)
{
  return Value_file(path, number_of_vertices).read();
}
