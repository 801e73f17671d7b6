// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/format_readers.h"

#include <CGAL/IO/OFF/File_scanner_OFF.h>

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <cmath>
#include <locale>
#include <string>
#include <string_view>

namespace {

// Stores the header, whose keyword states the data of a vertex beside its position.
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
  Off_reader(Scanner& in, Polygon_soup& soup) : m_in(in), m_soup(soup) {}

  void operator()()
  {
    read_keyword();
    read_numbers();
    m_soup.points.reserve((std::min)(m_header.vertices, m_in.remaining() / 6));
    for(std::size_t v = 0; v < m_header.vertices; ++v)
      m_header.is_binary ? read_binary_vertex() : read_vertex();
    m_soup.polygons.reserve((std::min)(m_header.faces, m_in.remaining() / 8),
                            (std::min)(3 * m_header.faces, m_in.remaining() / 2));
    m_header.is_binary ? read_binary_faces() : read_faces();
    m_in.expect_end("the last of " + std::to_string(m_header.faces) + " faces", '#');
    add_data();
  }

private:
  // ---- Header ----

  // Reads the first word, or an empty text. Digits of a number may follow directly.
  std::string read_first_word()
  {
    m_in.skip_comments('#');
    const Scanner::Place start = m_in.place();
    const std::string_view word = m_in.word();
    const std::size_t size = word.find_last_not_of("0123456789") + 1;
    m_in.return_to(start + size);
    const std::string result(word.substr(0, size));
    const bool is_written_as_usual =
      size >= 3 && (result.compare(size - 3, 3, "OFF") == 0 || result == "SKEL");
    return is_written_as_usual ? result : boost::to_upper_copy(result, std::locale::classic());
  }

  void read_keyword()
  {
    m_in.skip_comments('#');
    const Scanner::Place start = m_in.place();
    const std::string text = read_first_word();
    if(text.empty())
      return;
    std::string_view keyword = text;
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
      m_in.fail("'OFF' or a number of vertices expected at the beginning");
    }
    m_in.skip_comments('#');
    m_header.is_binary = m_in.accept_in_any_case("binary");
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
    if(!m_header.is_skeleton)
      skip_number_of_edges();
  }

  // Skips the number of edges, which some programs omit. It may stand alone in a line.
  void skip_number_of_edges()
  {
    if(m_header.is_binary || !m_in.at_line_end('#')) {
      read_number();
      return;
    }
    m_in.skip_comments('#');
    const Scanner::Place next = m_in.place();
    if(m_in.word().find_first_not_of("0123456789") != std::string_view::npos ||
       !m_in.at_line_end('#'))
      m_in.return_to(next);
  }

  // ---- Text: a vertex or face in each line, with what else there is ----

  void begin_line()
  {
    m_in.skip_comments('#');
    m_break = nullptr;
  }

  // Finds the next number, which may be in the next line.
  void find_number()
  {
    if(!m_in.at_line_end('#') || m_in.at_end())
      return;
    if(m_break == nullptr)
      m_break = m_in.place();
    m_in.skip_comments('#');
    if(m_in.at_end())
      fail_at_break();
  }

  // Checks the end of a line. If numbers continued in it, it must end here: otherwise a number was
  // missing in the previous line.
  void end_line()
  {
    if(m_break != nullptr && !m_in.at_line_end('#'))
      fail_at_break();
    m_in.skip_line();
  }

  [[noreturn]] void fail_at_break()
  {
    m_in.return_to(m_break);
    m_in.fail("a number is missing");
  }

  double read_coordinate()
  {
    find_number();
    return m_in.number<double>();
  }

  void add_point(double x, double y, double z, double w)
  {
    m_soup.points.emplace_back(x / w, y / w, z / w);
  }

  void read_vertex()
  {
    begin_line();
    const double x = read_coordinate(), y = read_coordinate(), z = read_coordinate();
    const double w = m_header.is_homogeneous ? read_coordinate() : 1;
    if(w == 0)
      m_in.fail("a vertex is infinitely far away; its fourth coordinate must not be 0");
    add_point(x, y, z, w);
    if(m_header.has_normal || m_header.has_color || m_header.has_texture)
      read_data();
    end_line();
  }

  void read_faces()
  {
    for(std::size_t f = 0; f < m_header.faces; ++f)
      read_face();
  }

  void read_face()
  {
    begin_line();
    for(std::size_t corners = m_in.count(); corners > 0; --corners) {
      find_number();
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
    end_line();
  }

  // ---- Data ----

  // Reads the normal, then the color, then the texture coordinates. The color is a number, or three
  // or four components, which are integers up to 255 or fractions. A fourth coordinate of a normal
  // is dropped.
  void read_data()
  {
    std::vector<double> numbers = m_in.numbers();
    const std::size_t texture = m_header.has_texture ? m_header.coordinates() - 1 : 0,
                      normal = m_header.has_normal ? m_header.coordinates() : 0;
    if(numbers.size() < texture + normal)
      return;
    const auto color = numbers.begin() + static_cast<std::ptrdiff_t>(normal),
               rest = numbers.end() - static_cast<std::ptrdiff_t>(texture);
    for(std::size_t k = 0; k < 3 && m_header.has_normal; ++k)
      m_normals[k].push_back(numbers[k]);
    if(m_header.has_texture)
      m_texture.push_back({rest[0], rest[1], texture == 3 ? rest[2] : 1});
    if(m_header.has_color)
      add_color({color, rest});
  }

  void add_color(const std::vector<double>& numbers)
  {
    if(numbers.size() == 1) {
      const CGAL::IO::Color color = CGAL::File_scanner_OFF::get_indexed_color(
        static_cast<int>(std::clamp(numbers[0], 0., 148.)));
      add_components({double(color.red()), double(color.green()), double(color.blue())});
    } else if(numbers.size() >= 3)
      add_components(numbers);
  }

  void add_components(const std::vector<double>& components)
  {
    for(std::size_t k = 0; k < (std::min)(components.size(), m_colors.size()); ++k)
      m_colors[k].push_back(components[k]);
  }

  // Adds the data. Data of only some vertices are removed later.
  void add_data()
  {
    const std::size_t points = m_soup.points.size();
    const char* const normals[] = {"nx", "ny", "nz"};
    for(std::size_t k = 0; k < 3; ++k)
      m_soup.data.functions.push_back({normals[k], std::move(m_normals[k])});
    make_bytes(m_colors);
    const char* const colors[] = {"red", "green", "blue", "alpha"};
    for(std::size_t k = 0; k < 4; ++k)
      m_soup.data.functions.push_back({colors[k], std::move(m_colors[k])});
    if(m_texture.size() == points)
      add_corner_data(
        m_header.is_homogeneous ? "homogeneous_texcoord" : "texcoord",
        m_header.is_homogeneous ? 3 : 2, m_soup.polygons, points,
        [&](std::size_t c) { return m_texture[m_soup.polygons.corners()[c]]; }, m_soup.data);
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

  // Returns whether the number of color components after each face is missing, as in some files.
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
  Off_header m_header;
  Scanner::Place m_break = nullptr; // the first end of a line inside a vertex or a face
  std::vector<double> m_normals[3];
  std::vector<std::vector<double>> m_colors = std::vector<std::vector<double>>(4);
  std::vector<Corner_data_builder::Coordinates> m_texture; // of vertices
};

} // namespace

void read_off(Scanner& in, Polygon_soup& soup) { Off_reader(in, soup)(); }
