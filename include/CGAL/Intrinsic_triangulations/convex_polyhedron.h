// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONVEX_POLYHEDRON_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONVEX_POLYHEDRON_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Polyhedron_certificate.h>
#include <CGAL/Intrinsic_triangulations/extrinsic_mesh.h>
#include <CGAL/Intrinsic_triangulations/internal/convex_polyhedron/Polyhedron_builder.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// the convex polyhedron that has a given surface, as a result of `convex_polyhedron()`. It is an
/// intrinsic triangulation of the surface, whose edges are straight lines on the polyhedron, with
/// the positions of its vertices.
class Convex_polyhedron
{
public:
  /// the kernel of the positions.
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  /// the type of positions.
  typedef Kernel::Point_3 Point;
  /// the type of the triangulation.
  typedef Intrinsic_triangulation<> Triangulation;

#ifndef DOXYGEN_RUNNING
  Convex_polyhedron(Triangulation triangulation, std::optional<double> tolerance)
    : m_triangulation(std::move(triangulation))
  {
    internal::Polyhedron_builder<Triangulation::Traits> built(m_triangulation, tolerance);
    m_points = built.points();
    m_flat_vertices = built.flat_vertices();
    m_kind = built.kind();
    m_certificate = built.certificate();
    m_max_edge_error = built.max_edge_error();
    m_last_curvature = built.last_curvature();
    m_newton_steps = built.newton_steps();
  }
#endif

  /// returns the triangulation: \f$T_1\f$ is the input, and the faces of \f$T_2\f$ are triangles
  /// of the polyhedron. So the correspondence of both, such as `Common_subdivision`, relates the
  /// input and the polyhedron.
  const Triangulation& triangulation() const { return m_triangulation; }

  /// returns the position of a vertex.
  const Point& point(Vertex_index v) const { return m_points[v.idx()]; }
  /// returns the positions of all vertices, by index.
  const std::vector<Point>& points() const { return m_points; }

  /// returns the vertices without curvature, which lie on faces and edges of the polyhedron.
  const std::vector<Vertex_index>& flat_vertices() const { return m_flat_vertices; }

  /// returns how convexity has been decided, and whether the polyhedron is a polygon.
  Polyhedron_kind kind() const { return m_kind; }

  /// returns whether the polyhedron is a polygon with two sides, in the plane \f$z = 0\f$.
  bool is_flat() const { return m_kind == Polyhedron_kind::polygon; }

  /// returns the results of exact predicates about the positions of vertices with curvature.
  const Polyhedron_certificate& certificate() const { return m_certificate; }

  /// returns the greatest difference between the length of an edge of \f$T_2\f$ on the surface and
  /// the distance of its ends, relative to the length.
  double max_edge_error() const { return m_max_edge_error; }

  /// returns the part of the curvature that was left at the apex at the end of the path. It is zero
  /// for a polygon that was found without a path.
  double last_curvature() const { return m_last_curvature; }

  /// returns the number of steps of Newton's method.
  std::size_t newton_steps() const { return m_newton_steps; }

  /// returns the polyhedron as a mesh with the elements of \f$T_2\f$, which keep their indices. A
  /// polygon with two sides can have parallel edges. Complexity: linear.
  Surface_mesh<Point> mesh() const
  {
    auto result = internal::mesh_with_connectivity<Point>(m_triangulation.mesh());
    for(Vertex_index v : m_triangulation.mesh().vertices())
      result.point(v) = point(v);
    return result;
  }

private:
  Triangulation m_triangulation;
  std::vector<Point> m_points;
  std::vector<Vertex_index> m_flat_vertices;
  Polyhedron_kind m_kind = Polyhedron_kind::convex;
  Polyhedron_certificate m_certificate;
  double m_max_edge_error = 0, m_last_curvature = 1;
  std::size_t m_newton_steps = 0;
};

/// \ingroup PkgIntrinsicTriangulationsPolyhedra
/// computes the convex polyhedron that has the surface of `g`. By Alexandrov's theorem exactly one
/// exists, up to motions, if the surface is a sphere and no vertex has negative curvature. It may
/// be a polygon with two sides. Vertices of zero curvature lie on its faces and edges.
///
/// Each result has been measured. An edge has its length up to a relative error of 1e-9, or of the
/// `curvature_tolerance` if it is greater. Rounding adds at most \f$2^{-50}\f$ of the largest
/// coordinate. `Convex_polyhedron::kind()` returns how convexity has been decided. An exception
/// reports that measurements confirm no result.
///
/// Distances of vertices determine a polygon with two sides, which is tried first. For others, the
/// pyramids over the triangles have a common apex \cgalCite{BI08}. Its distances from the
/// vertices begin large, and are followed until the edges to the apex have no curvature. The
/// triangulation is always weighted Delaunay for the squares of the distances. Then Newton's method
/// gives the edges their lengths in space, and concave edges are flipped. Derivatives have type
/// `double`; curvatures, lengths, and positions have twice as many digits.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`; a Delta-complex is allowed
/// \tparam NamedParameters a sequence of named parameters
/// \param g a triangulated sphere
/// \param np
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the positions of the vertices, whose distances are the edge lengths;
///       the surface need not be convex}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, g)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_length_map}
///     \cgalParamDescription{the lengths of the edges themselves; no positions are needed then}
///     \cgalParamType{a model of `ReadablePropertyMap` with value type convertible to `double`}
///     \cgalParamDefault{unused}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_tolerance}
///     \cgalParamDescription{the curvature in radians, positive or negative, up to which a vertex
///       counts as flat}
///     \cgalParamType{convertible to `double`}
///     \cgalParamDefault{the rounding error of curvatures, from positions if there are any; if no
///       polyhedron is found with it, the error from lengths}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: some dozens of factorizations of a sparse matrix with as many rows as vertices, and
/// more steps for thin polyhedra.
/// \throws Invalid_input if `g` is not a triangulated sphere
/// \throws Negative_curvature if vertices have negative curvature
/// \throws Numerical_error if measurements confirm neither a polyhedron nor a polygon
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Convex_polyhedron convex_polyhedron(const Graph& g,
                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef internal_np::curvature_tolerance_t Tag;
  std::optional<double> tolerance;
  if constexpr(internal::has_parameter<NamedParameters, Tag>())
    tolerance = CGAL::parameters::get_parameter(np, Tag());
  return Convex_polyhedron(Intrinsic_triangulation<>(g, np), tolerance);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONVEX_POLYHEDRON_H
