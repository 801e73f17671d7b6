// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Canvas.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

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
           << height << "\" viewBox=\"0 0 " << width << ' ' << height
           << "\">\n<style>path{fill:none;stroke-width:.4;stroke-linejoin:round;"
           << "stroke-linecap:round}";
    for(const Line_style& style : styles)
      m_text << '.' << style.name << "{stroke:" << text_of(style.color)
             << ";stroke-width:" << style.width << '}';
    m_text << "</style>\n";
  }

  void begin_square(double left, double side, bool is_clipped) override
  {
    m_text << m_end << "<g transform=\"translate(" << left << ")\">\n";
    m_end = is_clipped ? "</g>\n</g>\n" : "</g>\n";
    if(is_clipped)
      m_text << "<clipPath id=\"c\"><path d=\"M0,0h" << side << 'v' << side << 'h' << -side
             << "z\"/></clipPath>\n<g clip-path=\"url(#c)\">\n";
  }

  void add(const std::vector<Canvas_point>& points, const Rgb* fill,
           const Line_style* line) override
  {
    m_text << "<path ";
    if(line != nullptr)
      m_text << "class=\"" << line->name << '"';
    else
      m_text << "stroke=\"" << text_of(*fill) << '"';
    if(fill != nullptr)
      m_text << " style=\"fill:" << text_of(*fill) << '"';
    m_text << " d=\"";
    char separator = 'M';
    for(const Canvas_point& p : points) {
      m_text << separator << rounded(p[0]) << ',' << rounded(p[1]);
      separator = ' ';
    }
    m_text << (fill != nullptr ? "z\"/>\n" : "\"/>\n");
  }

  void add_circle(const Canvas_point& center, double radius, const Line_style& line) override
  {
    m_text << "<circle class=\"" << line.name << "\" fill=\"none\" cx=\"" << center[0] << "\" cy=\""
           << center[1] << "\" r=\"" << radius << "\"/>\n";
  }

  void finish() override { m_text << m_end << "</svg>\n"; }

private:
  static double rounded(double x) { return std::round(100 * x) / 100; }

  Text& m_text;
  std::string_view m_end; // of the square
};

} // namespace

std::unique_ptr<Canvas> svg_canvas(Text& text, double width, double height,
                                   const std::vector<Line_style>& styles)
{
  return std::make_unique<Svg_canvas>(text, width, height, styles);
}
