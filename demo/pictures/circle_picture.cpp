// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/circle_picture.h"

#include "pictures/Canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

constexpr double size = 1000; // in pixels
constexpr Line_style style{'c', {0, 0, 0}, .5};

// Returns whether a part of the circle is in the square [0, size]^2.
bool is_visible(const Canvas_point& center, double radius)
{
  const auto [x, y] = center;
  const double nearest = std::hypot(x - std::clamp(x, 0., size), y - std::clamp(y, 0., size));
  const double farthest = std::hypot((std::max)(x, size - x), (std::max)(y, size - y));
  return nearest <= radius && radius <= farthest;
}

} // namespace

void write_circle_picture(Text& text, const DCM::Circle_packing& packing, const std::string& path)
{
  const double scale = size / 2 / (packing.is_disk() ? 1.01 : 3);
  const auto canvas = ::canvas(text, path, size, size, {style});
  canvas->begin_square(0, size, !packing.is_disk());
  const auto add = [&](const DCM::Planar_circle& c) {
    const Canvas_point center{size / 2 + scale * c.center.real(),
                              size / 2 - scale * c.center.imag()};
    if(is_visible(center, scale * c.radius))
      canvas->add_circle(center, scale * c.radius, style);
  };
  for(std::size_t v = 0; v < packing.size(); ++v)
    add(packing.circle(DCM::Vertex_index(static_cast<DCM::Vertex_index::size_type>(v))));
  if(packing.is_disk())
    add({0, 1});
  canvas->finish();
}
