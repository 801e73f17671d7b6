// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pictures/disk_picture.h"

#include <CGAL/Discrete_conformal_maps/Hyperbolic_tiling.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <sstream>
#include <vector>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

typedef std::complex<double> Complex;
typedef DCM::Hyperbolic_tiling::Tile Tile;

constexpr double pixel = 1. / 1000; // what cannot be seen, in a disk with radius 1

// Continues a path along the geodesic from `from` to `to`.
void add_geodesic(std::ostream& out, const Complex& from, const Complex& to)
{
  const bool is_left = (std::conj(from) * to).imag() > 0; // of the origin
  const double radius = std::sqrt((std::max)(std::norm(DCM::geodesic_center(from, to)) - 1, 0.));
  if(std::isfinite(radius) && radius < 1000)
    out << 'A' << radius << ' ' << radius << " 0 0 " << (is_left ? 0 : 1) << ' ';
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

// Returns the tiles. With cones, returns only the domain, because its images overlap.
std::vector<Tile> tiles(const DCM::Hyperbolic_conformal_map& map, std::size_t component,
                        const DCM::Hyperbolic_tiling& tiling, int depth)
{
  if(tiling.corners().empty())
    return {};
  return tiling.tiles(map.group(component).relation.empty() ? 0 : depth, pixel);
}

// Geodesics are straight in the Klein disk.
Complex to_Klein(const Complex& z) { return 2. * z / (1 + std::norm(z)); }
Complex from_Klein(const Complex& z)
{
  return z / (1 + std::sqrt((std::max)(1 - std::norm(z), 0.)));
}

std::vector<std::array<double, 2>> outline(const Tile& tile, const std::vector<Complex>& corners)
{
  constexpr int pieces = 8;
  std::vector<std::array<double, 2>> result;
  for(std::size_t i = 0; i < corners.size(); ++i) {
    const Complex from = to_Klein(tile.motion(corners[i])),
                  to = to_Klein(tile.motion(corners[(i + 1) % corners.size()]));
    for(int k = i == 0 ? 0 : 1; k <= pieces; ++k) {
      const Complex z = from_Klein(from + double(k) / pieces * (to - from));
      result.push_back({z.real(), z.imag()});
    }
  }
  return result;
}

std::vector<std::array<double, 2>> unit_circle()
{
  constexpr int pieces = 256;
  std::vector<std::array<double, 2>> result;
  for(int k = 0; k <= pieces; ++k) {
    const Complex z = std::polar(1., 2 * std::acos(-1.) * k / pieces);
    result.push_back({z.real(), z.imag()});
  }
  return result;
}

} // namespace

std::string disk_picture(const DCM::Hyperbolic_conformal_map& map, int depth)
{
  const std::size_t n = map.number_of_components();
  std::ostringstream out;
  out.precision(6);
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << 1000 * n
      << "\" height=\"1000\" viewBox=\"-1.02 -1.02 " << disk_distance * double(n) << " 2.04\">\n"
      << "<style>path{stroke:#234;stroke-width:.002;stroke-linejoin:round}"
         ".t0{fill:#f4b860}.t1{fill:#c9dbe8}.t2{fill:#e6eef4}.t3{fill:#fafcfd}"
         "circle{fill:none;stroke:#234;stroke-width:.004}</style>\n";
  for(std::size_t c = 0; c < n; ++c) {
    const DCM::Hyperbolic_tiling tiling(map, c);
    out << "<g transform=\"translate(" << disk_distance * double(c) << ") scale(1 -1)\">\n";
    for(const Tile& tile : tiles(map, c, tiling, depth))
      add_tile(out, tile, tiling.corners());
    out << "<circle r=\"1\"/>\n</g>\n";
  }
  out << "</svg>\n";
  return out.str();
}

std::vector<std::vector<std::array<double, 2>>>
disk_outlines(const DCM::Hyperbolic_conformal_map& map, int depth)
{
  std::vector<std::vector<std::array<double, 2>>> result;
  for(std::size_t c = 0; c < map.number_of_components(); ++c) {
    const std::size_t first = result.size();
    const DCM::Hyperbolic_tiling tiling(map, c);
    result.push_back(unit_circle());
    for(const Tile& tile : tiles(map, c, tiling, depth))
      result.push_back(outline(tile, tiling.corners()));
    for(std::size_t i = first; i < result.size(); ++i)
      for(std::array<double, 2>& p : result[i])
        p[0] += disk_distance * double(c);
  }
  return result;
}
