// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Svg_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <string_view>
#include <utility>

namespace {

typedef std::array<double, 3> Vector;

constexpr double size = 600, margin = 20; // of each picture, in pixels

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector difference(const Vector& a, const Vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector unit(const Vector& a)
{
  const double length = std::sqrt(dot(a, a));
  return length > 0 ? Vector{a[0] / length, a[1] / length, a[2] / length} : Vector{0, 0, 1};
}

// The least and the greatest coordinates of points.
std::pair<Vector, Vector> box_of(const std::vector<Vector>& points)
{
  constexpr double most = std::numeric_limits<double>::max();
  Vector low{most, most, most}, high{-most, -most, -most};
  for(const Vector& p : points)
    for(std::size_t k = 0; k < 3; ++k) {
      low[k] = (std::min)(low[k], p[k]);
      high[k] = (std::max)(high[k], p[k]);
    }
  return {low, high};
}

// Coordinates to the right, upwards and to the viewer, who sees the broadest side, a little from above;
// what is flat is seen from above.
std::vector<Vector> seen(const std::vector<Vector>& points)
{
  const auto [low, high] = box_of(points);
  const Vector extent = difference(high, low);
  std::size_t axis = extent[0] < extent[1] ? 0 : 1;
  if(extent[2] <= extent[axis])
    axis = 2;
  const std::size_t up_axis = axis == 1 || (axis == 0 && extent[2] > extent[1]) ? 2 : 1;
  const double oblique = extent[axis] > 0 ? 1 : 0;
  Vector way{}, up{};
  way[axis] = axis == 1 ? -1 : 1;
  up[up_axis] = 1;
  way[up_axis] += .22 * oblique;
  way[3 - axis - up_axis] += .32 * oblique;
  way = unit(way);
  const Vector right = unit(cross(up, way)), top = cross(way, right);
  std::vector<Vector> result;
  for(const Vector& p : points)
    result.push_back({dot(p, right), dot(p, top), dot(p, way)});
  return result;
}

// Scaled into the picture, where y leads downwards.
void fit(std::vector<Vector>& points, const std::pair<Vector, Vector>& box)
{
  const auto& [low, high] = box;
  const double extent = (std::max)({high[0] - low[0], high[1] - low[1], 1e-300});
  const double scale = (size - 2 * margin) / extent;
  for(Vector& p : points)
    p = {size / 2 + scale * (p[0] - low[0] / 2 - high[0] / 2),
         size / 2 - scale * (p[1] - low[1] / 2 - high[1] / 2), scale * p[2]};
}

std::string color_text(const Vector& rgb)
{
  std::array<char, 8> text;
  const auto channel = [&](std::size_t k) {
    return static_cast<unsigned>(std::lround((std::min)((std::max)(rgb[k], 0.), 255.)));
  };
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", channel(0), channel(1), channel(2));
  return text.data();
}

// The kinds of lines, the last over the others.
struct Layer
{
  const char* attribute;
  const char* style;
};
constexpr std::array<Layer, 7> layers = {{{"input_edge", "i"},
                                          {"intrinsic_edge", "t"},
                                          {"flat_edge", "f"},
                                          {"sphere_edge", "f"},
                                          {"coarse_edge", "c"},
                                          {"path_edge", "p"},
                                          {"is_seam", "s"}}};
constexpr const char* style =
  "<style>path{stroke-width:.4;stroke-linejoin:round}line{stroke-linecap:round}"
  ".i{stroke:#8795a3;stroke-width:.5}.t{stroke:#c8501e;stroke-width:1}.f{stroke:#1f6fb2;stroke-"
  "width:.8}.c{stroke:#14202c;stroke-width:1.2}.p{stroke:#147a5a;stroke-width:2}.s{stroke:#7a2fa0;"
  "stroke-width:1.8}.e{stroke:#8795a3;stroke-width:.6}polyline{fill:none;stroke:#9aa7b3;stroke-"
  "width:.6}</style>\n";

// One surface, in its place or in its image.
class Surface_drawing
{
public:
  Surface_drawing(Text& text, const Shown_surface& surface, bool is_image)
    : m_text(text),
      m_surface(surface),
      m_polygons(is_image && surface.mesh.texture.dimension > 0 ? surface.mesh.texture.polygons
                                                                : surface.mesh.polygons),
      m_is_flat(is_image && surface.kind != Image_kind::sphere)
  {
    set_positions(is_image);
    set_edges();
    for(const Surface_marks& marks : surface.marks)
      if(marks.is_failure)
        m_failures.insert(m_failures.end(), marks.polygons.begin(), marks.polygons.end());
    std::sort(m_failures.begin(), m_failures.end());
  }

  void draw()
  {
    for(const auto& line : m_outlines)
      add_outline(line);
    std::vector<std::size_t> order(m_polygons.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<double> depth;
    for(const std::size_t i : order)
      depth.push_back(mean_depth(i));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return depth[i] < depth[j]; });
    for(const std::size_t i : order)
      if(m_polygons[i].size() > 2)
        add_polygon(i);
  }

private:
  void set_positions(bool is_image)
  {
    if(is_image)
      m_positions = m_surface.image;
    else
      for(const Point& p : m_surface.mesh.points)
        m_positions.push_back({p.x(), p.y(), p.z()});
    if(!m_is_flat)
      m_positions = seen(m_positions);
    const auto box = m_surface.kind == Image_kind::disk && is_image
                       ? std::pair(Vector{-1, -1, 0}, Vector{1, 1, 0})
                       : box_of(m_positions);
    fit(m_positions, box);
    if(is_image)
      for(const auto& line : m_surface.outlines) {
        m_outlines.emplace_back();
        for(const std::array<double, 2>& p : line)
          m_outlines.back().push_back({p[0], p[1], 0});
        fit(m_outlines.back(), box);
      }
  }

  // The style of the edge between two points; the last layer counts.
  void set_edges()
  {
    const Output_mesh& mesh = m_surface.mesh;
    if(find_attribute(mesh.point_data, "distance") != nullptr)
      return; // they would hide the colors
    for(std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto [v, w] = mesh.edges[e];
      const char* name = mesh.edge_data.empty() ? "e" : nullptr;
      for(const Layer& layer : layers)
        if(const Attribute* a = find_attribute(mesh.edge_data, layer.attribute)) {
          const std::int64_t value = std::get<0>(a->values)[e];
          if(std::string_view(layer.attribute) == "is_seam" ? value == 1 : value >= 0)
            name = layer.style;
        }
      if(name != nullptr)
        m_edge_style[{(std::min)(v, w), (std::max)(v, w)}] = name;
    }
  }

  double mean_depth(std::size_t i) const
  {
    double sum = 0;
    for(const Polygons::Index c : m_polygons[i])
      sum += m_positions[c][2];
    return sum / double((std::max)(m_polygons[i].size(), std::size_t(1)));
  }

  // The normal, as the sum of cross products.
  Vector normal(std::size_t i) const
  {
    const Polygons::Polygon p = m_polygons[i];
    Vector sum{};
    for(std::size_t k = 2; k < p.size(); ++k) {
      const Vector n = cross(difference(m_positions[p[k - 1]], m_positions[p[0]]),
                             difference(m_positions[p[k]], m_positions[p[0]]));
      sum = {sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]};
    }
    return unit(sum);
  }

  Vector color(std::size_t i) const
  {
    if(std::binary_search(m_failures.begin(), m_failures.end(), std::int64_t(i)))
      return {216, 30, 30};
    const std::vector<Attribute>& data = m_surface.mesh.polygon_data;
    Vector result{238, 236, 228};
    if(find_attribute(data, "red") != nullptr)
      for(std::size_t k = 0; k < 3; ++k) {
        const Attribute* channel = find_attribute(data, std::array{"red", "green", "blue"}[k]);
        result[k] = double(std::get<0>(channel->values)[i]);
      }
    else if(const Attribute* a = find_attribute(m_surface.mesh.point_data, "distance"))
      result = color_of_value(std::get<1>(a->values), i);
    const double lit = m_is_flat ? 1 : .45 + .55 * std::abs(normal(i)[2]);
    return {lit * result[0], lit * result[1], lit * result[2]};
  }

  // From dark to light, in twenty steps.
  Vector color_of_value(const std::vector<double>& values, std::size_t i) const
  {
    const Polygons::Polygon p = m_surface.mesh.polygons[i];
    double sum = 0;
    for(const Polygons::Index v : p)
      sum += values[v];
    const double most = (std::max)(*std::max_element(values.begin(), values.end()), 1e-300);
    const double t = std::floor(20 * sum / double(p.size()) / most) / 20;
    return {40 + 210 * t, 55 + 185 * t, 110 + 70 * t};
  }

  void add_polygon(std::size_t i)
  {
    const std::string fill = color_text(color(i));
    const Polygons::Polygon p = m_polygons[i];
    m_text << "<path fill=\"" << fill << "\" stroke=\"" << fill << "\" d=\"M";
    for(const Polygons::Index c : p)
      add_position(m_positions[c], ' ');
    m_text << "z\"/>\n";
    const Polygons::Polygon points = m_surface.mesh.polygons[i];
    for(std::size_t k = 0; k < p.size(); ++k) {
      const std::size_t l = (k + 1) % p.size();
      const auto found =
        m_edge_style.find({(std::min)(points[k], points[l]), (std::max)(points[k], points[l])});
      if(found != m_edge_style.end())
        add_line(found->second, m_positions[p[k]], m_positions[p[l]]);
    }
  }

  void add_line(const char* name, const Vector& from, const Vector& to)
  {
    m_text << "<line class=\"" << name << "\" x1=\"" << rounded(from[0]) << "\" y1=\""
           << rounded(from[1]) << "\" x2=\"" << rounded(to[0]) << "\" y2=\"" << rounded(to[1])
           << "\"/>\n";
  }

  void add_outline(const std::vector<Vector>& line)
  {
    m_text << "<polyline points=\"";
    for(const Vector& p : line)
      add_position(p, ' ');
    m_text << "\"/>\n";
  }

  void add_position(const Vector& p, char separator)
  {
    m_text << rounded(p[0]) << ',' << rounded(p[1]) << separator;
  }

  static double rounded(double x) { return std::round(100 * x) / 100; }

  Text& m_text;
  const Shown_surface& m_surface;
  const Polygons& m_polygons;
  bool m_is_flat;
  std::vector<Vector> m_positions;
  std::vector<std::vector<Vector>> m_outlines;
  std::map<std::pair<Polygons::Index, Polygons::Index>, const char*> m_edge_style;
  std::vector<std::int64_t> m_failures; // polygons
};

} // namespace

void write_svg(Text& text, const std::vector<Shown_surface>& surfaces)
{
  std::size_t count = 0;
  for(const Shown_surface& surface : surfaces)
    count += surface.kind == Image_kind::none ? 1 : 2;
  text << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << size * double(count)
       << "\" height=\"" << size << "\">\n"
       << style;
  std::size_t place = 0;
  const auto draw = [&](const Shown_surface& surface, bool is_image) {
    text << "<g transform=\"translate(" << size * double(place++) << ")\">\n";
    Surface_drawing(text, surface, is_image).draw();
    text << "</g>\n";
  };
  for(const Shown_surface& surface : surfaces) {
    draw(surface, false);
    if(surface.kind != Image_kind::none)
      draw(surface, true);
  }
  text << "</svg>\n";
}
