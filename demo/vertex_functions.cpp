// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vertex_functions.h"

#include "Polygon_soup.h"
#include "Program_error.h"
#include "file_extension.h"

#include <CGAL/IO/Color.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/read_ply_points.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

namespace {

typedef std::vector<double> Values;

// Writes a number of any type to a number.
struct Number_map
{
  template <class Number>
  friend void put(Number_map, double& target, Number x)
  {
    target = static_cast<double>(x);
  }
};

template <class Number>
bool read_property(std::istream& in, const std::string& name, Values& values)
{
  return CGAL::IO::read_PLY_with_properties<double>(
    in, std::back_inserter(values),
    std::make_pair(Number_map(), CGAL::IO::PLY_property<Number>(name.c_str())));
}

struct Number_type
{
  std::array<std::string_view, 2> names;
  bool (*read)(std::istream& in, const std::string& name, Values& values);
};

constexpr std::array<Number_type, 8> number_types = {
  {{{"char", "int8"}, read_property<std::int8_t>},
   {{"uchar", "uint8"}, read_property<std::uint8_t>},
   {{"short", "int16"}, read_property<std::int16_t>},
   {{"ushort", "uint16"}, read_property<std::uint16_t>},
   {{"int", "int32"}, read_property<std::int32_t>},
   {{"uint", "uint32"}, read_property<std::uint32_t>},
   {{"float", "float32"}, read_property<float>},
   {{"double", "float64"}, read_property<double>}}};

// Of each property of vertices.
std::map<std::string, std::string> ply_types(const std::string& path)
{
  std::map<std::string, std::string> result;
  std::ifstream file(path, std::ios::binary);
  std::string line, element;
  while(element != "end_header" && std::getline(file, line)) {
    std::istringstream words(line);
    std::string key, type, name;
    words >> key >> type >> name;
    if(key == "element" || key == "end_header")
      element = key == "element" ? type : key;
    else if(key == "property" && (element == "vertex" || element == "vertices"))
      result[name] = type;
  }
  return result;
}

[[noreturn]] void fail(const std::string& path, const std::string& what)
{
  throw Program_error(path + ": " + what);
}

Values ply_values(const std::string& path, const std::string& name, const std::string& type)
{
  Values result;
  std::ifstream file(path, std::ios::binary);
  for(const Number_type& t : number_types)
    if((t.names[0] == type || t.names[1] == type) && t.read(file, name, result))
      return result;
  fail(path, "the property '" + name + "' of vertices cannot be read as numbers");
}

std::vector<Values> ply_colors(const std::string& path)
{
  const auto types = ply_types(path);
  for(const std::array<const char*, 3>& names :
      {std::array{"red", "green", "blue"}, std::array{"r", "g", "b"}}) {
    std::vector<Values> result;
    for(const char* name : names)
      if(const auto type = types.find(name); type != types.end())
        result.push_back(ply_values(path, name, type->second));
    if(result.size() == names.size())
      return result;
  }
  return {};
}

std::vector<Values> off_colors(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  Polygon_soup soup;
  std::vector<CGAL::IO::Color> colors;
  CGAL::IO::read_OFF(
    file, soup.points, soup.polygons,
    CGAL::parameters::vertex_color_output_iterator(std::back_inserter(colors)).verbose(false));
  if(colors.size() != soup.points.size())
    return {};
  std::vector<Values> result(3);
  for(const CGAL::IO::Color& c : colors) {
    result[0].push_back(c.red());
    result[1].push_back(c.green());
    result[2].push_back(c.blue());
  }
  return result;
}

std::vector<Values> colors(const std::string& path)
{
  std::vector<Values> result;
  if(extension_of(path) == ".ply")
    result = ply_colors(path);
  else if(extension_of(path) == ".off")
    result = off_colors(path);
  if(result.empty())
    fail(path, "vertices have no colors (.ply and .off can have them)");
  return result;
}

Values property(const std::string& path, const std::string& name)
{
  if(extension_of(path) != ".ply")
    fail(path, "vertices have no property '" + name + "' (.ply can have properties)");
  const auto types = ply_types(path);
  const auto type = types.find(name);
  if(type != types.end())
    return ply_values(path, name, type->second);
  std::string known;
  for(const auto& [other, other_type] : types)
    known += (known.empty() ? "" : ", ") + other;
  fail(path, "vertices have no property '" + name + "'; they have " + known);
}

} // namespace

std::vector<std::vector<double>> read_vertex_function(const std::string& path,
                                                      const std::string& name)
{
  const std::vector<Values> result =
    name == "color" ? colors(path) : std::vector<Values>{property(path, name)};
  for(const Values& component : result)
    for(const double x : component)
      if(!std::isfinite(x))
        fail(path, "a value of '" + name + "' is not finite");
  return result;
}
