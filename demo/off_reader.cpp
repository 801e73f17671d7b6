// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "format_readers.h"

#include <CGAL/IO/OFF/File_scanner_OFF.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace {

// The keyword says what a vertex has beside its position.
struct Off_header
{
  bool has_texture = false, has_color = false, has_normal = false, is_homogeneous = false,
       has_dimension = false, is_skeleton = false, is_binary = false;
  std::size_t vertices = 0, faces = 0;

  std::size_t coordinates() const { return is_homogeneous ? 4 : 3; }
};

class Off_reader
{
public:
  Off_reader(Scanner& in, Polygon_soup& soup, Vertex_functions* functions)
    : m_in(in), m_soup(soup), m_functions(functions)
  {}

  void operator()()
  {
    read_keyword();
    read_numbers();
    m_soup.points.reserve((std::min)(m_header.vertices, m_in.remaining() / 6));
    for(std::size_t v = 0; v < m_header.vertices; ++v)
      m_header.is_binary ? read_binary_vertex() : read_vertex();
    m_soup.polygons.reserve((std::min)(m_header.faces, m_in.remaining() / 8),
                            (std::min)(3 * m_header.faces, m_in.remaining() / 2));
    if(m_header.is_binary)
      read_binary_faces();
    else
      for(std::size_t f = 0; f < m_header.faces; ++f)
        read_face();
    add_colors();
  }

private:
  // ---- Header ----

  void read_keyword()
  {
    m_in.skip_comments('#');
    const Scanner::Place start = m_in.place();
    std::string_view keyword = m_in.word();
    const auto accept = [&](std::string_view prefix) {
      const bool is_there = keyword.substr(0, prefix.size()) == prefix;
      keyword.remove_prefix(is_there ? prefix.size() : 0);
      return is_there;
    };
    m_header.has_texture = accept("ST");
    m_header.has_color = accept("C");
    m_header.has_normal = accept("N");
    m_header.is_homogeneous = accept("4");
    m_header.has_dimension = accept("n");
    m_header.is_skeleton = keyword == "SKEL";
    if(keyword != "OFF" && keyword != "SKEL") {
      m_in.return_to(start);
      m_in.fail("'OFF' expected at the beginning; does another extension name the format?");
    }
    m_in.skip_comments('#');
    m_header.is_binary = m_in.accept("BINARY");
    if(m_header.is_binary) {
      m_in.skip_line();
      m_in.set_binary();
    }
  }

  std::size_t read_number()
  {
    if(!m_header.is_binary) {
      m_in.skip_comments('#');
      return m_in.count();
    }
    const auto n = m_in.binary<std::int32_t>(true);
    if(n < 0)
      m_in.fail(
        "a number of elements is negative; the first line counts vertices, faces and edges");
    return static_cast<std::size_t>(n);
  }

  void read_numbers()
  {
    if(m_header.has_dimension)
      read_number();
    m_header.vertices = read_number();
    m_header.faces = read_number();
    if(!m_header.is_skeleton) // edges
      read_number();
  }

  // ---- Text: a vertex or face in each line, with what else there is ----

  void add_point(double x, double y, double z, double w)
  {
    m_soup.points.emplace_back(x / w, y / w, z / w);
  }

  void read_vertex()
  {
    m_in.skip_comments('#');
    const double x = m_in.number<double>(), y = m_in.number<double>(), z = m_in.number<double>();
    const double w = m_header.is_homogeneous ? m_in.number<double>() : 1;
    if(w == 0)
      m_in.fail("a vertex is infinitely far away; its fourth coordinate must not be 0");
    add_point(x, y, z, w);
    if(m_functions != nullptr && m_header.has_color)
      read_color();
    m_in.skip_line();
  }

  void read_face()
  {
    m_in.skip_comments('#');
    for(std::size_t corners = m_in.count(); corners > 0; --corners) {
      const Scanner::Place start = m_in.place();
      const std::int64_t i = m_in.integer();
      if(i < 0 || static_cast<std::size_t>(i) >= m_header.vertices) {
        m_in.return_to(start);
        m_in.fail("there is no vertex " + std::to_string(i) + "; they are 0 to " +
                  std::to_string(static_cast<std::int64_t>(m_header.vertices) - 1));
      }
      m_soup.polygons.add_corner(static_cast<std::size_t>(i));
    }
    m_soup.polygons.close();
    m_in.skip_line();
  }

  // ---- Colors ----

  // Between the normal and the texture coordinates: the number of a color, or three or four
  // components, which are integers up to 255 or fractions of that.
  void read_color()
  {
    for(std::size_t k = m_header.has_normal ? m_header.coordinates() : 0; k > 0; --k)
      m_in.number<double>();
    std::vector<double> numbers;
    while(!m_in.at_line_end('#'))
      numbers.push_back(m_in.number<double>());
    const std::size_t texture = m_header.has_texture ? m_header.coordinates() - 1 : 0;
    numbers.resize(numbers.size() - (std::min)(numbers.size(), texture));
    if(numbers.size() == 1)
      add_color(CGAL::File_scanner_OFF::get_indexed_color(
        static_cast<int>(std::clamp(numbers[0], 0., 148.))));
    else if(numbers.size() >= 3)
      add_color(color(numbers));
  }

  static CGAL::IO::Color color(const std::vector<double>& numbers)
  {
    const bool are_integers = std::all_of(numbers.begin(), numbers.begin() + 3,
                                          [](double x) { return x == std::floor(x); });
    const auto component = [&](std::size_t k) {
      return static_cast<unsigned char>(
        std::clamp(are_integers ? numbers[k] : 255 * numbers[k], 0., 255.));
    };
    return CGAL::IO::Color(component(0), component(1), component(2));
  }

  void add_color(const CGAL::IO::Color& color)
  {
    m_colors[0].push_back(color.red());
    m_colors[1].push_back(color.green());
    m_colors[2].push_back(color.blue());
  }

  void add_colors()
  {
    if(m_functions != nullptr && m_colors[0].size() == m_soup.points.size())
      *m_functions = {{"red", m_colors[0]}, {"green", m_colors[1]}, {"blue", m_colors[2]}};
  }

  // ---- Binary: numbers of four bytes, the most significant first ----

  double binary_float() { return static_cast<double>(m_in.binary<float>(true)); }

  void read_binary_vertex()
  {
    const double x = binary_float(), y = binary_float(), z = binary_float();
    add_point(x, y, z, m_header.is_homogeneous ? binary_float() : 1);
    m_in.skip_bytes(4 * ((m_header.has_normal ? m_header.coordinates() : 0) +
                         (m_header.has_color ? 4 : 0) +
                         (m_header.has_texture ? m_header.coordinates() - 1 : 0)));
  }

  void read_binary_faces()
  {
    const bool have_colors = !are_without_colors();
    for(std::size_t f = 0; f < m_header.faces; ++f) {
      for(std::size_t corners = read_number(); corners > 0; --corners)
        m_soup.polygons.add_corner(static_cast<std::uint32_t>(m_in.binary<std::int32_t>(true)));
      m_soup.polygons.close();
      if(have_colors)
        m_in.skip_bytes(4 * read_number());
    }
  }

  // Some files have no number of color components after each face, as they should.
  bool are_without_colors()
  {
    const Scanner::Place start = m_in.place();
    std::size_t f = 0;
    for(; f < m_header.faces && m_in.remaining() >= 4; ++f) {
      const auto bytes = 4 * static_cast<std::size_t>(m_in.binary<std::uint32_t>(true));
      if(bytes > m_in.remaining())
        break;
      m_in.skip_bytes(bytes);
    }
    const bool fits = f == m_header.faces && m_in.at_end();
    m_in.return_to(start);
    return fits;
  }

  Scanner& m_in;
  Polygon_soup& m_soup;
  Vertex_functions* m_functions;
  Off_header m_header;
  std::vector<double> m_colors[3];
};

} // namespace

void read_off(Scanner& in, Polygon_soup& soup, Vertex_functions* functions)
{
  Off_reader(in, soup, functions)();
}
