// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_H
#define CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_H

#include <CGAL/license/Discrete_conformal_maps.h>

#include <CGAL/Discrete_conformal_maps/Newton_minimizer.h>
#include <CGAL/Discrete_conformal_maps/Planar_conformal_map.h>
#include <CGAL/Discrete_conformal_maps/internal/Chart_packing.h>
#include <CGAL/Discrete_conformal_maps/internal/Flat_layout.h>
#include <CGAL/Discrete_conformal_maps/internal/Scale_factors.h>
#include <CGAL/Discrete_conformal_maps/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Discrete_conformal_maps {

/// \ingroup PkgDiscreteConformalMapsFlat
/// a part of the work of `flatten()`.
enum class Flattening_stage
{
  cones,     ///< cones are placed
  optimize,  ///< scale factors are computed
  trace,     ///< the triangulations are traced over each other
  subdivide, ///< their common subdivision is made
  layout     ///< faces are laid out in the plane
};

/// \ingroup PkgDiscreteConformalMapsFlat
/// a visitor that does nothing.
///
/// \cgalModels `FlatteningVisitor`
struct Default_flattening_visitor : Default_minimization_visitor
{
  /// is called when a part of the work begins.
  void start(Flattening_stage /* stage */) {}
};

namespace internal {

// The steps from a doubled problem to a map.
template <typename Visitor>
class Flattening
{
  typedef Planar_conformal_map::Ideal_triangulation Ideal_triangulation;
  typedef Intrinsic_triangulations::Diamond<double> Diamond;

public:
  Flattening(Doubled_problem& problem, std::size_t number_of_front_faces, Visitor& visitor)
    : m_problem(problem), m_visitor(visitor), m_scale(problem)
  {
    m_data = m_map.m_data.get();
    m_data->number_of_front_faces = number_of_front_faces;
  }

  // by the vertices of the input
  void start_from(const std::vector<double>& log_scale) { m_scale.start_from(log_scale); }

  // Cones are placed for a finite `bound` of scale factors.
  template <typename Minimizer>
  void find_scale_factors(const Minimizer& minimizer, double bound)
  {
    m_visitor.start(Flattening_stage::cones);
    const bool is_bounded = bound < std::numeric_limits<double>::infinity();
    if(is_bounded)
      m_scale.place_cones(bound);
    m_problem.check();
    m_visitor.start(Flattening_stage::optimize);
    do
      m_scale.minimize(minimizer, 1e-11, m_visitor);
    while(is_bounded && m_scale.add_cone_if_beyond(bound));
    m_data->status = m_scale.status();
    m_data->cones = m_scale.cones();
    m_data->minimization = m_scale.result();
    m_data->max_curvature_error = m_scale.max_curvature_error();
  }

  Planar_conformal_map finish()
  {
    m_visitor.start(Flattening_stage::trace);
    make_ideal_Delaunay();
    m_visitor.start(Flattening_stage::subdivide);
    m_data->subdivision = std::make_unique<Planar_conformal_map::Subdivision>(
      *m_data->correspondence_ab, *m_data->correspondence_bc);
    m_visitor.start(Flattening_stage::layout);
    find_walls();
    m_data->has_layout = m_scale.has_layout();
    if(m_data->has_layout)
      lay_out();
    else
      leave_out();
    return std::move(m_map);
  }

private:
  // ---- Triangulations ----

  void make_ideal_Delaunay()
  {
    const auto& u = m_scale.values();
    m_data->log_scale.assign(u.data(), u.data() + u.size());
    for(Vertex_index v : m_problem.triangulation().mesh().vertices())
      m_data->input_vertex.push_back(m_problem.front(v));
    m_data->ab = std::move(m_problem.triangulation());
    m_data->number_of_flips[1] = m_problem.number_of_flips();
    m_data->bc = Ideal_triangulation(
      m_data->ab.mesh(),
      Intrinsic_triangulations::parameters::edge_length_map(m_data->ab.length_map()));
    if(m_problem.flipping() == Flipping::to_Delaunay)
      flip_to_Delaunay();
    m_data->number_of_flips[2] = m_flips.size();
    m_data->correspondence_ab =
      std::make_unique<Intrinsic_triangulations::Correspondence<>>(m_data->ab);
    m_data->correspondence_bc = std::make_unique<
      Intrinsic_triangulations::Correspondence<Planar_conformal_map::Ideal_traits>>(m_data->bc);
  }

  const Delta_complex& mesh() const { return m_data->bc.mesh(); }

  double scaled_length(Halfedge_index h) const
  {
    const double u =
      m_data->log_scale[mesh().source(h).idx()] + m_data->log_scale[mesh().target(h).idx()];
    return m_data->bc.length(mesh().edge(h)) * std::exp(u / 2);
  }

  bool is_Delaunay(Halfedge_index h) const
  {
    const Halfedge_index o = mesh().opposite(h);
    const Diamond diamond{scaled_length(h), scaled_length(mesh().next(h)),
                          scaled_length(mesh().prev(h)), scaled_length(mesh().next(o)),
                          scaled_length(mesh().prev(o))};
    return m_data->bc.traits().is_locally_Delaunay_object()(diamond) ||
           flip_status(h, mesh()) != Intrinsic_triangulations::Operation_status::possible;
  }

  void flip_to_Delaunay()
  {
    Intrinsic_triangulations::internal::Edge_stack stack(mesh().num_edges());
    for(Edge_index e : mesh().edges())
      stack.push(e);
    while(!stack.empty()) {
      const Halfedge_index h(2 * stack.pop().idx()), o = mesh().opposite(h);
      if(is_Delaunay(h))
        continue;
      for(Halfedge_index x : {mesh().next(h), mesh().prev(h), mesh().next(o), mesh().prev(o)})
        stack.push(mesh().edge(x));
      m_data->bc.flip(h);
      m_flips.push_back(h);
    }
  }

  // ---- Layout ----

  // On a doubled surface, only edges of T^C with a part inside the input are passed.
  void find_walls()
  {
    m_is_wall.assign(mesh().num_edges(), 1);
    const auto& subdivision = *m_data->subdivision;
    const auto is_front = [&](Halfedge_index h) {
      const Face_index f = subdivision.mesh().face(h);
      return f.is_valid() && m_map.is_front(subdivision.parent_face(Layer::A, f));
    };
    for(Edge_index e : subdivision.mesh().edges())
      if(const Edge_index c = subdivision.parent_edge(Layer::C, e); c.is_valid())
        if(is_front(subdivision.mesh().halfedge(e)) &&
           is_front(subdivision.mesh().opposite(subdivision.mesh().halfedge(e))))
          m_is_wall[c.idx()] = 0;
    m_data->is_laid_out.assign(mesh().num_faces(), 0);
    for(Face_index f : subdivision.mesh().faces())
      if(m_map.is_front(subdivision.parent_face(Layer::A, f)))
        m_data->is_laid_out[subdivision.parent_face(Layer::C, f).idx()] = 1;
  }

  // the vertices around which faces do not close up: those with prescribed values, and ends of walls
  std::vector<char> terminals() const
  {
    std::vector<char> result = m_problem.is_fixed();
    const auto target = m_problem.target_defect();
    for(Vertex_index v : mesh().vertices())
      result[v.idx()] =
        !mesh().is_isolated(v) && (result[v.idx()] || target[Eigen::Index(v.idx())] != 0);
    for(Edge_index e : mesh().edges())
      if(m_is_wall[e.idx()])
        result[mesh().vertex(e, 0).idx()] = result[mesh().vertex(e, 1).idx()] = 1;
    return result;
  }

  std::size_t component(Face_index f) const
  {
    return m_problem.components()[mesh().target(mesh().halfedge(f)).idx()];
  }

  // the area of each component, for these lengths of halfedges
  template <typename Length>
  std::vector<double> areas(const Delta_complex& complex, const Length& length) const
  {
    std::vector<double> result(m_problem.components().size(), 0);
    for(Face_index f : complex.faces()) {
      const auto h = Intrinsic_triangulations::internal::sides(f, complex);
      result[m_problem.components()[complex.target(h[0]).idx()]] +=
        std::sqrt(Intrinsic_triangulations::squared_quadrupled_area(length(h[0]), length(h[1]),
                                                                    length(h[2]))) /
        4;
    }
    return result;
  }

  // What is to be added to the scale factors at each vertex: nothing, or where none are prescribed, what
  // keeps the area of the component.
  std::vector<double> area_correction() const
  {
    const std::vector<double> flat =
      areas(mesh(), [&](Halfedge_index h) { return scaled_length(h); });
    const std::vector<double> curved = areas(m_data->ab.mesh(), [&](Halfedge_index h) {
      return m_data->ab.length(m_data->ab.mesh().edge(h));
    });
    const std::vector<std::size_t> fixed = m_problem.number_of_fixed();
    std::vector<double> result(m_problem.size(), 0);
    for(std::size_t v = 0; v < result.size(); ++v)
      if(const std::size_t c = m_problem.components()[v]; fixed[c] == 0)
        result[v] = std::log(curved[c] / flat[c]) / 2;
    return result;
  }

  void lay_out()
  {
    const std::vector<double> correction = area_correction();
    if(m_scale.is_extended())
      lay_out(m_scale.extended_values(), correction);
    else
      lay_out(std::vector<double>(m_data->log_scale), correction);
    arrange_charts();
  }

  void leave_out()
  {
    m_data->is_laid_out.assign(mesh().num_faces(), 0);
    m_data->position.assign(mesh().num_halfedges(), 0);
    m_data->is_seam.assign(mesh().num_edges(), 1);
  }

  template <typename FT>
  void lay_out(std::vector<FT> u, const std::vector<double>& correction)
  {
    for(std::size_t v = 0; v < u.size(); ++v) {
      u[v] += FT(correction[v]);
      m_data->log_scale[v] += correction[v];
    }
    std::vector<double> length(mesh().num_edges());
    for(Edge_index e : mesh().edges())
      length[e.idx()] = scaled_length(Halfedge_index(2 * e.idx()));
    const Cut_graph cut(mesh(), length, m_is_wall, m_data->is_laid_out, terminals());
    const std::vector<FT> exact = scaled_lengths(u);
    const Flat_layout<FT> layout(mesh(), exact, cut);
    for(Halfedge_index h : mesh().halfedges())
      m_data->position.push_back(layout.position(h));
    for(Edge_index e : mesh().edges())
      m_data->is_seam.push_back(cut.is_seam(e));
  }

  // The charts of different components side by side. What lies beyond the boundary does not count.
  void arrange_charts()
  {
    const auto& subdivision = *m_data->subdivision;
    std::vector<std::vector<std::complex<double>>> points(m_problem.components().size());
    for(Halfedge_index h : subdivision.mesh().halfedges()) {
      const Face_index f = subdivision.mesh().face(h);
      if(!f.is_valid() || !m_map.is_front(subdivision.parent_face(Layer::A, f)))
        continue;
      const auto z = m_map.homogeneous_coordinates(subdivision.place_on_C(h));
      points[component(subdivision.parent_face(Layer::C, f))].emplace_back(z[0] / z[2],
                                                                           z[1] / z[2]);
    }
    const Chart_packing packing(points);
    for(Halfedge_index h : mesh().halfedges())
      m_data->position[h.idx()] =
        packing.motion(component(mesh().face(h)))(m_data->position[h.idx()]);
  }

  // of the edges of T^C, by the same flips in the precision of the scale factors
  template <typename FT>
  std::vector<FT> scaled_lengths(const std::vector<FT>& u) const
  {
    using std::exp;
    const Intrinsic_triangulations::Ideal_geometry_traits<FT> traits;
    Delta_complex b = m_data->bc.input_mesh();
    std::vector<FT> length(b.num_edges());
    for(Edge_index e : b.edges())
      length[e.idx()] = FT(m_data->bc.input_length(e));
    const auto of = [&](Halfedge_index h) { return length[Edge_index(h).idx()]; };
    for(Halfedge_index h : m_flips) {
      const Halfedge_index o = b.opposite(h);
      length[Edge_index(h).idx()] = traits.compute_flipped_length_object()(
        {of(h), of(b.next(h)), of(b.prev(h)), of(b.next(o)), of(b.prev(o))});
      flip_edge(h, b);
    }
    for(Edge_index e : b.edges())
      length[e.idx()] *= exp((u[b.vertex(e, 0).idx()] + u[b.vertex(e, 1).idx()]) / 2);
    return length;
  }

  Doubled_problem& m_problem;
  Visitor& m_visitor;
  Scale_factors m_scale;
  Planar_conformal_map m_map;
  Planar_conformal_map::Data* m_data;
  std::vector<Halfedge_index> m_flips; // from T^B to T^C
  std::vector<char> m_is_wall;         // edges of T^C that are not passed
};

// What is prescribed where the caller says nothing: flat inside, not scaled on the boundary.
template <typename Graph, typename NamedParameters>
std::vector<Vertex_condition> vertex_conditions(const Graph& g, const Delta_complex& mesh,
                                                const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  std::vector<Vertex_condition> result(mesh.num_vertices());
  constexpr bool has_map =
    !CGAL::parameters::is_default_parameter<NamedParameters,
                                            internal_np::vertex_condition_map_t>::value;
  if constexpr(has_map) {
    std::size_t number = 0;
    for(auto v : vertices(g))
      result[number++] = get(get_parameter(np, internal_np::vertex_condition_map), v);
  } else
    for(Vertex_index v : mesh.vertices())
      if(!mesh.is_isolated(v) && mesh.is_border(v))
        result[v.idx()] = Vertex_condition::log_scale(0);
  return result;
}

// those to start from
template <typename Graph, typename NamedParameters>
std::vector<double> initial_log_scales(const Graph& g, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  std::vector<double> result;
  for([[maybe_unused]] auto v : vertices(g))
    if constexpr(CGAL::parameters::is_default_parameter<
                   NamedParameters, internal_np::initial_log_scale_map_t>::value)
      result.push_back(0);
    else
      result.push_back(get(get_parameter(np, internal_np::initial_log_scale_map), v));
  return result;
}

} // namespace internal

/// \ingroup PkgDiscreteConformalMapsFlat
/// maps a surface to the plane, discretely conformally (Section 4.3).
///
/// The faces of the result are flat. Its cones are the vertices with a curvature that is not zero. There are
/// none on a torus without conditions; elsewhere there must be some, which are prescribed or placed
/// greedily.
///
/// The result says how that has ended (`Planar_conformal_map::status()`); without convergence, it has the best
/// scale factors that have been found.
///
/// \tparam Graph a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
/// \param g a manifold triangle mesh of any genus, with or without boundary, with any number of components
/// \param np the parameters of `Intrinsic_triangulations::Intrinsic_triangulation`, and
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_condition_map}
///     \cgalParamDescription{what is prescribed at each vertex}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `Vertex_condition` as value}
///     \cgalParamDefault{curvature zero inside, a logarithmic scale factor of zero on the boundary}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_log_scale}
///     \cgalParamDescription{cones without scaling are placed until all logarithmic scale factors are at most
///                           so great; infinity for none}
///     \cgalParamType{`double`}
///     \cgalParamDefault{5 if there is no `vertex_condition_map`, otherwise infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimizer}
///     \cgalParamDescription{what minimizes the energy}
///     \cgalParamType{a model of `ConvexMinimizer`}
///     \cgalParamDefault{`Newton_minimizer`}
///   \cgalParamNEnd
///   \cgalParamNBegin{initial_log_scale_map}
///     \cgalParamDescription{where the minimization starts: the nearer the result, the fewer steps it takes}
///     \cgalParamType{a readable property map with a vertex of `g` as key and `double` as value}
///     \cgalParamDefault{zero everywhere}
///   \cgalParamNEnd
///   \cgalParamNBegin{flipping}
///     \cgalParamDescription{whether triangulations follow the scale factors. In a fixed triangulation, the scale
///                           factors are those of Springborn, Schr&ouml;der and Pinkall (2008): they exist only
///                           sometimes, which `Planar_conformal_map::status()` tells, and depend on how the
///                           surface is triangulated}
///     \cgalParamType{`Flipping`}
///     \cgalParamDefault{`Flipping::to_Delaunay`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is told the progress; an exception that it throws stops the work}
///     \cgalParamType{a model of `FlatteningVisitor`; use `std::ref()` to pass an object with a state}
///     \cgalParamDefault{`Default_flattening_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// Complexity: for each step of the minimization, that of a sparse Cholesky factorization; beyond that
/// \f$O(n \log n)\f$ in the vertices and crossings.
/// \throws Intrinsic_triangulations::Invalid_input if `g` is no valid input, or what is prescribed cannot
///         be: the error says where, and for curvatures the excess
/// \throws Intrinsic_triangulations::Numerical_error, Intrinsic_triangulations::Overflow_error where numbers
///         have not enough digits
template <typename Graph, typename NamedParameters = CGAL::parameters::Default_named_parameters>
Planar_conformal_map flatten(const Graph& g,
                             const NamedParameters& np = CGAL::parameters::default_values())
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  using CGAL::parameters::get_parameter_reference;
  constexpr bool is_free =
    CGAL::parameters::is_default_parameter<NamedParameters,
                                           internal_np::vertex_condition_map_t>::value;
  const double bound(choose_parameter(get_parameter(np, internal_np::maximum_log_scale),
                                      is_free ? 5. : std::numeric_limits<double>::infinity()));
  Default_flattening_visitor silent;
  auto&& visitor =
    choose_parameter(get_parameter_reference(np, CGAL::internal_np::visitor), silent);
  const Intrinsic_triangulations::Intrinsic_triangulation<> input(g, np);
  internal::Doubled_problem problem(
    input, internal::vertex_conditions(g, input.mesh(), np),
    choose_parameter(get_parameter(np, internal_np::flipping), Flipping::to_Delaunay));
  internal::Flattening<std::remove_reference_t<decltype(visitor)>> flattening(
    problem, input.mesh().num_faces(), visitor);
  flattening.start_from(internal::initial_log_scales(g, np));
  flattening.find_scale_factors(
    choose_parameter(get_parameter(np, internal_np::minimizer), Newton_minimizer()), bound);
  return flattening.finish();
}

} // namespace Discrete_conformal_maps
} // namespace CGAL

#endif // CGAL_DISCRETE_CONFORMAL_MAPS_FLATTEN_H
