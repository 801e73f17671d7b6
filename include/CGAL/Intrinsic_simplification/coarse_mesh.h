// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_COARSE_MESH_H
#define CGAL_INTRINSIC_SIMPLIFICATION_COARSE_MESH_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/internal/maps/Coarse_mesh_measurement.h>
#include <CGAL/Intrinsic_simplification/named_parameters.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_triangulations/Subdivision_part.h>
#include <CGAL/Intrinsic_triangulations/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/exceptions.h>
#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/is_simplicial.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_simplification {

/// \ingroup PkgIntrinsicSimplificationRef
/// the distances of a coarse mesh in space from the surface that it represents, and its defects.
struct Coarse_mesh_quality
{
  /// the number of vertices that were inserted into the coarse triangulation
  std::size_t inserted_vertices = 0;
  /// the greatest distance in space of a vertex of the fine level from the coarse mesh
  double distance_to_coarse = 0;
  /// the greatest distance in space of the middle of an edge or face of the coarse mesh from the
  /// fine level
  double distance_to_fine = 0;
  /// the number of flipped faces: their normals point away from the mean normal of the part of the
  /// fine level that is mapped to them
  std::size_t flipped_faces = 0;
  std::size_t degenerate_faces = 0;   ///< the number of faces whose corners are on a line, exactly
  std::size_t self_intersections = 0; ///< the number of pairs of faces that intersect, exactly

  /// returns the greater of both distances.
  double deviation() const { return (std::max)(distance_to_coarse, distance_to_fine); }
};

namespace internal {

// Returns the edges in the order of decreasing lengths.
inline std::deque<Edge_index> longest_edges_first(const Evolving_surface::Triangulation& tri)
{
  std::deque<Edge_index> result(tri.mesh().edges_begin(), tri.mesh().edges_end());
  std::stable_sort(result.begin(), result.end(),
                   [&](Edge_index e, Edge_index f) { return tri.length(e) > tri.length(f); });
  return result;
}

// Splits the edge of `h` in the middle, or near it: the third corner of a face without area can lie
// in the middle. The edge has two faces, so three points suffice.
inline Vertex_index split_near_middle(Halfedge_index h,
                                      Intrinsic_triangulations::Vertex_inserter<>& inserter)
{
  for(double t : {0.5, 0.375})
    try {
      return inserter.split_edge(h, t);
    } catch(const Intrinsic_triangulations::Numerical_error&) {
    }
  return inserter.split_edge(h, 0.625);
}

// Inserts vertices until the surface is simplicial, and returns their number. Splits loops in the
// middle, and of several edges with the same ends all but the shortest. Then a face whose corners
// another face has gets a vertex inside. No edge is flipped, so new vertices have simple
// coordinates, however thin a face is. A new edge is a loop, or has the ends of another edge, only
// if corners of split faces coincide, so few splits suffice.
inline std::size_t make_simplicial(Evolving_surface& surface)
{
  namespace IT = Intrinsic_triangulations;
  Evolving_surface::Triangulation tri =
    constrained_triangulation(Surface_level(surface), surface.surface());
  const Delta_complex& mesh = tri.mesh();
  IT::Default_refinement_visitor silent;
  Refinement_follower<IT::Default_refinement_visitor> follower(tri, surface, silent);
  IT::Vertex_inserter<> inserter(tri);
  std::deque<Edge_index> edges = longest_edges_first(tri);
  for(; !edges.empty(); edges.pop_front())
    if(const Halfedge_index h = mesh.halfedge(edges.front()); !is_simplicial(h, mesh)) {
      const Vertex_index m = split_near_middle(h, inserter);
      follower.after_insertion(m, inserter);
      for_each_outgoing_halfedge(m, mesh, [&](Halfedge_index x) { edges.push_back(mesh.edge(x)); });
    }
  const std::vector<Face_index> faces(mesh.faces_begin(), mesh.faces_end());
  for(Face_index f : faces)
    if(!is_simplicial(f, mesh))
      follower.after_insertion(
        inserter.insert(IT::Face_location<double>(f, {1. / 3, 1. / 3, 1. / 3})), inserter);
  follower.take_lengths();
  return tri.number_of_inserted_vertices();
}

// Represents a triangulation as a subdivision with one triangulation.
struct Whole_triangulation
{
  typedef Delta_complex Mesh;
  typedef Delta_complex::size_type size_type;

  const Delta_complex& mesh() const { return m_mesh; }

  const Delta_complex& m_mesh;
};

inline bool is_fine_vertex(Vertex_index v, const Surface_map& map)
{
  return map.fine().level_vertex(map.coarse().surface_vertex(v)).is_valid();
}

// Returns the locations on the fine level of the vertices that only the coarse level has. Other
// vertices have null faces.
inline std::vector<Surface_map::Location> locations_of_inserted_vertices(const Surface_map& map)
{
  std::vector<Surface_map::Location> result;
  for(Vertex_index v : map.coarse().mesh().vertices())
    result.push_back(is_fine_vertex(v, map) ? Surface_map::Location() : preimage_of_vertex(v, map));
  return result;
}

// Returns the positions of the vertices of the coarse level. Vertices of both levels have their
// exact positions.
template <typename PointMap>
auto coarse_points(const Surface_map& map, const std::vector<Surface_map::Location>& locations,
                   const PointMap& points)
{
  std::vector<std::decay_t<decltype(get(points, Vertex_index()))>> result;
  for(Vertex_index v : map.coarse().mesh().vertices()) {
    const auto& [face, weight] = locations[v.idx()];
    if(!face.is_valid()) {
      result.push_back(get(points, map.fine().level_vertex(map.coarse().surface_vertex(v))));
      continue;
    }
    const auto side = Intrinsic_triangulations::sides(face, map.fine().mesh());
    std::array<Vertex_index, 3> corner;
    for(std::size_t c = 0; c < 3; ++c)
      corner[c] = map.fine().mesh().source(side[c]);
    result.push_back(
      Intrinsic_triangulations::internal::linear_value(points, corner, weight, corner.size()));
  }
  return result;
}

// Returns the mesh with the position `point(v)` of each vertex.
template <typename Point_of>
Space_mesh mesh_in_space(const Delta_complex& complex, const Point_of& point)
{
  Space_mesh result =
    Intrinsic_triangulations::internal::mesh_with_connectivity<Space::Point_3>(complex);
  for(Vertex_index v : complex.vertices()) {
    const auto& p = point(v);
    result.point(v) = Space::Point_3(to_double(p.x()), to_double(p.y()), to_double(p.z()));
  }
  return result;
}

inline Coarse_mesh_quality measured(const Surface_map& map, const Space_mesh& fine,
                                    const Space_mesh& coarse)
{
  const Coarse_mesh_measurement measurement(map, fine, coarse);
  Coarse_mesh_quality result;
  result.distance_to_coarse = measurement.distance_to_coarse();
  result.distance_to_fine = measurement.distance_to_fine();
  result.flipped_faces = measurement.number_of_flipped_faces();
  result.degenerate_faces = measurement.number_of_degenerate_faces();
  result.self_intersections = measurement.number_of_self_intersections();
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicSimplificationRef
/// adds the coarse triangulation to a mesh of any type, as an ordinary mesh in space. Vertices are
/// at their positions on the fine level, edges are straight, and faces are flat.
///
/// The triangulation may have loops or several edges with the same ends. Then a copy of it is made
/// simplicial. Loops are split in the middle, and of several edges with the same ends all but the
/// shortest. Of two faces with the same corners, one gets a vertex inside. New vertices follow the
/// other vertices and lie on the fine level.
///
/// The coarse triangulation is close to the fine level in its lengths, not in space. Its faces can
/// be flipped, intersect, or have no area. The result counts such faces.
///
/// \tparam Graph a model of `MutableFaceGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param surface the surface after its simplification
/// \param fine the level before
/// \param out the mesh; elements that it has are kept
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{input_point_map}
///     \cgalParamDescription{the positions of the vertices of the fine level}
///     \cgalParamType{a readable property map with `Vertex_index` as key and a point of a kernel as
///                    value, such as `mesh.points()` of a `Surface_mesh` without garbage}
///     \cgalParamDefault{none: required}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the map that gets the positions of the vertices of `out`}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key}
///     \cgalParamDefault{`get(CGAL::vertex_point, out)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{parent_vertex_map}
///     \cgalParamDescription{gets the vertex of the fine level for each vertex of `out`, null for
///       inserted vertices}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key and `Vertex_index` as
///                    value}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{location_map}
///     \cgalParamDescription{gets the location on the fine level for each inserted vertex of `out`;
///       other vertices get a location with a null face}
///     \cgalParamType{a writable property map with a vertex of `Graph` as key and
///       `Surface_map::Location` as value}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \returns the distances of both surfaces in space, and the defects of the mesh
///
/// Complexity: linear in the elements and the history, and \f$O(n \log n)\f$ for distances and
/// intersections.
/// \throws Intrinsic_triangulations::Numerical_error if a new edge has no length because of
///   rounding; then `out` is not changed
template <typename Graph, typename NamedParameters>
Coarse_mesh_quality coarse_mesh(const Evolving_surface& surface, const Surface_level& fine,
                                Graph& out, const NamedParameters& np)
{
  namespace IT = Intrinsic_triangulations;
  typedef internal_np::input_point_map_t Tag;
  static_assert(IT::internal::has_parameter<NamedParameters, Tag>(),
                "input_point_map() is missing");
  const auto input = CGAL::parameters::get_parameter(np, Tag());
  Evolving_surface refined = surface;
  const std::size_t inserted =
    IT::is_simplicial(Surface_level(surface).mesh()) ? 0 : internal::make_simplicial(refined);
  const Surface_level coarse(refined);
  const Surface_map map(refined, fine, coarse);
  const std::vector<Surface_map::Location> locations =
    internal::locations_of_inserted_vertices(map);
  const auto points = internal::coarse_points(map, locations, input);

  typedef internal::Whole_triangulation Triangulation;
  const Triangulation triangulation{coarse.mesh()};
  const IT::Subdivision_part<Triangulation> part(triangulation);
  const IT::Copied_part copy(part, out);
  IT::write_points(
    part, copy, out, [&](Vertex_index v, const auto&) { return points[v.idx()]; }, np);
  const auto copied = [&](std::size_t n) { return copy.vertex(n); };
  IT::internal::put_parents<internal_np::parent_vertex_map_t>(
    np, part.vertices(), copied,
    [&](Vertex_index v, std::size_t) { return fine.level_vertex(coarse.surface_vertex(v)); });
  IT::internal::put_parents<internal_np::location_map_t>(
    np, part.vertices(), copied, [&](Vertex_index v, std::size_t) { return locations[v.idx()]; });

  Coarse_mesh_quality result = internal::measured(
    map, internal::mesh_in_space(fine.mesh(), [&](Vertex_index v) { return get(input, v); }),
    internal::mesh_in_space(coarse.mesh(), [&](Vertex_index v) { return points[v.idx()]; }));
  result.inserted_vertices = inserted;
  return result;
}

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_COARSE_MESH_H
