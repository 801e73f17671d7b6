// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reading/Strip_splitter.h"
#include "reading/format_readers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace {

enum class Number_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT,
  DOUBLE
};

struct Type_description
{
  std::string_view name, other_name;
  std::size_t bytes;
};

constexpr std::array<Type_description, 8> types = {{{"char", "int8", 1},
                                                    {"uchar", "uint8", 1},
                                                    {"short", "int16", 2},
                                                    {"ushort", "uint16", 2},
                                                    {"int", "int32", 4},
                                                    {"uint", "uint32", 4},
                                                    {"float", "float32", 4},
                                                    {"double", "float64", 8}}};

struct Property
{
  std::string name;
  Number_type type;
  std::optional<Number_type> type_of_size; // of a list
};

struct Element
{
  std::string name;
  std::size_t count;
  std::vector<Property> properties;

  // Returns the position of the property with one of these names, or no position.
  template <class... Names>
  std::size_t position(const Names&... names) const
  {
    const auto has_name = [&](const Property& p) { return ((p.name == names) || ...); };
    return static_cast<std::size_t>(std::find_if(properties.begin(), properties.end(), has_name) -
                                    properties.begin());
  }

  bool has(std::size_t position, bool is_list) const
  {
    return position < properties.size() && properties[position].type_of_size.has_value() == is_list;
  }
};

class Ply_reader
{
public:
  Ply_reader(Scanner& in, Polygon_soup& soup, Polygons* lines)
    : m_in(in), m_soup(soup), m_lines(lines)
  {}

  void operator()()
  {
    read_header();
    m_number_of_vertices = number_of_vertices();
    for(const Element& element : m_elements)
      read_element(element);
    m_in.expect_end("the last element");
    add_corner_lists();
    if(m_soup.data.corners.empty())
      add_texture_of_points();
  }

private:
  // ---- Header ----

  void read_header()
  {
    if(!m_in.accept_in_any_case("ply"))
      m_in.fail("'ply' expected at the beginning");
    m_in.skip_line();
    read_format();
    for(; !m_in.accept("end_header"); m_in.skip_line())
      read_header_line();
    m_in.skip_line();
    if(m_is_binary)
      m_in.set_binary();
  }

  void read_format()
  {
    while(is_comment())
      m_in.skip_line();
    if(!m_in.accept("format"))
      m_in.fail("'format' expected after 'ply' and comments");
    m_is_big_endian = m_in.accept("binary_big_endian");
    m_is_binary = m_is_big_endian || m_in.accept("binary_little_endian");
    if(!m_is_binary && !m_in.accept("ascii"))
      m_in.fail("the format is none of ascii, binary_little_endian and binary_big_endian");
    m_in.skip_line();
  }

  bool is_comment() { return m_in.accept("comment") || m_in.accept("obj_info"); }

  void read_header_line()
  {
    if(m_in.accept("element")) {
      std::string name(m_in.word());
      m_elements.push_back({std::move(name), m_in.count(), {}});
    } else if(m_in.accept("property"))
      read_property();
    else if(!is_comment())
      m_in.fail("'element', 'property', 'comment' or 'end_header' expected");
  }

  void read_property()
  {
    if(m_elements.empty())
      m_in.fail("a property comes before any element; 'element vertex' must come first");
    Property p;
    if(m_in.accept("list")) {
      p.type_of_size = read_type();
      if(*p.type_of_size >= Number_type::FLOAT)
        m_in.fail("the size of a list must be an integer; make its first type uchar or int");
    }
    p.type = read_type();
    p.name = m_in.word();
    m_elements.back().properties.push_back(std::move(p));
  }

  Number_type read_type()
  {
    for(std::size_t t = 0; t < types.size(); ++t)
      if(m_in.accept(types[t].name) || m_in.accept(types[t].other_name))
        return static_cast<Number_type>(t);
    m_in.fail(
      "this type of numbers is unknown; the types are char, short, int, float and double, and "
      "uchar, ushort and uint");
  }

  // ---- Numbers ----

  // Reads a number. All types are exact in `double`.
  double read_number(Number_type type)
  {
    if(!m_is_binary) {
      m_in.skip_space();
      return type == Number_type::FLOAT ? static_cast<double>(m_in.number<float>())
                                        : m_in.number<double>();
    }
    switch(type) {
      case Number_type::INT8: return m_in.binary<std::int8_t>(m_is_big_endian);
      case Number_type::UINT8: return m_in.binary<std::uint8_t>(m_is_big_endian);
      case Number_type::INT16: return m_in.binary<std::int16_t>(m_is_big_endian);
      case Number_type::UINT16: return m_in.binary<std::uint16_t>(m_is_big_endian);
      case Number_type::INT32: return m_in.binary<std::int32_t>(m_is_big_endian);
      case Number_type::UINT32: return m_in.binary<std::uint32_t>(m_is_big_endian);
      case Number_type::FLOAT: return static_cast<double>(m_in.binary<float>(m_is_big_endian));
      default: return m_in.binary<double>(m_is_big_endian);
    }
  }

  // Reads an index, or no index if the number is none.
  std::size_t read_index(Number_type type)
  {
    const double x = read_number(type);
    return x >= 0 && x < Polygons::none && x == std::floor(x) ? static_cast<std::size_t>(x)
                                                              : Polygons::none;
  }

  // Reads the index of a vertex of `what`. Vertices may come after it.
  std::size_t read_vertex_index(Number_type type, const char* what)
  {
    const Scanner::Place start = m_in.place();
    const std::size_t result = read_index(type);
    if(result < m_number_of_vertices)
      return result;
    m_in.return_to(start);
    if(!m_is_binary)
      m_in.skip_space();
    m_in.fail(std::string(what) + " names a vertex that does not exist; there are " +
              std::to_string(m_number_of_vertices));
  }

  std::size_t read_size(Number_type type)
  {
    const std::size_t size = read_index(type);
    if(size == Polygons::none)
      m_in.fail(
        "the size of a list is negative or not an integer; give the number of its elements");
    if(size > m_in.remaining())
      m_in.fail_as_a_whole("ends too early; it is not complete");
    return size;
  }

  // Reads the number, or the size of the list that is skipped.
  double read_or_skip(const Property& property)
  {
    if(!property.type_of_size)
      return read_number(property.type);
    const std::size_t size = read_size(*property.type_of_size);
    for(std::size_t k = 0; k < size; ++k)
      read_number(property.type);
    return static_cast<double>(size);
  }

  // ---- Elements ----

  // Returns the expected number of elements. Each number needs a byte or more.
  std::size_t expected_count(const Element& element) const
  {
    return (std::min)(element.count,
                      m_in.remaining() / (std::max)(element.properties.size(), std::size_t(1)));
  }

  void read_element(const Element& element)
  {
    if(element.name == "vertex" || element.name == "vertices")
      read_vertices(element);
    else if(element.name == "face" || element.name == "faces") {
      m_soup.polygons.reserve(expected_count(element), 3 * expected_count(element));
      read_lists(element, [this](std::size_t size, Number_type type) {
        for(std::size_t k = 0; k < size; ++k)
          m_soup.polygons.add_corner(read_vertex_index(type, "a face"));
        m_soup.polygons.close();
      });
    } else if(element.name == "tristrips")
      read_lists(element, [this](std::size_t size, Number_type type) {
        Strip_splitter splitter(m_soup.polygons);
        for(std::size_t k = 0; k < size; ++k)
          splitter.add_corner(read_index(type));
      });
    else if((element.name == "edge" || element.name == "edges") && m_lines != nullptr)
      read_edges(element);
    else
      skip(element);
  }

  void skip(const Element& element)
  {
    if(!element.properties.empty())
      for(std::size_t i = 0; i < element.count; ++i)
        for(const Property& p : element.properties)
          read_or_skip(p);
  }

  // Reads lists, where `read_list(size, type)` reads the indices of vertices of an element.
  template <class Read_list>
  void read_lists(const Element& element, const Read_list& read_list)
  {
    const std::size_t list = element.position("vertex_indices", "vertex_index");
    if(!element.has(list, true))
      m_in.fail_as_a_whole("has no list 'vertex_indices' of element '" + element.name + "'");
    for(std::size_t i = 0; i < element.count; ++i)
      for(std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        if(p == list)
          read_list(read_size(*property.type_of_size), property.type);
        else if(property.type_of_size && corner_dimension(property.name) > 0)
          read_corner_list(property);
        else
          read_or_skip(property);
      }
  }

  // ---- Data of corners ----

  // Stores the numbers of all polygons so far, one polygon after the other.
  struct Corner_list
  {
    std::vector<double> numbers;
    std::vector<std::size_t> first; // of each polygon
  };

  void read_corner_list(const Property& property)
  {
    Corner_list& list = m_corner_lists[property.name];
    list.first.push_back(list.numbers.size());
    for(std::size_t size = read_size(*property.type_of_size); size > 0; --size)
      list.numbers.push_back(read_number(property.type));
  }

  // Adds the lists that have a number for each polygon. Lists with another number of corners are
  // ignored.
  void add_corner_lists()
  {
    for(auto& [name, list] : m_corner_lists)
      if(list.first.size() == m_soup.polygons.size()) {
        const std::size_t dimension = corner_dimension(name);
        const std::vector<std::size_t> place = places(list, dimension);
        add_corner_data(
          name, dimension, m_soup.polygons, m_soup.points.size(),
          [&, &numbers = list.numbers](std::size_t c) {
            auto result = Corner_data_builder::missing;
            if(place[c] != numbers.size())
              result = {numbers[place[c]], numbers[place[c] + 1],
                        dimension == 3 ? numbers[place[c] + 2] : 1};
            return result;
          },
          m_soup.data);
      }
  }

  // Returns the positions of the numbers of each corner, or the end for none.
  std::vector<std::size_t> places(const Corner_list& list, std::size_t dimension) const
  {
    std::vector<std::size_t> result;
    result.reserve(m_soup.polygons.number_of_corners());
    for(std::size_t i = 0; i < list.first.size(); ++i) {
      const std::size_t size = m_soup.polygons[i].size(), first = list.first[i],
                        end = i + 1 < list.first.size() ? list.first[i + 1] : list.numbers.size();
      for(std::size_t k = 0; k < size; ++k)
        result.push_back(end - first == dimension * size ? first + dimension * k
                                                         : list.numbers.size());
    }
    return result;
  }

  // Adds texture coordinates that are properties of vertices with these names.
  void add_texture_of_points()
  {
    for(const std::array<const char*, 2>& names :
        {std::array{"texture_u", "texture_v"}, std::array{"s", "t"}, std::array{"u", "v"}}) {
      const Point_function *u = m_soup.data.function(names[0]), *v = m_soup.data.function(names[1]);
      const std::size_t n = m_soup.points.size();
      const bool is_vector = names[0][0] == 'u' && m_soup.data.function("w") != nullptr;
      if(u == nullptr || v == nullptr || is_vector || u->values.size() != n ||
         v->values.size() != n)
        continue;
      const auto coordinates = [&](std::size_t c) -> Corner_data_builder::Coordinates {
        const Polygons::Index p = m_soup.polygons.corners()[c];
        return {u->values[p], v->values[p], 1};
      };
      return add_corner_data("texcoord", 2, m_soup.polygons, n, coordinates, m_soup.data);
    }
  }

  void read_vertices(const Element& element)
  {
    std::array<std::size_t, 3> axes;
    for(std::size_t k = 0; k < 3; ++k) {
      const std::string name(1, "xyz"[k]);
      axes[k] = element.position(name);
      if(!element.has(axes[k], false))
        m_in.fail_as_a_whole("vertices have no coordinate '" + name + "'");
    }
    m_soup.points.reserve(m_soup.points.size() + expected_count(element));
    const std::vector<std::array<std::size_t, 2>> columns = columns_of_functions(element, axes);
    std::vector<double> row(element.properties.size());
    for(std::size_t i = 0; i < element.count; ++i) {
      for(std::size_t p = 0; p < row.size(); ++p)
        row[p] = read_or_skip(element.properties[p]);
      m_soup.points.emplace_back(row[axes[0]], row[axes[1]], row[axes[2]]);
      for(const auto& [property, function] : columns)
        m_soup.data.functions[function].values.push_back(row[property]);
    }
  }

  // Returns the properties that are functions, each with the number of the function.
  std::vector<std::array<std::size_t, 2>>
  columns_of_functions(const Element& element, const std::array<std::size_t, 3>& axes)
  {
    std::vector<std::array<std::size_t, 2>> result;
    auto& all = m_soup.data.functions;
    for(std::size_t p = 0; p < element.properties.size(); ++p) {
      if(!element.has(p, false) || std::find(axes.begin(), axes.end(), p) != axes.end())
        continue;
      const std::string& name = element.properties[p].name;
      const Point_function* known = m_soup.data.function(name);
      result.push_back({p, known == nullptr ? all.size() : std::size_t(known - all.data())});
      if(known == nullptr)
        all.push_back({name, {}, element.properties[p].type >= Number_type::FLOAT});
    }
    return result;
  }

  void read_edges(const Element& element)
  {
    const std::array ends{element.position("vertex1"), element.position("vertex2")};
    if(!element.has(ends[0], false) || !element.has(ends[1], false))
      m_in.fail_as_a_whole("edges have no properties 'vertex1' and 'vertex2'");
    for(std::size_t i = 0; i < element.count; ++i) {
      std::array<std::size_t, 2> edge{};
      for(std::size_t p = 0; p < element.properties.size(); ++p)
        if(const auto end = std::find(ends.begin(), ends.end(), p); end != ends.end())
          edge[static_cast<std::size_t>(end - ends.begin())] =
            read_vertex_index(element.properties[p].type, "an edge");
        else
          read_or_skip(element.properties[p]);
      m_lines->push_back(edge);
    }
  }

  std::size_t number_of_vertices() const
  {
    std::size_t result = 0;
    for(const Element& element : m_elements)
      if(element.name == "vertex" || element.name == "vertices")
        result += element.count;
    return result;
  }

  Scanner& m_in;
  Polygon_soup& m_soup;
  Polygons* m_lines; // edges, unless it is null
  bool m_is_binary = false, m_is_big_endian = false;
  std::vector<Element> m_elements;
  std::size_t m_number_of_vertices = 0;              // of all elements
  std::map<std::string, Corner_list> m_corner_lists; // by the names of the properties
};

} // namespace

void read_ply(Scanner& in, Polygon_soup& soup, Polygons* lines) { Ply_reader(in, soup, lines)(); }
