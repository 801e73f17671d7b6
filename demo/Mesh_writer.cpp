// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_writer.h"

#include "Program_error.h"
#include "Text.h"
#include "file_extension.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

namespace {

Text& operator<<(Text& text, const Attribute::Value& value)
{
  std::visit([&](auto x) { text << x; }, value);
  return text;
}

Text& operator<<(Text& text, const Point& p)
{
  return text << p.x() << ' ' << p.y() << ' ' << p.z();
}

void add_polygon(Text& text, const std::vector<std::size_t>& polygon)
{
  text << polygon.size();
  for(const std::size_t i : polygon)
    text << ' ' << i;
}

void add_values(Text& text, const std::vector<Attribute>& data, std::size_t i)
{
  for(const Attribute& a : data)
    text << ' ' << a.values[i];
  text << '\n';
}

std::string off(const Output_mesh& mesh)
{
  Text text;
  text << "OFF\n" << mesh.points.size() << ' ' << mesh.polygons.size() << " 0\n";
  for(const Point& p : mesh.points)
    text << p << '\n';
  for(const std::vector<std::size_t>& polygon : mesh.polygons) {
    add_polygon(text, polygon);
    text << '\n';
  }
  return text.take();
}

void add_coordinates(Text& text, const Texture& texture, std::size_t i)
{
  for(std::size_t k = 0; k < texture.dimension; ++k)
    text << ' ' << texture.coordinates[i][k];
}

void add_obj_face(Text& text, const Output_mesh& mesh, std::size_t i)
{
  text << 'f';
  for(std::size_t k = 0; k < mesh.polygons[i].size(); ++k) {
    text << ' ' << mesh.polygons[i][k] + 1;
    if(mesh.texture.dimension > 0)
      text << '/' << mesh.texture.polygons[i][k] + 1;
  }
  text << '\n';
}

std::string obj(const Output_mesh& mesh)
{
  Text text;
  for(const Point& p : mesh.points)
    text << "v " << p << '\n';
  for(std::size_t i = 0; i < mesh.texture.coordinates.size(); ++i) {
    text << "vt";
    add_coordinates(text, mesh.texture, i);
    text << '\n';
  }
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i)
    add_obj_face(text, mesh, i);
  return text.take();
}

const char* name_of(const Texture& texture)
{
  return texture.dimension == 3 ? "homogeneous_texcoord" : "texcoord";
}

void add_ply_texture(Text& text, const Texture& texture, std::size_t i)
{
  if(texture.dimension == 0)
    return;
  text << ' ' << texture.dimension * texture.polygons[i].size();
  for(const std::size_t c : texture.polygons[i])
    add_coordinates(text, texture, c);
}

// Viewers know colors by their names and this type.
const char* ply_type(const Attribute& a)
{
  if(a.name == "red" || a.name == "green" || a.name == "blue")
    return "uchar";
  return a.has_integers() ? "int" : "double";
}

void add_ply_properties(Text& text, const std::vector<Attribute>& data)
{
  for(const Attribute& a : data)
    text << "property " << ply_type(a) << ' ' << a.name << '\n';
}

void add_ply_header(Text& text, const Output_mesh& mesh)
{
  text << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
       << "\nproperty double x\nproperty double y\nproperty double z\n";
  add_ply_properties(text, mesh.point_data);
  text << "element face " << mesh.polygons.size() << "\nproperty list uint int vertex_indices\n";
  if(mesh.texture.dimension > 0)
    text << "property list uchar double " << name_of(mesh.texture) << '\n';
  add_ply_properties(text, mesh.polygon_data);
  if(!mesh.edges.empty()) {
    text << "element edge " << mesh.edges.size()
         << "\nproperty int vertex1\nproperty int vertex2\n";
    add_ply_properties(text, mesh.edge_data);
  }
  text << "end_header\n";
}

std::string ply(const Output_mesh& mesh)
{
  Text text;
  add_ply_header(text, mesh);
  for(std::size_t i = 0; i < mesh.points.size(); ++i) {
    text << mesh.points[i];
    add_values(text, mesh.point_data, i);
  }
  for(std::size_t i = 0; i < mesh.polygons.size(); ++i) {
    add_polygon(text, mesh.polygons[i]);
    add_ply_texture(text, mesh.texture, i);
    add_values(text, mesh.polygon_data, i);
  }
  for(std::size_t i = 0; i < mesh.edges.size(); ++i) {
    text << mesh.edges[i][0] << ' ' << mesh.edges[i][1];
    add_values(text, mesh.edge_data, i);
  }
  return text.take();
}

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
    add_vtp_array(text,
                  (a.has_integers() ? "type=\"Int32\" Name=\"" : "type=\"Float64\" Name=\"") +
                    a.name + "\"",
                  a.values.size(), [&](std::size_t i) { text << a.values[i]; });
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
    m_mesh.texture.polygons.clear();
    for(std::size_t i = 0; i < mesh.polygons.size(); ++i)
      for(std::size_t k = 0; k < mesh.polygons[i].size(); ++k)
        m_mesh.polygons[i][k] = point_with(mesh.texture.polygons[i][k], mesh.polygons[i][k]);
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
      a.values.push_back(Attribute::Value(a.values[point]));
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
void add_vtp_cells(Text& text, std::string_view kind,
                   const std::vector<std::vector<std::size_t>>& cells)
{
  if(cells.empty())
    return;
  text << '<' << kind << ">\n";
  add_vtp_array(text, "type=\"Int64\" Name=\"connectivity\"", cells.size(), [&](std::size_t i) {
    for(const std::size_t v : cells[i])
      text << v << ' ';
  });
  std::size_t offset = 0;
  add_vtp_array(text, "type=\"Int64\" Name=\"offsets\"", cells.size(),
                [&](std::size_t i) { text << (offset += cells[i].size()); });
  text << "</" << kind << ">\n";
}

// `n` times -1, of the type that `like` has.
std::vector<Attribute::Value> missing_values(const Attribute& like, std::size_t n)
{
  typedef Attribute::Value Value;
  return std::vector<Value>(n, like.has_integers() ? Value(std::int64_t(-1)) : Value(-1.));
}

// Those of lines, then those of polygons.
std::vector<Attribute> vtp_cell_data(const Output_mesh& mesh)
{
  std::vector<Attribute> result;
  for(const Attribute& a : mesh.line_data) {
    result.push_back(a);
    const std::vector<Attribute::Value> rest = missing_values(a, mesh.polygons.size());
    result.back().values.insert(result.back().values.end(), rest.begin(), rest.end());
  }
  for(const Attribute& a : mesh.polygon_data) {
    auto both = std::find_if(result.begin(), result.end(),
                             [&](const Attribute& b) { return b.name == a.name; });
    if(both == result.end())
      both = result.insert(both, {a.name, missing_values(a, mesh.lines.size() + a.values.size())});
    std::copy(a.values.begin(), a.values.end(),
              both->values.end() - std::ptrdiff_t(a.values.size()));
  }
  return result;
}

std::string vtp_with_point_texture(const Output_mesh& mesh)
{
  Text text;
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
  return text.take();
}

std::string vtp(const Output_mesh& mesh)
{
  if(mesh.texture.dimension == 0)
    return vtp_with_point_texture(mesh);
  return vtp_with_point_texture(Texture_splitting(mesh).mesh());
}

struct Format_description
{
  std::string_view name;
  Mesh_format format;
  std::string (*text_of)(const Output_mesh&);
};

constexpr std::array<Format_description, 4> formats = {{{"off", Mesh_format::OFF, off},
                                                        {"obj", Mesh_format::OBJ, obj},
                                                        {"ply", Mesh_format::PLY, ply},
                                                        {"vtp", Mesh_format::VTP, vtp}}};

// By its name or extension, with or without dot, in any case.
Mesh_format mesh_format(const std::string& name)
{
  const std::string key = lower_case(name.substr(name.compare(0, 1, ".") == 0 ? 1 : 0));
  for(const Format_description& f : formats)
    if(f.name == key)
      return f.format;
  throw Program_error("no such output format: '" + name + "' (there are off, obj, ply and vtp)");
}

} // namespace

Mesh_format output_format(const std::string& path, const std::string& name)
{
  return mesh_format(path == "-" ? name : std::filesystem::path(path).extension().string());
}

bool has_attributes(Mesh_format format)
{
  return format == Mesh_format::PLY || format == Mesh_format::VTP;
}

bool has_texture(Mesh_format format) { return format != Mesh_format::OFF; }

std::string text_of(const Output_mesh& mesh, Mesh_format format)
{
  return formats[static_cast<std::size_t>(format)].text_of(mesh);
}
