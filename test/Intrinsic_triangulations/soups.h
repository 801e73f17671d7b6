// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_SOUPS_H
#define INTRINSIC_TRIANGULATIONS_TEST_SOUPS_H

#include "generators.h"

// This file generates triangles that need not be a surface, all from a seed.
namespace Test_surfaces {

struct Soup
{
  std::vector<Point> points;
  Triangles triangles;
};

Soup soup_of(const Mesh& mesh);

// Represents pages of m x n squares with a common left side on the z-axis. Page k has the angle
// angles[k]. Vertex (page, i, j) is i squares from the spine.
struct Book
{
  Book(const std::vector<double>& angles, std::size_t m_, std::size_t n_, double width = 1,
       double height = 1)
    : m(m_), n(n_)
  {
    const auto point = [&](double angle, std::size_t i, std::size_t j) {
      const double x = width * static_cast<double>(i) / static_cast<double>(m);
      return Point(x * std::cos(angle), x * std::sin(angle),
                   height * static_cast<double>(j) / static_cast<double>(n));
    };
    for(std::size_t j = 0; j <= n; ++j)
      soup.points.push_back(point(0, 0, j));
    for(std::size_t page = 0; page < angles.size(); ++page)
      add(page, [&](std::size_t i, std::size_t j) { return point(angles[page], i, j); });
  }

  std::size_t vertex(std::size_t page, std::size_t i, std::size_t j) const
  {
    return i == 0 ? j : (1 + page * m + i - 1) * (n + 1) + j;
  }

  template <typename Place>
  void add(std::size_t page, const Place& place)
  {
    for(std::size_t i = 1; i <= m; ++i)
      for(std::size_t j = 0; j <= n; ++j)
        soup.points.push_back(place(i, j));
    for(std::size_t i = 0; i < m; ++i)
      for(std::size_t j = 0; j < n; ++j) {
        const std::size_t a = vertex(page, i, j), b = vertex(page, i + 1, j),
                          c = vertex(page, i + 1, j + 1), d = vertex(page, i, j + 1);
        soup.triangles.push_back({a, b, c});
        soup.triangles.push_back({a, c, d});
      }
  }

  std::size_t m, n;
  Soup soup;
};

std::vector<double> random_angles(std::size_t n, CGAL::Random& random);

// Returns a band of n squares with half a turn.
Soup moebius_band(std::size_t n);

// Returns the union, with one common vertex.
Soup joined(Soup a, const Soup& b, CGAL::Random& random);

void flip_orientations(Soup& soup, CGAL::Random& random);

void move_points(Soup& soup, double amount, CGAL::Random& random);

Soup random_part(int kind, CGAL::Random& random);

// Returns books of three to seven pages, Moebius bands and bipyramids that touch in vertices. Some
// faces occur twice or three times, without orientation.
Soup random_soup(unsigned int seed);

// Removes faces from a manifold mesh and adds as many elsewhere, so that it is no longer a surface.
class Mesh_spoiler
{
public:
  Mesh_spoiler(const Mesh& mesh, unsigned int seed) : m_random(seed), m_soup(soup_of(mesh))
  {
    m_kept.resize(m_soup.triangles.size());
    std::iota(m_kept.begin(), m_kept.end(), std::size_t(0));
    CGAL::cpp98::random_shuffle(m_kept.begin(), m_kept.end(), m_random);
  }

  // Moves one of every `share` faces to another position.
  Soup operator()(std::size_t share)
  {
    const std::size_t stay = m_kept.size() - m_kept.size() / share;
    m_taken.assign(m_kept.begin() + static_cast<std::ptrdiff_t>(stay), m_kept.end());
    m_kept.resize(stay);
    while(!m_taken.empty())
      switch(m_random.get_int(0, 4)) {
        case 0: add_fins(); break;
        case 1: put(random_face()); break; // twice
        case 2: add_band(); break;
        default: add_at_vertex();
      }
    flip_orientations(m_soup, m_random);
    return std::move(m_soup);
  }

private:
  void put(const Triangles::value_type& t)
  {
    if(m_taken.empty())
      return;
    m_soup.triangles[m_taken.back()] = t;
    m_taken.pop_back();
  }

  Triangles::value_type random_face()
  {
    return m_soup
      .triangles[m_kept[std::size_t(m_random.get_int(0, static_cast<int>(m_kept.size())))]];
  }

  double length(std::size_t a, std::size_t b) const
  {
    return std::sqrt(CGAL::squared_distance(m_soup.points[a], m_soup.points[b]));
  }

  std::size_t add_point_near(std::size_t v, double distance)
  {
    const auto coordinate = [&] { return m_random.get_double(-distance, distance); };
    const double x = coordinate(), y = coordinate(), z = coordinate();
    m_soup.points.push_back(m_soup.points[v] + Kernel::Vector_3(x, y, z));
    return m_soup.points.size() - 1;
  }

  // Adds three to seven faces at an edge.
  void add_fins()
  {
    const auto [a, b, c] = random_face();
    for(int fins = m_random.get_int(1, 6); fins > 0; --fins)
      put({b, a, add_point_near(a, length(a, b))});
  }

  // Adds a face that touches only a vertex.
  void add_at_vertex()
  {
    const auto [a, b, c] = random_face();
    const std::size_t d = add_point_near(a, length(a, b)), e = add_point_near(a, length(a, b));
    put({a, d, e});
  }

  // Adds a Moebius band at a vertex.
  void add_band()
  {
    const auto [a, b, c] = random_face();
    const Soup band = moebius_band(std::size_t(m_random.get_int(5, 9)));
    if(m_taken.size() < band.triangles.size())
      return add_fins();
    const std::size_t shift = m_soup.points.size() - 1;
    for(std::size_t v = 1; v < band.points.size(); ++v)
      m_soup.points.push_back(m_soup.points[a] + length(a, b) * (band.points[v] - band.points[0]));
    for(const auto& t : band.triangles) {
      const auto number = [&, a = a](std::size_t v) { return v == 0 ? a : shift + v; };
      put({number(t[0]), number(t[1]), number(t[2])});
    }
  }

  CGAL::Random m_random;
  Soup m_soup;
  std::vector<std::size_t> m_kept, m_taken; // faces
};

// Returns a manifold mesh with every eighth face moved: to edges that then have up to seven faces,
// to other faces, to vertices only, or into Moebius bands. Faces have no orientation.
inline Soup spoiled(const Mesh& mesh, unsigned int seed) { return Mesh_spoiler(mesh, seed)(8); }

} // namespace Test_surfaces

#endif // INTRINSIC_TRIANGULATIONS_TEST_SOUPS_H
