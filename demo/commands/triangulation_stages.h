// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATION_STAGES_H
#define INTRINSIC_TRIANGULATION_STAGES_H

#include "commands/Command_run.h"
#include "writing/subdivision_mesh.h"

#include <CGAL/Intrinsic_triangulations/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Refinement_result.h>

#include <cstddef>
#include <string>
#include <vector>

using Triangulation = CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>;

using Edge_length_map = Mesh::Property_map<Mesh::Edge_index, double>;

// Stores edges of the input that are not flipped.
struct Constraints
{
  double angle = 0;       // those at which the normals differ by it or more, in degrees; 0 for none
  bool has_seams = false; // those of the texture
};

// Returns the length that mollification adds to each edge of the input, or zero if it is not
// requested.
double length_of_mollification(Command_run& run);

// Shows flips or removals as they are made.
struct Step_counter
{
  Progress_bar& progress;

  void after_flip(CGAL::Intrinsic_triangulations::Halfedge_index) { progress.step(); }
  void before_exact_flips() {}
  template <class Star>
  void before_removal(const Star&, double)
  {}
  void after_removal(CGAL::Intrinsic_triangulations::Vertex_index) { progress.step(); }
};

// Returns the lengths of the edges of the input, mollified if this is requested. Adds the
// mollification to the statistics.
Edge_length_map edge_lengths(Command_run& run);

// Returns the named parameter for the mollification of lengths. Adds the mollification to the
// statistics.
double mollification(Command_run& run);

// The names of stages are arguments of `Command_run::plan()`.
inline const Stages delaunay_stages{"build", "flip"};
// Returns the stages of the certificate, which exists only for exact decisions.
inline Stages certificate_stages(const Common_options& options)
{
  return options.is_exact ? Stages{"certify"} : Stages{};
}
inline const Stages subdivision_stages{"trace", "subdivide"};
// Returns the stages of refinement, which needs a bound on the angle.
inline Stages refinement_stages(const Refinement_bounds& bounds)
{
  return bounds.minimum_angle > 0 ? Stages{"refine"} : Stages{};
}

// Checks that a limit of insertions comes with a bound that needs insertions.
// \throws Program_error if it does not
void check_insertions(const Refinement_bounds& bounds);

// Returns the stages of a requested page or picture, if nothing else needs the subdivision.
inline Stages view_stages(const Common_options& options)
{
  return options.is_shown() ? subdivision_stages : Stages{};
}

// Returns the triangulation T2 = T1 of the input, mollified if this is requested.
Triangulation make_triangulation(Command_run& run, const Constraints& constraints = {});

// Runs the stages "build" and "flip". Returns the intrinsic Delaunay triangulation of the input,
// made as by `make_triangulation()`.
Triangulation make_delaunay_triangulation(Command_run& run, const Constraints& constraints = {});

// Runs the stage "refine", which inserts vertices until the faces satisfy the bounds. Adds its
// result to the statistics.
CGAL::Intrinsic_triangulations::Refinement_result
refine_triangulation(Command_run& run, Triangulation& triangulation,
                     const Refinement_bounds& bounds);

// Refines if a bound on the angle is given.
void refine_if_wanted(Command_run& run, Triangulation& triangulation,
                      const Refinement_bounds& bounds);

// Returns how many vertices may be inserted into a surface with this number of faces.
std::size_t maximum_number_of_insertions(const Refinement_bounds& bounds,
                                         std::size_t number_of_faces);

// Runs the stage "certify". Returns the certificate, and adds it to the statistics.
CGAL::Intrinsic_triangulations::Delaunay_certificate certify(Command_run& run,
                                                             const Triangulation& triangulation);

// Returns the triangulation after flips to the weighted Delaunay triangulation for the weights of
// vertices.
Triangulation make_weighted_delaunay_triangulation(Command_run& run, const Constraints& constraints,
                                                   const std::vector<double>& weights);

// Describes the triangulation in the statistics, with the certificate if decisions are exact.
void describe(Command_run& run, const Triangulation& triangulation);

// Describes the triangulation in the statistics, apart from the Delaunay condition.
void describe_edges(Statistics& statistics, const Triangulation& triangulation);

// Runs the stages "trace" and "subdivide". Returns the common subdivision in space, and adds its
// size to the statistics.
Subdivision subdivide(Command_run& run, const Triangulation& triangulation);

// Shows a subdivision on the page, with the curvature of the input, and histograms of the angles of
// the input and of the triangulation.
//
// If the subdivision is large, or on request, the page draws the surface without it, with functions
// `vertex_data` on the triangulation. Prints a note if the page cannot do this on request. It
// cannot if lengths were mollified, because the page computes lengths of the input from its points,
// or if single precision is insufficient.
void show(View_page& page, Command_run& run, const Triangulation& triangulation,
          const Subdivision& subdivision, Output_mesh mesh,
          std::vector<Attribute> vertex_data = {});

// Computes and shows the common subdivision of the triangulation.
void show(Command_run& run, const Triangulation& triangulation);

// Returns the curvature of each vertex of the input, divided by its area; zero on the boundary.
std::vector<double> curvatures(Command_run& run);

// Adds the file of the triangulation to the outputs, if it is requested.
void save(Command_run& run, const Triangulation& triangulation);

// Summarizes flips and insertions.
// Precondition: the triangulation has been described.
std::string summary_of_changes(Command_run& run);

#endif // INTRINSIC_TRIANGULATION_STAGES_H
