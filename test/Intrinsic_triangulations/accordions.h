// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_ACCORDIONS_H
#define INTRINSIC_TRIANGULATIONS_TEST_ACCORDIONS_H

#include "generators.h"

// This file generates strips of panels that are folded along parallel lines. The width of a panel
// is the root of a whole number, so the width of the unfolded strip is a sum of roots. Four points
// at two heights on its ends are the corners of a rectangle: a tie with all these roots.
namespace Test_surfaces {

// Represents a panel. A panel that steps by (x, z) has the width sqrt(x^2 + z^2).
struct Panel
{
  double x, z;
};

// Stores the heights on both ends, from the lowest to the highest, which all folds reach.
struct Accordion
{
  std::vector<Panel> panels;
  std::vector<double> left, right;

  Mesh mesh() const
  {
    Mesh mesh;
    std::vector<Vertex_index> last = add_column(0, {0, 0}, mesh);
    Panel place{0, 0};
    for(std::size_t c = 1; c <= panels.size(); ++c) {
      place = {place.x + panels[c - 1].x, place.z + panels[c - 1].z};
      const std::vector<Vertex_index> column = add_column(c, place, mesh);
      join(last, column, mesh);
      last = column;
    }
    return mesh;
  }

private:
  std::vector<Vertex_index> add_column(std::size_t c, const Panel& place, Mesh& mesh) const
  {
    std::vector<Vertex_index> result;
    const std::vector<double> ends{left.front(), left.back()};
    for(double y : c == 0 ? left : c == panels.size() ? right : ends)
      result.push_back(mesh.add_vertex(Point(place.x, y, place.z)));
    return result;
  }

  // Adds triangles between two columns, the lowest first.
  static void join(const std::vector<Vertex_index>& a, const std::vector<Vertex_index>& b,
                   Mesh& mesh)
  {
    const auto height = [&](Vertex_index v) { return mesh.point(v).y(); };
    for(std::size_t i = 0, j = 0; i + 1 < a.size() || j + 1 < b.size();)
      if(j + 1 == b.size() || (i + 1 < a.size() && height(a[i + 1]) <= height(b[j + 1]))) {
        mesh.add_face(a[i], b[j], a[i + 1]);
        ++i;
      } else {
        mesh.add_face(a[i], b[j], b[j + 1]);
        ++j;
      }
  }
};

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_ACCORDIONS_H
