// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_CANVAS_H
#define INTRINSIC_CANVAS_H

#include "writing/Text.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

typedef std::array<double, 2> Canvas_point; // in pixels, downwards
typedef std::array<unsigned char, 3> Rgb;

struct Line_style
{
  char name; // of its class in SVG
  Rgb color;
  double width;
};

// Represents the surface of a picture, with squares side by side. Later shapes cover earlier ones.
class Canvas
{
public:
  virtual ~Canvas() = default;

  // Begins a square at `left`. Shapes that follow are drawn in it, and also beyond its sides unless
  // `is_clipped`.
  virtual void begin_square(double left, double side, bool is_clipped) = 0;

  // Adds a filled polygon. Without a line, its border has the color of the inside, so that
  // neighbors leave no gap. If `fill` is null, adds a line.
  virtual void add(const std::vector<Canvas_point>& points, const Rgb* fill,
                   const Line_style* line) = 0;

  // Adds a circle that is not filled.
  virtual void add_circle(const Canvas_point& center, double radius, const Line_style& line) = 0;

  // Writes the picture. Nothing can be added afterwards.
  virtual void finish() = 0;
};

// Returns an SVG picture in which lines have one of the styles.
std::unique_ptr<Canvas> svg_canvas(Text& text, double width, double height,
                                   const std::vector<Line_style>& styles);

// Returns a PNG picture, or null if the program was built without Cairo. Lines are `line_scale`
// times as wide as their styles.
std::unique_ptr<Canvas> png_canvas(Text& text, double width, double height, double line_scale = 1);

// Returns the picture for a path: PNG if it ends with .png, else SVG.
std::unique_ptr<Canvas> canvas(Text& text, const std::string& path, double width, double height,
                               const std::vector<Line_style>& styles, double line_scale = 1);

// Throws Program_error, with the name of the option, if the path requests PNG and the program was
// built without Cairo.
void check_picture_available(const std::string& option, const std::string& path);

#endif // INTRINSIC_CANVAS_H
