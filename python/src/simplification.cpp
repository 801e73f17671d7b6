// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "Watch.h"
#include "bindings.h"

#include <CGAL/Intrinsic_simplification/Evolving_surface.h>
#include <CGAL/Intrinsic_simplification/Surface_level.h>
#include <CGAL/Intrinsic_simplification/Surface_map.h>
#include <CGAL/Intrinsic_simplification/coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/Edge_point.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <limits>

namespace IS = CGAL::Intrinsic_simplification;

namespace {

typedef std::shared_ptr<Surface> Shared_surface;

// Stores a coarse surface with the map to the input, which refers to the other members.
class Bound_simplification
{
public:
  Bound_simplification(Shared_surface surface, double mollification)
    : m_surface(std::move(surface)),
      m_evolving(triangulation_of(*m_surface, mollification)),
      m_fine(m_evolving)
  {}

  Bound_simplification(const Bound_simplification&) = delete;
  Bound_simplification& operator=(const Bound_simplification&) = delete;

  void run(std::size_t number_of_vertices, double maximum_cost, Watch& watch)
  {
    IS::Transport_cost cost = IS::default_cost(m_evolving);
    m_result = IS::simplify(m_evolving, cost,
                            IS::parameters::number_of_vertices(number_of_vertices)
                              .maximum_cost(maximum_cost)
                              .visitor(std::ref(watch)));
    m_coarse.emplace(m_evolving);
    m_map.emplace(m_evolving, m_fine, *m_coarse);
  }

  const Surface& surface() const { return *m_surface; }
  const IS::Evolving_surface& evolving() const { return m_evolving; }
  const IS::Simplification_result& result() const { return m_result; }
  const IS::Surface_level& fine() const { return m_fine; }
  const IS::Surface_level& coarse() const { return *m_coarse; }
  const IS::Surface_map& map() const { return *m_map; }

private:
  Shared_surface m_surface;
  IS::Evolving_surface m_evolving;
  IS::Surface_level m_fine;
  IS::Simplification_result m_result;
  std::optional<IS::Surface_level> m_coarse;
  std::optional<IS::Surface_map> m_map;
};

py::array coarse_vertices(const Bound_simplification& self)
{
  return array_over(self.coarse().mesh().vertices(), [&](IT::Vertex_index v) {
    return std::int64_t(self.coarse().surface_vertex(v).idx());
  });
}

py::tuple points_mapped(const Bound_simplification& self, bool to_coarse, const Index_array& faces,
                        const Number_array& coordinates)
{
  return arrays_of(released([&] {
    const IS::Surface_level& from = to_coarse ? self.fine() : self.coarse();
    const auto points = locations_of(faces, coordinates, from.mesh().number_of_faces());
    return to_coarse ? self.map().to_coarse(points) : self.map().to_fine(points);
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
    const auto result = IS::coarse_mesh(self.evolving(), self.fine(), mesh,
                                        IS::parameters::input_point_map(self.surface().point_map())
                                          .parent_vertex_map(fine_vertex)
                                          .location_map(location));
    for(const Mesh::Vertex_index v : mesh.vertices()) {
      const IS::Vertex_index parent = fine_vertex[v];
      parents.push_back(parent.is_valid() ? std::int64_t(parent.idx()) : -1);
      places.push_back(parent.is_valid() ? place_of(parent, self.fine().mesh()) : location[v]);
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

std::unique_ptr<Bound_simplification> simplified(const Shared_surface& surface,
                                                 std::size_t number_of_vertices,
                                                 double maximum_cost, double mollification,
                                                 const py::object& progress)
{
  Watch watch(progress, "simplify");
  return released([&] {
    auto result = std::make_unique<Bound_simplification>(surface, mollification);
    result->run(number_of_vertices, maximum_cost, watch);
    return result;
  });
}

} // namespace

void bind_simplification(py::module_& module)
{
  typedef Bound_simplification Bound;
  py::class_<Bound>(module, "Simplification")
    .def(py::init(&simplified))
    .def("removed", [](const Bound& self) { return self.result().removed; })
    .def("greatest_cost", [](const Bound& self) { return self.result().greatest_cost; })
    .def("faces", [](const Bound& self) { return array_of(corners_of(self.coarse().mesh())); })
    .def("face_edges", [](const Bound& self) { return face_edges_of(self.coarse().mesh()); })
    .def("lengths", [](const Bound& self) { return lengths_of(self.coarse()); })
    .def("vertices", &coarse_vertices)
    .def("mapped", &points_mapped)
    .def("prolongation",
         [](const Bound& self) {
           return sparse_arrays(released([&] { return IS::prolongation_matrix(self.map()); }));
         })
    .def("triangulation",
         [](const Bound& self) {
           return released([&] {
             return std::make_unique<Bound_triangulation>(nullptr, self.coarse().triangulation());
           });
         })
    .def("coarse_mesh", &mesh_in_space);
}
