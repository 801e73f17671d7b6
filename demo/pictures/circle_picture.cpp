// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/circle_picture.h"

#include "pictures/Canvas.h"

#include <cstddef>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

constexpr double size = 1000; // in pixels
constexpr Line_style style{'c', {0, 0, 0}, .5};

} // namespace

void write_circle_picture(Text& text, const DCM::Circle_packing& packing, const std::string& path)
{
  const double scale = size / 2 / (packing.is_disk() ? 1.01 : 3);
  const auto canvas = ::canvas(text, path, size, size, {style});
  canvas->begin_square(0, size, false);
  const auto add = [&](const DCM::Planar_circle& c) {
    canvas->add_circle({size / 2 + scale * c.center.real(), size / 2 - scale * c.center.imag()},
                       scale * c.radius, style);
  };
  for(std::size_t v = 0; v < packing.size(); ++v)
    add(packing.circle(DCM::Vertex_index(static_cast<DCM::Vertex_index::size_type>(v))));
  if(packing.is_disk())
    add({0, 1});
  canvas->finish();
}
