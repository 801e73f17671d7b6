// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "format_readers.h"

#include <algorithm>
#include <string_view>

namespace {

// What says nothing about faces and vertices.
constexpr std::string_view ignored_keywords[] = {
  "vt",       "vn",         "vp",        "o",      "g",        "s",      "l",        "p",
  "usemtl",   "mtllib",     "usemap",    "bevel",  "lod",      "ctech",  "c_interp", "stech",
  "d_interp", "shadow_obj", "trace_obj", "cstype", "deg",      "step",   "bmat",     "con",
  "curv",     "curv2",      "surf",      "parm",   "trim",     "hole",   "scrv",     "sp",
  "end",      "surf_1",     "q0_1",      "q1_1",   "curv2d_1", "surf_2", "q0_2",     "q1_2",
  "curv2d_2", "bsp",        "bzp",       "cdc",    "cdp",      "res"};

Point read_point(Scanner& in)
{
  const double x = in.number<double>(), y = in.number<double>(), z = in.number<double>();
  return Point(x, y, z);
}

// A negative index counts back from the last vertex so far; a positive one may be of a vertex that
// follows.
std::size_t read_index(Scanner& in, std::size_t number_of_points)
{
  const Scanner::Place start = in.place();
  const std::int64_t i = in.integer();
  if(i == 0 || i < -static_cast<std::int64_t>(number_of_points)) {
    in.return_to(start);
    in.fail("there is no vertex " + std::to_string(i) +
            "; count from 1, or back from -1 for the last one before");
  }
  in.skip_rest_of_word(); // texture coordinates and normals
  return i > 0 ? static_cast<std::size_t>(i - 1) : number_of_points - static_cast<std::size_t>(-i);
}

void read_corners(Scanner& in, std::size_t number_of_points, Polygons& polygons)
{
  while(!in.at_line_end('#'))
    polygons.add_corner(read_index(in, number_of_points));
  polygons.close();
}

// Polylines are read unless `lines` is null.
void read_line(Scanner& in, Polygon_soup& soup, Polygons* lines)
{
  const Scanner::Place start = in.place();
  const std::string_view key = in.word();
  if(key == "v")
    soup.points.push_back(read_point(in));
  else if(key == "f")
    read_corners(in, soup.points.size(), soup.polygons);
  else if(key == "l" && lines != nullptr)
    read_corners(in, soup.points.size(), *lines);
  else if(std::find(std::begin(ignored_keywords), std::end(ignored_keywords), key) ==
          std::end(ignored_keywords)) {
    in.return_to(start);
    in.fail("'" + std::string(key) + "' is no keyword of .obj; begin a comment with #");
  }
  in.skip_line();
}

} // namespace

void read_obj(Scanner& in, Polygon_soup& soup, Polygons* lines)
{
  for(in.skip_comments('#'); !in.at_end(); in.skip_comments('#'))
    read_line(in, soup, lines);
}
