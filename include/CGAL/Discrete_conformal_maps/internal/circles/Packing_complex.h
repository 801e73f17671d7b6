// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_PACKING_COMPLEX_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_PACKING_COMPLEX_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>
#include <CGAL/Intrinsic_triangulations/topological_type.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Discrete_conformal_maps::internal {

// Represents a triangulated sphere without one face, the outer face. The circles at the corners of
// the outer face touch each other, and enclose all other circles. A disk becomes a sphere by an
// apex that is joined to its boundary. The outside of the circle of the apex is the image of the
// disk.
class Packing_complex
{
public:
  // `size` contains known sizes of the circles at the vertices of `mesh`. If it is empty, degrees
  // replace the sizes.
  // \throws Invalid_input if `mesh` is not a simplicial sphere or disk
  explicit Packing_complex(const Delta_complex& mesh, std::vector<double> size = {})
  {
    check(mesh);
    for(std::size_t v = 0; v < mesh.num_vertices(); ++v)
      m_rest.add_vertex();
    std::vector<std::array<Vertex_index, 3>> faces;
    for(Face_index f : mesh.faces()) {
      const auto side = sides(f, mesh);
      faces.push_back({mesh.source(side[0]), mesh.source(side[1]), mesh.source(side[2])});
    }
    const auto loops = Intrinsic_triangulations::boundary_loops(mesh);
    if(!loops.empty()) {
      m_apex = m_rest.add_vertex();
      Halfedge_index h = loops.front();
      do {
        faces.push_back({mesh.source(h), mesh.target(h), m_apex});
        h = mesh.next(h);
      } while(h != loops.front());
    }
    if(size.empty())
      size = degrees(faces);
    size.resize(m_rest.num_vertices(), 1.);
    remove_outer_face(faces, size);
    for(const auto& f : faces)
      m_rest.add_face(f[0], f[1], f[2]);
  }

  // Returns the disk without the outer face.
  const Delta_complex& rest() const { return m_rest; }
  // Returns the corners of the outer face.
  const std::array<Vertex_index, 3>& outer_corners() const { return m_outer; }
  // Returns the apex of a disk, which is invalid for a sphere.
  Vertex_index apex() const { return m_apex; }

private:
  static void check(const Delta_complex& mesh)
  {
    using Intrinsic_triangulations::Invalid_input;
    const auto type = Intrinsic_triangulations::topological_type(mesh);
    if(type.components != 1 || type.genus > 0 || type.boundary_loops > 1)
      throw Invalid_input("circles are packed on spheres and disks; this is " +
                          Intrinsic_triangulations::description(type));
    for(Vertex_index v : mesh.vertices())
      if(mesh.is_isolated(v))
        throw Invalid_input("vertex " + std::to_string(v.idx()) + " has no face");
    for(Face_index f : mesh.faces())
      if(!Intrinsic_triangulations::is_simplicial(f, mesh))
        throw Invalid_input("another edge or face has the same vertices as face " +
                            std::to_string(f.idx()) + " or one of its edges");
  }

  std::vector<double> degrees(const std::vector<std::array<Vertex_index, 3>>& faces) const
  {
    std::vector<double> result(m_rest.num_vertices(), 0);
    for(const auto& f : faces)
      for(Vertex_index v : f)
        ++result[v.idx()];
    return result;
  }

  // Removes the face with the greatest product of sizes, which becomes the outer face. Many
  // circles touch the circles of this face, so that no circle is far from them. If an apex exists,
  // only faces at the apex are candidates.
  void remove_outer_face(std::vector<std::array<Vertex_index, 3>>& faces,
                         const std::vector<double>& size)
  {
    std::size_t best = 0;
    double greatest = -1;
    for(std::size_t f = 0; f < faces.size(); ++f) {
      const auto& [a, b, c] = faces[f];
      const double product = size[a.idx()] * size[b.idx()] * size[c.idx()];
      if((!m_apex.is_valid() || c == m_apex) && product > greatest) {
        best = f;
        greatest = product;
      }
    }
    m_outer = faces[best];
    faces.erase(faces.begin() + std::ptrdiff_t(best));
  }

  Delta_complex m_rest;
  std::array<Vertex_index, 3> m_outer;
  Vertex_index m_apex;
};

} // namespace CGAL::Discrete_conformal_maps::internal

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_INTERNAL_CIRCLES_PACKING_COMPLEX_H
