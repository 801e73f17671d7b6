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

// Edges of the input that stay.
struct Constraints
{
  double angle = 0;       // those at which the normals differ by it or more, in degrees; 0 for none
  bool has_seams = false; // those of the texture
};

// What mollification adds to each edge of the input; zero if it is not wanted.
double length_of_mollification(Command_run& run);

// Shows flips or removals while they are made.
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

// The lengths of the edges of the input, mollified if that is wanted; what was added in the
// statistics.
Edge_length_map edge_lengths(Command_run& run);

// The named parameter for what the lengths of surfaces are to be; what is added in the statistics.
double mollification(Command_run& run);

// The names of stages, for `Command_run::plan()`.
inline const Stages delaunay_stages{"build", "flip"};
// none unless decisions are exact
inline Stages certificate_stages(const Common_options& options)
{
  return options.is_exact ? Stages{"certify"} : Stages{};
}
inline const Stages subdivision_stages{"trace", "subdivide"};
// none if there is no bound on the angle
inline Stages refinement_stages(const Refinement_bounds& bounds)
{
  return bounds.minimum_angle > 0 ? Stages{"refine"} : Stages{};
}

// those of a page or picture, if one is wanted, where nothing else needs the subdivision
inline Stages view_stages(const Common_options& options)
{
  return options.is_shown() ? subdivision_stages : Stages{};
}

// The triangulation T2 = T1 of the input, mollified if that is wanted.
Triangulation make_triangulation(Command_run& run, const Constraints& constraints = {});

// The stages "build" and "flip": the intrinsic Delaunay triangulation of the input, made
// as by `make_triangulation()`.
Triangulation make_delaunay_triangulation(Command_run& run, const Constraints& constraints = {});

// The stage "refine": inserts vertices until the faces obey the bounds; how it went in the
// statistics.
CGAL::Intrinsic_triangulations::Refinement_result
refine_triangulation(Command_run& run, Triangulation& triangulation,
                     const Refinement_bounds& bounds);

// Refines if there is a bound on the angle.
void refine_if_wanted(Command_run& run, Triangulation& triangulation,
                      const Refinement_bounds& bounds);

// Returns how many vertices may be inserted into a surface with this number of faces.
std::size_t maximum_number_of_insertions(const Refinement_bounds& bounds,
                                         std::size_t number_of_faces);

// The stage "certify": the certificate, which is added to the statistics.
CGAL::Intrinsic_triangulations::Delaunay_certificate certify(Command_run& run,
                                                             const Triangulation& triangulation);

// Adds what the triangulation is to the statistics, with the certificate if decisions are exact.
void describe(Command_run& run, const Triangulation& triangulation);

// The stages "trace" and "subdivide": the common subdivision in space, its size in the statistics.
Subdivision subdivide(Command_run& run, const Triangulation& triangulation);

// Shows a subdivision on the page, with the curvature of the input, and histograms of the angles of
// the input and of the triangulation.
void show(View_page& page, Command_run& run, const Triangulation& triangulation,
          const Subdivision& subdivision, Output_mesh mesh);

// Lets the page draw the surface that was shown last without the subdivision, if that is large or
// it is wanted, with these functions on the triangulation; not if lengths were mollified, as the
// page takes those of the input from its points.
void develop_if_large(View_page& page, Command_run& run, const Triangulation& triangulation,
                      const Subdivision& subdivision, std::vector<Attribute> vertex_data = {});

// Shows the common subdivision of the triangulation, which is made for that.
void show(Command_run& run, const Triangulation& triangulation);

// The curvature of each vertex of the input, divided by its area; zero on the boundary.
std::vector<double> curvatures(Command_run& run);

// Adds the file of the triangulation to the outputs, if it is wanted.
void save(Command_run& run, const Triangulation& triangulation);

// What flips and insertions did, for a summary.
// Precondition: the triangulation has been described.
std::string summary_of_changes(Command_run& run);

#endif // INTRINSIC_TRIANGULATION_STAGES_H
