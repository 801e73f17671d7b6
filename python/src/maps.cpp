// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "Watch.h"
#include "bindings.h"

#include "reading/map_names.h"
#include "reading/missed_promises.h"

#include <CGAL/Discrete_conformal_maps/charts.h>
#include <CGAL/Discrete_conformal_maps/flatten.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_disk.h>
#include <CGAL/Discrete_conformal_maps/flatten_to_rectangle.h>
#include <CGAL/Discrete_conformal_maps/hyperbolic_texture_points.h>
#include <CGAL/Discrete_conformal_maps/map_to_sphere.h>
#include <CGAL/Discrete_conformal_maps/sphere_points.h>
#include <CGAL/Discrete_conformal_maps/texture_points.h>
#include <CGAL/Discrete_conformal_maps/uniformize.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <functional>
#include <limits>
#include <type_traits>
#include <variant>

namespace DCM = CGAL::Discrete_conformal_maps;

namespace {

typedef std::shared_ptr<Surface> Shared_surface;

// Stores a map with its surface.
template <class Map>
struct Bound_map
{
  Shared_surface surface;
  Map map;
  std::size_t iterations;
};
typedef Bound_map<DCM::Planar_conformal_map> Bound_planar_map;
typedef Bound_map<DCM::Spherical_conformal_map> Bound_spherical_map;
typedef Bound_map<DCM::Hyperbolic_conformal_map> Bound_hyperbolic_map;

// ---- Computation ----

struct Flattening_options
{
  std::string cones = "none", boundary = "free", layout = "least-squares";
  bool keeps_triangulation = false, is_exact = false;
  double maximum_log_scale, maximum_area_distortion, mollification;
};

// Returns the condition at each vertex: a logarithmic scale factor, or a curvature.
std::vector<DCM::Vertex_condition> conditions_of(const Index_array& has_log_scale,
                                                 const Number_array& values)
{
  std::vector<DCM::Vertex_condition> result;
  for(std::size_t v = 0; v < std::size_t(values.size()); ++v)
    result.push_back(has_log_scale.data()[v] != 0
                       ? DCM::Vertex_condition::log_scale(values.data()[v])
                       : DCM::Vertex_condition::curvature(values.data()[v]));
  return result;
}

template <class Parameters>
DCM::Planar_conformal_map shaped(const IT::Delta_complex& mesh, const std::string& boundary,
                                 const Parameters& np)
{
  if(boundary == "disk")
    return DCM::flatten_to_disk(mesh, np);
  if(boundary == "rectangle")
    return DCM::flatten_to_rectangle(mesh, DCM::rectangle_corners(mesh, np), np);
  return DCM::flatten(mesh, np);
}

// Returns the result of `compute(np)`, where `np` are the parameters that all maps have.
template <class Compute>
auto computed(const Shared_surface& surface, const Number_array& radii, double mollification,
              const py::object& progress, const Compute& compute)
{
  Watch watch(progress, "build");
  return released([&] {
    const auto radius =
      boost::make_iterator_property_map(radii.data(), get(boost::vertex_index, surface->mesh));
    auto map = with_lengths(*surface,
                            DCM::parameters::mollification(mollification)
                              .vertex_radius_map(radius)
                              .visitor(std::ref(watch)),
                            compute);
    return Bound_map<decltype(map)>{surface, std::move(map), watch.iterations()};
  });
}

Bound_planar_map flattened(const Shared_surface& surface, const Flattening_options& options,
                           const Index_array& has_log_scale, const Number_array& values,
                           const Number_array& radii, const py::object& progress)
{
  return computed(surface, radii, options.mollification, progress, [&](const auto& np) {
    const auto conditions = conditions_of(has_log_scale, values);
    const auto condition = boost::make_iterator_property_map(
      conditions.begin(), get(boost::vertex_index, surface->mesh));
    return shaped(
      surface->mesh, options.boundary,
      np.vertex_condition_map(condition)
        .cones(cones_named(options.cones))
        .maximum_log_scale(options.maximum_log_scale)
        .maximum_area_distortion(options.maximum_area_distortion)
        .layout(layout_named(options.layout))
        .flipping(options.keeps_triangulation ? DCM::Flipping::none : DCM::Flipping::to_Delaunay)
        .exact_decisions(options.is_exact));
  });
}

Bound_spherical_map mapped_to_sphere(const Shared_surface& surface, const Number_array& radii,
                                     double mollification, const py::object& progress)
{
  return computed(surface, radii, mollification, progress,
                  [&](const auto& np) { return DCM::map_to_sphere(surface->mesh, np); });
}

Bound_hyperbolic_map mapped_to_hyperbolic(const Shared_surface& surface,
                                          const Number_array& curvatures, const Number_array& radii,
                                          double mollification, const py::object& progress)
{
  return computed(surface, radii, mollification, progress, [&](const auto& np) {
    std::vector<DCM::Vertex_condition> conditions;
    for(const double c : vector_of(curvatures))
      conditions.push_back(DCM::Vertex_condition::curvature(c));
    const auto condition = boost::make_iterator_property_map(
      conditions.begin(), get(boost::vertex_index, surface->mesh));
    return DCM::uniformize_hyperbolic(surface->mesh, np.vertex_condition_map(condition));
  });
}

// ---- What all maps have ----

// Returns a value of the map at each vertex of the input.
template <class Map, class Value>
py::array at_vertices(const Bound_map<Map>& self, const Value& value)
{
  return array_over(self.surface->mesh.vertices(),
                    [&](IT::Vertex_index v) { return value(DCM::Vertex_index(v.idx())); });
}

py::dict promises_of(const DCM::Discrete_conformal_map& map)
{
  py::dict result;
  for(const DCM::Map_promise& p : map.promises())
    result[p.name] = py::make_tuple(p.error, p.bound);
  return result;
}

// Adds the part of the subdivision that belongs to the input. It has polygons with the corners of
// each, their parents, and the weights of vertices of the input.
void add_elements(const DCM::Input_part& part, const Surface& surface, py::dict& result)
{
  std::vector<std::int64_t> corners, starts{0}, input_face;
  std::vector<std::array<double, 3>> points;
  Eigen::SparseMatrix<double, Eigen::RowMajor> from_input;
  released([&] {
    const auto& mesh = part.mesh();
    for(const DCM::Face_index f : part.faces()) {
      for(const DCM::Halfedge_index h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
        corners.push_back(part.number(mesh.target(h)));
      starts.push_back(std::int64_t(corners.size()));
      input_face.push_back(part.subdivision().parent_face(DCM::Layer::A, f).idx());
    }
    from_input =
      matrix_of_weights(part.vertices().size(), surface.mesh.number_of_vertices(),
                        [&](std::size_t row) { return part.input_weights(part.vertices()[row]); });
    for(std::size_t row = 0; surface.has_positions() && row < part.vertices().size(); ++row) {
      const auto w = part.input_weights(part.vertices()[row]);
      Kernel::Vector_3 sum = CGAL::NULL_VECTOR;
      for(std::size_t c = 0; c < w.size; ++c)
        sum += w.weight[c] * (surface.points[w.vertex[c]] - CGAL::ORIGIN);
      points.push_back({sum.x(), sum.y(), sum.z()});
      if(w.size == 1) // without rounding
        for(int k = 0; k < 3; ++k)
          points.back()[std::size_t(k)] = surface.points[w.vertex[0]][k];
    }
  });
  result["corners"] = array_of(std::move(corners));
  result["starts"] = array_of(std::move(starts));
  result["input_face"] = array_of(std::move(input_face));
  result["from_input"] = sparse_arrays(std::move(from_input));
  if(surface.has_positions())
    result["points"] = array_of(std::move(points));
}

// Returns texture coordinates, and their indices at the corners.
template <class Map>
py::dict flat_subdivision(const Bound_map<Map>& self)
{
  std::vector<std::int64_t> corner_texture;
  std::vector<std::array<double, 2>> texture;
  std::vector<std::array<double, 3>> homogeneous;
  const DCM::Input_part part(self.map);
  released([&] {
    const DCM::Texture_corners corners(self.map, part);
    for(const DCM::Face_index f : part.faces())
      for(const DCM::Halfedge_index h :
          CGAL::halfedges_around_face(part.mesh().halfedge(f), part.mesh()))
        corner_texture.push_back(corners.index(h));
    texture = DCM::texture_points(self.map, part, corners).points;
    homogeneous = DCM::homogeneous_texture_points(self.map, part, corners).points;
  });
  py::dict result;
  add_elements(part, *self.surface, result);
  result["corner_texture"] = array_of(std::move(corner_texture));
  result["texture"] = array_of(std::move(texture));
  result["homogeneous_texture"] = array_of(std::move(homogeneous));
  return result;
}

// Returns points of the unit sphere.
py::dict sphere_subdivision(const Bound_spherical_map& self)
{
  std::vector<std::array<double, 3>> sphere;
  std::vector<std::array<double, 4>> homogeneous;
  const DCM::Input_part part(self.map);
  released([&] {
    homogeneous = DCM::homogeneous_coordinates(self.map, part);
    sphere = DCM::sphere_points(self.map, part, homogeneous).points;
  });
  py::dict result;
  add_elements(part, *self.surface, result);
  result["sphere"] = array_of(std::move(sphere));
  result["homogeneous"] = array_of(std::move(homogeneous));
  return result;
}

py::array positions_of(const Bound_spherical_map& self)
{
  return at_vertices(self, [&](DCM::Vertex_index v) { return self.map.position(v); });
}

// Returns images of points of the input.
template <class Map>
py::array images(const Bound_map<Map>& self, const Index_array& faces,
                 const Number_array& coordinates)
{
  const auto points = locations_of(faces, coordinates, self.surface->mesh.number_of_faces());
  if constexpr(std::is_same<Map, DCM::Spherical_conformal_map>::value) {
    std::vector<std::array<double, 3>> result;
    released([&] {
      for(const Location& p : points)
        result.push_back(self.map(p));
    });
    return array_of(std::move(result));
  } else {
    std::vector<std::array<double, 2>> result;
    released([&] {
      for(const Location& p : points) {
        const std::complex<double> z = self.map(p);
        result.push_back({z.real(), z.imag()});
      }
    });
    return array_of(std::move(result));
  }
}

template <class Map>
py::class_<Bound_map<Map>> bind_map(py::module_& module, const char* name)
{
  typedef Bound_map<Map> Bound;
  return py::class_<Bound>(module, name)
    .def("status", [](const Bound& self) { return DCM::to_string(self.map.status()); })
    .def("message",
         [](const Bound& self) {
           const std::string cause = self.map.cause();
           return DCM::message(self.map.status()) + missed_promises(self.map.promises()) +
                  (cause.empty() ? cause : "; " + cause);
         })
    .def("is_laid_out", [](const Bound& self) { return self.map.is_laid_out(); })
    .def("promises", [](const Bound& self) { return promises_of(self.map); })
    .def("iterations", [](const Bound& self) { return self.iterations; })
    .def("max_curvature_error", [](const Bound& self) { return self.map.max_curvature_error(); })
    .def("crowded_faces", [](const Bound& self) { return indices_of(self.map.crowded_faces()); })
    .def("log_scales",
         [](const Bound& self) {
           return at_vertices(self, [&](auto v) { return self.map.log_scale(v); });
         })
    .def("images", &images<Map>);
}

// ---- Uniformization ----

// Returns the type of the surface, the map, and the modulus or None.
py::tuple uniformized(const Shared_surface& surface, const Number_array& radii,
                      double mollification, const py::object& progress)
{
  auto [shared, result, iterations] =
    computed(surface, radii, mollification, progress,
             [&](const auto& np) { return DCM::uniformize(surface->mesh, np); });
  py::object map = std::visit(
    [&, count = iterations](auto& any) {
      return py::cast(Bound_map<std::decay_t<decltype(any)>>{surface, std::move(any), count});
    },
    result.map);
  return py::make_tuple(DCM::to_string(result.type), map,
                        result.modulus ? py::cast(*result.modulus) : py::none());
}

} // namespace

void bind_maps(py::module_& module)
{
  bind_map<DCM::Planar_conformal_map>(module, "PlanarMap")
    .def("cones", [](const Bound_planar_map& self) { return indices_of(self.map.cones()); })
    .def("radii",
         [](const Bound_planar_map& self) {
           return at_vertices(self, [&](auto v) { return self.map.scaled_radius(v); });
         })
    .def(
      "cut_overlaps",
      [](Bound_planar_map& self) { return released([&] { return DCM::cut_overlaps(self.map); }); })
    .def("fit_into_unit_square",
         [](Bound_planar_map& self) { return DCM::fit_into_unit_square(self.map); })
    .def("subdivision", &flat_subdivision<DCM::Planar_conformal_map>);
  bind_map<DCM::Spherical_conformal_map>(module, "SphericalMap")
    .def("is_disk", [](const Bound_spherical_map& self) { return self.map.is_disk(); })
    .def("is_flat", [](const Bound_spherical_map& self) { return self.map.is_flat(); })
    .def("positions", &positions_of)
    .def("radii",
         [](const Bound_spherical_map& self) {
           return at_vertices(self, [&](auto v) { return self.map.circle_radius(v); });
         })
    .def("subdivision", &sphere_subdivision);
  bind_map<DCM::Hyperbolic_conformal_map>(module, "HyperbolicMap")
    .def("area", [](const Bound_hyperbolic_map& self) { return self.map.area(); })
    .def("radius", [](const Bound_hyperbolic_map& self) { return self.map.radius(); })
    .def("radii",
         [](const Bound_hyperbolic_map& self) {
           return at_vertices(self, [&](auto v) { return self.map.circle_radius(v); });
         })
    .def("subdivision", &flat_subdivision<DCM::Hyperbolic_conformal_map>);
  module.def("flatten",
             [](const Shared_surface& surface, const std::string& cones, double maximum_log_scale,
                double maximum_area_distortion, const std::string& boundary,
                const std::string& layout, bool keeps_triangulation, bool is_exact,
                double mollification, const Index_array& has_log_scale, const Number_array& values,
                const Number_array& radii, const py::object& progress) {
               return flattened(surface,
                                {cones, boundary, layout, keeps_triangulation, is_exact,
                                 maximum_log_scale, maximum_area_distortion, mollification},
                                has_log_scale, values, radii, progress);
             });
  module.def("to_sphere", &mapped_to_sphere);
  module.def("to_hyperbolic", &mapped_to_hyperbolic);
  module.def("uniformize", &uniformized);
}
