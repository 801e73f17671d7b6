// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Bound_triangulation.h"
#include "Watch.h"
#include "bindings.h"

#include <CGAL/Intrinsic_triangulations/Distance_sources.h>
#include <CGAL/Intrinsic_triangulations/Precise_surface.h>
#include <CGAL/Intrinsic_triangulations/Tufted_surface.h>
#include <CGAL/Intrinsic_triangulations/connection_laplacian.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/local_triangulations.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/operators.h>
#include <CGAL/Intrinsic_triangulations/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/weighted_laplacian.h>

#include <boost/property_map/function_property_map.hpp>

#include <pybind11/stl.h>

#include <complex>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

namespace {

typedef Eigen::SparseMatrix<double> Matrix;

// Returns a matrix by name. Functions of the Python layer have the same names.
template <class Surface>
Matrix matrix_of(const std::string& name, const Surface& surface)
{
  if(name == "laplacian")
    return IT::rounded_values(IT::cotan_laplacian(surface));
  if(name == "mass")
    return IT::rounded_values(IT::mass_matrix(surface));
  if(name == "lumped_mass")
    return IT::rounded_values(IT::lumped_mass_matrix(surface));
  if(name == "gradient")
    return IT::rounded_values(IT::gradient_matrix(surface));
  return IT::rounded_values(IT::divergence_matrix(surface));
}

py::tuple operator_of(const Bound_triangulation& self, const std::string& name)
{
  return sparse_arrays(released([&] {
    return IT::with_resolved_areas(self.triangulation(),
                                   [&](const auto& surface) { return matrix_of(name, surface); });
  }));
}

py::tuple weighted_laplacian(const Bound_triangulation& self, const Number_array& weights)
{
  const std::vector<double> weight = vector_of(weights);
  return sparse_arrays(released([&] {
    return IT::with_resolved_areas(self.triangulation(), [&](const auto& surface) {
      return IT::rounded_values(
        IT::weighted_laplacian(surface, boost::make_function_property_map<IT::Vertex_index>(
                                          [&](IT::Vertex_index v) { return weight[v.idx()]; })));
    });
  }));
}

// Returns the matrix in the frames of the input.
py::tuple connection_laplacian(const Bound_triangulation& self)
{
  return sparse_arrays(released([&] {
    Eigen::SparseMatrix<std::complex<double>> result =
      IT::with_resolved_areas(self.triangulation(), [&](const auto& surface) {
        const IT::Tangent_frames<IT::Length_of<std::decay_t<decltype(surface)>>> frames(surface);
        return IT::rounded_values(IT::connection_laplacian(surface, frames));
      });
    const std::vector<std::complex<double>> rotation = rotations_to_input(self.triangulation());
    for(Eigen::Index j = 0; j < result.cols(); ++j)
      for(decltype(result)::InnerIterator i(result, j); i; ++i)
        i.valueRef() *= rotation[std::size_t(i.row())] * std::conj(rotation[std::size_t(j)]);
    return result;
  }));
}

// Wraps triangles that need not be a surface, with the Delaunay triangulation of their tufted
// cover.
class Bound_soup
{
public:
  // Without faces, points are triangulated with so many neighbors.
  Bound_soup(const Number_array& points, const Index_array& faces, std::size_t neighbors,
             double mollification, Watch& watch)
  {
    Polygon_soup soup = checked_soup_of(points, faces, mollification > 0);
    m_points = soup.points;
    m_share = faces.size() == 0 ? 1. / 6 : 1. / 2;
    if(faces.size() == 0)
      for(const auto& triangle : IT::local_triangulations(soup.points, neighbors))
        soup.polygons.push_back(triangle);
    m_cover.emplace(IT::tufted_cover(soup.points, soup.polygons));
    m_triangulation = Triangulation(m_cover->mesh(), IT::parameters::mollification(mollification));
    IT::make_Delaunay(m_triangulation,
                      IT::parameters::exact_decisions(false).visitor(std::ref(watch)));
  }

  template <class Use>
  auto with_surface(const Use& use) const
  {
    return IT::with_resolved_areas(m_triangulation, [&](const auto& surface) {
      typedef IT::Length_of<std::decay_t<decltype(surface)>> FT;
      return use(IT::Tufted_surface<FT>(*m_cover, surface, m_share));
    });
  }

  // Returns the distances of all points from the nearest of some vertices, by heat.
  std::vector<double> distances(const std::vector<std::int64_t>& vertices,
                                std::optional<double> time_step_factor) const
  {
    const auto point = boost::make_function_property_map<IT::Vertex_index>(
      [&](IT::Vertex_index v) { return m_points[v.idx()]; });
    const auto np = IT::parameters::vertex_point_map(point);
    return with_surface([&](const auto& surface) {
      IT::Distance_sources<std::decay_t<decltype(surface)>> sources(surface);
      for(const std::int64_t v : vertices)
        sources.add(IT::Vertex_index(static_cast<Mesh::size_type>(v)));
      const auto found =
        time_step_factor
          ? IT::geodesic_distances(surface, sources, np.time_step_factor(*time_step_factor))
          : IT::geodesic_distances(surface, sources, np);
      std::vector<double> result;
      for(const auto& d : found.distance)
        result.push_back(CGAL::to_double(d));
      return result;
    });
  }

private:
  std::vector<Point> m_points;
  std::optional<IT::Tufted_cover<Point>> m_cover;
  Triangulation m_triangulation;
  double m_share;
};

} // namespace

void bind_operators(py::module_& module)
{
  module.def("operator_of", &operator_of);
  module.def("connection_laplacian", &connection_laplacian);
  module.def("weighted_laplacian", &weighted_laplacian);
  py::class_<Bound_soup>(module, "Soup")
    .def(py::init([](const Number_array& points, const Index_array& faces, std::size_t neighbors,
                     double mollification, const py::object& progress) {
      Watch watch(progress, "flip");
      return released([&] {
        return std::make_unique<Bound_soup>(points, faces, neighbors, mollification, watch);
      });
    }))
    .def("operator_of",
         [](const Bound_soup& self, const std::string& name) {
           return sparse_arrays(released([&] {
             return self.with_surface(
               [&](const auto& surface) { return matrix_of(name, surface); });
           }));
         })
    .def("distances", [](const Bound_soup& self, const Index_array& vertices,
                         std::optional<double> time_step_factor) {
      return array_of(
        released([&] { return self.distances(vector_of(vertices), time_step_factor); }));
    });
}
