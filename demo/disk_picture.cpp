// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "disk_picture.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <sstream>
#include <vector>

namespace CM = CGAL::Discrete_conformal_maps;

namespace {

using CM::Delta_complex;
using CM::Edge_index;
using CM::Halfedge_index;
typedef std::complex<double> Complex;
typedef CM::Disk_motion<> Motion;

constexpr double pixel = 1. / 1000; // what cannot be seen, in a disk with radius 1

struct Tile
{
  Motion motion;
  int depth;
};

// The domain of one component and its images.
class Tiling
{
public:
  Tiling(const CM::Hyperbolic_conformal_map& map, std::size_t component)
    : m_map(map), m_mesh(map.ideal().mesh())
  {
    for(const Halfedge_index h : m_mesh.halfedges())
      if(map.component(m_mesh.face(h)) == component && map.is_seam(Edge_index(h))) {
        if(m_corners.empty())
          follow_boundary(h);
        add_side(map.gluing(h));
      }
  }

  // the corners of the domain, counterclockwise
  const std::vector<Complex>& corners() const { return m_corners; }

  // The domain comes first. An image farther away than a pixel from the boundary of the disk is
  // left out.
  std::vector<Tile> tiles(int depth) const
  {
    std::vector<Tile> result{{Motion(), 0}};
    for(std::size_t i = 0; i < result.size() && result[i].depth < depth; ++i)
      for(const Motion& side : m_sides) {
        const Tile tile{result[i].motion * side, result[i].depth + 1};
        const Complex center = tile.motion(0);
        const auto is_same = [&](const Tile& t) { return are_close(t.motion(0), center); };
        if(std::abs(center) < 1 - pixel && std::none_of(result.begin(), result.end(), is_same))
          result.push_back(tile);
      }
    return result;
  }

private:
  // in the hyperbolic plane; images of a point inside the domain are much farther apart
  static bool are_close(const Complex& z, const Complex& w)
  {
    return std::abs(z - w) < 1e-6 * std::abs(1. - std::conj(z) * w);
  }

  void follow_boundary(Halfedge_index start)
  {
    Halfedge_index h = start;
    do {
      m_corners.push_back(m_map.position(h));
      h = m_mesh.next(h);
      while(!m_map.is_seam(Edge_index(h)))
        h = m_mesh.next(m_mesh.opposite(h));
    } while(h != start);
  }

  // Edges along one side have the same motion.
  void add_side(const Motion& motion)
  {
    const auto is_same = [&](const Motion& m) { return are_close(m(0), motion(0)); };
    if(std::none_of(m_sides.begin(), m_sides.end(), is_same))
      m_sides.push_back(motion);
  }

  const CM::Hyperbolic_conformal_map& m_map;
  const Delta_complex& m_mesh;
  std::vector<Complex> m_corners;
  std::vector<Motion> m_sides;
};

// Continues a path along the geodesic from `from` to `to`, an arc of a circle that meets the unit
// circle at right angles: its center c has 2 Re(c conj(z)) = 1 + |z|^2 for both points z.
void add_geodesic(std::ostream& out, const Complex& from, const Complex& to)
{
  const double det = from.real() * to.imag() - to.real() * from.imag();
  const double a = 1 + std::norm(from), b = 1 + std::norm(to);
  const Complex center(a * to.imag() - b * from.imag(), b * from.real() - a * to.real());
  const double radius = std::sqrt((std::max)(std::norm(center) / (4 * det * det) - 1, 0.));
  if(std::isfinite(radius) && radius < 1000)
    out << 'A' << radius << ' ' << radius << " 0 0 " << (det > 0 ? 0 : 1) << ' ';
  else
    out << 'L';
  out << to.real() << ' ' << to.imag();
}

void add_tile(std::ostream& out, const Tile& tile, const std::vector<Complex>& corners)
{
  Complex last = tile.motion(corners.front());
  out << "<path class=\"t" << (std::min)(tile.depth, 3) << "\" d=\"M" << last.real() << ' '
      << last.imag();
  for(const Complex& corner : corners)
    if(const Complex z = tile.motion(corner); std::abs(z - last) > pixel / 2) {
      add_geodesic(out, last, z);
      last = z;
    }
  out << "Z\"/>\n";
}

} // namespace

std::string disk_picture(const CM::Hyperbolic_conformal_map& map, int depth)
{
  const std::size_t n = map.number_of_components();
  std::ostringstream out;
  out.precision(6);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << 1000 * n
      << "\" height=\"1000\" viewBox=\"-1.02 -1.02 " << 2.04 * double(n) << " 2.04\">\n"
      << "<style>path{stroke:#234;stroke-width:.002;stroke-linejoin:round}"
         ".t0{fill:#f4b860}.t1{fill:#c9dbe8}.t2{fill:#e6eef4}.t3{fill:#fafcfd}"
         "circle{fill:none;stroke:#234;stroke-width:.004}</style>\n";
  for(std::size_t c = 0; c < n; ++c) {
    const Tiling tiling(map, c);
    out << "<g transform=\"translate(" << 2.04 * double(c) << ") scale(1 -1)\">\n";
    if(!tiling.corners().empty())
      for(const Tile& tile : tiling.tiles(map.group(c).relation.empty() ? 0 : depth))
        add_tile(out, tile, tiling.corners());
    out << "<circle r=\"1\"/>\n</g>\n";
  }
  out << "</svg>\n";
  return out.str();
}
