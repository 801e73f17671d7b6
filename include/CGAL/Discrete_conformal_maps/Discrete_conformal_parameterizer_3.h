// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_DISCRETE_CONFORMAL_PARAMETERIZER_3_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_DISCRETE_CONFORMAL_PARAMETERIZER_3_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/texture_coordinates.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/internal/validity.h>
#include <CGAL/boost/graph/iterator.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// Holds the component of a face as a separate mesh. For a `Seam_mesh`, it is cut open.
template <typename Graph, typename Point>
class Component_copy
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  typedef typename boost::graph_traits<Graph>::face_descriptor Face;

public:
  typedef Surface_mesh<Point> Mesh;

  Component_copy(Face seed, const Graph& g)
  {
    std::vector<Face> component;
    Polygon_mesh_processing::connected_component(seed, g, std::back_inserter(component));
    for(Face f : component)
      add(f, g);
  }

  const Mesh& mesh() const { return m_mesh; }
  // Returns the vertices of the graph, by their indices in the mesh.
  const std::vector<Vertex>& vertices() const { return m_vertices; }

private:
  void add(Face f, const Graph& g)
  {
    std::vector<typename Mesh::Vertex_index> corners;
    for(Vertex v : CGAL::vertices_around_face(halfedge(f, g), g)) {
      const auto [entry, is_new] = m_number.emplace(v, m_vertices.size());
      if(is_new) {
        m_vertices.push_back(v);
        m_mesh.add_vertex(get(get(CGAL::vertex_point, g), v));
      }
      corners.emplace_back(static_cast<typename Mesh::size_type>(entry->second));
    }
    m_mesh.add_face(corners);
  }

  Mesh m_mesh;
  std::vector<Vertex> m_vertices;
  std::unordered_map<Vertex, std::size_t> m_number;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// lets `Surface_mesh_parameterization::parameterize()` map a disk to the plane, discretely
/// conformally, as `flatten()` does. Vertices on the boundary are not scaled.
///
/// One position for each vertex determines the map only if no edge is flipped. By default
/// (`Flipping::to_Delaunay`), the map belongs to the surface and does not depend on its
/// triangulation. Then `mesh` must be its intrinsic Delaunay triangulation and stay Delaunay with
/// the scale factors. No angle opposite to the boundary may be obtuse. Otherwise the error says to
/// use `flatten()`, whose result has a common subdivision. With `Flipping::none`, the map belongs
/// to the given triangulation. It often exists if triangles have good angles.
///
/// \tparam TriangleMesh_ a model of `FaceListGraph` with points, such as `Surface_mesh` or
///   `Seam_mesh`
///
/// \cgalModels `Parameterizer_3`
template <typename TriangleMesh_>
class Discrete_conformal_parameterizer_3
{
  typedef Surface_mesh_parameterization::internal::Kernel_traits<TriangleMesh_> Traits;
  typedef typename Traits::Kernel::Point_3 Point_3;
  typedef internal::Component_copy<TriangleMesh_, Point_3> Component;

public:
  /// the type of meshes.
  typedef TriangleMesh_ Triangle_mesh;
  /// the type of meshes.
  typedef TriangleMesh_ TriangleMesh;
  /// a halfedge of it.
  typedef typename boost::graph_traits<Triangle_mesh>::halfedge_descriptor halfedge_descriptor;
  /// the type of results.
  typedef Surface_mesh_parameterization::Error_code Error_code;

  /// makes a parameterizer.
  /// \param flipping whether the map belongs to the surface or to its triangulation
  explicit Discrete_conformal_parameterizer_3(Flipping flipping = Flipping::to_Delaunay)
    : m_flipping(flipping)
  {}

  /// returns whether the faces of the component of `bhd` have images with the same orientation that
  /// do not overlap.
  template <typename VertexUVMap>
  bool is_one_to_one_mapping(const Triangle_mesh& mesh, halfedge_descriptor bhd,
                             const VertexUVMap uvmap) const
  {
    return Surface_mesh_parameterization::internal::is_one_to_one_mapping(mesh, bhd, uvmap);
  }

  /// maps the component of `bhd`. Complexity: see `flatten()`.
  ///
  /// \param mesh a triangle mesh
  /// \param bhd a border halfedge
  /// \param uvmap a writable property map from vertices to points of the plane; nothing is written
  ///        in case of an error
  ///
  /// The property maps of indices and of parameterized vertices, which the concept requires, are
  /// not used.
  /// \return
  ///   - `OK`;
  ///   - `ERROR_NO_1_TO_1_MAPPING` if no map is one-to-one and projective on the faces of `mesh`.
  ///     With `Flipping::to_Delaunay` an edge had to be flipped; with `Flipping::none` no scale
  ///     factors exist. Faces in the plane that are smaller than rounding are another reason;
  ///   - `ERROR_NON_TRIANGULAR_MESH`, `ERROR_NO_TOPOLOGICAL_DISC` as their names say;
  ///   - `ERROR_WRONG_PARAMETER` if `flatten()` refuses the input, because an edge has no length,
  ///     for example;
  ///   - `ERROR_CANNOT_SOLVE_LINEAR_SYSTEM` if numbers have too few digits.
  template <typename VertexUVMap, typename VertexIndexMap, typename VertexParameterizedMap>
  Error_code parameterize(Triangle_mesh& mesh, halfedge_descriptor bhd, VertexUVMap uvmap,
                          VertexIndexMap /* vimap */, VertexParameterizedMap /* vpmap */)
  {
    const Component component(face(opposite(bhd, mesh), mesh), mesh);
    if(!CGAL::is_triangle_mesh(component.mesh()))
      return Surface_mesh_parameterization::ERROR_NON_TRIANGULAR_MESH;
    if(!is_disk(component.mesh()))
      return Surface_mesh_parameterization::ERROR_NO_TOPOLOGICAL_DISC;
    try {
      return write(flattened(component.mesh()), component, uvmap);
    } catch(const No_texture_coordinates&) {
      return Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING;
    } catch(const Intrinsic_triangulations::Invalid_input&) {
      return Surface_mesh_parameterization::ERROR_WRONG_PARAMETER;
    } catch(const Intrinsic_triangulations::Error&) {
      return Surface_mesh_parameterization::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    }
  }

private:
  // Returns whether a connected mesh with boundary is a disk.
  static bool is_disk(const typename Component::Mesh& mesh)
  {
    return mesh.number_of_vertices() + mesh.number_of_faces() == mesh.number_of_edges() + 1;
  }

  Planar_conformal_map flattened(const typename Component::Mesh& mesh) const
  {
    return flatten(mesh, parameters::flipping(m_flipping).cones(Cones::none));
  }

  template <typename VertexUVMap>
  static Error_code write(const Planar_conformal_map& map, const Component& component,
                          VertexUVMap uvmap)
  {
    typedef typename boost::property_traits<VertexUVMap>::value_type Point_2;
    if(map.status() == Map_status::not_converged || map.status() == Map_status::wrong_curvature)
      return Surface_mesh_parameterization::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM;
    if(map.status() != Map_status::success && map.is_laid_out())
      return Surface_mesh_parameterization::ERROR_NO_1_TO_1_MAPPING;
    internal::for_each_corner(
      map, component.mesh(), [](const auto&... args) { return texture_points(args...); },
      [&](Halfedge_index h, const std::array<double, 2>& z) {
        const Vertex_index v = component.mesh().target(h);
        put(uvmap, component.vertices()[v.idx()], Point_2(z[0], z[1]));
      });
    return Surface_mesh_parameterization::OK;
  }

  Flipping m_flipping;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_DISCRETE_CONFORMAL_PARAMETERIZER_3_H
