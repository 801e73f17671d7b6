// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "Watch.h"
#include "bindings.h"

#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Edge_paths.h>
#include <CGAL/Intrinsic_triangulations/Flipped_paths.h>
#include <CGAL/Intrinsic_triangulations/Shortest_paths.h>
#include <CGAL/Intrinsic_triangulations/Surface_curve.h>
#include <CGAL/Intrinsic_triangulations/curve_across.h>
#include <CGAL/Intrinsic_triangulations/distances_from_each.h>
#include <CGAL/Intrinsic_triangulations/exponential_map.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/geodesic_homology_basis.h>
#include <CGAL/Intrinsic_triangulations/heat_distance.h>
#include <CGAL/Intrinsic_triangulations/level_set.h>
#include <CGAL/Intrinsic_triangulations/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/path_on_input.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>
#include <CGAL/Intrinsic_triangulations/signed_distance.h>
#include <CGAL/Intrinsic_triangulations/vector_heat.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <complex>
#include <functional>
#include <optional>

namespace {

typedef IT::Surface_curve<double> Curve;

// Stores sources: vertices, points of the input, and a curve on T2.
struct Sources
{
  std::vector<IT::Vertex_index> vertices;
  std::vector<Location> points;
  Curve curve;
};

IT::Vertex_index checked_vertex(std::int64_t number, const Triangulation& triangulation)
{
  const std::int64_t n = triangulation.input_mesh().number_of_vertices();
  if(number < 0 || number >= n)
    throw Element_error("InputError",
                        "there is no vertex " + std::to_string(number) +
                          "; the vertices are 0 to " + std::to_string(n - 1),
                        {});
  return IT::Vertex_index(static_cast<Mesh::size_type>(number));
}

Sources sources_of(const Index_array& vertices, const Index_array& faces,
                   const Number_array& coordinates, const Triangulation& triangulation)
{
  Sources result;
  for(const std::int64_t v : vector_of(vertices))
    result.vertices.push_back(checked_vertex(v, triangulation));
  result.points = locations_of(faces, coordinates, triangulation.input_mesh().number_of_faces());
  return result;
}

Sources one_source(IT::Vertex_index v) { return {{v}, {}, {}}; }
Sources one_source(const Location& p) { return {{}, {p}, {}}; }

// Returns a curve on T2 along polylines through points of the input. Polyline i begins at the point
// `starts[i]` and ends before the point `starts[i + 1]`.
Curve curve_of_polylines(const Bound_triangulation& self, const Index_array& faces,
                         const Number_array& coordinates, const Index_array& starts)
{
  const std::vector<Location> points =
    locations_of(faces, coordinates, self.triangulation().input_mesh().number_of_faces());
  Curve curve;
  if(points.empty()) // the correspondence is not needed then
    return curve;
  for(std::size_t i = 0; i + 1 < std::size_t(starts.size()); ++i) {
    const Curve part = IT::curve_through(
      self.triangulation().input(), std::vector<Location>(points.begin() + starts.data()[i],
                                                          points.begin() + starts.data()[i + 1]));
    curve.insert(curve.end(), part.begin(), part.end());
  }
  return IT::curve_across(self.correspondence(), IT::Side::input, curve);
}

// Holds the arrays of sources: vertices, then faces and coordinates of points, then polylines as of
// `curve_of_polylines()`.
struct Source_arrays
{
  Index_array vertices, faces;
  Number_array coordinates;
  Index_array curve_faces;
  Number_array curve_coordinates;
  Index_array starts;

  explicit Source_arrays(const py::tuple& arrays)
    : vertices(arrays[0]),
      faces(arrays[1]),
      coordinates(arrays[2]),
      curve_faces(arrays[3]),
      curve_coordinates(arrays[4]),
      starts(arrays[5])
  {}

  Sources on(const Bound_triangulation& self) const
  {
    Sources result = sources_of(vertices, faces, coordinates, self.triangulation());
    result.curve = curve_of_polylines(self, curve_faces, curve_coordinates, starts);
    return result;
  }
};

// Returns `set_of(source)` for each of the sources.
template <class Make>
auto separated(const Sources& sources, const Make& set_of)
{
  std::vector<decltype(set_of(IT::Vertex_index()))> result;
  for(const IT::Vertex_index v : sources.vertices)
    result.push_back(set_of(v));
  for(const Location& p : sources.points)
    result.push_back(set_of(p));
  return result;
}

// Calls `use(tag)` with the tag of one thread or of several.
template <class Use>
auto with_concurrency(bool is_parallel, const Use& use)
{
  return is_parallel ? use(CGAL::Parallel_if_available_tag()) : use(CGAL::Sequential_tag());
}

// Returns the sources on the intrinsic triangulation.
IT::Distance_sources<Triangulation> sources_across(const Bound_triangulation& self,
                                                   const Sources& sources)
{
  IT::Distance_sources<Triangulation> result(self.triangulation());
  result.add(sources.vertices);
  for(const Location& p : sources.points)
    result.add(IT::point_across(self.correspondence(), IT::Side::input, p));
  if(!sources.curve.empty())
    result.add(sources.curve);
  return result;
}

// Returns the positions of all vertices, including inserted ones, or nothing if the surface has no
// positions.
std::vector<Point> vertex_positions(const Bound_triangulation& self)
{
  std::vector<Point> result;
  if(!self.has_positions())
    return result;
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  result = self.surface()->points;
  for(const auto& place : self.triangulation().inserted_vertices()) {
    const Location p = IT::face_location(place, mesh);
    const auto side = IT::sides(p.first, mesh);
    result.push_back(CGAL::barycenter(result[mesh.source(side[0])], p.second[0],
                                      result[mesh.source(side[1])], p.second[1],
                                      result[mesh.source(side[2])], p.second[2]));
  }
  return result;
}

IT::Distance_method method_named(const std::string& name)
{
  return name == "exact"  ? IT::Distance_method::exact
         : name == "heat" ? IT::Distance_method::heat
                          : IT::Distance_method::automatic;
}

template <class Parameters>
IT::Geodesic_distances<double>
measured(const Bound_triangulation& self, const IT::Distance_sources<Triangulation>& sources,
         std::optional<double> time_step_factor, const Parameters& np)
{
  if(time_step_factor)
    return IT::geodesic_distances(self.triangulation(), sources,
                                  np.time_step_factor(*time_step_factor));
  return IT::geodesic_distances(self.triangulation(), sources, np);
}

py::dict description_of(const IT::Geodesic_distances<double>& distances)
{
  py::dict result;
  const bool is_exact = distances.method == IT::Distance_method::exact;
  result["method"] = is_exact ? "exact" : "heat";
  if(is_exact)
    return result;
  result["time_step_factor"] = distances.time_step_factor;
  result["raised_vertices"] = distances.number_of_raised_vertices;
  if(const auto& error = distances.error)
    result["relative_error"] = py::dict(
      py::arg("vertices") = error->number_of_vertices, py::arg("mean") = error->mean,
      py::arg("ninety_percent") = error->ninety_percent, py::arg("greatest") = error->greatest);
  return result;
}

py::tuple distances(const Bound_triangulation& self, const py::tuple& arrays,
                    const std::string& method, std::optional<double> time_step_factor,
                    const py::object& progress)
{
  const Source_arrays given(arrays);
  Watch watch(progress, "windows");
  IT::Geodesic_distances<double> result = released([&] {
    const auto sources = sources_across(self, given.on(self));
    const auto np = IT::parameters::distance_method(method_named(method)).visitor(std::ref(watch));
    const std::vector<Point> points = vertex_positions(self);
    if(points.empty())
      return measured(self, sources, time_step_factor, np);
    const auto point = boost::make_function_property_map<IT::Vertex_index>(
      [&](IT::Vertex_index v) { return points[v.idx()]; });
    return measured(self, sources, time_step_factor, np.vertex_point_map(point));
  });
  const py::dict description = description_of(result);
  return py::make_tuple(array_of(std::move(result.distance)), description);
}

// ---- A factorization for many sources ----

class Bound_heat
{
  typedef IT::internal::Positions<double> Positions;

public:
  Bound_heat(const Bound_triangulation& triangulation, double time_step_factor)
    : m_heat(triangulation.triangulation().intrinsic(),
             IT::parameters::time_step_factor(time_step_factor))
  {}

  py::array distances(const Bound_triangulation& on, const py::tuple& arrays) const
  {
    const Source_arrays given(arrays);
    return array_of(released([&] {
      const auto sources = sources_across(on, given.on(on));
      return raised(m_heat.distances(sources), on.triangulation(), sources, positions_on(on));
    }));
  }

  py::array distances_from_each(const Bound_triangulation& on, const Index_array& vertices,
                                const Index_array& faces, const Number_array& coordinates,
                                bool is_parallel) const
  {
    return array_of_columns(released([&] {
      const auto sources =
        separated(sources_of(vertices, faces, coordinates, on.triangulation()),
                  [&](auto source) { return sources_across(on, one_source(source)); });
      auto columns = with_concurrency(is_parallel, [&](const auto& tag) {
        return m_heat.distances_from_each(sources, IT::parameters::concurrency_tag(tag));
      });
      const Positions positions = positions_on(on);
      for(std::size_t k = 0; k < sources.size(); ++k) {
        const auto values =
          raised(columns.col(Eigen::Index(k)), on.triangulation(), sources[k], positions);
        std::copy(values.begin(), values.end(), columns.col(Eigen::Index(k)).begin());
      }
      return columns;
    }));
  }

private:
  static Positions positions_on(const Bound_triangulation& on)
  {
    Positions result;
    for(const Point& p : vertex_positions(on))
      result.push_back({p.x(), p.y(), p.z()});
    return result;
  }

  // Returns the distances after all that `IT::geodesic_distances()` does with distances by heat.
  template <class Values>
  static std::vector<double> raised(const Values& values, const Triangulation& triangulation,
                                    const IT::Distance_sources<Triangulation>& sources,
                                    const Positions& positions)
  {
    IT::Geodesic_distances<double> result{{values.begin(), values.end()},
                                          IT::Distance_method::heat};
    IT::internal::raise_to_bounds(triangulation, sources, positions, result);
    return std::move(result.distance);
  }

  IT::Heat_distance<double> m_heat;
};

// ---- Exact distances from each of many sources ----

py::array distances_from_each(const Bound_triangulation& self, const Index_array& vertices,
                              const Index_array& faces, const Number_array& coordinates,
                              bool is_parallel, const py::object& progress)
{
  Watch watch(progress, "windows");
  return array_of_columns(released([&] {
    const auto input = self.triangulation().input();
    const auto sources =
      separated(sources_of(vertices, faces, coordinates, self.triangulation()), [&](auto source) {
        IT::Distance_sources<std::decay_t<decltype(input)>> result(input);
        result.add(source);
        return result;
      });
    return with_concurrency(is_parallel, [&](const auto& tag) {
      return IT::distances_from_each(input, sources,
                                     IT::parameters::visitor(std::ref(watch)).concurrency_tag(tag));
    });
  }));
}

// ---- Paths ----

py::tuple path_arrays(const IT::Surface_path<double>& path, const IT::Delta_complex& mesh)
{
  std::vector<Location> places;
  for(const auto& place : path.places)
    places.push_back(IT::face_location(place, mesh));
  const py::tuple arrays = arrays_of(places);
  return py::make_tuple(path.length, arrays[0], arrays[1]);
}

py::tuple shortest_path(const Bound_triangulation& self, const Index_array& faces,
                        const Number_array& coordinates)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  Watch watch(py::none(), "windows");
  const auto path = released([&] {
    const auto ends = locations_of(faces, coordinates, mesh.number_of_faces());
    return IT::shortest_path(self.triangulation().input(), ends.at(0), ends.at(1),
                             IT::parameters::visitor(std::ref(watch)));
  });
  return path_arrays(path, mesh);
}

// Returns the path along edges of the input through some vertices, or an empty one if none exists.
std::vector<IT::Halfedge_index> path_along_edges(const Triangulation& triangulation,
                                                 const Index_array& vertices)
{
  std::vector<IT::Halfedge_index> result;
  for(py::ssize_t i = 0; i + 1 < vertices.size(); ++i) {
    const IT::Vertex_index v = checked_vertex(vertices.data()[i], triangulation),
                           w = checked_vertex(vertices.data()[i + 1], triangulation);
    const auto part = IT::shortest_edge_path(triangulation.input(), v, w);
    if(part.empty() && v != w)
      throw Element_error("InputError",
                          "there is no path from vertex " + std::to_string(v.idx()) +
                            " to vertex " + std::to_string(w.idx()),
                          {});
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

// Shortens a path along edges of the input by flips. If a loop contracts, the result has no points.
py::tuple geodesic_through(const Bound_triangulation& self, const Index_array& vertices,
                           bool is_loop)
{
  bool is_geodesic = true;
  IT::Surface_path<double> path{0, {}};
  released([&] {
    const auto halfedges = path_along_edges(self.triangulation(), vertices);
    if(halfedges.empty())
      return;
    self.with_paths([&](const Triangulation& triangulation, auto& paths) {
      is_loop ? paths.add_loop(halfedges) : paths.add_path(halfedges);
      is_geodesic = paths.shorten() == IT::Shortening_status::geodesic;
      path = IT::path_on_input(triangulation, paths.halfedges(0));
    });
  });
  return path_arrays(path, self.triangulation().input_mesh()) + py::make_tuple(is_geodesic);
}

// Shortens the paths along edges of the input between pairs of vertices by flips.
py::list geodesics_between(const Bound_triangulation& self, const Index_array& pairs)
{
  std::vector<std::pair<IT::Vertex_index, IT::Vertex_index>> ends;
  const auto paths = released([&] {
    for(py::ssize_t i = 0; i + 1 < pairs.size(); i += 2)
      ends.emplace_back(checked_vertex(pairs.data()[i], self.triangulation()),
                        checked_vertex(pairs.data()[i + 1], self.triangulation()));
    return self.with_paths([&](const Triangulation& triangulation, const auto&) {
      return IT::flipped_paths(triangulation, ends);
    });
  });
  py::list result;
  for(const auto& path : paths)
    result.append(path_arrays(path.path, self.triangulation().input_mesh()) +
                  py::make_tuple(path.status == IT::Shortening_status::geodesic));
  return result;
}

// Returns the loops of a homology basis, which flips have shortened.
py::list homology_loops(const Bound_triangulation& self)
{
  const auto loops = released([&] { return IT::geodesic_homology_basis(self.triangulation()); });
  py::list result;
  for(const auto& loop : loops)
    result.append(path_arrays(loop.path, self.triangulation().input_mesh()) +
                  py::make_tuple(loop.status == IT::Shortening_status::geodesic));
  return result;
}

// Returns the curves on which a function of the vertices has a value.
py::list level_set(const Bound_triangulation& self, const Number_array& values, double level)
{
  const std::vector<double> of_vertices = vector_of(values);
  const auto curves =
    released([&] { return IT::level_set(self.triangulation().input(), of_vertices, level); });
  py::list result;
  for(const auto& curve : curves)
    result.append(path_arrays(curve, self.triangulation().input_mesh()));
  return result;
}

// ---- Signed distances ----

py::tuple signed_distances(const Bound_triangulation& self, const Index_array& faces,
                           const Number_array& coordinates, const Index_array& starts,
                           const std::string& method, std::optional<double> time_step_factor,
                           const py::object& progress)
{
  Watch watch(progress, "windows");
  IT::Geodesic_distances<double> result = released([&] {
    const Curve curve = curve_of_polylines(self, faces, coordinates, starts);
    const auto np = IT::parameters::distance_method(method_named(method)).visitor(std::ref(watch));
    return time_step_factor ? IT::signed_distance(self.triangulation(), curve,
                                                  np.time_step_factor(*time_step_factor))
                            : IT::signed_distance(self.triangulation(), curve, np);
  });
  const py::dict description = description_of(result);
  return py::make_tuple(array_of(std::move(result.distance)), description);
}

// ---- Tangent spaces ----

py::tuple logarithms(const Bound_triangulation& self, std::int64_t source)
{
  std::vector<std::complex<double>> vectors;
  std::vector<std::int64_t> statuses;
  Watch watch(py::none(), "windows");
  released([&] {
    const IT::Vertex_index v = checked_vertex(source, self.triangulation());
    if(self.triangulation().input_mesh().is_isolated(v))
      throw Element_error("InputError", "vertex " + std::to_string(source) + " has no face",
                          {{"vertex", {std::size_t(source)}}});
    for(const auto& logarithm : IT::logarithmic_map(self.triangulation().input(), v,
                                                    IT::parameters::visitor(std::ref(watch)))) {
      vectors.push_back(logarithm.vector);
      statuses.push_back(static_cast<std::int64_t>(logarithm.status));
    }
  });
  return py::make_tuple(array_of(std::move(vectors)), array_of(std::move(statuses)));
}

constexpr std::size_t greatest_number_of_crossings = 1000000;

// Returns the geodesic with a first direction: its length, the points that it crosses, and how it
// ended.
template <class Source>
py::tuple geodesic_from(const Bound_triangulation& self, const Source& source,
                        const Location& start, std::complex<double> vector)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  std::vector<Location> places{start};
  Watch watch(py::none(), "trace");
  const auto end = released([&] {
    const auto add = [&](const IT::Edge_point<double>& p) {
      watch.step();
      if(places.size() > greatest_number_of_crossings)
        throw IT::Overflow_error("the path crosses more than " +
                                 std::to_string(greatest_number_of_crossings) +
                                 " edges; shorten the vector");
      places.push_back(IT::face_location(IT::edge_location(p), mesh));
    };
    return IT::trace_geodesic(self.triangulation().input(), source, vector, IT::At_boundary::stop,
                              boost::make_function_output_iterator(add));
  });
  places.push_back(end.end);
  const py::tuple arrays = arrays_of(places);
  return py::make_tuple(end.length, arrays[0], arrays[1],
                        end.status == IT::Geodesic_status::reached);
}

py::tuple exponential(const Bound_triangulation& self, std::int64_t source,
                      std::complex<double> vector)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  const IT::Vertex_index v = checked_vertex(source, self.triangulation());
  if(mesh.is_isolated(v))
    throw Element_error("InputError", "vertex " + std::to_string(source) + " has no face",
                        {{"vertex", {std::size_t(source)}}});
  const Location start = IT::face_location(
    IT::Edge_location<double>{IT::first_outgoing_halfedge(v, mesh), {1, 0}}, mesh);
  return geodesic_from(self, v, start, vector);
}

// Returns the vertex at the end of the first edge of each vertex of the input, or -1 at isolated
// vertices.
py::array first_neighbors(const Bound_triangulation& self)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  return array_over(mesh.vertices(), [&](IT::Vertex_index v) {
    return mesh.is_isolated(v)
             ? std::int64_t(-1)
             : std::int64_t(mesh.target(IT::first_outgoing_halfedge(v, mesh)).idx());
  });
}

// Returns vectors at all vertices, from the nearest of some vertices by parallel transport. They
// are in the frames of the input.
py::array transported(const Bound_triangulation& self, const Index_array& vertices,
                      const py::array_t<std::complex<double>, py::array::c_style>& vectors,
                      double time_step_factor)
{
  return array_of(released([&] {
    const std::vector<std::complex<double>> rotation = rotations_to_input(self.triangulation());
    std::vector<IT::Vector_heat<double>::Source> sources;
    for(std::size_t i = 0; i < std::size_t(vertices.size()); ++i) {
      const IT::Vertex_index v = checked_vertex(vertices.data()[i], self.triangulation());
      sources.emplace_back(v, vectors.data()[i] * std::conj(rotation[v.idx()]));
    }
    const IT::Vector_heat<double> heat(self.triangulation().intrinsic(),
                                       IT::parameters::time_step_factor(time_step_factor));
    const auto field = heat.transport(sources);
    std::vector<std::complex<double>> result(field.begin(), field.end());
    std::transform(result.begin(), result.end(), rotation.begin(), result.begin(),
                   std::multiplies<>());
    return result;
  }));
}

} // namespace

void bind_distances(py::module_& module)
{
  module.def("distances", &distances);
  module.def("distances_from_each", &distances_from_each);
  module.def("shortest_path", &shortest_path);
  module.def("geodesic_through", &geodesic_through);
  module.def("geodesics_between", &geodesics_between);
  module.def("homology_loops", &homology_loops);
  module.def("level_set", &level_set);
  module.def("signed_distances", &signed_distances);
  module.def("transported", &transported);
  module.def("first_neighbors", &first_neighbors);
  module.def("logarithms", &logarithms);
  module.def("exponential", &exponential);
  py::class_<Bound_heat>(module, "Heat")
    .def(py::init([](const Bound_triangulation& on, double time_step_factor) {
      return released([&] { return std::make_unique<Bound_heat>(on, time_step_factor); });
    }))
    .def("distances", &Bound_heat::distances)
    .def("distances_from_each", &Bound_heat::distances_from_each);
}
