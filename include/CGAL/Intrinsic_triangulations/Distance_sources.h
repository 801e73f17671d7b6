// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DISTANCE_SOURCES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DISTANCE_SOURCES_H

#include <CGAL/license/Intrinsic_triangulations.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/Flat_face.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_view.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <typename FT>
class Heat_method;

struct Access_to_sources;

// Stores the data of a vertex about a source in one of its faces. These are the integral of its hat
// function over the source, and the distance within the face.
template <typename FT>
struct Vertex_and_source
{
  Vertex_index vertex;
  FT moment, distance;
};

// Stores a vertex, a point or a segment, and the corners of the face, edge or vertex that contains
// it.
template <typename FT>
struct Source_part
{
  FT length; // zero for a point
  std::vector<Vertex_and_source<FT>> corners;

  static Source_part at_vertex(Vertex_index v) { return {FT(0), {{v, FT(1), FT(0)}}}; }

  Vertex_index vertex() const { return corners.front().vertex; }
  bool is_vertex() const { return corners.size() == 1; }
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOperators
/// collects sources of distances: vertices, points on edges and in faces, and curves.
///
/// The object refers to the surface, which must not change as long as sources are added.
///
/// \tparam Surface a model of `IntrinsicSurface` with floating point lengths
template <typename Surface>
class Distance_sources
{
public:
  /// the number type of lengths.
  typedef Length_of<Surface> FT;

  /// makes an empty set of sources on a surface.
  explicit Distance_sources(const Surface& surface) : m_surface(internal::view_of(surface)) {}

  /// adds a vertex.
  /// \throws Invalid_input if the surface has no such vertex
  void add(Vertex_index v)
  {
    internal::check_point(v, m_surface.mesh());
    m_vertices.push_back(v);
    m_parts.push_back(internal::Source_part<FT>::at_vertex(v));
  }

  /// adds a point of a face, also on its boundary.
  /// \throws Invalid_input if the coordinates of `p` are negative or do not sum up to one
  void add(const Face_location<FT>& p) { add(Curve_segment<FT>{p.first, p.second, p.second}); }

  /// adds a vertex, a point on an edge, or a point of a face.
  /// \pre `p` is not an isolated vertex
  void add(const Surface_point<FT>& p) { add(face_location(p, m_surface.mesh())); }

  /// adds a point on an edge.
  void add(const Edge_point<FT>& p) { add(face_location(edge_location(p), m_surface.mesh())); }

  /// adds all points of a segment.
  /// \throws Invalid_input if the coordinates of an end are negative or do not sum up to one
  void add(const Curve_segment<FT>& segment)
  {
    internal::check_ends(segment, m_surface.mesh());
    m_curve.push_back(segment);
    const auto h = sides(segment.face, m_surface.mesh());
    const Flat_face<FT> face(h[0], m_surface);
    const FT length = internal::norm_of(face.between(segment.source, segment.target));
    m_parts.push_back({length, {}});
    for(std::size_t k = 0; k < 3; ++k)
      if(const FT weight = segment.source[k] + segment.target[k]; weight > 0)
        m_parts.back().corners.push_back(
          {m_surface.mesh().source(h[k]), (length > 0 ? length : FT(1)) * weight / 2,
           internal::distance_from_segment(face.to_corner(k, segment.source),
                                           face.to_corner(k, segment.target))});
  }

  /// adds all sources of another set on the surface.
  void add(const Distance_sources& other)
  {
    m_vertices.insert(m_vertices.end(), other.m_vertices.begin(), other.m_vertices.end());
    m_curve.insert(m_curve.end(), other.m_curve.begin(), other.m_curve.end());
    m_parts.insert(m_parts.end(), other.m_parts.begin(), other.m_parts.end());
  }

  /// adds all sources of a set on the same faces with lengths of another type.
  template <typename Other>
  void add(const Distance_sources<Other>& other)
  {
    add(other.m_vertices);
    add(converted_curve<FT>(other.m_curve));
  }

  /// adds all elements of a range of sources, such as a `Surface_curve`.
  template <typename Range, typename = decltype(std::begin(std::declval<const Range&>()))>
  void add(const Range& sources)
  {
    for(const auto& source : sources)
      add(source);
  }

private:
  template <typename Other>
  friend class Distance_sources;
  friend class internal::Heat_method<FT>;
  friend struct internal::Access_to_sources;

  Surface_view<Length_map_of<Surface>> m_surface;
  std::vector<Vertex_index> m_vertices;
  Surface_curve<FT> m_curve; // points are segments of length zero
  std::vector<internal::Source_part<FT>> m_parts;
};

namespace internal {

struct Access_to_sources
{
  template <typename Surface>
  static const std::vector<Vertex_index>& vertices(const Distance_sources<Surface>& sources)
  {
    return sources.m_vertices;
  }
  template <typename Surface>
  static const Surface_curve<Length_of<Surface>>& curve(const Distance_sources<Surface>& sources)
  {
    return sources.m_curve;
  }

  // Returns for each vertex whether its distance is zero.
  template <typename Surface>
  static std::vector<char> is_source(const Distance_sources<Surface>& sources)
  {
    std::vector<char> result(sources.m_surface.mesh().num_vertices(), 0);
    for(const auto& part : sources.m_parts)
      for(const auto& corner : part.corners)
        if(corner.distance == 0)
          result[corner.vertex.idx()] = 1;
    return result;
  }
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DISTANCE_SOURCES_H
