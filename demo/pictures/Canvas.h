// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_CANVAS_H
#define INTRINSIC_CANVAS_H

#include "writing/Text.h"

#include <array>
#include <memory>
#include <vector>

typedef std::array<double, 2> Canvas_point; // in pixels, downwards
typedef std::array<unsigned char, 3> Rgb;

struct Line_style
{
  char name; // of its class in SVG
  Rgb color;
  double width;
};

// What a picture is drawn on. Later shapes cover earlier ones.
class Canvas
{
public:
  virtual ~Canvas() = default;

  // What follows is drawn that far to the right.
  virtual void move_to(double left) = 0;

  // What follows is drawn in a square only, whose upper left corner is where it was moved to.
  virtual void clip(double side) = 0;

  // A polygon, with a border in its own color if there is no other, so that neighbors leave no gap.
  virtual void add_polygon(const std::vector<Canvas_point>& points, const Rgb& fill,
                           const Line_style* border) = 0;

  virtual void add_line(const std::vector<Canvas_point>& points, const Line_style& style) = 0;

  // Writes the picture; nothing can be added then.
  virtual void finish() = 0;
};

// An SVG picture in which lines have one of the styles.
std::unique_ptr<Canvas> svg_canvas(Text& text, double width, double height,
                                   const std::vector<Line_style>& styles);

// A PNG picture, or null if the program was built without Cairo.
std::unique_ptr<Canvas> png_canvas(Text& text, double width, double height);

#endif // INTRINSIC_CANVAS_H
