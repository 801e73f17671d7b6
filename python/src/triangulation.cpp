// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "Watch.h"
#include "bindings.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/certify_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/function_transfer.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/point_across.h>
#include <CGAL/Intrinsic_triangulations/refine.h>
#include <CGAL/Intrinsic_triangulations/trace_edge.h>

#include <pybind11/stl.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <functional>
#include <optional>
#include <sstream>

namespace {

typedef std::shared_ptr<Surface> Shared_surface;
typedef IT::Common_subdivision<Triangulation::Traits, Point> Subdivision;

IT::Side side_of(bool is_input) { return is_input ? IT::Side::input : IT::Side::intrinsic; }

// ---- Changes ----

std::size_t make_Delaunay(Bound_triangulation& self, bool is_exact, const py::object& progress)
{
  Watch watch(progress, "flip");
  return released([&] {
    return self.changed([&](Triangulation& triangulation) {
      return IT::make_Delaunay(triangulation,
                               IT::parameters::exact_decisions(is_exact).visitor(std::ref(watch)));
    });
  });
}

py::dict make_weighted_Delaunay(Bound_triangulation& self, const Number_array& weights,
                                bool is_exact, const py::object& progress)
{
  const std::vector<double> weight = vector_of(weights);
  Watch watch(progress, "flip");
  IT::Weighted_Delaunay_result<double> weighted;
  released([&] {
    weighted = self.changed([&](Triangulation& triangulation) {
      return IT::make_weighted_Delaunay(
        triangulation, boost::make_function_property_map<IT::Vertex_index>([&](IT::Vertex_index v) {
          return weight[v.idx()];
        }),
        IT::parameters::exact_decisions(is_exact).visitor(std::ref(watch)));
    });
  });
  py::dict result;
  result["flips"] = weighted.flips;
  result["hidden_vertices"] = indices_of(weighted.hidden_vertices);
  result["weights"] = array_of(std::move(weighted.weights));
  return result;
}

py::dict dictionary_of(const IT::Refinement_result& result)
{
  std::vector<std::int64_t> faces;
  for(const IT::Remaining_face& remaining : result.remaining)
    faces.push_back(remaining.face.idx());
  py::dict dictionary;
  dictionary["status"] = IT::to_string(result.status);
  dictionary["flips"] = result.flips;
  dictionary["insertions"] = result.insertions;
  dictionary["removals"] = result.removals;
  dictionary["is_exact"] = result.is_exact;
  dictionary["remaining_faces"] = array_of(std::move(faces));
  dictionary["excused_faces"] =
    std::count_if(result.remaining.begin(), result.remaining.end(), IT::is_excused);
  return dictionary;
}

py::dict refine(Bound_triangulation& self, double minimum_angle, double maximum_circumradius,
                bool is_simplicial, std::optional<std::size_t> maximum_number_of_insertions,
                bool is_exact, const py::object& progress)
{
  Watch watch(progress, "refine");
  return dictionary_of(released([&] {
    return self.changed([&](Triangulation& triangulation) {
      const std::size_t limit = maximum_number_of_insertions
                                  ? *maximum_number_of_insertions
                                  : IT::default_maximum_number_of_insertions(
                                      triangulation, minimum_angle, maximum_circumradius);
      return IT::refine(triangulation, IT::parameters::minimum_angle(minimum_angle)
                                         .maximum_circumradius(maximum_circumradius)
                                         .simplicial(is_simplicial)
                                         .maximum_number_of_insertions(limit)
                                         .exact_decisions(is_exact)
                                         .visitor(std::ref(watch)));
    });
  }));
}

// Forbids or allows flips of some edges.
void constrain(Bound_triangulation& self, const Index_array& edges, bool is_constrained)
{
  self.changed([&](Triangulation& triangulation) {
    for(const std::int64_t number : vector_of(edges))
      triangulation.set_constrained(IT::Edge_index(static_cast<Mesh::size_type>(number)),
                                    is_constrained);
  });
}

// ---- Elements ----

const IT::Delta_complex& mesh_of(const Bound_triangulation& self, bool is_input)
{
  return is_input ? self.triangulation().input_mesh() : self.triangulation().mesh();
}

py::array face_edges(const Bound_triangulation& self, bool is_input)
{
  return face_edges_of(mesh_of(self, is_input));
}

// Returns the corners of some faces of the input.
py::array input_corners(const Bound_triangulation& self, const Index_array& faces)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  return array_over(vector_of(faces), [&](std::int64_t f) {
    return corners_of(IT::Face_index(static_cast<Mesh::size_type>(f)), mesh);
  });
}

// Returns the first face of a vertex of the input, and its corner, or None for an isolated vertex.
std::optional<std::pair<std::size_t, std::size_t>> place_of_vertex(const Bound_triangulation& self,
                                                                   std::size_t v)
{
  const IT::Delta_complex& mesh = self.triangulation().input_mesh();
  std::optional<std::pair<std::size_t, std::size_t>> result;
  const IT::Halfedge_index first = mesh.halfedge(IT::Vertex_index(Mesh::size_type(v)));
  if(!first.is_valid())
    return result;
  for(const IT::Halfedge_index h : mesh.halfedges_around_target(first))
    if(const IT::Halfedge_index o = mesh.opposite(h); !mesh.is_border(o)) {
      const std::pair place(std::size_t(mesh.face(o).idx()), std::size_t(IT::side_number(o, mesh)));
      result = result ? std::min(*result, place) : place;
    }
  return result;
}

py::array edges(const Bound_triangulation& self, bool is_input)
{
  const IT::Delta_complex& mesh = mesh_of(self, is_input);
  return array_over(mesh.edges(), [&](IT::Edge_index e) -> std::array<std::int64_t, 2> {
    const IT::Halfedge_index h = IT::first_halfedge(e);
    return {std::int64_t(mesh.source(h).idx()), std::int64_t(mesh.target(h).idx())};
  });
}

py::array lengths(const Bound_triangulation& self, bool is_input)
{
  const Triangulation& triangulation = self.triangulation();
  return lengths_of(is_input ? triangulation.input() : triangulation.intrinsic());
}

// Returns the number of edges of the input that cross each edge, or -1 for edges of the input.
py::array normal_coordinates(const Bound_triangulation& self)
{
  const Triangulation& triangulation = self.triangulation();
  return array_over(triangulation.mesh().edges(), [&](IT::Edge_index e) {
    return std::int64_t(triangulation.coordinates().normal_coordinate(e));
  });
}

py::array constraints(const Bound_triangulation& self)
{
  const Triangulation& triangulation = self.triangulation();
  return array_over(triangulation.mesh().edges(), [&](IT::Edge_index e) {
    return std::uint8_t(triangulation.is_constrained(e));
  });
}

py::tuple inserted_vertices(const Bound_triangulation& self)
{
  std::vector<Location> result;
  for(const auto& place : self.triangulation().inserted_vertices())
    result.push_back(IT::face_location(place, self.triangulation().input_mesh()));
  return arrays_of(result);
}

// ---- The correspondence ----

// Returns the position of a point of a trace, also for ends that are inserted vertices inside
// faces.
Location location_on_input(const IT::Edge_point<double>& p, IT::Vertex_index v,
                           const Triangulation& triangulation)
{
  return p.halfedge.is_valid()
           ? IT::face_location(IT::edge_location(p), triangulation.input_mesh())
           : IT::face_location(triangulation.inserted_vertex(v), triangulation.input_mesh());
}

// Returns polylines, one for each edge: their starts, and the points on both triangulations.
py::tuple trace(const Bound_triangulation& self, bool is_input, const Index_array& edge_numbers)
{
  const IT::Side side = side_of(is_input);
  std::vector<std::int64_t> starts{0};
  std::vector<Location> on_other;
  std::vector<double> along;
  released([&] {
    const auto& correspondence = self.correspondence();
    const Triangulation& triangulation = self.triangulation();
    const IT::Delta_complex& mesh = correspondence.mesh(side);
    for(const std::int64_t number : vector_of(edge_numbers)) {
      if(number < 0 || number >= std::int64_t(mesh.number_of_edges()))
        throw Element_error("InputError", "there is no edge " + std::to_string(number), {});
      const IT::Halfedge_index h =
        IT::first_halfedge(IT::Edge_index(static_cast<Mesh::size_type>(number)));
      const auto points = IT::trace_edge(side, h, correspondence);
      for(std::size_t i = 0; i < points.size(); ++i) {
        const auto& p = points[i];
        const IT::Vertex_index v = i == 0 ? mesh.source(h) : mesh.target(h);
        along.push_back(is_input ? p.on_input.t : p.on_intrinsic.t);
        on_other.push_back(
          is_input ? IT::face_location(IT::edge_location(p.on_intrinsic), triangulation.mesh())
                   : location_on_input(p.on_input, v, triangulation));
      }
      starts.push_back(std::int64_t(on_other.size()));
    }
  });
  const py::tuple places = arrays_of(on_other);
  return py::make_tuple(array_of(std::move(starts)), places[0], places[1],
                        array_of(std::move(along)));
}

py::tuple points_across(const Bound_triangulation& self, bool from_input, const Index_array& faces,
                        const Number_array& coordinates)
{
  std::vector<Location> points;
  released([&] {
    const auto& correspondence = self.correspondence();
    const IT::Side side = side_of(from_input);
    points = locations_of(faces, coordinates, correspondence.mesh(side).number_of_faces());
    for(Location& p : points)
      p = IT::point_across(correspondence, side, p);
  });
  return arrays_of(points);
}

py::array function_across(const Bound_triangulation& self, bool from_input,
                          const Number_array& values)
{
  return array_of(released([&] {
    const Eigen::VectorXd there = IT::transfer_function<Triangulation::Traits>(
      self.correspondence(), side_of(from_input),
      Eigen::Map<const Eigen::VectorXd>(values.data(), values.size()));
    return std::vector<double>(there.begin(), there.end());
  }));
}

// Returns the matrix of the values at the vertices of a subdivision of functions that are linear on
// the faces of one side.
auto matrix_of_side(const Subdivision& subdivision, IT::Side side)
{
  return matrix_of_weights(subdivision.mesh().number_of_vertices(),
                           subdivision.mesh(side).number_of_vertices(), [&](std::size_t row) {
                             return subdivision.weights(side,
                                                        IT::Vertex_index(Mesh::size_type(row)));
                           });
}

struct Polygon_arrays
{
  std::vector<std::int64_t> corners, starts{0}, input_face, intrinsic_face;
};

// Returns the polygons. Faces with two sides have no area and are omitted.
Polygon_arrays polygons_of(const Subdivision& subdivision)
{
  Polygon_arrays result;
  const auto& mesh = subdivision.mesh();
  for(const IT::Face_index f : mesh.faces()) {
    if(mesh.degree(f) < 3)
      continue;
    for(const IT::Halfedge_index h : mesh.halfedges_around_face(mesh.halfedge(f)))
      result.corners.push_back(mesh.source(h).idx());
    result.starts.push_back(std::int64_t(result.corners.size()));
    result.input_face.push_back(subdivision.parent_face(IT::Side::input, f).idx());
    result.intrinsic_face.push_back(subdivision.parent_face(IT::Side::intrinsic, f).idx());
  }
  return result;
}

// Returns the positions, which are empty if the surface has none.
std::vector<std::array<double, 3>> positions_of(Subdivision& subdivision, const Surface* surface)
{
  std::vector<std::array<double, 3>> result;
  if(surface == nullptr)
    return result;
  auto& mesh = subdivision.mesh();
  IT::interpolate(IT::Side::input, subdivision, surface->point_map(), mesh.points());
  result.reserve(mesh.number_of_vertices());
  for(const Point& p : mesh.points())
    result.push_back({p.x(), p.y(), p.z()});
  return result;
}

py::dict common_subdivision(const Bound_triangulation& self)
{
  Polygon_arrays polygons;
  std::vector<std::array<double, 3>> positions;
  Eigen::SparseMatrix<double, Eigen::RowMajor> from_input, from_intrinsic;
  released([&] {
    Subdivision subdivision(self.correspondence());
    positions = positions_of(subdivision, self.has_positions() ? self.surface().get() : nullptr);
    polygons = polygons_of(subdivision);
    from_input = matrix_of_side(subdivision, IT::Side::input);
    from_intrinsic = matrix_of_side(subdivision, IT::Side::intrinsic);
  });
  py::dict result;
  if(self.has_positions())
    result["points"] = array_of(std::move(positions));
  result["corners"] = array_of(std::move(polygons.corners));
  result["starts"] = array_of(std::move(polygons.starts));
  result["input_face"] = array_of(std::move(polygons.input_face));
  result["intrinsic_face"] = array_of(std::move(polygons.intrinsic_face));
  result["from_input"] = sparse_arrays(std::move(from_input));
  result["from_intrinsic"] = sparse_arrays(std::move(from_intrinsic));
  return result;
}

// ---- Certificates and files ----

py::dict dictionary_of(const IT::Delaunay_certificate& certificate)
{
  py::dict result;
  result["is_delaunay"] = certificate.is_Delaunay();
  result["is_geodesic"] = certificate.is_geodesic();
  result["undecided"] = certificate.undecided();
  result["ties"] = indices_of(certificate.ties);
  result["non_delaunay_edges"] = indices_of(certificate.non_Delaunay_edges);
  result["non_straight_edges"] = indices_of(certificate.non_straight_edges);
  result["folded_vertices"] = indices_of(certificate.folded_vertices);
  result["visible_vertices"] = indices_of(std::vector<IT::Vertex_index>());
  result["decisions"] = py::dict(py::arg("lengths") = certificate.decided_by_lengths,
                                 py::arg("floating_point") = certificate.decided_in_floating_point,
                                 py::arg("multiprecision") = certificate.decided_in_multiprecision,
                                 py::arg("exact") = certificate.decided_exactly);
  return result;
}

py::dict certify(const Bound_triangulation& self)
{
  return dictionary_of(released([&] { return IT::certify_Delaunay(self.triangulation()); }));
}

py::dict certify_weighted(const Bound_triangulation& self, const Number_array& weights,
                          const Index_array& hidden)
{
  const std::vector<double> weight = vector_of(weights);
  std::vector<IT::Vertex_index> hidden_vertices;
  for(const std::int64_t v : vector_of(hidden))
    hidden_vertices.emplace_back(static_cast<IT::Vertex_index::size_type>(v));
  const IT::Weighted_Delaunay_certificate certificate = released([&] {
    return IT::certify_weighted_Delaunay(self.triangulation(),
                                         boost::make_function_property_map<IT::Vertex_index>(
                                           [&](IT::Vertex_index v) { return weight[v.idx()]; }),
                                         hidden_vertices);
  });
  py::dict result = dictionary_of(static_cast<const IT::Delaunay_certificate&>(certificate));
  result["is_delaunay"] = certificate.is_weighted_Delaunay();
  result["undecided"] = certificate.undecided();
  result["visible_vertices"] = indices_of(certificate.visible_vertices);
  return result;
}

std::string text_of(const Bound_triangulation& self)
{
  return released([&] {
    std::ostringstream text;
    IT::write_intrinsic_triangulation(text, self.triangulation());
    return text.str();
  });
}

// Checks that only blank lines follow the text that has been read.
void expect_end(std::istringstream& stream, const std::string& text)
{
  if((stream >> std::ws).eof())
    return;
  const auto lines = std::count(text.begin(), text.begin() + stream.tellg(), '\n');
  throw IT::File_format_error("text follows the triangulation",
                              static_cast<std::size_t>(lines) + 1);
}

std::unique_ptr<Bound_triangulation> triangulation_from_text(const std::string& text,
                                                             const Shared_surface& surface)
{
  return released([&] {
    std::istringstream stream(text);
    auto result =
      std::make_unique<Bound_triangulation>(surface, IT::read_intrinsic_triangulation<>(stream));
    expect_end(stream, text);
    return result;
  });
}

std::unique_ptr<Bound_triangulation> make_triangulation(const Shared_surface& surface,
                                                        double mollification, bool keeps_mesh)
{
  return released([&] {
    return std::make_unique<Bound_triangulation>(
      surface, keeps_mesh ? triangulation_of(*surface, mollification)
                          : triangulation_from(*surface, mollification));
  });
}

} // namespace

void bind_triangulation(py::module_& module)
{
  py::class_<Bound_triangulation>(module, "Triangulation")
    .def(py::init(&make_triangulation))
    .def_static("from_text", &triangulation_from_text)
    .def("copy",
         [](const Bound_triangulation& self) {
           return released([&] {
             return std::make_unique<Bound_triangulation>(self.surface(), self.triangulation());
           });
         })
    .def("make_delaunay", &make_Delaunay)
    .def("make_weighted_delaunay", &make_weighted_Delaunay)
    .def("refine", &refine)
    .def("constrain", &constrain)
    .def("constraints", &constraints)
    .def("is_delaunay",
         [](const Bound_triangulation& self) {
           return released([&] { return IT::is_Delaunay(self.triangulation()); });
         })
    .def("faces", [](const Bound_triangulation& self,
                     bool is_input) { return array_of(corners_of(mesh_of(self, is_input))); })
    .def("input_corners", &input_corners)
    .def("place_of_vertex", &place_of_vertex)
    .def("number_of_faces", [](const Bound_triangulation& self,
                               bool is_input) { return mesh_of(self, is_input).number_of_faces(); })
    .def("face_edges", &face_edges)
    .def("edges", &edges)
    .def("lengths", &lengths)
    .def("normal_coordinates", &normal_coordinates)
    .def("inserted_vertices", &inserted_vertices)
    .def("number_of_vertices",
         [](const Bound_triangulation& self) {
           return self.triangulation().mesh().number_of_vertices();
         })
    .def("number_of_input_vertices",
         [](const Bound_triangulation& self) {
           return self.triangulation().input_mesh().number_of_vertices();
         })
    .def("trace", &trace)
    .def("points_across", &points_across)
    .def("function_across", &function_across)
    .def("common_subdivision", &common_subdivision)
    .def("certify", &certify)
    .def("certify_weighted", &certify_weighted)
    .def("to_text", &text_of);
}
