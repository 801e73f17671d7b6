// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "page/View_page.h"

#include "Program_error.h"
#include "page/Page_arrays.h"
#include "reading/text_encoding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace {

const Embedded_file& embedded_file(std::string_view name)
{
  return *std::find_if(embedded_files.begin(), embedded_files.end(),
                       [&](const Embedded_file& f) { return f.name == name; });
}

std::string text_of(const Embedded_file& file)
{
  std::string result;
  for(const std::string_view piece : file.pieces)
    result += piece;
  return result;
}

bool is_module(const Embedded_file& file)
{
  const std::size_t dot = file.name.rfind('.');
  return dot != std::string_view::npos && file.name.substr(dot) == ".js" && file.name != "start.js";
}

void add_modules(Text& text)
{
  for(const Embedded_file& file : embedded_files)
    if(is_module(file)) {
      text << "<script type=\"text/plain\" data-module=\"" << file.name << "\">\n";
      for(const std::string_view piece : file.pieces)
        text << piece;
      text << "</script>\n";
    }
}

// Returns JSON without the end tag of a script.
std::string json_in_script(const Statistics& json)
{
  std::string result;
  for(const char c : json.dump(-1, ' ', true, Statistics::error_handler_t::replace))
    if(c == '<')
      result += "\\u003c";
    else
      result += c;
  return result;
}

double coordinate(const Point& p, std::size_t k) { return p[static_cast<int>(k)]; }
template <std::size_t n>
double coordinate(const std::array<double, n>& p, std::size_t k)
{
  return p[k];
}

// Stores the center and half the greatest side of a box.
struct Frame
{
  template <class Points>
  Frame(const Points& points, std::size_t dimension) : center{}, radius(0)
  {
    for(std::size_t k = 0; k < dimension; ++k) {
      double low = std::numeric_limits<double>::max(), high = -low;
      for(const auto& p : points)
        if(const double x = coordinate(p, k); std::isfinite(x)) {
          low = (std::min)(low, x);
          high = (std::max)(high, x);
        }
      if(low <= high) {
        center[k] = low / 2 + high / 2;
        radius = (std::max)(radius, high / 2 - low / 2);
      }
    }
    if(radius == 0)
      radius = 1;
  }

  double operator()(double x, std::size_t k) const { return (x - center[k]) / radius; }

  std::array<double, 3> center;
  double radius;
};

// Returns homogeneous coordinates as positions.
std::vector<std::array<double, 3>> in_plane(const Corner_data& texture)
{
  std::vector<std::array<double, 3>> result;
  for(const std::array<double, 3>& z : texture.coordinates)
    result.push_back({z[0] / z[2], z[1] / z[2], 0});
  return result;
}

bool begins_with(const std::string& name, std::string_view begin)
{
  return name.compare(0, begin.size(), begin) == 0;
}

bool is_mark(const Attribute& a) { return begins_with(a.name, "is_"); }

// Returns whether an attribute is shown. Some attributes of points are only used to write files, or
// to compute others.
bool is_shown(const Attribute& a)
{
  for(const std::string_view name :
      {"input_coordinate", "intrinsic_coordinate", "input_x", "input_y", "input_z"})
    if(a.name == name)
      return false;
  return a.has_integers() ? is_mark(a) : !begins_with(a.name, "homogeneous_");
}

// Counts the numbers that are not negative, and the different ones among them.
std::array<std::size_t, 2> count_owners(const std::vector<std::int64_t>& owners)
{
  std::array<std::size_t, 2> result{};
  std::vector<bool> is_known;
  for(const std::int64_t owner : owners)
    if(const auto i = static_cast<std::size_t>(owner); owner >= 0) {
      is_known.resize((std::max)(is_known.size(), i + 1));
      result[1] += is_known[i] ? 0 : 1;
      is_known[i] = true;
      ++result[0];
    }
  return result;
}

// Moves marked polygons of a common subdivision to intrinsic faces, and marked points to points of
// the input.
void move_to_developed(Surface_marks& marks, const Output_mesh& mesh, Developed_faces& developed)
{
  const Attribute& owners = *find_attribute(mesh.polygon_data, "intrinsic_face");
  for(std::int64_t& polygon : marks.polygons)
    polygon = owners.integer(static_cast<std::size_t>(polygon));
  std::vector<Point>& points = developed.input.points;
  const auto added = [&](std::size_t i) {
    points.push_back(mesh.points[i]);
    return points.size() - 1;
  };
  for(std::int64_t& point : marks.points)
    point = static_cast<std::int64_t>(added(static_cast<std::size_t>(point)));
  Polygons lines;
  for(const Polygons::Polygon& line : marks.lines) {
    for(const std::size_t point : line)
      lines.add_corner(added(point));
    lines.close();
  }
  marks.lines = std::move(lines);
  for(Attribute& a : developed.input.point_data)
    resize(a, points.size());
}

// Encodes surfaces in JSON, with their numbers in arrays.
class Surface_coder
{
public:
  explicit Surface_coder(Page_arrays& arrays) : m_arrays(arrays) {}

  Statistics operator()(const Shown_surface& surface)
  {
    const Output_mesh& mesh = surface.developed ? surface.developed->input : surface.mesh;
    const Corner_data texture = texture_of(mesh, surface.kind);
    Statistics result{{"name", surface.name}};
    add_points(mesh.points, surface.developed.has_value(), result);
    result["edges"] = edges(mesh);
    result["edge_data"] = attributes(mesh.edge_data);
    result["point_data"] = attributes(mesh.point_data, is_shown);
    result["polygon_data"] = attributes(mesh.polygon_data);
    result["polygons"] = polygons(texture.dimension == 0 ? mesh.polygons : texture.polygons);
    if(texture.dimension > 0)
      add_texture(mesh.polygons, texture, result);
    if(surface.kind != Image_kind::none)
      result["picture"] = image(surface);
    result["marks"] = Statistics::array();
    for(const Surface_marks& marks : surface.marks)
      result["marks"].push_back(coded(marks));
    if(surface.developed)
      result["developed"] = coded(*surface.developed);
    return result;
  }

private:
  void add_points(const std::vector<Point>& points, bool are_exact, Statistics& result)
  {
    const Frame frame(points, 3);
    std::vector<double> coordinates;
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k)
        coordinates.push_back(frame(coordinate(p, k), k));
    result["center"] = frame.center;
    result["radius"] = frame.radius;
    result["points"] =
      are_exact ? m_arrays.add_singles(coordinates) : m_arrays.add_reals(coordinates, 3);
  }

  // Encodes the edges. Without data, they are the sides of polygons.
  Statistics edges(const Output_mesh& mesh)
  {
    if(mesh.edge_data.empty())
      return {{"size", 2 * mesh.edges.size()}};
    std::vector<std::int64_t> ends;
    for(const auto& edge : mesh.edges)
      ends.insert(ends.end(), edge.begin(), edge.end());
    return m_arrays.add_integers(ends);
  }

  Statistics polygons(const Polygons& polygons)
  {
    std::vector<std::int64_t> sizes;
    for(const Polygons::Polygon& p : polygons)
      sizes.push_back(std::int64_t(p.size()));
    const std::vector<std::int64_t> corners(polygons.corners().begin(), polygons.corners().end());
    const bool are_triangles =
      std::count(sizes.begin(), sizes.end(), 3) == std::ptrdiff_t(sizes.size());
    Statistics result{{"corners", m_arrays.add_integers(corners)}};
    result["sizes"] = are_triangles ? Statistics(3) : m_arrays.add_integers(sizes);
    return result;
  }

  Statistics attributes(
    const std::vector<Attribute>& data,
    bool (*is_wanted)(const Attribute&) = [](const Attribute&) { return true; })
  {
    Statistics result = Statistics::object();
    for(const Attribute& a : data)
      if(is_wanted(a))
        result[a.name] = a.are_integers() ? integers(a) : m_arrays.add_reals(a.kept());
    return result;
  }

  // Encodes integers with the number of elements that are marked, or are parts of other elements,
  // and the number of the latter.
  Statistics integers(const Attribute& a)
  {
    const std::vector<std::int64_t> values(a.kept().begin(), a.kept().end());
    Statistics result = m_arrays.add_integers(values);
    const std::size_t marked = std::size_t(std::count(values.begin(), values.end(), 1));
    const auto counts = is_mark(a) ? std::array{marked, marked} : count_owners(values);
    result["parts"] = counts[0];
    result["owners"] = counts[1];
    return result;
  }

  // Returns the texture of the mesh, or the texture of the input if no image has other corners.
  static Corner_data texture_of(const Output_mesh& mesh, Image_kind kind)
  {
    return mesh.texture.dimension > 0 || kind != Image_kind::none
             ? mesh.texture
             : texture_on(mesh.polygons, mesh.corner_data);
  }

  // Adds a texture. Polygons have texture coordinates as their corners, and each coordinate has a
  // point.
  void add_texture(const Polygons& polygons, const Corner_data& texture, Statistics& result)
  {
    std::vector<std::int64_t> points(texture.coordinates.size(), 0);
    for(std::size_t i = 0; i < polygons.size(); ++i)
      for(std::size_t k = 0; k < polygons[i].size(); ++k)
        points[texture.polygons[i][k]] = polygons[i][k];
    result["point_of_corner"] = m_arrays.add_integers(points);
    const Frame frame(in_plane(texture), 2);
    double greatest_weight = 0;
    for(const std::array<double, 3>& z : texture.coordinates)
      greatest_weight = (std::max)(greatest_weight, std::abs(z[2]));
    std::vector<double> homogeneous;
    for(const std::array<double, 3>& z : texture.coordinates) {
      const double w = z[2] / greatest_weight;
      homogeneous.insert(homogeneous.end(),
                         {w * frame(z[0] / z[2], 0), w * frame(z[1] / z[2], 1), w});
    }
    result["texture"] = m_arrays.add_reals(homogeneous, 3);
    result["texture_center"] = frame.center;
    result["texture_radius"] = frame.radius;
  }

  Statistics image(const Shown_surface& surface)
  {
    static constexpr const char* const names[] = {"", "plane", "disk", "sphere"};
    std::vector<double> coordinates;
    const Frame frame = frame_of_image(surface);
    for(const std::array<double, 3>& p : surface.image)
      for(std::size_t k = 0; k < 3; ++k)
        coordinates.push_back(frame(p[k], k));
    return {{"kind", names[std::size_t(surface.kind)]},
            {"center", frame.center},
            {"radius", frame.radius},
            {"positions", m_arrays.add_reals(coordinates, 3)},
            {"outlines", outlines(surface, frame)}};
  }

  // Returns the frame of the image. Disks are whole, and side by side; the sphere is unchanged.
  static Frame frame_of_image(const Shown_surface& surface)
  {
    if(surface.kind == Image_kind::plane)
      return Frame(surface.image, 3);
    std::vector<std::array<double, 2>> extent;
    for(const auto& line : surface.outlines)
      extent.insert(extent.end(), line.begin(), line.end());
    return Frame(extent, 2);
  }

  Statistics outlines(const Shown_surface& surface, const Frame& frame)
  {
    std::vector<double> coordinates;
    std::vector<std::int64_t> sizes;
    for(const auto& line : surface.outlines) {
      sizes.push_back(std::int64_t(line.size()));
      for(const std::array<double, 2>& p : line)
        coordinates.insert(coordinates.end(), {frame(p[0], 0), frame(p[1], 1)});
    }
    return {{"sizes", m_arrays.add_integers(sizes)},
            {"points", m_arrays.add_reals(coordinates, 2)}};
  }

  Statistics coded(const Surface_marks& marks)
  {
    return {{"name", marks.name},
            {"is_failure", marks.is_failure},
            {"polygons", m_arrays.add_integers(marks.polygons)},
            {"lines", polygons(marks.lines)},
            {"points", m_arrays.add_integers(marks.points)}};
  }

  Statistics coded(const Developed_faces& faces)
  {
    return {
      {"edges", {{"input", faces.number_of_edges[0]}, {"intrinsic", faces.number_of_edges[1]}}},
      {"opposites", m_arrays.add_integers(once(faces.opposites))},
      {"shapes", m_arrays.add_singles(faces.shapes)},
      {"values", values_at_sources(faces)},
      {"starts", m_arrays.add_integers(faces.starts)},
      {"first_edges", m_arrays.add_singles(faces.first_edges)}};
  }

  // Returns the greater halfedge of each edge in the order of the smaller ones, or -1 on the
  // boundary.
  static std::vector<std::int64_t> once(const std::vector<std::int64_t>& opposites)
  {
    std::vector<std::int64_t> result;
    for(std::size_t h = 0; h < opposites.size(); ++h)
      if(opposites[h] < 0 || opposites[h] > static_cast<std::int64_t>(h))
        result.push_back(opposites[h]);
    return result;
  }

  // Returns for each attribute its value at the source of each halfedge.
  Statistics values_at_sources(const Developed_faces& faces)
  {
    Statistics result = Statistics::object();
    for(const Attribute& a : faces.vertex_data) {
      std::vector<double> at_sources;
      for(const std::int64_t v : faces.sources)
        at_sources.push_back(a[static_cast<std::size_t>(v)]);
      result[a.name] = m_arrays.add_reals(at_sources);
    }
    return result;
  }

  Page_arrays& m_arrays;
};

} // namespace

void View_page::check_available(const std::string& option, const std::string& path)
{
  if(path.empty())
    return;
  const std::string extension = extension_of(path);
  if(path != "-" && extension != ".html" && extension != ".htm")
    throw Program_error(path + ": " + option + " needs a name that ends with .html or .htm");
  if(!is_available())
    throw Program_error(option + ": this program was built without three.js, which could not be "
                                 "fetched from registry.npmjs.org when it was configured");
}

void View_page::add_surface(const std::string& name, Output_mesh mesh)
{
  m_surfaces.emplace_back();
  m_surfaces.back().name = name;
  mesh.keep(); // it outlives what the values are computed from
  for(Attribute& a : mesh.point_data)
    resize(a, mesh.points.size());
  m_surfaces.back().mesh = std::move(mesh);
  if(const Corner_data& texture = m_surfaces.back().mesh.texture; texture.dimension > 0)
    set_image(Image_kind::plane, in_plane(texture));
}

void View_page::set_image(Image_kind kind, std::vector<std::array<double, 3>> positions)
{
  m_surfaces.back().kind = kind;
  m_surfaces.back().image = std::move(positions);
}

void View_page::add_marks(Surface_marks marks)
{
  Shown_surface& surface = m_surfaces.back();
  if(marks.empty())
    return;
  if(surface.developed)
    move_to_developed(marks, surface.mesh, *surface.developed);
  surface.marks.push_back(std::move(marks));
}

void View_page::add_angles(const std::string& name, const std::vector<double>& angles)
{
  constexpr std::size_t intervals = 36;
  std::vector<std::size_t> counts(intervals, 0);
  for(const double a : angles)
    if(a >= 0)
      ++counts[(std::min)(static_cast<std::size_t>(a / 5), intervals - 1)];
  m_angles.push_back({{"name", name}, {"counts", counts}});
}

void View_page::add_to_curve(const std::string& name, double value)
{
  const auto is_wanted = [&](const Statistics& curve) { return curve["name"] == name; };
  auto curve = std::find_if(m_curves.begin(), m_curves.end(), is_wanted);
  if(curve == m_curves.end()) {
    m_curves.push_back({{"name", name}, {"values", Statistics::array()}});
    curve = m_curves.end() - 1;
  }
  (*curve)["values"].push_back(value);
}

// Replaces comments that name parts of the page by these parts.
void View_page::write_html(Text& text) const
{
  Page_arrays arrays;
  Statistics json{{"statistics", m_statistics}, {"angles", m_angles}, {"curves", m_curves}};
  json["surfaces"] = Statistics::array();
  for(const Shown_surface& surface : m_surfaces)
    json["surfaces"].push_back(Surface_coder(arrays)(surface));
  const std::string page = text_of(embedded_file("page.html"));
  std::size_t begin = 0;
  for(std::size_t at; (at = page.find("<!--@", begin)) != std::string::npos;) {
    text << std::string_view(page).substr(begin, at - begin);
    begin = page.find("-->", at) + 3;
    const std::string part = page.substr(at + 5, begin - at - 8);
    if(part == "modules")
      add_modules(text);
    else if(part == "page")
      text << json_in_script(json);
    else if(part == "arrays")
      arrays.write(text);
    else
      text << text_of(embedded_file(part));
  }
  text << std::string_view(page).substr(begin);
}
