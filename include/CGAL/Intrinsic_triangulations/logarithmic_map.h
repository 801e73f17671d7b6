// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LOGARITHMIC_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LOGARITHMIC_MAP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/side_access.h>

#include <CGAL/assertions.h>
#include <boost/property_map/property_map.hpp>

#include <complex>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// says what a shortest path is like.
enum class Logarithm_status
{
  straight,   ///< it is a straight line: the exponential map leads to its end
  bent,       ///< it bends at a vertex, and no straight line to its end is as short
  unreachable ///< there is none
};

/// \ingroup PkgIntrinsicTriangulationsTangent
/// returns a short sentence for `status`.
inline const char* to_string(Logarithm_status status)
{
  switch(status) {
    case Logarithm_status::straight: return "the shortest path is straight";
    case Logarithm_status::bent: return "the shortest path bends at a vertex";
    case Logarithm_status::unreachable: return "the point is on another component";
  }
  return "unknown";
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// a value of the logarithmic map.
template <typename FT>
struct Logarithm
{
  Logarithm_status status; ///< what the shortest path is like
  std::complex<FT> vector; ///< the tangent vector with the first direction of the shortest path and
                           ///< its length, which is the distance; infinite if there is no path
};

namespace internal {

// Gives a path a vector; a source that is a vertex has a normalized frame.
template <typename EdgeLengthMap>
class Logarithm_of_path
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  typedef typename Shortest_paths<EdgeLengthMap>::Path Path;

public:
  Logarithm_of_path(bool from_vertex, const Delta_complex& mesh, const EdgeLengthMap& length)
    : m_from_vertex(from_vertex), m_mesh(mesh), m_length(length)
  {}

  Logarithm<FT> operator()(const Path& path) const
  {
    if(path.length == std::numeric_limits<FT>::infinity())
      return {Logarithm_status::unreachable, path.length};
    const auto status = path.is_straight ? Logarithm_status::straight : Logarithm_status::bent;
    return {status, path.length > 0 ? std::polar(path.length, angle(path)) : std::complex<FT>(0)};
  }

private:
  FT angle(const Path& path) const
  {
    const FT in_frame = std::arg(path.direction);
    return m_from_vertex ? Vertex_angles<FT>(path.frame, m_mesh, m_length).normalized(in_frame)
                         : in_frame;
  }

  bool m_from_vertex;
  const Delta_complex& m_mesh;
  const EdgeLengthMap& m_length;
};

// The vertex where `p` is; null if it is none.
template <typename FT>
Vertex_index vertex_at(const Face_location<FT>& p, const Delta_complex& mesh)
{
  for(std::size_t s = 0; s < 3; ++s)
    if(p.second[(s + 1) % 3] == 0 && p.second[(s + 2) % 3] == 0)
      return mesh.source(sides(p.first, mesh)[s]);
  return Delta_complex::null_vertex();
}

inline bool is_vertex(Vertex_index, const Delta_complex&) { return true; }

template <typename FT>
bool is_vertex(const Face_location<FT>& p, const Delta_complex& mesh)
{
  return vertex_at(p, mesh) != Delta_complex::null_vertex();
}

// `source` is a vertex or a point that is none.
template <typename Source, typename EdgeLengthMap, typename FT>
Logarithm<FT> logarithm_at(const Source& source, const Face_location<FT>& target,
                           const Delta_complex& mesh, const EdgeLengthMap& length)
{
  typedef Shortest_paths<EdgeLengthMap> Paths;
  const Logarithm_of_path<EdgeLengthMap> logarithm(is_vertex(source, mesh), mesh, length);
  const Vertex_index v = vertex_at(target, mesh);
  const bool to_vertex = v != Delta_complex::null_vertex();
  Paths paths(mesh, length, to_vertex ? Face_location<FT>() : target);
  paths.start_at(source);
  return logarithm(to_vertex ? paths.path_to(v) : paths.path_to_target());
}

template <typename Source, typename EdgeLengthMap>
auto logarithms_at(const Source& source, const Delta_complex& mesh, const EdgeLengthMap& length)
{
  typedef typename boost::property_traits<EdgeLengthMap>::value_type FT;
  Shortest_paths<EdgeLengthMap> paths(mesh, length);
  paths.start_at(source);
  paths.run();
  const Logarithm_of_path<EdgeLengthMap> logarithm(is_vertex(source, mesh), mesh, length);
  std::vector<Logarithm<FT>> result(mesh.num_vertices());
  for(Vertex_index v : mesh.vertices())
    result[v.idx()] = logarithm(paths[v]);
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the logarithmic map at the vertex `v`: the shortest tangent vector that leads to `target`, with
/// an angle normalized as in `Tangent_frames`.
///
/// The shortest path is found among all, by unfolding faces along the views from `v`, from edge
/// lengths alone. `trace_geodesic()` of the vector ends at `target`, unless the path bends: at a
/// vertex with an angle sum of more than \f$2\pi\f$, or of more than \f$\pi\f$ on the boundary.
/// Behind such a vertex there may be points to which no straight line leads. A straight path may
/// touch the boundary, where `At_boundary::slide` leads on. Of several shortest paths any one is
/// taken.
///
/// Lengths are accurate to rounding for every face passed. A vector that passes close to a vertex
/// with curvature may be traced to the wrong side of it (see `trace_geodesic()`).
/// \param v the vertex, not isolated
/// \param target a point with barycentric coordinates that are not negative and sum up to one
/// \param mesh a triangulated surface; loops, parallel edges and faces that meet themselves are
///   welcome
/// \param length a readable property map from its edges to their lengths, floating point numbers
/// Complexity: linear in the vertices for initialization, and \f$O(k \log k)\f$ for \f$k\f$ views
/// up to the distance of `target`; these can be quadratic in the number of faces or more, but tend
/// to be some dozens for each face within that distance.
/// \throws Numerical_error if the angles at a vertex have no positive finite sum
template <typename EdgeLengthMap>
Logarithm<typename boost::property_traits<EdgeLengthMap>::value_type> logarithmic_map(
  Vertex_index v,
  const Face_location<typename boost::property_traits<EdgeLengthMap>::value_type>& target,
  const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(!mesh.is_isolated(v));
  return internal::logarithm_at(v, target, mesh, length);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same at the point `p` of a face, with a vector in the frame of this face, whose real axis is
/// along `halfedge(p.first)`.
/// \param p a point that is no vertex, with coordinates as those of `target`
/// \param target, mesh, length as above
template <typename EdgeLengthMap>
Logarithm<typename boost::property_traits<EdgeLengthMap>::value_type> logarithmic_map(
  const Face_location<typename boost::property_traits<EdgeLengthMap>::value_type>& p,
  const Face_location<typename boost::property_traits<EdgeLengthMap>::value_type>& target,
  const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(!internal::is_vertex(p, mesh));
  return internal::logarithm_at(p, target, mesh, length);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the logarithmic map at the vertex `v` of all vertices, in a vector by their index; otherwise as
/// above.
template <typename EdgeLengthMap>
std::vector<Logarithm<typename boost::property_traits<EdgeLengthMap>::value_type>>
logarithmic_map(Vertex_index v, const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(!mesh.is_isolated(v));
  return internal::logarithms_at(v, mesh, length);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the logarithmic map at the point `p` of all vertices, in a vector by their index; otherwise as
/// above.
template <typename EdgeLengthMap>
std::vector<Logarithm<typename boost::property_traits<EdgeLengthMap>::value_type>>
logarithmic_map(const Face_location<typename boost::property_traits<EdgeLengthMap>::value_type>& p,
                const Delta_complex& mesh, const EdgeLengthMap& length)
{
  CGAL_precondition(!internal::is_vertex(p, mesh));
  return internal::logarithms_at(p, mesh, length);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same of one point on one of the two triangulations of `tri`, at a vertex.
template <typename Traits>
Logarithm<typename Traits::FT> logarithmic_map(Side side, Vertex_index v,
                                               const Face_location<typename Traits::FT>& target,
                                               const Intrinsic_triangulation<Traits>& tri)
{
  return logarithmic_map(v, target, internal::mesh_of(side, tri), internal::lengths_of(side, tri));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same of one point on one of the two triangulations of `tri`, at a point of a face.
template <typename Traits>
Logarithm<typename Traits::FT> logarithmic_map(Side side,
                                               const Face_location<typename Traits::FT>& p,
                                               const Face_location<typename Traits::FT>& target,
                                               const Intrinsic_triangulation<Traits>& tri)
{
  return logarithmic_map(p, target, internal::mesh_of(side, tri), internal::lengths_of(side, tri));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same of all vertices on one of the two triangulations of `tri`, at a vertex.
template <typename Traits>
std::vector<Logarithm<typename Traits::FT>>
logarithmic_map(Side side, Vertex_index v, const Intrinsic_triangulation<Traits>& tri)
{
  return logarithmic_map(v, internal::mesh_of(side, tri), internal::lengths_of(side, tri));
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// the same of all vertices on one of the two triangulations of `tri`, at a point of a face.
template <typename Traits>
std::vector<Logarithm<typename Traits::FT>>
logarithmic_map(Side side, const Face_location<typename Traits::FT>& p,
                const Intrinsic_triangulation<Traits>& tri)
{
  return logarithmic_map(p, internal::mesh_of(side, tri), internal::lengths_of(side, tri));
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LOGARITHMIC_MAP_H
