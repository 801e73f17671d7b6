// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/format_readers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

// These keywords begin a group of faces. Each group lasts until the next line with its keyword.
constexpr std::array<std::string_view, 3> group_keywords = {"o", "g", "usemtl"};

// Reads indices of one kind of elements. Elements can follow their indices in the file, so the
// greatest index is checked at the end.
class Index_reader
{
public:
  explicit Index_reader(const char* element) : m_element(element) {}

  // Reads an index, and returns the offset from the first element. A negative index counts back
  // from the last of the elements so far.
  std::size_t operator()(Scanner& in, std::size_t number_so_far)
  {
    const Scanner::Place start = in.place();
    const std::int64_t i = in.integer(), n = static_cast<std::int64_t>(number_so_far);
    if(i == 0 || i < -n) {
      in.return_to(start);
      in.fail("there is no " + m_element + " " + std::to_string(i) +
              "; count from 1, or backwards from -1 for the last element before");
    }
    const auto offset = static_cast<std::size_t>(i > 0 ? i - 1 : n + i);
    if(offset >= m_end) {
      m_end = offset + 1;
      m_place = start;
    }
    return offset;
  }

  // Fails where the greatest index stands if it names none of the elements.
  void check(Scanner& in, std::size_t number_of_elements) const
  {
    if(m_end <= number_of_elements)
      return;
    in.return_to(m_place);
    in.fail("there is no " + m_element + " " + std::to_string(m_end) + "; the file has " +
            std::to_string(number_of_elements));
  }

private:
  std::string m_element; // its name in messages
  std::size_t m_end = 0; // the greatest index, counted from 1
  Scanner::Place m_place = nullptr;
};

// Stores texture coordinates or normals, which corners refer to by indices.
struct Indexed_coordinates
{
  explicit Indexed_coordinates(const char* element) : read_index(element) {}

  void add(const std::vector<double>& numbers)
  {
    Corner_data_builder::Coordinates c{0, 0, 0};
    std::copy_n(numbers.begin(), (std::min)(numbers.size(), c.size()), c.begin());
    all.push_back(numbers.empty() ? Corner_data_builder::missing : c);
  }

  // Reads the index of a corner, which may be empty.
  void read_corner(std::size_t corner, std::string_view index, Scanner& in)
  {
    if(index.empty())
      return;
    in.return_to(index.data());
    const std::size_t i = read_index(in, all.size());
    number.resize(corner + 1, Polygons::none);
    number[corner] = static_cast<Polygons::Index>((std::min)(i, std::size_t(Polygons::none)));
  }

  // Ignores the indices if the file has no coordinates: some programs omit these alone.
  void check(Scanner& in) const
  {
    if(!all.empty())
      read_index.check(in, all.size());
  }

  Corner_data_builder::Coordinates operator()(std::size_t corner) const
  {
    return corner < number.size() && number[corner] < all.size() ? all[number[corner]]
                                                                 : Corner_data_builder::missing;
  }

  std::vector<Corner_data_builder::Coordinates> all;
  std::vector<Polygons::Index> number; // of those of each corner, as far as there were any
  Index_reader read_index;
};

// Reads the groups of polygons.
class Groups_reader
{
public:
  // Returns false if the line does not concern groups. `polygons` is the current number of
  // polygons.
  bool read_line(std::string_view key, Scanner& in, std::size_t polygons)
  {
    const auto found = std::find(group_keywords.begin(), group_keywords.end(), key);
    if(found != group_keywords.end()) {
      close(polygons);
      m_lines[std::size_t(found - group_keywords.begin())] = line(key, in);
    } else if(key == "mtllib")
      m_result.libraries.push_back(line(key, in));
    else
      return false;
    return true;
  }

  // Returns the groups. A keyword that appears late is missing in earlier groups.
  Polygon_groups finish(std::size_t polygons)
  {
    if(m_lines == Lines())
      return {};
    close(polygons);
    for(const Lines& group : m_groups) {
      m_result.lines.emplace_back();
      for(std::size_t k = 0; k < group.size(); ++k)
        m_result.lines.back() += group[k].empty() && !m_lines[k].empty()
                                   ? std::string(group_keywords[k]) + '\n'
                                   : group[k];
    }
    return std::move(m_result);
  }

private:
  typedef std::array<std::string, group_keywords.size()> Lines;

  static std::string line(std::string_view key, Scanner& in)
  {
    std::string result(key);
    for(std::string_view word = in.word(); !word.empty(); word = in.word())
      result.append(" ").append(word);
    return result + '\n';
  }

  void close(std::size_t polygons)
  {
    if(polygons == m_result.of_polygon.size())
      return;
    const auto next = static_cast<Polygons::Index>(m_groups.size());
    const auto [number, is_new] = m_numbers.emplace(m_lines, next);
    if(is_new)
      m_groups.push_back(m_lines);
    m_result.of_polygon.resize(polygons, number->second);
  }

  Lines m_lines; // in force
  std::vector<Lines> m_groups;
  std::map<Lines, Polygons::Index> m_numbers;
  Polygon_groups m_result;
};

class Obj_reader
{
public:
  Obj_reader(Scanner& in, Polygon_soup& soup, Polygons* lines)
    : m_in(in), m_soup(soup), m_lines(lines)
  {}

  void operator()()
  {
    m_in.join_lines('#');
    for(m_in.skip_comments('#'); !m_in.at_end(); m_in.skip_comments('#'))
      read_line();
    m_read_vertex.check(m_in, m_soup.points.size());
    m_texture.check(m_in);
    m_normals.check(m_in);
    add_data();
  }

private:
  // Reads a line. Polylines are read unless `m_lines` is null. Unknown statements are ignored, but
  // a line that begins with a number belongs to the previous line.
  void read_line()
  {
    const Scanner::Place start = m_in.place();
    const std::string_view key = m_in.word();
    if(key == "v")
      read_point();
    else if(key == "f" || key == "fo")
      read_corners(m_soup.polygons, true);
    else if(key == "vt")
      m_texture.add(m_in.numbers());
    else if(key == "vn")
      m_normals.add(m_in.numbers());
    else if(key == "l" && m_lines != nullptr)
      read_corners(*m_lines, false);
    else if(!m_groups.read_line(key, m_in, m_soup.polygons.size()) &&
            key.find_first_of("0123456789+-.") == 0) {
      m_in.return_to(start);
      m_in.fail(
        "a line begins with a number; a line that continues in the next one ends with a backslash");
    }
    m_in.skip_line();
  }

  void read_point()
  {
    const double x = m_in.number<double>(), y = m_in.number<double>(), z = m_in.number<double>();
    m_soup.points.emplace_back(x, y, z);
    if(m_in.at_line_end('#'))
      return;
    if(const std::vector<double> rest = m_in.numbers(); rest.size() == 3)
      for(std::size_t k = 0; k < 3; ++k)
        m_colors[k].push_back(rest[k]);
  }

  void read_corners(Polygons& polygons, bool have_data)
  {
    while(!m_in.at_line_end('#')) {
      const std::size_t corner = polygons.number_of_corners();
      polygons.add_corner(m_read_vertex(m_in, m_soup.points.size()));
      const std::string_view data = m_in.take_rest_of_word();
      if(have_data && !data.empty() && data[0] == '/')
        read_indices_of_data(corner, data.substr(1));
    }
    polygons.close();
  }

  void read_indices_of_data(std::size_t corner, std::string_view texture)
  {
    const Scanner::Place next = m_in.place();
    const std::size_t slash = texture.find('/');
    m_texture.read_corner(corner, texture.substr(0, slash), m_in);
    if(slash != texture.npos)
      m_normals.read_corner(corner, texture.substr(slash + 1), m_in);
    m_in.return_to(next);
  }

  // ---- Data ----

  // Returns whether the third texture coordinate is always zero, as many programs write it.
  bool is_texture_flat() const
  {
    return std::all_of(m_texture.all.begin(), m_texture.all.end(),
                       [](const Corner_data_builder::Coordinates& c) { return c[2] == 0; });
  }

  void add_data()
  {
    const Polygons& polygons = m_soup.polygons;
    const std::size_t points = m_soup.points.size();
    if(!m_texture.number.empty()) {
      const bool is_flat = is_texture_flat();
      for(Corner_data_builder::Coordinates& c : m_texture.all)
        c[2] = is_flat ? 1 : c[2];
      add_corner_data(
        is_flat ? "texcoord" : "homogeneous_texcoord", is_flat ? 2 : 3, polygons, points,
        [this](std::size_t c) { return m_texture(c); }, m_soup.data);
    }
    if(!m_normals.number.empty())
      add_corner_data(
        "normal", 3, polygons, points, [this](std::size_t c) { return m_normals(c); }, m_soup.data);
    m_soup.data.groups = m_groups.finish(polygons.size());
    add_colors();
  }

  void add_colors()
  {
    make_bytes(m_colors);
    const char* const names[] = {"red", "green", "blue"};
    for(std::size_t k = 0; k < 3; ++k)
      m_soup.data.functions.push_back({names[k], std::move(m_colors[k])});
  }

  Scanner& m_in;
  Polygon_soup& m_soup;
  Polygons* m_lines;
  Index_reader m_read_vertex{"vertex"};
  Indexed_coordinates m_texture{"texture coordinate"}, m_normals{"normal"};
  Groups_reader m_groups;
  std::vector<std::vector<double>> m_colors = std::vector<std::vector<double>>(3);
};

} // namespace

void read_obj(Scanner& in, Polygon_soup& soup, Polygons* lines) { Obj_reader(in, soup, lines)(); }
