// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATION_STAGES_H
#define INTRINSIC_TRIANGULATION_STAGES_H

#include "Command_run.h"
#include "subdivision_mesh.h"

#include <CGAL/Intrinsic_triangulations/Delaunay_certificate.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <string>

using Triangulation = CGAL::Intrinsic_triangulations::Intrinsic_triangulation<>;

using Edge_length_map = Mesh::Property_map<Mesh::Edge_index, double>;

// The lengths of the edges of the input, mollified if that is wanted; what was added in the
// statistics.
Edge_length_map edge_lengths(Command_run& run);

// The names of stages, for `Command_run::plan()`.
inline const Stages delaunay_stages{"build", "flip"};
// none unless decisions are exact
inline Stages certificate_stages(const Common_options& options)
{
  return options.is_exact ? Stages{"certify"} : Stages{};
}
inline const Stages subdivision_stages{"trace", "subdivide"};
// none if there is no bound on the angle
inline Stages refinement_stages(double minimum_angle)
{
  return minimum_angle > 0 ? Stages{"refine"} : Stages{};
}

// The triangulation T2 = T1 of the input, mollified if that is wanted. Edges at which the normals
// differ by `constrained_angle` degrees or more stay; zero for none.
Triangulation make_triangulation(Command_run& run, double constrained_angle = 0);

// The stages "build" and "flip": the intrinsic Delaunay triangulation of the input, made
// as by `make_triangulation()`.
Triangulation make_delaunay_triangulation(Command_run& run, double constrained_angle = 0);

// The stage "refine": inserts vertices until the faces obey the bounds; how it went in the
// statistics.
void refine_triangulation(Command_run& run, Triangulation& triangulation,
                          const Refinement_bounds& bounds);

// Refines with a bound on the angle alone, in degrees; nothing if it is zero.
void refine_if_wanted(Command_run& run, Triangulation& triangulation, double minimum_angle);

// The stage "certify": the certificate, which is added to the statistics.
CGAL::Intrinsic_triangulations::Delaunay_certificate certify(Command_run& run,
                                                             const Triangulation& triangulation);

// Adds what the triangulation is to the statistics, with the certificate if decisions are exact.
void describe(Command_run& run, const Triangulation& triangulation);

// The stages "trace" and "subdivide": the common subdivision in space, its size in the statistics.
Subdivision subdivide(Command_run& run, const Triangulation& triangulation);

// Adds the file of the triangulation to the outputs, if it is wanted.
void save(Command_run& run, const Triangulation& triangulation);

// What flips and insertions did, for a summary.
// Precondition: the triangulation has been described.
std::string summary_of_changes(Command_run& run);

#endif // INTRINSIC_TRIANGULATION_STAGES_H
