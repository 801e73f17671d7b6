// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/Canvas.h"

#ifdef INTRINSIC_USE_CAIRO

#include <cairo.h>

#include <cmath>
#include <stdexcept>

namespace {

// Draws with Cairo on a white background.
class Png_canvas : public Canvas
{
public:
  Png_canvas(Text& text, double width, double height, double line_scale)
    : m_text(text),
      m_line_scale(line_scale),
      m_surface(
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, int(scale * width), int(scale * height))),
      m_cairo(cairo_create(m_surface))
  {
    cairo_set_source_rgb(m_cairo, 1, 1, 1);
    cairo_paint(m_cairo);
    cairo_set_line_join(m_cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(m_cairo, CAIRO_LINE_CAP_ROUND);
  }

  ~Png_canvas() override
  {
    cairo_destroy(m_cairo);
    cairo_surface_destroy(m_surface);
  }

  Png_canvas(const Png_canvas&) = delete;
  Png_canvas& operator=(const Png_canvas&) = delete;

  void begin_square(double left, double side, bool is_clipped) override
  {
    cairo_reset_clip(m_cairo);
    cairo_identity_matrix(m_cairo);
    cairo_scale(m_cairo, scale, scale);
    cairo_translate(m_cairo, left, 0);
    cairo_rectangle(m_cairo, 0, 0, side, side);
    is_clipped ? cairo_clip(m_cairo) : cairo_new_path(m_cairo);
  }

  void add(const std::vector<Canvas_point>& points, const Rgb* fill,
           const Line_style* line) override
  {
    for(const Canvas_point& p : points)
      cairo_line_to(m_cairo, p[0], p[1]);
    if(fill != nullptr) {
      cairo_close_path(m_cairo);
      set_color(*fill);
      cairo_fill_preserve(m_cairo);
    }
    set_color(line != nullptr ? line->color : *fill);
    cairo_set_line_width(m_cairo, line != nullptr ? m_line_scale * line->width : .4);
    cairo_stroke(m_cairo);
  }

  void add_circle(const Canvas_point& center, double radius, const Line_style& line) override
  {
    cairo_arc(m_cairo, center[0], center[1], radius, 0, 2 * std::acos(-1.));
    set_color(line.color);
    cairo_set_line_width(m_cairo, m_line_scale * line.width);
    cairo_stroke(m_cairo);
  }

  void finish() override
  {
    const auto write = [](void* text, const unsigned char* bytes, unsigned size) {
      *static_cast<Text*>(text) << std::string_view(reinterpret_cast<const char*>(bytes), size);
      return CAIRO_STATUS_SUCCESS;
    };
    const cairo_status_t status = cairo_surface_write_to_png_stream(m_surface, write, &m_text);
    if(status != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error(std::string("the PNG picture cannot be drawn: ") +
                               cairo_status_to_string(status));
  }

private:
  void set_color(const Rgb& color)
  {
    cairo_set_source_rgb(m_cairo, color[0] / 255., color[1] / 255., color[2] / 255.);
  }

  static constexpr double scale = 2; // for screens with many pixels

  Text& m_text;
  double m_line_scale;
  cairo_surface_t* m_surface;
  cairo_t* m_cairo;
};

} // namespace

std::unique_ptr<Canvas> png_canvas(Text& text, double width, double height, double line_scale)
{
  return std::make_unique<Png_canvas>(text, width, height, line_scale);
}

#else

std::unique_ptr<Canvas> png_canvas(Text&, double, double, double) { return nullptr; }

#endif
