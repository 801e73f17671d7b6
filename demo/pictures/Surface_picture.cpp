// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Surface_picture.h"

#include "Program_error.h"
#include "pictures/Canvas.h"
#include "pictures/Occlusion.h"
#include "reading/surface_points.h"
#include "reading/text_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace {

typedef Occlusion::Vector Vector;

constexpr double size = 600, margin = 20; // of each picture, in pixels

Vector unit(const Vector& a)
{
  const double length = std::sqrt(a.squared_length());
  return length > 0 ? a / length : Vector(0, 0, 1);
}

CGAL::Bbox_3 box_of(const std::vector<Vector>& points)
{
  CGAL::Bbox_3 result;
  for(const Vector& p : points)
    result += CGAL::Bbox_3(p.x(), p.y(), p.z(), p.x(), p.y(), p.z());
  return result;
}

// Stores the directions to the right, upwards and to the viewer.
typedef std::array<Vector, 3> Outlook;

Outlook outlook(const Vector& way, const Vector& up)
{
  const Vector right = unit(CGAL::cross_product(up, way));
  return {right, CGAL::cross_product(way, right), way};
}

// Returns the directions. The viewer sees the broadest side, slightly from above. A flat surface is
// seen from above.
Outlook outlook_on(const std::vector<Vector>& points)
{
  const CGAL::Bbox_3 box = box_of(points);
  const std::array<double, 3> extent{box.x_span(), box.y_span(), box.z_span()};
  std::size_t axis = extent[0] < extent[1] ? 0 : 1;
  if(extent[2] <= extent[axis])
    axis = 2;
  const std::size_t up_axis = axis == 1 || (axis == 0 && extent[2] > extent[1]) ? 2 : 1;
  const double oblique = extent[axis] > 0 ? 1 : 0;
  std::array<double, 3> way{}, up{};
  way[axis] = axis == 1 ? -1 : 1;
  up[up_axis] = 1;
  way[up_axis] += .22 * oblique;
  way[3 - axis - up_axis] += .32 * oblique;
  return outlook(unit({way[0], way[1], way[2]}), {up[0], up[1], up[2]});
}

Outlook outlook_along(const Vector& normal)
{
  return outlook(normal, std::abs(normal.y()) < .9 ? Vector(0, 1, 0) : Vector(0, 0, 1));
}

// Scales points into the picture, where y leads downwards.
void fit(std::vector<Vector>& points, const CGAL::Bbox_3& box)
{
  const double scale = (size - 2 * margin) / (std::max)({box.x_span(), box.y_span(), 1e-300});
  for(Vector& p : points)
    p = {size / 2 + scale * (p.x() - box.xmin() / 2 - box.xmax() / 2),
         size / 2 - scale * (p.y() - box.ymin() / 2 - box.ymax() / 2), scale * p.z()};
}

// Stores lines of a kind; the last layer is drawn over the others.
struct Layer
{
  const char* attribute;
  Line_style style;
};
constexpr Line_style plain_edge{'e', {86, 100, 115}, .7}, outline{'o', {154, 167, 179}, .6},
  marked{'p', {20, 122, 90}, 2};
constexpr std::array<Layer, 7> layers = {{{"input_edge", {'i', {86, 100, 115}, .8}},
                                          {"intrinsic_edge", {'t', {200, 80, 30}, 1.2}},
                                          {"flat_edge", {'f', {31, 111, 178}, .8}},
                                          {"sphere_edge", {'f', {31, 111, 178}, .8}},
                                          {"coarse_edge", {'c', {20, 32, 44}, 1.2}},
                                          {"path_edge", marked},
                                          {"is_seam", {'s', {122, 47, 160}, 1.8}}}};

// Returns the styles, with lines that are `scale` times as wide.
std::vector<Line_style> all_styles(double scale)
{
  std::vector<Line_style> result{plain_edge, outline};
  for(const Layer& layer : layers)
    result.push_back(layer.style);
  for(Line_style& style : result)
    style.width *= scale;
  return result;
}

// Draws one surface, or its image.
class Surface_drawing
{
public:
  Surface_drawing(Canvas& canvas, const Shown_surface& surface, bool is_image,
                  const std::optional<Picture_section>& section)
    : m_canvas(canvas),
      m_surface(surface),
      m_polygons(is_image && surface.mesh.texture.dimension > 0 ? surface.mesh.texture.polygons
                                                                : surface.mesh.polygons),
      m_is_image(is_image),
      m_is_flat(is_image && surface.kind != Image_kind::sphere),
      m_section(section)
  {
    choose_polygons();
    set_positions();
    set_edges();
    for(const Surface_marks& marks : surface.marks)
      if(marks.is_failure)
        m_failures.insert(m_failures.end(), marks.polygons.begin(), marks.polygons.end());
    std::sort(m_failures.begin(), m_failures.end());
  }

  void draw()
  {
    for(const auto& line : m_outlines)
      m_canvas.add(line, nullptr, &outline);
    std::vector<double> depth(m_polygons.size());
    for(const std::size_t i : m_order)
      depth[i] = mean_depth(i);
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t i, std::size_t j) { return depth[i] < depth[j]; });
    for(const std::size_t i : m_order)
      add_polygon(i);
    if(!m_is_image)
      add_marked_lines();
  }

private:
  // ---- Positions and styles ----

  // Chooses all polygons, or the polygons that meet the section.
  void choose_polygons()
  {
    for(std::size_t i = 0; i < m_polygons.size(); ++i)
      if(m_polygons[i].size() > 2 && (!m_section || meets_section(m_surface.mesh.polygons[i])))
        m_order.push_back(i);
  }

  // This is the distance from the center of a section to the corners of its square, in radii.
  static constexpr double reach = 1.6;

  bool meets_section(const Polygons::Polygon& p) const
  {
    const std::vector<Point>& points = m_surface.mesh.points;
    for(std::size_t k = 2; k < p.size(); ++k) {
      const std::array<Point, 3> t{points[p[0]], points[p[k - 1]], points[p[k]]};
      const auto [a, b, c] = nearest_in_triangle(m_section->center, t);
      const Point nearest = CGAL::barycenter(t[0], a, t[1], b, t[2], c);
      if(CGAL::squared_distance(m_section->center, nearest) <=
         std::pow(reach * m_section->radius, 2))
        return true;
    }
    return false;
  }

  void set_positions()
  {
    if(m_is_image)
      for(const auto& [x, y, z] : m_surface.image)
        m_positions.emplace_back(x, y, z);
    else {
      for(const Point& p : m_surface.mesh.points)
        m_positions.push_back(p - CGAL::ORIGIN);
      if(m_section) // after them
        m_positions.push_back(m_section->center - CGAL::ORIGIN);
    }
    if(!m_is_flat) {
      const auto [right, top, way] =
        m_section ? outlook_along(mean_normal()) : outlook_on(m_positions);
      for(Vector& p : m_positions)
        p = {p * right, p * top, p * way};
    }
    const auto box = box_of_picture();
    fit(m_positions, box);
    for(std::vector<Vector> line : outlines()) {
      fit(line, box);
      m_outlines.push_back(on_canvas(line));
    }
  }

  // Returns the outlines beside the image.
  std::vector<std::vector<Vector>> outlines() const
  {
    std::vector<std::vector<Vector>> result;
    for(std::size_t i = 0; i < m_surface.outlines.size() && m_is_image; ++i) {
      result.emplace_back();
      for(const std::array<double, 2>& p : m_surface.outlines[i])
        result.back().emplace_back(p[0], p[1], 0);
    }
    return result;
  }

  CGAL::Bbox_3 box_of_picture() const
  {
    std::vector<Vector> points;
    if(m_section && !m_is_image)
      for(const double r : {m_section->radius, -m_section->radius})
        points.push_back(m_positions.back() + Vector(r, r, 0));
    else if(m_section)
      for(const std::size_t i : m_order)
        for(const Polygons::Index c : m_polygons[i])
          points.push_back(m_positions[c]);
    else if(m_is_image && m_surface.kind == Image_kind::disk)
      for(const std::vector<Vector>& line : outlines())
        points.insert(points.end(), line.begin(), line.end());
    return box_of(points.empty() ? m_positions : points);
  }

  Vector mean_normal() const
  {
    Vector sum = CGAL::NULL_VECTOR;
    for(const std::size_t i : m_order)
      sum += normal(i);
    return unit(sum);
  }

  // Sets the style of the edge between two points. The last layer counts.
  void set_edges()
  {
    const Output_mesh& mesh = m_surface.mesh;
    if(find_attribute(mesh.point_data, "distance") != nullptr)
      return; // they would hide the colors
    for(std::size_t e = 0; e < mesh.edges.size(); ++e) {
      const auto [v, w] = mesh.edges[e];
      const Line_style* style = mesh.edge_data.empty() ? &plain_edge : nullptr;
      for(const Layer& layer : layers)
        if(const Attribute* a = find_attribute(mesh.edge_data, layer.attribute)) {
          const std::int64_t value = a->integer(e);
          if(std::string_view(layer.attribute) == "is_seam" ? value == 1 : value >= 0)
            style = &layer.style;
        }
      if(style != nullptr)
        m_edge_style[{(std::min)(v, w), (std::max)(v, w)}] = style;
    }
  }

  double mean_depth(std::size_t i) const
  {
    double sum = 0;
    for(const Polygons::Index c : m_polygons[i])
      sum += m_positions[c].z();
    return sum / double((std::max)(m_polygons[i].size(), std::size_t(1)));
  }

  // Returns the normal, as the sum of cross products.
  Vector normal(std::size_t i) const
  {
    const Polygons::Polygon p = m_polygons[i];
    Vector sum = CGAL::NULL_VECTOR;
    for(std::size_t k = 2; k < p.size(); ++k)
      sum += CGAL::cross_product(m_positions[p[k - 1]] - m_positions[p[0]],
                                 m_positions[p[k]] - m_positions[p[0]]);
    return unit(sum);
  }

  std::array<double, 3> color(std::size_t i) const
  {
    if(std::binary_search(m_failures.begin(), m_failures.end(), std::int64_t(i)))
      return {216, 30, 30};
    const std::vector<Attribute>& data = m_surface.mesh.polygon_data;
    std::array<double, 3> result{238, 236, 228};
    if(find_attribute(data, "red") != nullptr)
      for(std::size_t k = 0; k < 3; ++k) {
        const Attribute* channel = find_attribute(data, std::array{"red", "green", "blue"}[k]);
        result[k] = (*channel)[i];
      }
    else if(const Attribute* a = find_attribute(m_surface.mesh.point_data, "distance"))
      result = color_of_value(a->kept(), i);
    const double lit = m_is_flat ? 1 : .45 + .55 * std::abs(normal(i).z());
    return {lit * result[0], lit * result[1], lit * result[2]};
  }

  // Returns a color from dark to light, in twenty steps.
  std::array<double, 3> color_of_value(const std::vector<double>& values, std::size_t i) const
  {
    const Polygons::Polygon p = m_surface.mesh.polygons[i];
    double sum = 0;
    for(const Polygons::Index v : p)
      sum += values[v];
    const double most = (std::max)(*std::max_element(values.begin(), values.end()), 1e-300);
    const double share = std::fmin(std::fmax(sum / double(p.size()) / most, 0), 1);
    const double t = std::floor(20 * share) / 20;
    return {40 + 210 * t, 55 + 185 * t, 110 + 70 * t};
  }

  // ---- Shapes ----

  // Adds a polygon. Its border is part of its shape if all sides have one style.
  void add_polygon(std::size_t i)
  {
    const Polygons::Polygon p = m_polygons[i], points = m_surface.mesh.polygons[i];
    std::vector<const Line_style*> sides;
    for(std::size_t k = 0; k < p.size(); ++k)
      sides.push_back(style(points[k], points[(k + 1) % p.size()]));
    const std::vector<Canvas_point> polygon = on_canvas(corners_of(i));
    const bool is_one =
      std::all_of(sides.begin(), sides.end(), [&](auto s) { return s == sides[0]; });
    const Rgb color = fill(i);
    m_canvas.add(polygon, &color, is_one ? sides[0] : nullptr);
    for(std::size_t k = 0; k < p.size() && !is_one; ++k)
      if(sides[k] != nullptr)
        m_canvas.add({polygon[k], polygon[(k + 1) % p.size()]}, nullptr, sides[k]);
  }

  // Represents part of a marked line that is at most a pixel long.
  typedef std::array<Vector, 2> Segment;

  std::vector<Segment> parts_of_marked_lines() const
  {
    std::vector<Segment> result;
    for(const Surface_marks& marks : m_surface.marks)
      for(const Polygons::Polygon& line : marks.lines)
        for(std::size_t k = 1; k < line.size() && !marks.is_failure; ++k)
          add_parts(m_positions[line[k - 1]], m_positions[line[k]], result);
    return result;
  }

  // Returns the interval, within 0 to 1, in which the line from `a` along `d` is within reach of
  // the section. Polygons that could hide the rest are not drawn. The interval is NaN if it is
  // empty.
  std::array<double, 2> part_within_reach(const Vector& a, const Vector& d) const
  {
    if(!m_section)
      return {0, 1};
    const Vector p = a - m_positions.back();
    const double square = d.squared_length(), middle = square > 0 ? -(p * d) / square : 0;
    const Vector nearest = p + middle * d;
    const double half =
      std::sqrt((std::pow(reach * (size / 2 - margin), 2) - nearest.squared_length()) / square);
    return {(std::max)(middle - half, 0.), (std::min)(middle + half, 1.)};
  }

  void add_parts(const Vector& a, const Vector& b, std::vector<Segment>& parts) const
  {
    const Vector d = b - a;
    const auto [begin, end] = part_within_reach(a, d);
    const double n = (std::max)(std::ceil((end - begin) * std::hypot(d.x(), d.y())), 1.);
    if(!(begin < end) || !std::isfinite(n * d.z()))
      return;
    const auto point = [&](double t) { return a + t * d; };
    for(double i = 0; i < n; ++i)
      parts.push_back(
        {point(begin + (end - begin) * i / n), point(begin + (end - begin) * (i + 1) / n)});
  }

  // Adds marked lines, unless polygons hide them.
  void add_marked_lines()
  {
    const std::vector<Segment> parts = parts_of_marked_lines();
    std::vector<Vector> middles;
    for(const auto& [a, b] : parts)
      middles.push_back((a + b) / 2);
    Occlusion occlusion(std::move(middles));
    if(!parts.empty())
      for(const std::size_t i : m_order)
        occlusion.add_polygon(corners_of(i), normal(i));
    std::vector<Vector> line;
    for(std::size_t i = 0; i < parts.size(); ++i) {
      if(occlusion.is_hidden(i))
        continue;
      if(line.empty() || line.back() != parts[i][0]) {
        add_line(line);
        line = {parts[i][0]};
      }
      line.push_back(parts[i][1]);
    }
    add_line(line);
  }

  void add_line(const std::vector<Vector>& line)
  {
    if(!line.empty())
      m_canvas.add(on_canvas(line), nullptr, &marked);
  }

  std::vector<Vector> corners_of(std::size_t i) const
  {
    std::vector<Vector> result;
    for(const Polygons::Index c : m_polygons[i])
      result.push_back(m_positions[c]);
    return result;
  }

  const Line_style* style(Polygons::Index v, Polygons::Index w) const
  {
    const auto found = m_edge_style.find({(std::min)(v, w), (std::max)(v, w)});
    return found == m_edge_style.end() ? nullptr : found->second;
  }

  Rgb fill(std::size_t i) const
  {
    const std::array<double, 3> rgb = color(i);
    const auto channel = [&](std::size_t k) {
      return static_cast<unsigned char>(std::lround((std::min)((std::max)(rgb[k], 0.), 255.)));
    };
    return {channel(0), channel(1), channel(2)};
  }

  static std::vector<Canvas_point> on_canvas(const std::vector<Vector>& points)
  {
    std::vector<Canvas_point> result;
    for(const Vector& p : points)
      result.push_back({p[0], p[1]});
    return result;
  }

  Canvas& m_canvas;
  const Shown_surface& m_surface;
  const Polygons& m_polygons;
  bool m_is_image, m_is_flat;
  const std::optional<Picture_section>& m_section;
  std::vector<std::size_t> m_order; // of the polygons that are drawn
  std::vector<Vector> m_positions;
  std::vector<std::vector<Canvas_point>> m_outlines;
  std::map<std::pair<Polygons::Index, Polygons::Index>, const Line_style*> m_edge_style;
  std::vector<std::int64_t> m_failures; // polygons
};

} // namespace

void write_picture(Text& text, const std::vector<Shown_surface>& surfaces, const std::string& path,
                   const std::optional<Picture_section>& section)
{
  std::size_t count = 0;
  for(const Shown_surface& surface : surfaces)
    count += surface.kind == Image_kind::none ? 1 : 2;
  const double width = size * double(count);
  const double line_scale = section ? 2 : 1; // A section shows few edges.
  const std::unique_ptr<Canvas> canvas =
    ::canvas(text, path, width, size, all_styles(line_scale), line_scale);
  double left = 0;
  for(const Shown_surface& surface : surfaces)
    for(const bool is_image : {false, true})
      if(!is_image || surface.kind != Image_kind::none) {
        canvas->begin_square(left, size, section.has_value());
        Surface_drawing(*canvas, surface, is_image, section).draw();
        left += size;
      }
  canvas->finish();
}
