// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "writing/Mesh_writer.h"

#include "Program_error.h"
#include "reading/text_encoding.h"

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

// Returns the corner data. The texture comes first.
std::vector<const Corner_data*> all_corner_data(const Output_mesh& mesh)
{
  std::vector<const Corner_data*> result;
  if(mesh.texture.dimension > 0)
    result.push_back(&mesh.texture);
  for(const Corner_data& data : mesh.corner_data)
    result.push_back(&data);
  return result;
}

void add_coordinates(Text& text, std::size_t dimension, const std::array<double, 3>& coordinates)
{
  for(std::size_t k = 0; k < dimension; ++k)
    text << ' ' << coordinates[k];
}

// Returns attributes of points by their names. Returns nothing unless all exist with numbers of
// this kind.
std::vector<const Attribute*> components(const Output_mesh& mesh, bool are_integers,
                                         const std::array<const char*, 3>& names)
{
  std::vector<const Attribute*> result;
  for(const char* name : names)
    for(const Attribute& a : mesh.point_data)
      if(a.are_integers() == are_integers && a.name == name)
        result.push_back(&a);
  if(result.size() != names.size())
    result.clear();
  return result;
}

// Writes one texture, and normals of corners or of points.
class Obj_writer
{
public:
  Obj_writer(Text& text, const Output_mesh& mesh)
    : m_text(text), m_mesh(mesh), m_colors(components(mesh, true, {"red", "green", "blue"}))
  {
    if(m_colors.empty())
      set_fractions();
    for(const Corner_data* data : all_corner_data(mesh)) {
      const Corner_data*& place = data->name == "normal" ? m_normals : m_texture;
      if(place == nullptr)
        place = data;
    }
    if(m_normals == nullptr)
      m_point_normals = components(mesh, false, {"nx", "ny", "nz"});
  }

  void operator()()
  {
    for(const std::string& library : m_mesh.groups.libraries)
      m_text << library;
    for(std::size_t i = 0; i < m_mesh.points.size(); ++i)
      add_point(i);
    add_all_coordinates("vt", m_texture);
    add_all_coordinates("vn", m_normals);
    if(!m_point_normals.empty())
      for(std::size_t i = 0; i < m_mesh.points.size(); ++i)
        add_line("vn",
                 {(*m_point_normals[0])[i], (*m_point_normals[1])[i], (*m_point_normals[2])[i]}, 3);
    for(std::size_t i = 0; i < m_mesh.polygons.size(); ++i)
      add_face(i);
  }

private:
  // Takes colors that are fractions.
  void set_fractions()
  {
    m_colors = components(m_mesh, false, {"red", "green", "blue"});
    m_greatest_component = 1;
    for(const Attribute* component : m_colors)
      for(std::size_t i = 0; i < component->size(); ++i)
        if(!((*component)[i] >= 0 && (*component)[i] <= 1))
          return m_colors.clear();
  }

  void add_point(std::size_t i)
  {
    m_text << "v " << m_mesh.points[i];
    for(const Attribute* component : m_colors)
      m_text << ' ' << (*component)[i] / m_greatest_component;
    m_text << '\n';
  }

  void add_line(const char* key, const std::array<double, 3>& coordinates, std::size_t dimension)
  {
    m_text << key;
    add_coordinates(m_text, dimension, coordinates);
    m_text << '\n';
  }

  void add_all_coordinates(const char* key, const Corner_data* data)
  {
    if(data != nullptr)
      for(const std::array<double, 3>& coordinates : data->coordinates)
        add_line(key, coordinates, data->dimension);
  }

  // Adds a group line. Faces without a parent remain in the last group.
  void add_group(Polygons::Index group)
  {
    if(group == m_group || group == Polygons::none)
      return;
    m_text << m_mesh.groups.lines[group];
    m_group = group;
  }

  void add_face(std::size_t i)
  {
    add_group(m_mesh.groups[static_cast<std::int64_t>(i)]);
    m_text << 'f';
    for(std::size_t k = 0; k < m_mesh.polygons[i].size(); ++k)
      add_corner(i, k);
    m_text << '\n';
  }

  void add_corner(std::size_t i, std::size_t k)
  {
    const auto number = [&](const Corner_data* data, Polygons::Index otherwise) {
      return data == nullptr ? otherwise : data->polygons[i][k];
    };
    const Polygons::Index point = m_mesh.polygons[i][k],
                          texture = number(m_texture, Polygons::none),
                          normal =
                            number(m_normals, m_point_normals.empty() ? Polygons::none : point);
    m_text << ' ' << point + 1;
    if(texture != Polygons::none || normal != Polygons::none)
      m_text << '/';
    if(texture != Polygons::none)
      m_text << texture + 1;
    if(normal != Polygons::none)
      m_text << '/' << normal + 1;
  }

  Text& m_text;
  const Output_mesh& m_mesh;
  std::vector<const Attribute*> m_colors; // none if empty
  double m_greatest_component = 255;
  const Corner_data *m_texture = nullptr, *m_normals = nullptr;
  std::vector<const Attribute*> m_point_normals; // none if empty
  Polygons::Index m_group = Polygons::none;      // of the last face
};

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
  if(mesh.points.empty()) // an empty file could be the rest of a failure
    text << "# no vertices\n";
  Obj_writer(text, mesh)();
  if(mesh.polygons.size() == 0)
    add_obj_lines(text, mesh);
}

// Returns whether an attribute is a color. Viewers recognize colors by their names and this type.
bool is_color(const Attribute& a)
{
  return a.has_integers() &&
         (a.name == "red" || a.name == "green" || a.name == "blue" || a.name == "alpha");
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
    : m_text(text), m_mesh(mesh), m_is_binary(is_binary)
  {
    for(const Corner_data* data : all_corner_data(mesh))
      m_lists.push_back({data, is_small(*data)});
  }

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
    for(const List& list : m_lists)
      m_text << "property list " << (list.is_small ? "uchar" : "uint") << " double "
             << name_of(*list.data) << '\n';
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

  // Returns whether the number of coordinates of each polygon fits into one byte, as viewers
  // expect.
  static bool is_small(const Corner_data& data)
  {
    return std::all_of(data.polygons.begin(), data.polygons.end(),
                       [&](const Polygons::Polygon& p) { return data.dimension * p.size() < 256; });
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

  struct Column
  {
    explicit Column(const Attribute& a) : values(a), is_byte(is_color(a)) {}

    const Attribute& values;
    bool is_byte;
  };

  void add_value(const Column& column, std::size_t i)
  {
    if(!column.values.are_integers())
      add(column.values[i]);
    else if(column.is_byte)
      add(static_cast<std::uint8_t>(column.values.integer(i)));
    else
      add(static_cast<std::int32_t>(column.values.integer(i)));
  }

  // Adds rows. `add_element(i)` adds an element; attributes follow.
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
    for(const List& list : m_lists)
      add_list(list, list.data->polygons[i]);
  }

  struct List
  {
    const Corner_data* data;
    bool is_small;
  };

  void add_list(const List& list, const Polygons::Polygon& polygon)
  {
    const std::size_t n = list.data->dimension * polygon.size();
    if(list.is_small)
      add(static_cast<std::uint8_t>(n));
    else
      add(static_cast<std::uint32_t>(n));
    for(const Polygons::Index c : polygon)
      for(std::size_t k = 0; k < list.data->dimension; ++k)
        add(c == Polygons::none ? 0. : list.data->coordinates[c][k]);
  }

  Text& m_text;
  const Output_mesh& m_mesh;
  bool m_is_binary;
  std::vector<List> m_lists;
  bool m_is_in_row = false;
};

// Adds an array, where `add(i)` adds the text of entry i.
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

// Returns the name as an attribute of XML, in ASCII.
std::string vtp_name(const std::string& name)
{
  std::string result;
  for(const char c : name)
    if(c == '&' || c == '<' || c == '>' || c == '"')
      result += "&#" + std::to_string(static_cast<int>(c)) + ";";
    else
      result += c > ' ' && c <= '~' ? c : '_';
  return result;
}

void add_vtp_data(Text& text, const std::vector<Attribute>& data)
{
  for(const Attribute& a : data)
    add_vtp_array(text,
                  (a.has_integers() ? "type=\"Int32\" Name=\"" : "type=\"Float64\" Name=\"") +
                    vtp_name(a.name) + "\"",
                  a.size(),
                  [&](std::size_t i) { a.are_integers() ? text << a.integer(i) : text << a[i]; });
}

// Repeats points until each has one entry of all corner data. Coordinates then have the numbers of
// the points.
class Corner_splitting
{
public:
  explicit Corner_splitting(const Output_mesh& mesh) : m_mesh(mesh)
  {
    for(const Corner_data* data : all_corner_data(mesh))
      split(*data);
    m_mesh.corner_data = std::move(m_data);
  }

  const Output_mesh& mesh() const { return m_mesh; }

private:
  void split(const Corner_data& data)
  {
    m_number.assign(m_mesh.points.size(), Polygons::none);
    m_copy.clear();
    Polygons polygons;
    for(std::size_t i = 0; i < m_mesh.polygons.size(); ++i) {
      for(std::size_t k = 0; k < m_mesh.polygons[i].size(); ++k)
        polygons.add_corner(point_with(data.polygons[i][k], m_mesh.polygons[i][k]));
      polygons.close();
    }
    m_mesh.polygons = std::move(polygons);
    m_data.push_back({name_of(data), data.dimension, coordinates_of_points(data), {}});
  }

  std::size_t point_with(Polygons::Index number, Polygons::Index point)
  {
    if(m_number[point] == Polygons::none)
      m_number[point] = number;
    if(m_number[point] == number || number == Polygons::none)
      return point;
    const auto [copy, is_new] = m_copy.emplace(std::pair(point, number), m_number.size());
    if(is_new)
      repeat(point, number);
    return copy->second;
  }

  void repeat(Polygons::Index point, Polygons::Index number)
  {
    m_number.push_back(number);
    m_mesh.points.push_back(Point(m_mesh.points[point]));
    for(Attribute& a : m_mesh.point_data)
      a.kept().push_back(double(a.kept()[point]));
    for(Corner_data& data : m_data)
      data.coordinates.push_back(std::array(data.coordinates[point]));
  }

  // Points without coordinates are at the origin.
  std::vector<std::array<double, 3>> coordinates_of_points(const Corner_data& data) const
  {
    std::vector<std::array<double, 3>> result;
    for(const Polygons::Index c : m_number)
      result.push_back(c == Polygons::none ? std::array<double, 3>{0, 0, 1} : data.coordinates[c]);
    return result;
  }

  Output_mesh m_mesh;
  std::vector<Corner_data> m_data;       // with one entry for each point
  std::vector<Polygons::Index> m_number; // of the entry of each point
  std::map<std::pair<Polygons::Index, Polygons::Index>, std::size_t> m_copy;
};

void add_vtp_coordinates(Text& text, const Corner_data& data)
{
  Text attributes;
  attributes << "type=\"Float64\" Name=\"" << vtp_name(data.name) << "\" NumberOfComponents=\""
             << data.dimension << '"';
  add_vtp_array(text, attributes.take(), data.coordinates.size(),
                [&](std::size_t i) { add_coordinates(text, data.dimension, data.coordinates[i]); });
}

// Adds the names of the first texture and of the normals.
void add_vtp_roles(Text& text, const Output_mesh& mesh)
{
  for(const Corner_data& data : mesh.corner_data)
    if(data.name == "texcoord" || data.name == "normal")
      text << (data.name == "normal" ? " Normals=\"" : " TCoords=\"") << data.name << '"';
}

void add_vtp_points(Text& text, const Output_mesh& mesh)
{
  text << "<Points>\n";
  add_vtp_array(text, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
                mesh.points.size(), [&](std::size_t i) { text << mesh.points[i]; });
  text << "</Points>\n";
}

// Adds cells, but does nothing without cells.
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

// Returns the data of lines, then the data of polygons.
std::vector<Attribute> vtp_cell_data(const Output_mesh& mesh)
{
  std::vector<Attribute> result = mesh.line_data;
  for(Attribute& a : result)
    a.kept().resize(mesh.lines.size() + mesh.polygons.size(), -1);
  for(const Attribute& a : mesh.polygon_data) {
    auto both = std::find_if(result.begin(), result.end(),
                             [&](const Attribute& b) { return b.name == a.name; });
    if(both == result.end()) {
      both = result.insert(both, a);
      both->kept().insert(both->kept().begin(), mesh.lines.size(), -1);
    }
    for(std::size_t i = 0; i < a.size(); ++i)
      both->kept()[mesh.lines.size() + i] = a[i];
  }
  return result;
}

// Writes a mesh whose corner data have one entry for each point.
void write_vtp_with_point_data(Text& text, const Output_mesh& mesh)
{
  text << "<?xml version=\"1.0\"?>\n"
       << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
       << "<Piece NumberOfPoints=\"" << mesh.points.size() << "\" NumberOfVerts=\"0\" "
       << "NumberOfLines=\"" << mesh.lines.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
       << mesh.polygons.size() << "\">\n";
  text << "<PointData";
  add_vtp_roles(text, mesh);
  text << ">\n";
  add_vtp_data(text, mesh.point_data);
  for(const Corner_data& data : mesh.corner_data)
    add_vtp_coordinates(text, data);
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
  if(all_corner_data(mesh).empty())
    write_vtp_with_point_data(text, mesh);
  else
    write_vtp_with_point_data(text, Corner_splitting(mesh).mesh());
}

constexpr std::array<std::string_view, 4> names = {"off", "obj", "ply", "vtp"};

// Returns the format, by the extension of a path, or by a name for standard output, in any case.
Mesh_format mesh_format(const std::string& path, const Output_options& options)
{
  const std::string name =
    path == "-" ? options.format : std::filesystem::path(path).extension().string();
  const std::string key = lower_case(name.substr(name.compare(0, 1, ".") == 0 ? 1 : 0));
  for(std::size_t i = 0; i < names.size(); ++i)
    if(names[i] == key)
      return static_cast<Mesh_format>(i);
  throw Program_error(path + ": no such output format: '" + name +
                      "' (there are off, obj, ply and vtp)");
}

} // namespace

Mesh_format output_format(const std::string& path, const Output_options& options, Carried what)
{
  const Mesh_format format = mesh_format(path, options);
  const auto check = [&](bool is_possible, const char* message) {
    if(!is_possible)
      throw Program_error(path + ": this format " + message);
  };
  check(!options.is_binary || format == Mesh_format::PLY, "cannot be binary (.ply can)");
  check(what != Carried::DISTANCES || (has_texture(format) && format != Mesh_format::OBJ),
        "cannot carry distances (.ply and .vtp can)");
  check(what != Carried::TEXTURE || has_texture(format),
        "cannot carry texture coordinates (.obj, .ply and .vtp can)");
  check(what != Carried::LINES || has_texture(format), "has no lines (.obj, .ply and .vtp have)");
  return options.is_binary ? Mesh_format::BINARY_PLY : format;
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
