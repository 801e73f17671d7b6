// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "Watch.h"
#include "bindings.h"
#include "commands/weighted_cost.h"
#include "writing/Fine_vertices.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/pinch_handles.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/refine.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>
#include <CGAL/Intrinsic_triangulations/input_with_inserted_vertices.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>

namespace IS = CGAL::Intrinsic_simplification;

namespace {

typedef std::shared_ptr<Surface> Shared_surface;

// Stores the parameters of a simplification. Angles are in degrees; zero is no bound.
struct Simplification_options
{
  std::vector<std::size_t> sizes; // numbers of vertices of the levels
  double maximum_cost;
  std::optional<Named_weights> weights; // of `default_cost()` unless given
  Named_functions functions;
  double fine_angle;
  double coarse_angle;
  std::optional<std::size_t> maximum_number_of_insertions;
  double closed_length;
  double pinched_length;
  bool is_exact;
};

// Stores levels of a surface with the map to the input, which refers to the other members. The fine
// level is the input, or the input split by inserted vertices. Disks and cuts may have changed it.
class Bound_simplification
{
public:
  Bound_simplification(Shared_surface surface, const Simplification_options& options,
                       double mollification, Watch& watch)
    : m_surface(std::move(surface))
  {
    Triangulation start = triangulation_of(*m_surface, mollification);
    if(options.fine_angle > 0)
      split(start, options, watch);
    m_vertices.emplace(m_surface->mesh.number_of_vertices(), m_split ? &*m_split : nullptr);
    if(options.closed_length > 0 || options.pinched_length > 0)
      simplify_topology(start, options);
    m_evolving.emplace(start);
    m_levels.emplace_back(*m_evolving);
    if(options.is_exact)
      m_evolving->make_exactly_Delaunay(start);
    else if(m_split || !options.functions.empty()) // thin faces are no measure
      m_evolving->make_Delaunay();
    watch.start_stage("simplify");
    simplify(options, watch);
    if(options.coarse_angle > 0)
      refine_coarse(options, watch);
    m_map.emplace(*m_evolving, fine(), coarse());
  }

  Bound_simplification(const Bound_simplification&) = delete;
  Bound_simplification& operator=(const Bound_simplification&) = delete;

  // Returns "reached" if the last level has no more vertices than requested, or a cost bounds it.
  const char* status() const { return m_is_reached ? "reached" : "nothing_removable"; }

  // Returns the statuses of both refinements; nothing without a refinement.
  std::optional<std::string> fine_refinement() const { return m_fine_refinement; }
  std::optional<std::string> coarse_refinement() const { return m_coarse_refinement; }

  std::size_t removed() const { return m_removed; }
  double greatest_cost() const { return m_greatest_cost; }
  std::size_t closed_loops() const { return m_closed_loops; }
  std::size_t pinched_handles() const { return m_pinched_handles; }

  const IS::Evolving_surface& evolving() const { return *m_evolving; }
  const std::vector<IS::Surface_level>& levels() const { return m_levels; }
  const IS::Surface_level& fine() const { return m_levels.front(); }
  const IS::Surface_level& coarse() const { return m_levels.back(); }
  const IS::Surface_map& map() const { return *m_map; }

  std::size_t number_of_input_vertices() const { return m_surface->mesh.number_of_vertices(); }
  std::size_t number_of_input_faces() const { return m_surface->mesh.number_of_faces(); }

  // Returns the positions of the vertices of the fine level.
  std::vector<Point> points() const { return m_vertices->positions(m_surface->points); }

  Location on_fine(const Location& p) const
  {
    return m_split ? IT::point_across(*m_correspondence, IT::Side::input, p) : p;
  }

  // Returns the point of the input, or no face for a point in a disk.
  Location on_input(const Location& p) const
  {
    const std::size_t faces = m_split ? m_split->mesh().number_of_faces() : number_of_input_faces();
    if(!p.first.is_valid() || p.first.idx() >= faces)
      return Location();
    return m_split ? IT::point_across(*m_split, IT::Side::intrinsic, p) : p;
  }

  // Returns the index of a vertex of the input, or -1 for another vertex of the surface.
  std::int64_t input_vertex(IS::Vertex_index v) const
  {
    return v.is_valid() && v.idx() < number_of_input_vertices() ? std::int64_t(v.idx()) : -1;
  }

private:
  // Refines the input, and splits its faces at the inserted vertices.
  void split(Triangulation& start, const Simplification_options& options, Watch& watch)
  {
    watch.start_stage("refine");
    const auto np = IT::parameters::exact_decisions(options.is_exact).visitor(std::ref(watch));
    IT::make_Delaunay(start, np);
    const std::size_t limit = options.maximum_number_of_insertions.value_or(
      IT::default_maximum_number_of_insertions(start, options.fine_angle, no_radius));
    m_fine_refinement = IT::to_string(
      IT::refine(start, np.minimum_angle(options.fine_angle).maximum_number_of_insertions(limit))
        .status);
    start.collect_garbage();
    start = IT::input_with_inserted_vertices(start);
    m_split = start;
    m_correspondence.emplace(*m_split); // now, because threads may share this object
  }

  void simplify_topology(Triangulation& start, const Simplification_options& options)
  {
    IS::Surface_surgery surgery(start);
    if(options.closed_length > 0)
      m_closed_loops = IS::close_boundary_loops(surgery, options.closed_length);
    if(options.pinched_length > 0)
      m_pinched_handles = IS::pinch_handles(surgery, options.pinched_length);
    m_vertices->add(surgery);
    start = surgery.triangulation();
  }

  IS::Transport_cost cost(const Simplification_options& options) const
  {
    if(!options.weights)
      return IS::default_cost(*m_evolving);
    Named_functions functions = options.functions;
    for(auto& [name, components] : functions)
      for(std::vector<double>& values : components)
        m_vertices->extend(values, 0.);
    return weighted_cost(*m_evolving, *options.weights, functions);
  }

  void simplify(const Simplification_options& options, Watch& watch)
  {
    IS::Transport_cost transport_cost = cost(options);
    for(const std::size_t size : options.sizes) {
      const IS::Simplification_result result = IS::simplify(*m_evolving, transport_cost,
                                                            IS::parameters::number_of_vertices(size)
                                                              .maximum_cost(options.maximum_cost)
                                                              .visitor(std::ref(watch)));
      m_removed += result.removed;
      m_greatest_cost = (std::max)(m_greatest_cost, result.greatest_cost);
      m_levels.emplace_back(*m_evolving);
    }
    m_is_reached = std::isfinite(options.maximum_cost) ||
                   coarse().mesh().number_of_vertices() <= options.sizes.back();
  }

  void refine_coarse(const Simplification_options& options, Watch& watch)
  {
    watch.start_stage("refine");
    const std::size_t limit =
      options.maximum_number_of_insertions.value_or(IT::default_maximum_number_of_insertions(
        m_evolving->mesh().number_of_faces(), options.coarse_angle, no_radius));
    m_coarse_refinement =
      IT::to_string(IS::refine(*m_evolving, IS::parameters::minimum_angle(options.coarse_angle)
                                              .maximum_number_of_insertions(limit)
                                              .visitor(std::ref(watch)))
                      .status);
    m_levels.back() = IS::Surface_level(*m_evolving);
  }

  static constexpr double no_radius = std::numeric_limits<double>::infinity();

  Shared_surface m_surface;
  std::optional<Triangulation> m_split; // the input, and its faces split by inserted vertices
  std::optional<Fine_vertices> m_vertices;
  std::optional<IS::Evolving_surface> m_evolving;
  std::vector<IS::Surface_level> m_levels; // the fine one first
  std::optional<IS::Surface_map> m_map;    // from the first to the last level
  std::size_t m_removed = 0, m_closed_loops = 0, m_pinched_handles = 0;
  double m_greatest_cost = 0;
  bool m_is_reached = false;
  std::optional<std::string> m_fine_refinement, m_coarse_refinement; // statuses
  std::optional<IT::Correspondence<>> m_correspondence;              // of `m_split`
};

// Returns the vertices of the input on each level, from the first coarse one on; -1 for others.
py::list level_vertices(const Bound_simplification& self)
{
  py::list result;
  for(std::size_t n = 1; n < self.levels().size(); ++n) {
    const IS::Surface_level& level = self.levels()[n];
    result.append(array_over(level.mesh().vertices(), [&](IT::Vertex_index v) {
      return self.input_vertex(level.surface_vertex(v));
    }));
  }
  return result;
}

// Returns the matrix of a map. Its rows are vertices of the input, or of a coarse level.
py::tuple prolongation(const Bound_simplification& self, const IS::Surface_map& map,
                       bool is_from_input)
{
  Eigen::SparseMatrix<double> matrix = IS::prolongation_matrix(map);
  if(is_from_input)
    matrix.conservativeResize(Eigen::Index(self.number_of_input_vertices()), matrix.cols());
  return sparse_arrays(std::move(matrix));
}

// Returns the matrix from each level to the level before.
py::list prolongations(const Bound_simplification& self)
{
  py::list result;
  for(std::size_t n = 1; n < self.levels().size(); ++n)
    result.append(prolongation(
      self, IS::Surface_map(self.evolving(), self.levels()[n - 1], self.levels()[n]), n == 1));
  return result;
}

py::tuple points_mapped(const Bound_simplification& self, bool to_coarse, const Index_array& faces,
                        const Number_array& coordinates)
{
  return arrays_of(released([&] {
    auto points = locations_of(faces, coordinates,
                               to_coarse ? self.number_of_input_faces()
                                         : self.coarse().mesh().number_of_faces());
    if(to_coarse) {
      for(Location& p : points)
        p = self.on_fine(p);
      return self.map().to_coarse(points);
    }
    points = self.map().to_fine(points);
    for(Location& p : points)
      p = self.on_input(p);
    return points;
  }));
}

// Returns a vertex as a point of a face; without a face if the vertex is isolated.
Location place_of(IS::Vertex_index v, const IS::Delta_complex& mesh)
{
  return mesh.is_isolated(v)
           ? Location()
           : IT::face_location(IT::Edge_point<double>{IT::first_outgoing_halfedge(v, mesh), 0},
                               mesh);
}

// Returns the coarse triangulation in space. It has positions, corners, their vertices of the input
// (-1 for inserted ones), their points on the input, and the distance of both surfaces.
py::tuple mesh_in_space(const Bound_simplification& self)
{
  Mesh mesh;
  std::vector<std::int64_t> parents;
  std::vector<Location> places;
  const auto quality = released([&] {
    const auto fine_vertex =
      mesh.add_property_map<Mesh::Vertex_index, IS::Vertex_index>("v:fine_vertex").first;
    const auto location =
      mesh.add_property_map<Mesh::Vertex_index, IS::Surface_map::Location>("v:location").first;
    const std::vector<Point> points = self.points();
    const auto point_map = boost::make_iterator_property_map(
      points.data(), boost::typed_identity_property_map<IT::Vertex_index>());
    const auto result = IS::coarse_mesh(self.evolving(), self.fine(), mesh,
                                        IS::parameters::input_point_map(point_map)
                                          .parent_vertex_map(fine_vertex)
                                          .location_map(location));
    for(const Mesh::Vertex_index v : mesh.vertices()) {
      const IS::Vertex_index parent = fine_vertex[v];
      parents.push_back(self.input_vertex(parent));
      places.push_back(
        self.on_input(parent.is_valid() ? place_of(parent, self.fine().mesh()) : location[v]));
    }
    return result;
  });
  std::vector<std::array<double, 3>> points;
  for(const Point& p : mesh.points())
    points.push_back({p.x(), p.y(), p.z()});
  return py::make_tuple(array_of(std::move(points)), array_of(corners_of(mesh)),
                        array_of(std::move(parents)), arrays_of(places),
                        py::dict(py::arg("distance_to_coarse") = quality.distance_to_coarse,
                                 py::arg("distance_to_fine") = quality.distance_to_fine,
                                 py::arg("inserted_vertices") = quality.inserted_vertices,
                                 py::arg("flipped_faces") = quality.flipped_faces,
                                 py::arg("degenerate_faces") = quality.degenerate_faces,
                                 py::arg("self_intersections") = quality.self_intersections));
}

// Returns the columns of each function, an array of rows.
Named_functions components_of(const std::map<std::string, Number_array>& functions)
{
  Named_functions result;
  for(const auto& [name, rows] : functions) {
    const auto number = static_cast<std::size_t>(rows.shape(1));
    std::vector<std::vector<double>>& components = result[name];
    components.resize(number);
    for(const double* x = rows.data(); x != rows.data() + rows.size();)
      for(std::vector<double>& values : components)
        values.push_back(*x++);
  }
  return result;
}

std::unique_ptr<Bound_simplification>
simplified(const Shared_surface& surface, const std::vector<std::size_t>& sizes,
           double maximum_cost, const std::optional<Named_weights>& weights,
           const std::map<std::string, Number_array>& functions, double fine_angle,
           double coarse_angle, std::optional<std::size_t> maximum_number_of_insertions,
           double closed_length, double pinched_length, bool is_exact, double mollification,
           const py::object& progress)
{
  Watch watch(progress, "simplify");
  const Simplification_options options{sizes,
                                       maximum_cost,
                                       weights,
                                       components_of(functions),
                                       fine_angle,
                                       coarse_angle,
                                       maximum_number_of_insertions,
                                       closed_length,
                                       pinched_length,
                                       is_exact};
  return released(
    [&] { return std::make_unique<Bound_simplification>(surface, options, mollification, watch); });
}

} // namespace

void bind_simplification(py::module_& module)
{
  typedef Bound_simplification Bound;
  py::class_<Bound>(module, "Simplification")
    .def(py::init(&simplified))
    .def("status", &Bound::status)
    .def("fine_refinement", &Bound::fine_refinement)
    .def("coarse_refinement", &Bound::coarse_refinement)
    .def("removed", &Bound::removed)
    .def("greatest_cost", &Bound::greatest_cost)
    .def("closed_loops", &Bound::closed_loops)
    .def("pinched_handles", &Bound::pinched_handles)
    .def("faces", [](const Bound& self) { return array_of(corners_of(self.coarse().mesh())); })
    .def("face_edges", [](const Bound& self) { return face_edges_of(self.coarse().mesh()); })
    .def("lengths", [](const Bound& self) { return lengths_of(self.coarse()); })
    .def("level_vertices", &level_vertices)
    .def("mapped", &points_mapped)
    .def("prolongation", [](const Bound& self) { return prolongation(self, self.map(), true); })
    .def("prolongations", &prolongations)
    .def("triangulation",
         [](const Bound& self) {
           return released([&] {
             return std::make_unique<Bound_triangulation>(nullptr, self.coarse().triangulation());
           });
         })
    .def("coarse_mesh", &mesh_in_space);
}
