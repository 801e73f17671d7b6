// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_DISCRETE_CONFORMAL_MAP_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_DISCRETE_CONFORMAL_MAP_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Factorization_counts.h>
#include <CGAL/Discrete_conformal_maps/Map_promise.h>
#include <CGAL/Discrete_conformal_maps/Map_status.h>
#include <CGAL/Discrete_conformal_maps/Minimization.h>
#include <CGAL/Discrete_conformal_maps/Triple_subdivision.h>
#include <CGAL/Discrete_conformal_maps/internal/scale_factors/Ptolemy_surface.h>
#include <CGAL/Discrete_conformal_maps/internal/tolerances.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Decorated_length.h>
#include <CGAL/Intrinsic_triangulations/Hyperideal_geometry_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Discrete_conformal_maps {

namespace internal {

// The geometry of the image of a map.
enum class Image_geometry
{
  flat,
  hyperbolic, // scaled lengths are sinh(x/2) for hyperbolic lengths x
  spherical   // scaled lengths are chords of the unit sphere
};

// Holds the data of all maps.
struct Map_data
{
  typedef Intrinsic_triangulations::Hyperideal_geometry_traits<> Ideal_traits;

  Intrinsic_triangulations::Intrinsic_triangulation<> ab;
  Intrinsic_triangulations::Intrinsic_triangulation<Ideal_traits> bc;
  // These members refer to the triangulations, whose addresses do not change.
  std::unique_ptr<Intrinsic_triangulations::Correspondence<>> correspondence_ab;
  std::unique_ptr<Intrinsic_triangulations::Correspondence<Ideal_traits>> correspondence_bc;
  std::unique_ptr<Triple_subdivision<double>> subdivision;
  std::size_t number_of_original_faces = 0;
  std::vector<char> is_partly_original; // for each face of T_3
  std::vector<Vertex_index> input_vertex;
  std::vector<double> log_scale;
  std::array<std::size_t, 3> number_of_flips{0, 0, 0};
  Image_geometry geometry = Image_geometry::flat;
  std::shared_ptr<const Factorization_counts> counts = std::make_shared<Factorization_counts>();

  bool is_original(Face_index f) const { return f.idx() < number_of_original_faces; }
  bool is_original(Halfedge_index h) const
  {
    const Face_index f = subdivision->mesh().face(h);
    return f.is_valid() && is_original(subdivision->parent_face(Layer::A, f));
  }

  // Returns the scaled length of an edge of T_3. Before scale factors are normalized, it can be
  // beyond the range of `double`.
  template <typename FT = double>
  FT scaled_length(Halfedge_index h) const
  {
    if(bc.traits().has_radii())
      return FT(between_centers(scaled_decorated_length(h)));
    const double u = log_scale[bc.mesh().source(h).idx()] + log_scale[bc.mesh().target(h).idx()];
    return internal::scaled_length(FT(bc.length(bc.mesh().edge(h))), length_factor(FT(u)));
  }

  // Returns the length of an edge between centers of circles.
  template <typename FT>
  FT between_centers(const Intrinsic_triangulations::Decorated_length<FT>& edge) const
  {
    return geometry == Image_geometry::hyperbolic  ? edge.hyperbolic_length()
           : geometry == Image_geometry::spherical ? edge.spherical_length()
                                                   : edge.length();
  }

  // Returns the length of an edge of T_3 without scale factors.
  double length(Halfedge_index h) const
  {
    return bc.traits().has_radii() ? decorated_length(h).length() : bc.length(bc.mesh().edge(h));
  }

  // Returns the decorated length of an edge of T_3 without scale factors.
  // \pre vertices have circles
  Intrinsic_triangulations::Decorated_length<double> decorated_length(Halfedge_index h) const
  {
    return Intrinsic_triangulations::internal::decorated_lengths(bc.traits(), bc.length_map(),
                                                                 bc.mesh())(h);
  }

  // Returns the scaled decorated length of an edge.
  // \pre vertices have circles
  template <typename FT = double>
  Intrinsic_triangulations::Decorated_length<FT> scaled_decorated_length(Halfedge_index h) const
  {
    return scaled(Intrinsic_triangulations::internal::with_numbers<FT>(decorated_length(h)),
                  FT(log_scale[bc.mesh().source(h).idx()]),
                  FT(log_scale[bc.mesh().target(h).idx()]));
  }
};

// Holds the end of the search for a map, and the measurements on the result.
struct Map_outcome
{
  Map_status status = Map_status::not_converged;
  std::vector<Map_promise> promises;
  std::string cause;
  Minimization_result minimization;
  double max_curvature_error = 0;
  std::vector<Face_index> crowded_faces;
};

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsMaps
/// the common part of all discrete conformal maps: three triangulations with the correspondence of
/// each to the next, and scale factors (Section 4.2).
///
/// \f$T_1\f$ is the input. A component with boundary is doubled. Of its second copy, only the part
///   exists that edges of \f$T_2\f$ and \f$T_3\f$ across the boundary reach. Elements of its second
///   copy follow the elements of the input; the boundary is shared. \f$T_2\f$ is the intrinsic
///   Delaunay triangulation of \f$T_1\f$. \f$T_3\f$ is the ideal Delaunay triangulation of
///   \f$T_2\f$ with the scale factors. The paper writes \f$T^A\f$, \f$T^B\f$ and \f$T^C\f$.
class Discrete_conformal_map
{
public:
  /// the type of \f$T_1\f$ and \f$T_2\f$.
  typedef Intrinsic_triangulations::Intrinsic_triangulation<> Euclidean_triangulation;
  /// the geometry of \f$T_2\f$ and \f$T_3\f$ as one ideal polyhedron, or with circles at the
  /// vertices, a hyperideal one.
  typedef internal::Map_data::Ideal_traits Ideal_traits;
  /// the type of \f$T_2\f$ and \f$T_3\f$.
  typedef Intrinsic_triangulations::Intrinsic_triangulation<Ideal_traits> Ideal_triangulation;
  /// the common subdivision of all three.
  typedef Triple_subdivision<double> Subdivision;
  /// a point of the input.
  typedef Intrinsic_triangulations::Face_location<double> Face_location;

  /// \cond SKIP_IN_MANUAL
  Discrete_conformal_map() : Discrete_conformal_map(std::make_unique<internal::Map_data>()) {}
  explicit Discrete_conformal_map(std::unique_ptr<const internal::Map_data> data)
    : m_data(std::move(data))
  {}

  void set_outcome(internal::Map_outcome outcome) { m_outcome = std::move(outcome); }
  /// \endcond

  /// returns the pair of \f$T_1\f$, as `input()`, and \f$T_2\f$, as `intrinsic()`.
  const Euclidean_triangulation& Delaunay() const { return m_data->ab; }
  /// returns the pair of \f$T_2\f$, as `input()`, and \f$T_3\f$, as `intrinsic()`. Both have
  /// lengths for scale factors of zero. With circles these are lengths of tangents, see
  /// `Intrinsic_triangulations::Decorated_length`.
  const Ideal_triangulation& ideal() const { return m_data->bc; }
  /// returns the crossings of \f$T_1\f$ and \f$T_2\f$, the correspondence of `Delaunay()`.
  const Intrinsic_triangulations::Correspondence<>& Delaunay_correspondence() const
  {
    return *m_data->correspondence_ab;
  }
  /// returns the crossings of \f$T_2\f$ and \f$T_3\f$, the correspondence of `ideal()`.
  const Intrinsic_triangulations::Correspondence<Ideal_traits>& ideal_correspondence() const
  {
    return *m_data->correspondence_bc;
  }
  /// returns the triangulation `layer` as a model of `IntrinsicSurface`. Lengths of \f$T_3\f$ are
  /// for scale factors of zero.
  auto surface(Layer layer) const
  {
    return layer == Layer::A   ? m_data->ab.input()
           : layer == Layer::B ? m_data->ab.intrinsic()
                               : m_data->bc.intrinsic();
  }
  /// returns the common subdivision of \f$T_1\f$, \f$T_2\f$ and \f$T_3\f$, on the surface and the
  /// existing part of its second copy.
  const Subdivision& subdivision() const { return *m_data->subdivision; }

  /// returns whether the face `f` of \f$T_1\f$ belongs to the input, not to its second copy.
  bool is_original(Face_index f) const { return m_data->is_original(f); }

  /// returns whether `h`, a halfedge of `subdivision()`, is a side of a face that lies in the
  /// input, not in its second copy.
  bool is_original(Halfedge_index h) const { return m_data->is_original(h); }

  /// \deprecated Use `is_original()`.
  template <typename Index>
  [[deprecated("use is_original()")]] bool is_front(Index i) const
  {
    return is_original(i);
  }

  /// returns `v` if it is a vertex of the input, otherwise the vertex whose second copy it is.
  Vertex_index input_vertex(Vertex_index v) const { return m_data->input_vertex[v.idx()]; }

  /// returns the logarithmic scale factor at `v`.
  double log_scale(Vertex_index v) const { return m_data->log_scale[v.idx()]; }

  /// returns whether there are circles at the vertices: radii that are not all zero were given.
  bool has_radii() const { return m_data->bc.traits().has_radii(); }

  /// returns the radius of the circle at `v` in the image: \f$e^{u}\f$ times the radius that was
  /// given, or zero if no radii were given. For a hyperbolic map it is \f$\tanh(R)/2\f$ if \f$R\f$
  /// is the hyperbolic radius; on the sphere, \f$\tan R\f$ if \f$R\f$ is the angle of the circle.
  double scaled_radius(Vertex_index v) const
  {
    return has_radii() ? std::exp(log_scale(v)) * m_data->bc.traits().radius(v) : 0.;
  }

  /// returns the length of the edge of `h`, a halfedge of \f$T_3\f$, with the scale factors. For a
  /// hyperbolic map it is \f$\sinh(x/2)\f$ if \f$x\f$ is the hyperbolic length. On the sphere it is
  /// the length of a chord.
  double scaled_length(Halfedge_index h) const { return m_data->scaled_length(h); }

  /// returns whether the map keeps its promises, or the reason. It is `Map_status::success` if and
  /// only if all of `promises()` are kept.
  Map_status status() const { return m_outcome.status; }

  /// returns the promises of a map of this kind, with the errors measured on the result.
  const std::vector<Map_promise>& promises() const { return m_outcome.promises; }

  /// returns the message of the numerical error that ended the computation; empty if none has.
  const std::string& cause() const { return m_outcome.cause; }

  /// returns the outcome of the minimization of the energy.
  const Minimization_result& minimization() const { return m_outcome.minimization; }

  /// returns the numbers of factorizations of all stages: of cones, `Newton_minimizer` or
  /// `Bounded_Newton_minimizer`, and the layout. They share a fill-reducing order as long as it
  /// suits the flipped triangulation.
  const Factorization_counts& factorization_counts() const { return *m_data->counts; }

  /// returns the greatest difference of a curvature from its prescribed value, in radians.
  double max_curvature_error() const { return m_outcome.max_curvature_error; }

  /// returns the faces of the input with a part whose image is too small for positions of type
  /// `double`, in ascending order. Different corners of such a part have the same position, or its
  /// sides have wrong lengths, or it may be reversed in the Klein disk. Most maps have none.
  ///
  /// A long strip that is mapped to a disk has such faces: its ends shrink by a factor of
  /// \f$e^\pi\f$ for every square. This is known as crowding (\ref dcm_crowding). It is a property
  /// of the picture alone, and does not affect the scale factors, \f$T_3\f$ and the map to it.
  const std::vector<Face_index>& crowded_faces() const { return m_outcome.crowded_faces; }

  /// returns the number of flips from the previous triangulation to `layer`: from \f$T_1\f$ to
  /// \f$T_2\f$, or from \f$T_2\f$ to \f$T_3\f$. Zero for \f$T_1\f$.
  std::size_t number_of_flips(Layer layer) const
  {
    return m_data->number_of_flips[static_cast<std::size_t>(layer)];
  }

  /// returns the position of a point of the input on \f$T_3\f$: a face and weights of its corners,
  /// as in `Triple_subdivision::location()` (Section 4.2.3). A part of the face is in the input.
  /// The point is a `Face_location` or a `Surface_point` of `Intrinsic_triangulations`. Complexity:
  /// two calls of `Intrinsic_triangulations::point_across()` with a correspondence.
  template <typename Place = Face_location>
  Face_location place_on_C(const Place& p) const
  {
    using Intrinsic_triangulations::Side;
    const Face_location on_B = point_across(Delaunay_correspondence(), Side::input, p);
    return in_partly_original_face(point_across(ideal_correspondence(), Side::input, on_B));
  }

protected:
  /// \cond SKIP_IN_MANUAL
  // Returns the weights of the corners of a face of T_3 in homogeneous coordinates. If they exceed
  // the range of their type, they have another common factor.
  std::array<double, 3> homogeneous_weights(const Face_location& on_C) const
  {
    const auto side = sides(on_C.first, ideal().mesh());
    std::array<double, 3> u;
    for(std::size_t s = 0; s < 3; ++s)
      u[s] = log_scale(ideal().mesh().source(side[s]));
    const double least = (std::min)({u[0], u[1], u[2]});
    const double shift = std::abs(least) > internal::tolerance::narrow_log_scales ? least : 0;
    for(std::size_t s = 0; s < 3; ++s)
      u[s] = on_C.second[s] * std::exp(shift - u[s]);
    return u;
  }
  const internal::Map_data& data() const { return *m_data; }
  /// \endcond

private:
  // Returns a point of the input in a face of T_3 with a part in the input. A point of the boundary
  // is also in faces of the second copy. Rounding can move it away from the boundary, so the point
  // on the closest edge of its face is tried, and then the closest vertex.
  Face_location in_partly_original_face(Face_location p) const
  {
    using Intrinsic_triangulations::for_each_location;
    const auto is_found = [this](const Face_location& q) {
      return m_data->is_partly_original[q.first.idx()] != 0;
    };
    const Delta_complex& mesh = ideal().mesh();
    for(std::size_t corners = 2; corners > 0 && !is_found(p); --corners) {
      std::array<double, 3> order = p.second;
      std::sort(order.begin(), order.end());
      for(double& weight : p.second)
        weight = weight < order[3 - corners] ? 0 : weight;
      for_each_location(surface_point(p, mesh), mesh, [&](const Face_location& q) {
        if(!is_found(p) && is_found(q))
          p = q;
      });
    }
    return p;
  }

  std::unique_ptr<const internal::Map_data> m_data;
  internal::Map_outcome m_outcome;
};

} // namespace CGAL::Discrete_conformal_maps

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_DISCRETE_CONFORMAL_MAP_H
