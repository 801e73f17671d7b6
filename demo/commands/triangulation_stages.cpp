// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/triangulation_stages.h"

#include "Program_error.h"
#include "commands/kept_edges.h"
#include "page/show_angles.h"
#include "pictures/develop_faces.h"

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/certify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/certify_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/edge_lengths.h>
#include <CGAL/Intrinsic_triangulations/enclose_crossing.h>
#include <CGAL/Intrinsic_triangulations/interpolation.h>
#include <CGAL/Intrinsic_triangulations/io.h>
#include <CGAL/Intrinsic_triangulations/make_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_weighted_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/refine.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

const auto in_parallel = IT::parameters::concurrency_tag(CGAL::Parallel_if_available_tag());

Edge_bool_map constrained_edges(Input_mesh& input, const Constraints& constraints)
{
  auto result =
    input.mesh.add_property_map<Mesh::Edge_index, bool>("e:is_constrained", false).first;
  if(constraints.angle > 0)
    mark_sharp_edges(input.mesh, constraints.angle, result);
  if(constraints.has_seams)
    mark_seams(input.data, input.mesh, result);
  return result;
}

IT::Refinement_result refined(Triangulation& triangulation, const Refinement_bounds& bounds,
                              bool is_exact)
{
  const std::size_t limit = bounds.maximum_number_of_insertions
                              ? *bounds.maximum_number_of_insertions
                              : IT::default_maximum_number_of_insertions(
                                  triangulation, bounds.minimum_angle, bounds.maximum_circumradius);
  return IT::refine(triangulation, IT::parameters::minimum_angle(bounds.minimum_angle)
                                     .maximum_circumradius(bounds.maximum_circumradius)
                                     .simplicial(bounds.is_simplicial)
                                     .maximum_number_of_insertions(limit)
                                     .exact_decisions(is_exact));
}

template <typename Certificate>
void describe_certificate(Statistics& statistics, const Certificate& certificate, bool is_certified)
{
  statistics["certified"] = is_certified;
  statistics["ties"] = certificate.ties.size();
  statistics["undecided"] = certificate.undecided();
  statistics["non_delaunay_edges"] = certificate.non_Delaunay_edges.size();
  statistics["decisions"] = {{"lengths", certificate.decided_by_lengths},
                             {"floating_point", certificate.decided_in_floating_point},
                             {"multiprecision", certificate.decided_in_multiprecision},
                             {"exact", certificate.decided_exactly}};
}

// Returns whether the edges are certainly Delaunay, if they are straight.
bool is_certainly_Delaunay(const IT::Delaunay_certificate& certificate)
{
  return certificate.non_Delaunay_edges.empty() && certificate.possibly_non_Delaunay_edges.empty();
}

} // namespace

double length_of_mollification(Command_run& run)
{
  Mesh& mesh = run.input().mesh;
  auto lengths = mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
  IT::compute_edge_lengths(mesh, lengths);
  const double epsilon = run.options().mollification;
  return epsilon > 0 ? IT::mollify(mesh, lengths, epsilon) : 0;
}

Edge_length_map edge_lengths(Command_run& run)
{
  const double added = length_of_mollification(run);
  if(run.options().mollification > 0) {
    run.statistics()["mollification"] = run.options().mollification;
    run.statistics()["added_length"] = added;
  }
  return run.input().mesh.add_property_map<Mesh::Edge_index, double>("e:length").first;
}

double mollification(Command_run& run)
{
  if(run.options().mollification > 0)
    edge_lengths(run);
  return run.options().mollification;
}

Triangulation make_triangulation(Command_run& run, const Constraints& constraints)
{
  Mesh& mesh = run.input().mesh;
  const auto np =
    IT::parameters::edge_is_constrained_map(constrained_edges(run.input(), constraints));
  return Triangulation(mesh, np.mollification(mollification(run)));
}

Triangulation make_delaunay_triangulation(Command_run& run, const Constraints& constraints)
{
  Triangulation result = run.timed("build", [&] { return make_triangulation(run, constraints); });
  run.timed("flip", [&] {
    Step_counter counter{run.progress()};
    run.statistics()["flips"] = IT::make_Delaunay(
      result, in_parallel.visitor(std::ref(counter)).exact_decisions(run.options().is_exact));
  });
  return result;
}

Triangulation make_weighted_delaunay_triangulation(Command_run& run, const Constraints& constraints,
                                                   const std::vector<double>& weights)
{
  Triangulation result = run.timed("build", [&] { return make_triangulation(run, constraints); });
  const auto weight = boost::make_function_property_map<IT::Vertex_index>(
    [&weights](IT::Vertex_index v) { return weights[v.idx()]; });
  IT::Weighted_Delaunay_result<double> weighted;
  run.timed("flip", [&] {
    Step_counter counter{run.progress()};
    weighted = IT::make_weighted_Delaunay(
      result, weight,
      IT::parameters::visitor(std::ref(counter)).exact_decisions(run.options().is_exact));
  });
  Statistics& statistics = run.statistics();
  statistics["flips"] = weighted.flips;
  if(run.options().is_exact) {
    const IT::Weighted_Delaunay_certificate certificate = run.timed("certify", [&] {
      return IT::certify_weighted_Delaunay(result, weight, weighted.hidden_vertices, in_parallel);
    });
    describe_certificate(statistics, certificate, certificate.is_weighted_Delaunay());
    statistics["is_weighted_delaunay"] = is_certainly_Delaunay(certificate);
  } else
    statistics["is_weighted_delaunay"] = IT::is_weighted_Delaunay(result, weighted.weight_map());
  statistics["hidden_vertices"] = Statistics::array();
  for(const IT::Vertex_index v : weighted.hidden_vertices)
    statistics["hidden_vertices"].push_back(v.idx());
  return result;
}

void check_insertions(const Refinement_bounds& bounds)
{
  if(bounds.maximum_number_of_insertions && bounds.minimum_angle == 0 &&
     std::isinf(bounds.maximum_circumradius))
    throw Program_error("--max-insertions has no effect on --min-angle 0; give a greater angle");
}

std::size_t maximum_number_of_insertions(const Refinement_bounds& bounds,
                                         std::size_t number_of_faces)
{
  return bounds.maximum_number_of_insertions.value_or(IT::default_maximum_number_of_insertions(
    number_of_faces, bounds.minimum_angle, bounds.maximum_circumradius));
}

IT::Refinement_result refine_triangulation(Command_run& run, Triangulation& triangulation,
                                           const Refinement_bounds& bounds)
{
  const IT::Refinement_result result =
    run.timed("refine", [&] { return refined(triangulation, bounds, run.options().is_exact); });
  Statistics& statistics = run.statistics();
  statistics["flips"] = statistics["flips"].get<std::size_t>() + result.flips;
  statistics["inserted_vertices"] = triangulation.number_of_inserted_vertices();
  statistics["faces_below_bound"] = result.remaining.size();
  statistics["faces_excused"] =
    std::count_if(result.remaining.begin(), result.remaining.end(), IT::is_excused);
  statistics["status"] = IT::to_string(result.status);
  if(result.is_exact && !run.options().is_exact)
    statistics["exact_decisions"] = true;
  return result;
}

void refine_if_wanted(Command_run& run, Triangulation& triangulation,
                      const Refinement_bounds& bounds)
{
  if(bounds.minimum_angle > 0)
    refine_triangulation(run, triangulation, bounds);
}

IT::Delaunay_certificate certify(Command_run& run, const Triangulation& triangulation)
{
  const IT::Delaunay_certificate certificate =
    run.timed("certify", [&] { return IT::certify_Delaunay(triangulation, in_parallel); });
  describe_certificate(run.statistics(), certificate, certificate.is_Delaunay());
  return certificate;
}

void describe(Command_run& run, const Triangulation& triangulation)
{
  run.statistics()["is_delaunay"] = run.options().is_exact
                                      ? is_certainly_Delaunay(certify(run, triangulation))
                                      : IT::is_Delaunay(triangulation);
  describe_edges(run.statistics(), triangulation);
}

void describe_edges(Statistics& statistics, const Triangulation& triangulation)
{
  const auto& coordinates = triangulation.coordinates();
  std::size_t shared = 0;
  std::int64_t crossings = 0;
  double length = 0;
  for(const IT::Edge_index e : triangulation.mesh().edges()) {
    if(coordinates.is_shared(e))
      ++shared;
    else
      crossings += coordinates.normal_coordinate(e);
    length += triangulation.length(e);
  }
  statistics["shared_edges"] = shared;
  statistics["crossings"] = crossings;
  statistics["edge_length_sum"] = length;
  statistics["min_angle_degrees"] =
    IT::smallest_angle_in_degrees(triangulation.mesh(), triangulation.length_map());
}

Subdivision subdivide(Command_run& run, const Triangulation& triangulation)
{
  const auto correspondence =
    run.timed("trace", [&] { return IT::Correspondence<>(triangulation, in_parallel); });
  if(run.options().is_exact)
    run.timed("certify", [&] {
      const IT::Place_certificate places = IT::certify_places(correspondence);
      run.statistics()["place_error"] = places.greatest_error;
      run.statistics()["indefinite_places"] = places.indefinite;
    });
  Subdivision result = run.timed("subdivide", [&] {
    Subdivision subdivision(correspondence, in_parallel);
    IT::interpolate(IT::Side::input, subdivision, run.input().mesh.points(),
                    subdivision.mesh().points(), in_parallel);
    return subdivision;
  });
  const Mesh& mesh = result.mesh();
  describe_subdivision(run.statistics(), mesh.number_of_vertices(), mesh.number_of_edges(),
                       mesh.number_of_faces());
  return result;
}

std::vector<double> curvatures(Command_run& run)
{
  const Mesh& mesh = run.input().mesh;
  const Edge_length_map length = edge_lengths(run);
  std::vector<double> result(mesh.number_of_vertices()), area(mesh.number_of_vertices(), 0);
  IT::compute_curvatures(
    mesh, length,
    boost::make_iterator_property_map(result.begin(), get(boost::vertex_index, mesh)));
  for(const Mesh::Halfedge_index h : mesh.halfedges())
    if(!mesh.is_border(h))
      area[mesh.target(h)] +=
        IT::quadrupled_area(length[mesh.edge(h)], length[mesh.edge(mesh.next(h))],
                            length[mesh.edge(mesh.prev(h))]) /
        12;
  for(const Mesh::Vertex_index v : mesh.vertices())
    result[v] = area[v] > 0 && !mesh.is_border(v) ? result[v] / area[v] : 0;
  return result;
}

namespace {

// Reports that --direct has no effect.
void note_subdivision(Command_run& run)
{
  const char* reason = run.options().mollification > 0
                         ? "edges are longer than in space"
                         : "too many edges cross a face for single precision";
  run.progress().clear();
  std::cerr << run.options().input
            << ": note: the page shows the common subdivision, in spite of --direct: " << reason
            << '\n';
}

// Lets the page draw the last surface without the subdivision, if this is large or on request.
void develop_if_large(View_page& page, Command_run& run, const Triangulation& triangulation,
                      const Subdivision& subdivision, std::vector<Attribute> vertex_data)
{
  const Common_options& options = run.options();
  const bool is_large = subdivision.mesh().number_of_faces() > most_polygons;
  if(!is_large && !options.is_direct)
    return;
  const auto& points = run.input().mesh.points();
  auto faces = options.mollification > 0
                 ? std::nullopt
                 : develop_faces(triangulation, {points.begin(), points.end()},
                                 {{"curvature", curvatures(run)}}, std::move(vertex_data));
  if(faces) {
    add_input_data(run.input(), faces->input);
    page.set_developed(std::move(*faces));
  } else if(options.is_direct && !options.is_quiet)
    note_subdivision(run);
}

} // namespace

void show(View_page& page, Command_run& run, const Triangulation& triangulation,
          const Subdivision& subdivision, Output_mesh mesh, std::vector<Attribute> vertex_data)
{
  mesh.point_data.push_back(
    {"curvature", interpolated(IT::Side::input, curvatures(run), subdivision)});
  add_input_data(run.input(), mesh);
  page.add_surface("surface", mesh);
  show_angles(page, "input", run.input().mesh, edge_lengths(run));
  show_angles(page, "intrinsic", triangulation.mesh(), triangulation.length_map());
  develop_if_large(page, run, triangulation, subdivision, std::move(vertex_data));
}

void show(Command_run& run, const Triangulation& triangulation)
{
  run.show([&](View_page& page) {
    const Subdivision subdivision = subdivide(run, triangulation);
    show(page, run, triangulation, subdivision, subdivision_mesh(subdivision));
  });
}

void save(Command_run& run, const Triangulation& triangulation)
{
  if(run.options().save.empty())
    return;
  std::ostringstream text;
  IT::write_intrinsic_triangulation(text, triangulation);
  run.add_output(run.options().save, text.str());
}

std::string summary_of_changes(Command_run& run)
{
  const Statistics& s = run.statistics();
  std::ostringstream text;
  text << s["flips"] << " flips, ";
  if(s.contains("status"))
    text << s["inserted_vertices"] << " vertices inserted (" << s["status"].get<std::string>()
         << (s.contains("exact_decisions") ? ", with exact decisions because of rounding errors"
                                           : "")
         << "), ";
  if(s.contains("status") && s["status"] == to_string(IT::Refinement_status::insertion_limit))
    text << s["faces_below_bound"]
         << " faces are left: ask for smaller angles or larger faces, or raise --max-insertions, ";
  text << "smallest angle " << run.input().diagnosis.statistics().min_angle << " -> "
       << s["min_angle_degrees"].get<double>() << " degrees";
  return text.str();
}
