// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Canvas.h"

#include <cmath>
#include <cstdio>
#include <string>

namespace {

std::string text_of(const Rgb& color)
{
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned(color[0]), unsigned(color[1]),
                unsigned(color[2]));
  return text.data();
}

class Svg_canvas : public Canvas
{
public:
  Svg_canvas(Text& text, double width, double height, const std::vector<Line_style>& styles)
    : m_text(text)
  {
    m_text << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\""
           << height << "\">\n<style>path{fill:none;stroke-width:.4;stroke-linejoin:round;"
           << "stroke-linecap:round}";
    for(const Line_style& style : styles)
      m_text << '.' << style.name << "{stroke:" << text_of(style.color)
             << ";stroke-width:" << style.width << '}';
    m_text << "</style>\n";
  }

  void move_to(double left) override
  {
    close_group();
    m_text << "<g transform=\"translate(" << left << ")\">\n";
    m_is_group_open = true;
  }

  void clip(double side) override
  {
    m_text << "<clipPath id=\"c\"><path d=\"M0,0h" << side << 'v' << side << 'h' << -side
           << "z\"/></clipPath>\n<g clip-path=\"url(#c)\">\n";
    m_is_clipped = true;
  }

  void add_polygon(const std::vector<Canvas_point>& points, const Rgb& fill,
                   const Line_style* border) override
  {
    const std::string color = text_of(fill);
    m_text << "<path ";
    if(border != nullptr)
      m_text << "class=\"" << border->name << '"';
    else
      m_text << "stroke=\"" << color << '"';
    m_text << " style=\"fill:" << color << "\" d=\"";
    add_points(points);
    m_text << "z\"/>\n";
  }

  void add_line(const std::vector<Canvas_point>& points, const Line_style& style) override
  {
    m_text << "<path class=\"" << style.name << "\" d=\"";
    add_points(points);
    m_text << "\"/>\n";
  }

  void finish() override
  {
    close_group();
    m_text << "</svg>\n";
  }

private:
  void close_group()
  {
    if(m_is_group_open)
      m_text << (m_is_clipped ? "</g>\n</g>\n" : "</g>\n");
    m_is_group_open = m_is_clipped = false;
  }

  void add_points(const std::vector<Canvas_point>& points)
  {
    char separator = 'M';
    for(const Canvas_point& p : points) {
      m_text << separator << rounded(p[0]) << ',' << rounded(p[1]);
      separator = ' ';
    }
  }

  static double rounded(double x) { return std::round(100 * x) / 100; }

  Text& m_text;
  bool m_is_group_open = false, m_is_clipped = false;
};

} // namespace

std::unique_ptr<Canvas> svg_canvas(Text& text, double width, double height,
                                   const std::vector<Line_style>& styles)
{
  return std::make_unique<Svg_canvas>(text, width, height, styles);
}
