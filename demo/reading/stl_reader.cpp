// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/format_readers.h"

#include <boost/container_hash/hash.hpp>

#include <array>
#include <string>
#include <string_view>
#include <unordered_map>

namespace {

class Stl_reader
{
public:
  Stl_reader(Scanner& in, Polygon_soup& soup) : m_in(in), m_soup(soup) {}

  void operator()()
  {
    if(is_binary())
      read_binary();
    else
      read_text();
    m_soup.merged_corners = 3 * m_soup.polygons.size() - m_soup.points.size();
  }

private:
  typedef std::array<double, 3> Coordinates;

  static constexpr std::size_t header_bytes = 80;

  // Returns whether a file whose size does not fit is binary. It is if it has a byte that texts do
  // not contain.
  bool has_binary_numbers() const { return m_in.bytes().find('\0') != std::string_view::npos; }

  // Returns whether the file is binary. Binary files may start with "solid", too.
  bool is_binary()
  {
    const Scanner::Place start = m_in.place();
    m_in.skip_space();
    const bool result =
      is_binary_stl(m_in.bytes()) || !m_in.accept_in_any_case("solid") || has_binary_numbers();
    m_in.return_to(start);
    return result;
  }

  void add_corner(const Coordinates& p)
  {
    // Adding zero unites both signs of zero.
    const Coordinates key = {p[0] + 0., p[1] + 0., p[2] + 0.};
    const auto [point, is_new] = m_index.try_emplace(key, m_soup.points.size());
    if(is_new)
      m_soup.points.emplace_back(p[0], p[1], p[2]);
    m_soup.polygons.add_corner(point->second);
  }

  void read_binary()
  {
    m_in.set_binary();
    m_in.skip_bytes(header_bytes);
    const std::size_t facets = m_in.binary<std::uint32_t>(false);
    for(std::size_t f = 0; f < facets; ++f) {
      m_in.skip_bytes(12); // the normal
      for(int corner = 0; corner < 3; ++corner) {
        Coordinates p;
        for(double& x : p)
          x = static_cast<double>(m_in.binary<float>(false));
        add_corner(p);
      }
      m_soup.polygons.close();
      m_in.skip_bytes(2);
    }
    m_in.expect_end("the last of " + std::to_string(facets) + " facets");
  }

  void read_text()
  {
    for(m_in.skip_space(); !m_in.at_end(); m_in.skip_space())
      if(m_in.accept_in_any_case("facet"))
        read_facet();
      else if(m_in.accept_in_any_case("solid") || m_in.accept_in_any_case("endsolid"))
        m_in.skip_line();
      else
        m_in.fail("'facet' or 'endsolid' expected");
  }

  // Reads a facet, and skips the normal and redundant words.
  void read_facet()
  {
    int corners = 0;
    for(m_in.skip_space(); !m_in.accept_in_any_case("endfacet"); m_in.skip_space()) {
      if(m_in.accept_in_any_case("vertex")) {
        if(++corners > 3)
          m_in.fail("a facet has more than three vertices; split it into triangles");
        const double x = m_in.number<double>(), y = m_in.number<double>();
        add_corner({x, y, m_in.number<double>()});
      } else if(m_in.word().empty() && m_in.at_end())
        m_in.fail("'endfacet' expected");
    }
    if(corners < 3)
      m_in.fail("a facet has fewer than three vertices; remove it or complete it");
    m_soup.polygons.close();
  }

  Scanner& m_in;
  Polygon_soup& m_soup;
  std::unordered_map<Coordinates, std::size_t, boost::hash<Coordinates>> m_index;
};

} // namespace

void read_stl(Scanner& in, Polygon_soup& soup) { Stl_reader(in, soup)(); }
