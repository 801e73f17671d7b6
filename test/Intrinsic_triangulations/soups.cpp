// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "soups.h"

namespace Test_surfaces {

Soup soup_of(const Mesh& mesh)
{
  Soup result;
  result.points.assign(mesh.points().begin(), mesh.points().end());
  for(Face_index f : mesh.faces()) {
    const Halfedge_index h = mesh.halfedge(f);
    result.triangles.push_back({std::size_t(mesh.source(h).idx()),
                                std::size_t(mesh.target(h).idx()),
                                std::size_t(mesh.target(mesh.next(h)).idx())});
  }
  return result;
}

std::vector<double> random_angles(std::size_t n, CGAL::Random& random)
{
  std::vector<double> result;
  for(std::size_t i = 0; i < n; ++i)
    result.push_back(random.get_double(0, 6.28));
  return result;
}

Soup moebius_band(std::size_t n)
{
  Soup result;
  for(std::size_t i = 0; i < n; ++i)
    for(const double side : {-0.4, 0.4}) {
      const double angle = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(n);
      const double r = 1 + side * std::cos(angle / 2);
      result.points.emplace_back(r * std::cos(angle), r * std::sin(angle),
                                 side * std::sin(angle / 2));
    }
  for(std::size_t i = 0; i < n; ++i) {
    const std::size_t a = 2 * i, b = 2 * i + 1;
    const std::size_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    result.triangles.push_back({a, c, b});
    result.triangles.push_back({b, c, d});
  }
  return result;
}

Soup joined(Soup a, const Soup& b, CGAL::Random& random)
{
  const std::size_t shift = a.points.size() - 1;
  const auto at = static_cast<std::size_t>(random.get_int(0, static_cast<int>(shift) + 1));
  const auto number = [&](std::size_t v) { return v == 0 ? at : shift + v; };
  for(std::size_t v = 1; v < b.points.size(); ++v)
    a.points.push_back(a.points[at] + (b.points[v] - b.points[0]));
  for(const auto& [i, j, k] : b.triangles)
    a.triangles.push_back({number(i), number(j), number(k)});
  return a;
}

void flip_orientations(Soup& soup, CGAL::Random& random)
{
  for(auto& t : soup.triangles)
    if(random.get_bool())
      std::swap(t[1], t[2]);
}

void move_points(Soup& soup, double amount, CGAL::Random& random)
{
  for(Point& p : soup.points)
    p = Point(p.x() + amount * random.get_double(-1, 1), p.y() + amount * random.get_double(-1, 1),
              p.z() + amount * random.get_double(-1, 1));
}

Soup random_part(int kind, CGAL::Random& random)
{
  const auto number = [&](int from, int to) {
    return static_cast<std::size_t>(random.get_int(from, to + 1));
  };
  switch(kind) {
    case 0: return Book(random_angles(number(3, 7), random), number(1, 4), number(1, 4)).soup;
    case 1: return moebius_band(number(5, 12));
    default: return soup_of(bipyramid(number(3, 9), 0.7));
  }
}

Soup random_soup(unsigned int seed)
{
  CGAL::Random random(seed);
  Soup result = random_part(static_cast<int>(seed % 3), random);
  for(int parts = random.get_int(0, 3); parts > 0; --parts)
    result = joined(std::move(result), random_part(random.get_int(0, 3), random), random);
  move_points(result, 0.02, random);
  for(int copies = random.get_int(0, 4); copies > 0; --copies)
    result.triangles.push_back(result.triangles[static_cast<std::size_t>(
      random.get_int(0, static_cast<int>(result.triangles.size())))]);
  flip_orientations(result, random);
  return result;
}

} // namespace Test_surfaces
