// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_INTRINSIC_SURFACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_INTRINSIC_SURFACE_H

#include <CGAL/license/Intrinsic_simplification.h>

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Euclidean_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/copy_input.h>
#include <CGAL/Intrinsic_triangulations/corner_formulas.h>

#include <CGAL/assertions.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <complex>
#include <vector>

namespace CGAL::Intrinsic_simplification {

using Intrinsic_triangulations::Delta_complex;
using Intrinsic_triangulations::Edge_index;
using Intrinsic_triangulations::Face_index;
using Intrinsic_triangulations::Halfedge_index;
using Intrinsic_triangulations::Vertex_index;

using Intrinsic_triangulations::first_outgoing_halfedge;
using Intrinsic_triangulations::for_each_outgoing_halfedge;
using Intrinsic_triangulations::next_around_source;
using Intrinsic_triangulations::opposite;
using Intrinsic_triangulations::pi;

/// \ingroup PkgIntrinsicSimplificationRef
/// a Delta-complex with edge lengths, and with the direction of every halfedge in the tangent space
/// of its source. Unlike in an `Intrinsic_triangulations::Intrinsic_triangulation`, lengths can be
/// changed.
///
/// Directions are complex numbers. At first they are the directions of
/// `Intrinsic_triangulations::Tangent_frames`, or in equal angles around a vertex whose rounded
/// angles are all zero. After a flip or a change of lengths, a halfedge gets a direction between
/// its two neighbors. The angles of the two corners determine the proportion. The frame of a vertex
/// does not change.
///
/// Memory besides the connectivity: 8 bytes for each edge and 16 for each halfedge.
/// \cgalModels `IntrinsicSurface`
class Intrinsic_surface
{
public:
  /// the geometry of the faces.
  typedef Intrinsic_triangulations::Euclidean_geometry_traits<double> Traits;
  /// the type of the input.
  typedef Intrinsic_triangulations::Intrinsic_triangulation<Traits> Triangulation;
  /// a readable property map from edges to their lengths.
  typedef boost::iterator_property_map<
    const double*, boost::typed_identity_property_map<Edge_index>, double, const double&>
    Length_map;

  /// copies the triangulation \f$T_2\f$ of `tri`, with its indices, lengths and constraints.
  /// Complexity: linear.
  /// \pre `tri` has no garbage
  explicit Intrinsic_surface(const Triangulation& tri)
  {
    namespace IT = Intrinsic_triangulations;
    CGAL_precondition(!tri.mesh().has_garbage());
    m_mesh.resize(tri.mesh().number_of_vertices(), tri.mesh().number_of_edges(),
                  tri.mesh().number_of_faces());
    IT::internal::copy_connectivity(tri.mesh(), IT::internal::Surface_mesh_numbering(), m_mesh);
    for(Edge_index e : m_mesh.edges()) {
      m_length.push_back(tri.length(e));
      if(tri.is_constrained(e)) {
        m_is_constrained.resize(m_mesh.num_edges(), 0);
        m_is_constrained[e] = 1;
      }
    }
    m_mesh.set_recycle_garbage(false);
    m_direction.resize(m_mesh.num_halfedges(), 1.);
    for(Vertex_index v : m_mesh.vertices())
      if(!m_mesh.is_isolated(v))
        set_frame(v);
  }

  /// \name Access
  /// @{

  /// returns the connectivity; removed elements leave gaps in the indices.
  const Delta_complex& mesh() const { return m_mesh; }

  /// returns the length of `e`.
  double length(Edge_index e) const { return m_length[e]; }
  /// returns the length of the edge of `h`.
  double length(Halfedge_index h) const { return m_length[m_mesh.edge(h)]; }
  /// returns the lengths of all edges.
  Length_map length_map() const { return Length_map(m_length.data()); }

  /// returns the direction in which `h` leaves its source, a number of absolute value one.
  const std::complex<double>& direction(Halfedge_index h) const { return m_direction[h]; }

  /// returns whether `e` is constrained.
  bool is_constrained(Edge_index e) const
  {
    return !m_is_constrained.empty() && m_is_constrained[e] != 0;
  }

  /// returns the angle at the source of `h` in its face.
  double corner_angle(Halfedge_index h) const
  {
    return Intrinsic_triangulations::corner_angle(length(m_mesh.next(h)), length(m_mesh.prev(h)),
                                                  length(h));
  }

  /// returns whether connectivity and constraints allow a flip of the edge of `h`.
  bool can_be_turned(Halfedge_index h) const
  {
    namespace IT = Intrinsic_triangulations;
    return IT::flip_status(h, m_mesh) == IT::Operation_status::possible &&
           !is_constrained(m_mesh.edge(h));
  }

  /// returns whether the edge of `h` can be turned, and its diamond is strictly convex.
  bool is_flippable(Halfedge_index h) const
  {
    return can_be_turned(h) && Traits::Is_convex()(diamond(h));
  }

  /// returns whether `e` is Delaunay (Equation 2.6), or cannot be turned.
  bool is_Delaunay(Edge_index e) const
  {
    const Halfedge_index h = m_mesh.halfedge(e);
    return Traits::Is_locally_Delaunay()(diamond(h)) || !can_be_turned(h);
  }

  /// returns the lengths around the edge of `h`.
  Intrinsic_triangulations::Diamond<double> diamond(Halfedge_index h) const
  {
    return Intrinsic_triangulations::diamond(length_map(), h, m_mesh);
  }

  /// @}
  /// \name Changes
  /// @{

  /// turns the edge of `h` into the other diagonal (see `Intrinsic_triangulations::flip_edge()`).
  /// Complexity: constant.
  /// \pre `can_be_turned(h)`
  void flip(Halfedge_index h, double new_length)
  {
    Intrinsic_triangulations::flip_edge(h, m_mesh);
    m_length[m_mesh.edge(h)] = new_length;
    place_between_neighbors(h);
    place_between_neighbors(opposite(h));
  }

  /// inserts a vertex into the face of `h` (see `Intrinsic_triangulations::split_face()`). It gets
  /// a frame in which the direction of the first outgoing halfedge is 1. Elements get new indices,
  /// never indices of removed elements. Complexity: constant, amortized.
  /// \param h a halfedge
  /// \param new_length the lengths of the edges from the vertex to the source and the target of `h`
  ///   and to the opposite corner
  /// \returns the halfedge from the vertex to the source of `h`
  Halfedge_index split_face(Halfedge_index h, const std::array<double, 3>& new_length)
  {
    const Halfedge_index a = m_mesh.next(Intrinsic_triangulations::split_face(h, m_mesh));
    add_data();
    Halfedge_index outgoing = a;
    for(double length : new_length) {
      set_length(m_mesh.edge(outgoing), length);
      outgoing = next_around_source(outgoing, m_mesh);
    }
    direct_edges(m_mesh.source(a));
    return a;
  }

  /// inserts a vertex into the boundary edge of `h`; otherwise as `split_face()`.
  /// \param h a halfedge that is not on the border; afterwards it leads from the vertex to its
  ///   target
  /// \param new_length the lengths of the edges from the vertex to the target and the source of `h`
  ///   and to the opposite corner
  /// \pre `opposite(h)` is a border halfedge
  void split_border_edge(Halfedge_index h, const std::array<double, 3>& new_length)
  {
    CGAL_precondition(!m_mesh.is_border(h) && m_mesh.is_border(opposite(h)));
    const Halfedge_index first = Intrinsic_triangulations::split_edge(h, m_mesh);
    add_data();
    set_direction(first, direction(h));
    set_length(m_mesh.edge(h), new_length[0]);
    set_length(m_mesh.edge(first), new_length[1]);
    set_length(m_mesh.edge(next_around_source(h, m_mesh)), new_length[2]);
    if(is_constrained(m_mesh.edge(h)))
      constrain(m_mesh.edge(first), true);
    direct_edges(m_mesh.source(h));
  }

  /// sets whether `e` is constrained.
  void constrain(Edge_index e, bool is_constrained)
  {
    if(is_constrained)
      m_is_constrained.resize(m_mesh.num_edges(), 0);
    if(!m_is_constrained.empty())
      m_is_constrained[e] = is_constrained ? 1 : 0;
  }

  /// changes the length of `e`; the direction of neither halfedge changes.
  void set_length(Edge_index e, double new_length) { m_length[e] = new_length; }

  /// changes the direction of `h`.
  void set_direction(Halfedge_index h, const std::complex<double>& z) { m_direction[h] = z; }

  /// directs `h` between its neighbors at its source, in the proportion of the angles of the two
  /// corners. The direction of a border edge does not change. Complexity: constant.
  void place_between_neighbors(Halfedge_index h)
  {
    const Halfedge_index o = opposite(h);
    if(m_mesh.is_border(h) || m_mesh.is_border(o))
      return;
    const Halfedge_index before = m_mesh.next(o), after = opposite(m_mesh.prev(h));
    const double right = corner_angle(before), left = corner_angle(h);
    const double gap = positive(std::arg(m_direction[after] * std::conj(m_direction[before])));
    if(right + left > 0) // degenerate corners give no proportion
      m_direction[h] = m_direction[before] * std::polar(1., gap * (right / (right + left)));
  }

  /// returns the connectivity, for operations that keep lengths and directions themselves.
  Delta_complex& mesh() { return m_mesh; }

  /// @}

private:
  // Extends the properties for new edges, which are not constrained.
  void add_data()
  {
    m_length.resize(m_mesh.num_edges());
    m_direction.resize(m_mesh.num_halfedges());
    if(!m_is_constrained.empty())
      m_is_constrained.resize(m_mesh.num_edges(), 0);
  }

  // Gives directions to both ends of the edges at the new vertex `v`.
  void direct_edges(Vertex_index v)
  {
    set_frame(v);
    for_each_outgoing_halfedge(v, m_mesh,
                               [&](Halfedge_index h) { place_between_neighbors(opposite(h)); });
  }

  // Gives directions to the outgoing halfedges of `v`, in the proportion of the angles between
  // them. If rounded angles are all zero, they give no proportion.
  void set_frame(Vertex_index v)
  {
    double corners = 0, sum = 0;
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      m_direction[h] = {sum, corners}; // the sums before `h`, in the place of its direction
      corners += m_mesh.is_border(h) ? 0 : 1;
      sum += m_mesh.is_border(h) ? 0 : corner_angle(h);
    });
    const double all = m_mesh.is_border(v) ? pi<double>() : 2 * pi<double>();
    for_each_outgoing_halfedge(v, m_mesh, [&](Halfedge_index h) {
      const double part = sum > 0 ? m_direction[h].real() / sum : m_direction[h].imag() / corners;
      set_direction(h, std::polar(1., all * part));
    });
  }

  // Returns the angle, shifted between 0, exclusive, and 2 pi, inclusive.
  static double positive(double angle) { return angle > 0 ? angle : angle + 2 * pi<double>(); }

  Delta_complex m_mesh;
  std::vector<double> m_length;
  std::vector<std::complex<double>> m_direction; // of each halfedge
  std::vector<char> m_is_constrained;            // of each edge; empty if none is
};

} // namespace CGAL::Intrinsic_simplification

#endif // CGAL_INTRINSIC_SIMPLIFICATION_INTRINSIC_SURFACE_H
