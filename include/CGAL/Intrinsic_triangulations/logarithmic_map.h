// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LOGARITHMIC_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LOGARITHMIC_MAP_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Default_window_visitor.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Path_search.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Vertex_angles.h>
#include <CGAL/Intrinsic_triangulations/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <complex>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTangent
/// describes a shortest path.
enum class Logarithm_status
{
  straight,   ///< it is a straight line: the exponential map leads to its end, unless the line
              ///< touches the boundary or a vertex of negative curvature
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
  Logarithm_status status; ///< whether the shortest path bends
  std::complex<FT> vector; ///< the tangent vector with the first direction of the shortest path and
                           ///< its length, which is the distance; infinite if there is no path
};

namespace internal {

// Computes the directions in which shortest paths leave their sources.
template <typename EdgeLengthMap>
class Path_directions : public Path_search<EdgeLengthMap>
{
  typedef Path_search<EdgeLengthMap> Base;
  typedef typename Base::Charts Charts;
  typedef typename Base::Index Index;
  typedef typename Base::View View;
  typedef typename Base::Views Views;
  using Base::m_mesh;
  using Base::m_views;

public:
  typedef typename Base::FT FT;
  typedef typename Base::Vector Vector;
  typedef typename Base::Location Location;
  typedef typename Base::Last_part Last_part;

  using Base::at_vertex;
  using Base::to;

  explicit Path_directions(const Surface_view<EdgeLengthMap>& surface) : Base(surface) {}

  // Returns an outgoing halfedge of the source, or a halfedge of its face, and the direction of
  // the path in the frame of this halfedge.
  // \pre the path has a length that is positive and finite
  std::pair<Halfedge_index, Vector> start(Last_part part, const Location& q) const
  {
    Location end = q;
    for(; !m_views.is_source(part.origin); part = to(Vertex_index(part.origin)))
      end = at_vertex(Vertex_index(part.origin));
    if(part.view == Views::null && is_along_edge(part, end))
      return {part.last, Vector(1)};
    const auto result =
      part.view == Views::null ? start_in_face(part, end) : start_through_view(part);
    return m_views.is_vertex(part.origin) ? result : in_first_face(part.origin, result);
  }

private:
  // Returns the direction of side `c` in the frame of another side of its face.
  Vector direction_from(Index frame, Index c) const
  {
    const Charts& charts = m_views.charts();
    return c == frame                 ? Vector(1)
           : c == Charts::next(frame) ? -std::conj(charts.turn(c))
                                      : -charts.turn(frame);
  }

  bool is_along_edge(const Last_part& part, const Location& end) const
  {
    return m_views.is_vertex(part.origin) && vertex_at(end, m_mesh) != Delta_complex::null_vertex();
  }

  std::pair<Halfedge_index, Vector> start_through_view(const Last_part& part) const
  {
    const auto [root, z] = this->root_of(part.view, part.end, [](const View&, const Vector&) {});
    const Index frame =
      m_views.is_vertex(part.origin) ? Charts::previous(root.edge) : 3 * (root.edge / 3);
    return {Charts::halfedge(frame, m_mesh),
            (z - root.position) * direction_from(frame, root.edge)};
  }

  // Returns the start of a path that runs through one face only, from a corner or a source.
  std::pair<Halfedge_index, Vector> start_in_face(const Last_part& part, const Location& end) const
  {
    const Vertex_index v = vertex_at(end, m_mesh);
    const bool from_vertex = m_views.is_vertex(part.origin);
    const Halfedge_index h = from_vertex ? part.last : m_mesh.halfedge(m_mesh.face(part.last));
    const Flat_face<FT> face(h, m_views.surface());
    const Location q = v == Delta_complex::null_vertex()
                         ? end
                         : face_location(Edge_point<FT>{part.last, FT(1)}, m_mesh);
    const Location p = from_vertex ? face_location(Edge_point<FT>{h, FT(0)}, m_mesh)
                                   : m_views.origin(part.origin).source();
    return {h, face.between(coordinates_from(h, p, m_mesh), coordinates_from(h, q, m_mesh))};
  }

  // Transforms a direction at a source on an edge from the frame of either face to the frame of
  // the first.
  std::pair<Halfedge_index, Vector> in_first_face(Index origin,
                                                  std::pair<Halfedge_index, Vector> start) const
  {
    const Index first = m_views.origin(origin).first;
    if(first == origin)
      return start;
    const Location p = m_views.origin(first).source();
    const Index c = Charts::side_of(halfedge_of(surface_point(p, m_mesh)), m_mesh);
    const Index frame = 3 * p.first.idx(), o = m_views.charts().across(c);
    return {m_mesh.halfedge(p.first),
            -start.second * direction_from(frame, c) * std::conj(direction_from(3 * (o / 3), o))};
  }
};

// Computes the vector of a path. A source that is a vertex has a normalized frame.
template <typename EdgeLengthMap>
class Logarithm_of_path
{
  typedef Path_directions<EdgeLengthMap> Search;
  typedef typename Search::FT FT;

public:
  Logarithm_of_path(const Surface_view<EdgeLengthMap>& surface, bool from_vertex)
    : m_surface(surface), m_from_vertex(from_vertex)
  {}

  // Returns the logarithm of the path to `q`, whose last part is `part`.
  Logarithm<FT> operator()(const Search& search, const typename Search::Last_part& part,
                           const Face_location<FT>& q) const
  {
    if(part.length == std::numeric_limits<FT>::infinity())
      return {Logarithm_status::unreachable, part.length};
    const auto status = part.is_straight ? Logarithm_status::straight : Logarithm_status::bent;
    return {status, part.length > 0 ? std::polar(part.length, angle(search, part, q))
                                    : std::complex<FT>(0)};
  }

private:
  FT angle(const Search& search, const typename Search::Last_part& part,
           const Face_location<FT>& q) const
  {
    const auto [frame, direction] = search.start(part, q);
    const FT in_frame = std::arg(direction);
    return m_from_vertex ? Vertex_angles<FT>(frame, m_surface).normalized(in_frame) : in_frame;
  }

  Surface_view<EdgeLengthMap> m_surface;
  bool m_from_vertex;
};

// Adds a source to a search. Returns whether it is a vertex.
template <typename Source, typename Search>
bool add_valid_source(const Source& source, const Delta_complex& mesh, Search& search)
{
  return use_source(source, mesh, [&](const auto& p) {
    search.add_source(p);
    if constexpr(std::is_same<std::decay_t<decltype(p)>, Vertex_index>::value) {
      CGAL_precondition(!mesh.is_isolated(p));
      return true;
    } else {
      CGAL_precondition(vertex_at(p, mesh) == Delta_complex::null_vertex());
      return false;
    }
  });
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsTangent
/// computes the logarithmic map at `source`: the shortest tangent vector that leads to `target`. At
/// a vertex its angle is normalized as in `Tangent_frames`; at a point of a face `f` the real axis
/// is along `halfedge(f)`. For a point of an edge, it is the face of `face_location()`.
///
/// The path is shortest among all paths, and found from edge lengths alone (see `Shortest_paths`).
/// `trace_geodesic()` of the vector ends at `target`, unless the path bends at a vertex. Such a
/// vertex has an angle sum of more than \f$2\pi\f$, or of more than \f$\pi\f$ on the boundary. Of
/// several shortest paths, any is taken.
///
/// A straight path may touch such a vertex, with an angle of \f$\pi\f$ on one side.
/// `trace_geodesic()` halves the angle at the vertex, and leaves the path. A straight path may also
/// run along the boundary, and `At_boundary::slide` follows it.
///
/// Lengths are accurate to rounding for every face passed. A vector that passes close to a vertex
/// with curvature may be traced to the wrong side of it (see `trace_geodesic()`).
/// \param surface a model of `IntrinsicSurface` with floating point lengths; loops, parallel edges
///        and faces that meet themselves are allowed
/// \param source a vertex that is not isolated, a `Face_location` that is not at a vertex, an
///        `Edge_location` or a `Surface_point`
/// \param target a `Face_location`, an `Edge_location` or a `Surface_point`, with coordinates that
///        are not negative and sum up to one
///
/// Complexity: linear in the vertices, plus \f$O(k \log k)\f$ for \f$k\f$ windows up to the
/// distance of `target`. As a rule each face within that distance has some dozens.
/// \param np the visitor, as for `Shortest_paths::run()`
/// \throws Numerical_error if the angles at a vertex have no positive finite sum
template <typename Surface, typename Source, typename Target = Face_location<Length_of<Surface>>,
          typename NamedParameters = CGAL::parameters::Default_named_parameters,
          typename = internal::If_point<Target>>
Logarithm<Length_of<Surface>>
logarithmic_map(const Surface& surface, const Source& source, const Target& target,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  Default_window_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  const auto view = internal::view_of(surface);
  internal::Path_directions search(view);
  const internal::Logarithm_of_path logarithm(
    view, internal::add_valid_source(source, surface.mesh(), search));
  const auto& end = face_location(target, surface.mesh());
  search.run_to(end, visitor);
  return logarithm(search, search.to(end), end);
}

/// \ingroup PkgIntrinsicTriangulationsTangent
/// computes the logarithmic map at `source` of all vertices, in a vector by their index, with the
/// properties of the function for one point. Complexity: \f$O(k \log k)\f$ for \f$k\f$ windows.
/// \param surface, source as for one point
/// \param np the visitor, as for `Shortest_paths::run()`
/// \throws Numerical_error if the angles at a vertex have no positive finite sum
template <typename Surface, typename Source, typename T = bool,
          typename Tag = CGAL::internal_np::all_default_t,
          typename Base = CGAL::internal_np::No_property>
std::vector<Logarithm<Length_of<Surface>>> logarithmic_map(
  const Surface& surface, const Source& source,
  const CGAL::Named_function_parameters<T, Tag, Base>& np = CGAL::parameters::default_values())
{
  Default_window_visitor silent;
  auto&& visitor = internal::visitor_of(np, silent);
  const Delta_complex& mesh = surface.mesh();
  const auto view = internal::view_of(surface);
  internal::Path_directions search(view);
  const internal::Logarithm_of_path logarithm(view,
                                              internal::add_valid_source(source, mesh, search));
  search.run(search.unlimited_steps, visitor);
  typedef Length_of<Surface> FT;
  std::vector<Logarithm<FT>> result(mesh.num_vertices());
  for(Vertex_index v : mesh.vertices())
    if(mesh.is_isolated(v))
      result[v.idx()] = {Logarithm_status::unreachable, std::numeric_limits<FT>::infinity()};
    else
      result[v.idx()] = logarithm(search, search.to(v), search.at_vertex(v));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LOGARITHMIC_MAP_H
