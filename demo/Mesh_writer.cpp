// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_writer.h"

#include "Program_error.h"
#include "file_extension.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string_view>
#include <type_traits>
#include <utility>

namespace {

Text& operator<<(Text& text, const Point& p)
{
  return text << p.x() << ' ' << p.y() << ' ' << p.z();
}

void write_off(Text& text, const Output_mesh& mesh)
{
  text << "OFF\n" << mesh.points.size() << ' ' << mesh.polygons.size() << " 0\n";
  for(const Point& p : mesh.points)
    text << p << '\n';
  for(const Polygons::Polygon& polygon : mesh.polygons) {
    text << polygon.size();
    for(const Polygons::Index i : polygon)
      text << ' ' << i;
    text << '\n';
  }
}

void add_coordinates(Text& text, const Texture& texture, std::size_t i)
{
  for(std::size_t k = 0; k < texture.dimension; ++k)
    text << ' ' << texture.coordinates[i][k];
}

void add_obj_face(Text& text, const Output_mesh& mesh, std::size_t i)
{
  text << 'f';
  const Polygons::Polygon polygon = mesh.polygons[i];
  for(std::size_t k = 0; k < polygon.size(); ++k) {
    text << ' ' << polygon[k] + 1;
    if(mesh.texture.dimension > 0)
      text << '/' << mesh.texture.polygons[i][k] + 1;
  }
  text << '\n';
}

void add_obj_lines(Text& text, const Output_mesh& mesh)
{
  for(const Polygons::Polygon& line : mesh.lines) {
    text << 'l';
    for(const Polygons::Index i : line)
      text << ' ' << i + 1;
    text << '\n';
  }
}

void write_obj(Text& text, const Output_mesh& mesh)
{
  for(const Point& p : mesh.points)
    text << "v " << p << '\n';
  for(std::size_t i = 0; i < mesh.texture.coordinates.size(); ++i) {
    text << "vt";
    add_coordinates(text, mesh.texture, i);
    text << '\n';
  }
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i)
    add_obj_face(text, mesh, i);
  if(mesh.polygons.size() == 0)
    add_obj_lines(text, mesh);
}

const char* name_of(const Texture& texture)
{
  return texture.dimension == 3 ? "homogeneous_texcoord" : "texcoord";
}

// Viewers know colors by their names and this type.
bool is_color(const Attribute& a)
{
  return a.name == "red" || a.name == "green" || a.name == "blue";
}

const char* ply_type(const Attribute& a)
{
  if(is_color(a))
    return "uchar";
  return a.has_integers() ? "int" : "double";
}

class Ply_writer
{
public:
  Ply_writer(Text& text, const Output_mesh& mesh, bool is_binary)
    : m_text(text), m_mesh(mesh), m_is_binary(is_binary), m_is_texture_small(is_texture_small())
  {}

  void operator()()
  {
    add_header();
    add_rows(m_mesh.points.size(), m_mesh.point_data, [this](std::size_t i) {
      for(int k = 0; k < 3; ++k)
        add(m_mesh.points[i][k]);
    });
    add_rows(m_mesh.polygons.size(), m_mesh.polygon_data,
             [this](std::size_t i) { add_polygon(i); });
    add_rows(m_mesh.edges.size(), m_mesh.edge_data, [this](std::size_t i) {
      for(const Polygons::Index v : m_mesh.edges[i])
        add(static_cast<std::int32_t>(v));
    });
  }

private:
  // ---- Header ----

  void add_header()
  {
    m_text << "ply\nformat " << (m_is_binary ? "binary_little_endian" : "ascii")
           << " 1.0\nelement vertex " << m_mesh.points.size()
           << "\nproperty double x\nproperty double y\nproperty double z\n";
    add_properties(m_mesh.point_data);
    m_text << "element face " << m_mesh.polygons.size()
           << "\nproperty list uint int vertex_indices\n";
    if(m_mesh.texture.dimension > 0)
      m_text << "property list " << (m_is_texture_small ? "uchar" : "uint") << " double "
             << name_of(m_mesh.texture) << '\n';
    add_properties(m_mesh.polygon_data);
    if(!m_mesh.edges.empty()) {
      m_text << "element edge " << m_mesh.edges.size()
             << "\nproperty int vertex1\nproperty int vertex2\n";
      add_properties(m_mesh.edge_data);
    }
    m_text << "end_header\n";
  }

  void add_properties(const std::vector<Attribute>& data)
  {
    for(const Attribute& a : data)
      m_text << "property " << ply_type(a) << ' ' << a.name << '\n';
  }

  // Whether the number of coordinates of each polygon fits into one byte, as viewers expect it.
  bool is_texture_small() const
  {
    return std::all_of(
      m_mesh.texture.polygons.begin(), m_mesh.texture.polygons.end(),
      [this](const Polygons::Polygon& p) { return m_mesh.texture.dimension * p.size() < 256; });
  }

  // ---- Rows of numbers ----

  template <class Number>
  void add(Number x)
  {
    if(m_is_binary)
      m_text.add_bytes(x);
    else
      add_word(x);
  }

  template <class Number>
  void add_word(Number x)
  {
    typedef std::conditional_t<std::is_floating_point_v<Number>, double, std::int64_t> Written;
    if(m_is_in_row)
      m_text << ' ';
    m_text << static_cast<Written>(x);
    m_is_in_row = true;
  }

  // The values of an attribute; one of the two is null.
  struct Column
  {
    explicit Column(const Attribute& a)
      : integers(std::get_if<0>(&a.values)), reals(std::get_if<1>(&a.values)), is_byte(is_color(a))
    {}

    const Values<std::int64_t>* integers;
    const Values<double>* reals;
    bool is_byte;
  };

  void add_value(const Column& column, std::size_t i)
  {
    if(column.reals != nullptr)
      add((*column.reals)[i]);
    else if(column.is_byte)
      add(static_cast<std::uint8_t>((*column.integers)[i]));
    else
      add(static_cast<std::int32_t>((*column.integers)[i]));
  }

  // `add_element(i)` adds what an element is; attributes follow.
  template <class Add_element>
  void add_rows(std::size_t n, const std::vector<Attribute>& data, const Add_element& add_element)
  {
    const std::vector<Column> columns(data.begin(), data.end());
    for(std::size_t i = 0; i < n; ++i) {
      add_element(i);
      for(const Column& c : columns)
        add_value(c, i);
      if(!m_is_binary)
        m_text << '\n';
      m_is_in_row = false;
    }
  }

  void add_polygon(std::size_t i)
  {
    const Polygons::Polygon polygon = m_mesh.polygons[i];
    add(static_cast<std::uint32_t>(polygon.size()));
    for(const Polygons::Index v : polygon)
      add(static_cast<std::int32_t>(v));
    if(m_mesh.texture.dimension > 0)
      add_texture(m_mesh.texture.polygons[i]);
  }

  void add_texture(const Polygons::Polygon& polygon)
  {
    const std::size_t n = m_mesh.texture.dimension * polygon.size();
    if(m_is_texture_small)
      add(static_cast<std::uint8_t>(n));
    else
      add(static_cast<std::uint32_t>(n));
    for(const Polygons::Index c : polygon)
      for(std::size_t k = 0; k < m_mesh.texture.dimension; ++k)
        add(m_mesh.texture.coordinates[c][k]);
  }

  Text& m_text;
  const Output_mesh& m_mesh;
  bool m_is_binary;
  bool m_is_texture_small;
  bool m_is_in_row = false;
};

// `add(i)` adds the text of entry i.
template <class Add>
void add_vtp_array(Text& text, std::string_view attributes, std::size_t n, const Add& add)
{
  text << "<DataArray format=\"ascii\" " << attributes << ">\n";
  for(std::size_t i = 0; i < n; ++i) {
    add(i);
    text << '\n';
  }
  text << "</DataArray>\n";
}

void add_vtp_data(Text& text, const std::vector<Attribute>& data)
{
  for(const Attribute& a : data)
    add_vtp_array(
      text,
      (a.has_integers() ? "type=\"Int32\" Name=\"" : "type=\"Float64\" Name=\"") + a.name + "\"",
      a.size(),
      [&](std::size_t i) { std::visit([&](const auto& values) { text << values[i]; }, a.values); });
}

// The points have the texture coordinates with their numbers.
void add_vtp_texture(Text& text, const Texture& texture)
{
  if(texture.dimension == 0)
    return;
  Text attributes;
  attributes << "type=\"Float64\" Name=\"" << name_of(texture) << "\" NumberOfComponents=\""
             << texture.dimension << '"';
  add_vtp_array(text, attributes.take(), texture.coordinates.size(),
                [&](std::size_t i) { add_coordinates(text, texture, i); });
}

// Repeats points until each has one texture coordinate, with the number of the point.
class Texture_splitting
{
public:
  explicit Texture_splitting(const Output_mesh& mesh)
    : m_mesh(mesh), m_coordinate(mesh.points.size(), none)
  {
    m_mesh.texture.polygons = m_mesh.polygons = Polygons();
    for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
      for(std::size_t k = 0; k < mesh.polygons[i].size(); ++k)
        m_mesh.polygons.add_corner(point_with(mesh.texture.polygons[i][k], mesh.polygons[i][k]));
      m_mesh.polygons.close();
    }
    set_coordinates(mesh.texture.coordinates);
  }

  const Output_mesh& mesh() const { return m_mesh; }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t point_with(std::size_t coordinate, std::size_t point)
  {
    if(m_coordinate[point] == none)
      m_coordinate[point] = coordinate;
    if(m_coordinate[point] == coordinate)
      return point;
    const auto [copy, is_new] = m_copy.emplace(std::pair(point, coordinate), m_coordinate.size());
    if(is_new)
      repeat(point, coordinate);
    return copy->second;
  }

  void repeat(std::size_t point, std::size_t coordinate)
  {
    m_coordinate.push_back(coordinate);
    m_mesh.points.push_back(Point(m_mesh.points[point]));
    for(Attribute& a : m_mesh.point_data)
      std::visit([point](auto& v) { v.kept().insert(v.kept().end(), 1, v.kept()[point]); },
                 a.values);
  }

  // isolated points are at the origin
  void set_coordinates(const std::vector<std::array<double, 3>>& all)
  {
    m_mesh.texture.coordinates.clear();
    for(const std::size_t c : m_coordinate)
      m_mesh.texture.coordinates.push_back(c == none ? std::array<double, 3>{0, 0, 1} : all[c]);
  }

  Output_mesh m_mesh;
  std::vector<std::size_t> m_coordinate; // of each point
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> m_copy;
};

void add_vtp_points(Text& text, const Output_mesh& mesh)
{
  text << "<Points>\n";
  add_vtp_array(text, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
                mesh.points.size(), [&](std::size_t i) { text << mesh.points[i]; });
  text << "</Points>\n";
}

// Nothing if there are none.
void add_vtp_cells(Text& text, std::string_view kind, const Polygons& cells)
{
  if(cells.empty())
    return;
  text << '<' << kind << ">\n";
  add_vtp_array(text, "type=\"Int64\" Name=\"connectivity\"", cells.size(), [&](std::size_t i) {
    for(const Polygons::Index v : cells[i])
      text << v << ' ';
  });
  std::size_t offset = 0;
  add_vtp_array(text, "type=\"Int64\" Name=\"offsets\"", cells.size(),
                [&](std::size_t i) { text << (offset += cells[i].size()); });
  text << "</" << kind << ">\n";
}

// Adds -1 for each of `n` elements before the others, or behind them.
void pad(Attribute& a, std::size_t n, bool is_before)
{
  const auto add = [&](auto& v) { v.insert(is_before ? v.begin() : v.end(), n, -1); };
  if(n > 0)
    std::visit([&](auto& values) { add(values.kept()); }, a.values);
}

// Those of lines, then those of polygons.
std::vector<Attribute> vtp_cell_data(const Output_mesh& mesh)
{
  std::vector<Attribute> result = mesh.line_data;
  for(Attribute& a : result)
    pad(a, mesh.polygons.size(), false);
  for(const Attribute& a : mesh.polygon_data) {
    const auto both = std::find_if(result.begin(), result.end(),
                                   [&](const Attribute& b) { return b.name == a.name; });
    if(both == result.end()) {
      result.push_back(a);
      pad(result.back(), mesh.lines.size(), true);
      continue;
    }
    const auto copy_to_end = [](const auto& from, auto& to) {
      auto& numbers = to.kept();
      typedef typename std::decay_t<decltype(numbers)>::value_type Number;
      for(std::size_t i = 0; i < from.size(); ++i)
        numbers[numbers.size() - from.size() + i] = static_cast<Number>(from[i]);
    };
    std::visit(copy_to_end, a.values, both->values);
  }
  return result;
}

void write_vtp_with_point_texture(Text& text, const Output_mesh& mesh)
{
  text << "<?xml version=\"1.0\"?>\n"
       << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
       << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfVerts=\"0\" "
       << "NumberOfLines=\"" << mesh.lines.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
       << mesh.polygons.size() << "\">\n";
  text << "<PointData" << (mesh.texture.dimension == 2 ? " TCoords=\"texcoord\">\n" : ">\n");
  add_vtp_data(text, mesh.point_data);
  add_vtp_texture(text, mesh.texture);
  text << "</PointData>\n<CellData>\n";
  add_vtp_data(text, vtp_cell_data(mesh));
  text << "</CellData>\n";
  add_vtp_points(text, mesh);
  add_vtp_cells(text, "Lines", mesh.lines);
  add_vtp_cells(text, "Polys", mesh.polygons);
  text << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

void write_vtp(Text& text, const Output_mesh& mesh)
{
  if(mesh.texture.dimension == 0)
    write_vtp_with_point_texture(text, mesh);
  else
    write_vtp_with_point_texture(text, Texture_splitting(mesh).mesh());
}

constexpr std::array<std::string_view, 4> names = {"off", "obj", "ply", "vtp"};

// By its name or extension, with or without dot, in any case.
Mesh_format mesh_format(const std::string& name)
{
  const std::string key = lower_case(name.substr(name.compare(0, 1, ".") == 0 ? 1 : 0));
  for(std::size_t i = 0; i < names.size(); ++i)
    if(names[i] == key)
      return static_cast<Mesh_format>(i);
  throw Program_error("no such output format: '" + name + "' (there are off, obj, ply and vtp)");
}

} // namespace

Mesh_format output_format(const std::string& path, const Output_options& options)
{
  const Mesh_format format =
    mesh_format(path == "-" ? options.format : std::filesystem::path(path).extension().string());
  if(!options.is_binary)
    return format;
  if(format != Mesh_format::PLY)
    throw Program_error(path + ": this format cannot be binary (.ply can)");
  return Mesh_format::BINARY_PLY;
}

bool has_attributes(Mesh_format format)
{
  return format != Mesh_format::OFF && format != Mesh_format::OBJ;
}

bool has_texture(Mesh_format format) { return format != Mesh_format::OFF; }

void write(Text& text, const Output_mesh& mesh, Mesh_format format)
{
  switch(format) {
    case Mesh_format::OFF: return write_off(text, mesh);
    case Mesh_format::OBJ: return write_obj(text, mesh);
    case Mesh_format::VTP: return write_vtp(text, mesh);
    default: return Ply_writer(text, mesh, format == Mesh_format::BINARY_PLY)();
  }
}
