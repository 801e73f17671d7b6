// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "format_readers.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace {

// What stands between < and >.
struct Tag
{
  std::string_view text;

  // Ends of elements begin with a slash.
  std::string_view name() const { return text.substr(0, text.find_first_of(" \t\r\n")); }

  bool is_empty_element() const { return !text.empty() && text.back() == '/'; }

  // Empty if there is none.
  std::string_view attribute(const std::string& key) const
  {
    for(std::size_t i = text.find(key); i != text.npos; i = text.find(key, i + 1)) {
      const std::size_t first = i + key.size() + 2;
      if(i == 0 || text.find_first_of(" \t\r\n", i - 1) != i - 1 || first > text.size() ||
         text[first - 2] != '=' || (text[first - 1] != '"' && text[first - 1] != '\''))
        continue;
      const std::string_view rest = text.substr(first);
      return rest.substr(0, rest.find(text[first - 1]));
    }
    return {};
  }
};

// Indices of points and ends of lines are those of a piece of the file.
class Vtp_reader
{
public:
  Vtp_reader(Scanner& in, Polygon_soup& soup, Polygons& lines)
    : m_in(in), m_soup(soup), m_lines(lines)
  {}

  void operator()()
  {
    expect_poly_data();
    for(Tag tag = next_tag(); tag.name() != "/VTKFile"; tag = next_tag()) {
      if(tag.name() == "Piece")
        begin_piece();
      else if(tag.name() == "/Piece")
        end_piece();
      else if(tag.name() == "DataArray" && !m_section.empty())
        read_array(tag);
      else if(tag.name() == "Points" || tag.name() == "Lines")
        m_section = tag.name();
      else if(tag.name() == "/Points" || tag.name() == "/Lines")
        m_section = {};
    }
  }

private:
  struct Integer
  {
    std::size_t value;
    Scanner::Place place;
  };

  // Goes on to the next tag that is not a comment.
  Tag next_tag()
  {
    for(;;) {
      m_in.until("<");
      m_tag = m_in.place();
      if(const std::string_view text = m_in.until(">"); text.substr(0, 3) != "!--")
        return {text};
      m_in.return_to(m_tag);
      m_in.until("-->");
    }
  }

  [[noreturn]] void fail_at(Scanner::Place place, const std::string& what)
  {
    m_in.return_to(place);
    m_in.fail(what);
  }

  void expect_poly_data()
  {
    Tag tag = next_tag();
    if(tag.name() == "?xml")
      tag = next_tag();
    if(tag.name() != "VTKFile" || tag.attribute("type") != "PolyData")
      fail_at(m_tag, "<VTKFile type=\"PolyData\"> expected at the beginning");
  }

  void begin_piece()
  {
    m_points = m_soup.points.size();
    m_indices.clear();
    m_ends.clear();
  }

  void end_piece()
  {
    if((m_ends.empty() ? 0 : m_ends.back()) != m_indices.size())
      fail_at(m_tag, "the last of the offsets of lines is not the number of their points");
    std::size_t i = 0;
    for(const std::size_t end : m_ends) {
      for(; i < end; ++i)
        m_lines.add_corner(checked_index(i));
      m_lines.close();
    }
  }

  std::size_t checked_index(std::size_t i)
  {
    const std::size_t n = m_soup.points.size() - m_points;
    if(m_indices[i].value >= n)
      fail_at(m_indices[i].place, "a line names a point that does not exist; there are " +
                                    std::to_string(n) + " in this piece");
    return m_points + m_indices[i].value;
  }

  void read_array(const Tag& tag)
  {
    if(tag.attribute("format") != "ascii")
      fail_at(m_tag, "the numbers are encoded; save the file with the format ascii");
    if(tag.is_empty_element())
      return;
    if(m_section == "Points")
      read_points(tag);
    else if(tag.attribute("Name") == "connectivity")
      while(has_number())
        m_indices.push_back(read_integer());
    else if(tag.attribute("Name") == "offsets")
      read_ends();
  }

  bool has_number()
  {
    m_in.skip_space();
    return !m_in.at_line_end('<');
  }

  void read_points(const Tag& tag)
  {
    if(tag.attribute("NumberOfComponents") != "3")
      fail_at(m_tag, "points do not have three coordinates each");
    while(has_number()) {
      double x[3];
      for(double& coordinate : x) {
        m_in.skip_space();
        coordinate = m_in.number<double>();
      }
      m_soup.points.emplace_back(x[0], x[1], x[2]);
    }
  }

  void read_ends()
  {
    while(has_number()) {
      const Integer end = read_integer();
      if(end.value < (m_ends.empty() ? 0 : m_ends.back()))
        fail_at(end.place, "the offsets of lines are not ascending");
      m_ends.push_back(end.value);
    }
  }

  Integer read_integer()
  {
    const Scanner::Place place = m_in.place();
    const std::int64_t n = m_in.integer();
    if(n < 0)
      fail_at(place, "an index of a point or an offset is negative");
    return {static_cast<std::size_t>(n), place};
  }

  Scanner& m_in;
  Polygon_soup& m_soup;
  Polygons& m_lines;
  Scanner::Place m_tag;
  std::string_view m_section; // Points, Lines or nothing
  std::size_t m_points = 0;   // before those of the piece
  std::vector<Integer> m_indices;
  std::vector<std::size_t> m_ends;
};

} // namespace

void read_vtp(Scanner& in, Polygon_soup& soup, Polygons& lines) { Vtp_reader(in, soup, lines)(); }
