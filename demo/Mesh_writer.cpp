// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_writer.h"

#include "Program_error.h"
#include "Text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

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

std::string obj(const Output_mesh& mesh)
{
  Text text;
  for(const Point& p : mesh.points)
    text << "v " << p << '\n';
  for(const std::vector<std::size_t>& polygon : mesh.polygons) {
    text << 'f';
    for(const std::size_t i : polygon)
      text << ' ' << i + 1;
    text << '\n';
  }
  return text.take();
}

void add_ply_properties(Text& text, const std::vector<Attribute>& data)
{
  for(const Attribute& a : data)
    text << (a.has_integers() ? "property int " : "property double ") << a.name << '\n';
}

void add_ply_header(Text& text, const Output_mesh& mesh)
{
  text << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
       << "\nproperty double x\nproperty double y\nproperty double z\n";
  add_ply_properties(text, mesh.point_data);
  text << "element face " << mesh.polygons.size() << "\nproperty list uint int vertex_indices\n";
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

void add_vtp_data(Text& text, std::string_view element, const std::vector<Attribute>& data)
{
  text << '<' << element << ">\n";
  for(const Attribute& a : data)
    add_vtp_array(text,
                  (a.has_integers() ? "type=\"Int32\" Name=\"" : "type=\"Float64\" Name=\"") +
                    a.name + "\"",
                  a.values.size(), [&](std::size_t i) { text << a.values[i]; });
  text << "</" << element << ">\n";
}

void add_vtp_points(Text& text, const Output_mesh& mesh)
{
  text << "<Points>\n";
  add_vtp_array(text, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
                mesh.points.size(), [&](std::size_t i) { text << mesh.points[i]; });
  text << "</Points>\n";
}

void add_vtp_polygons(Text& text, const Output_mesh& mesh)
{
  text << "<Polys>\n";
  add_vtp_array(text, "type=\"Int64\" Name=\"connectivity\"", mesh.polygons.size(),
                [&](std::size_t i) {
                  for(const std::size_t v : mesh.polygons[i])
                    text << v << ' ';
                });
  std::size_t offset = 0;
  add_vtp_array(text, "type=\"Int64\" Name=\"offsets\"", mesh.polygons.size(),
                [&](std::size_t i) { text << (offset += mesh.polygons[i].size()); });
  text << "</Polys>\n";
}

std::string vtp(const Output_mesh& mesh)
{
  Text text;
  text << "<?xml version=\"1.0\"?>\n"
       << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
       << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfVerts=\"0\" "
       << "NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << mesh.polygons.size()
       << "\">\n";
  add_vtp_data(text, "PointData", mesh.point_data);
  add_vtp_data(text, "CellData", mesh.polygon_data);
  add_vtp_points(text, mesh);
  add_vtp_polygons(text, mesh);
  text << "</Piece>\n</PolyData>\n</VTKFile>\n";
  return text.take();
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
  std::string key = name.substr(name.compare(0, 1, ".") == 0 ? 1 : 0);
  std::transform(key.begin(), key.end(), key.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
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

std::string text_of(const Output_mesh& mesh, Mesh_format format)
{
  return formats[static_cast<std::size_t>(format)].text_of(mesh);
}
