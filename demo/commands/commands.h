// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMANDS_H
#define INTRINSIC_COMMANDS_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct Info_options
{
  std::string input;
  std::string view;    // a page; empty if it is not wanted
  std::string picture; // SVG or PNG; empty if it is not wanted
  bool is_json = false;
};

// Prints what is wrong with a mesh, what is worth noting and a few numbers.
// Returns the exit code: 2 if the mesh cannot be worked on.
int info(const Info_options& options);

struct View_options
{
  std::vector<std::string> inputs;
  std::string output;
};

// Writes a page that shows meshes beside each other, with their defects. Returns the exit code.
int view(const View_options& options);

// What all commands on intrinsic triangulations have; empty paths are outputs that are not wanted.
struct Common_options
{
  std::string input;
  std::string save;
  std::string statistics;
  std::string view;                            // a page
  std::string picture;                         // SVG or PNG
  std::pair<std::string, std::string> section; // of the picture: a point, empty for all; a radius
  double mollification = 0;
  bool is_repair_wanted = false;
  double weld_distance = 0;             // zero for no repair by it
  bool is_strict = false;               // faces must be triangles, and keep their lengths
  bool is_direct = false;               // pages are drawn without a common subdivision
  std::size_t number_of_neighbors = 0;  // in a cloud of points; zero if there must be faces
  std::optional<std::size_t> component; // the one that is mapped; all if not given
  bool is_largest_chosen = false;       // the component with the greatest area
  bool is_exact = false;                // decisions about Delaunay edges, with a certificate
  bool is_failure_kept = false;         // a map that is no success is written
  bool is_failure_expected = false;     // this is what there is, after all else has been tried
  bool is_quiet = false;
  std::size_t threads = 0; // 0 for as many as there are processors
};

// The output of a command that is a mesh.
struct Output_options
{
  explicit Output_options(const char* default_format) : format(default_format) {}

  std::string output;
  std::string format; // on standard output
  bool is_binary = false;
};

struct Delaunay_options : Output_options
{
  Delaunay_options() : Output_options("off") {}

  double constrained_angle = 0; // in degrees; 0 for none
};

// Flips to the intrinsic Delaunay triangulation and writes its common subdivision with the input.
// Returns the exit code.
int delaunay(const Common_options& common, const Delaunay_options& options);

// What the faces of a refined triangulation shall obey, and how many vertices that may take.
struct Refinement_bounds
{
  double minimum_angle = 0; // in degrees; 0 for none
  double maximum_circumradius = std::numeric_limits<double>::infinity();
  std::optional<std::size_t>
    maximum_number_of_insertions; // the default of the library if not given
  bool is_simplicial = false;
};

struct Refine_options : Output_options
{
  Refine_options() : Output_options("off") { bounds.minimum_angle = 25; }

  double constrained_angle = 0; // in degrees; 0 for none
  Refinement_bounds bounds;
};

// Inserts vertices into the intrinsic Delaunay triangulation until its faces obey the bounds, and
// writes its common subdivision with the input, or its own faces. Returns the exit code.
int refine(const Common_options& common, const Refine_options& options);

struct Distance_options : Output_options
{
  Distance_options() : Output_options("ply") {}

  std::string subdivision;
  std::vector<std::string> sources; // points as `surface_point()` reads them
  std::string curve;                // a file; empty for none
  std::string level_sets;           // a file; empty if they are not wanted
  std::vector<double> levels;       // none for a choice
  bool is_signed = false;
  std::optional<double> time_step_factor;
  Refinement_bounds refinement; // none without an angle
  std::string method = "auto";  // or "exact", "heat"
};

// Computes distances on the intrinsic Delaunay triangulation, refined if that is wanted, and writes
// the input with them. Returns the exit code.
int distance(const Common_options& common, const Distance_options& options);

struct Path_options : Output_options
{
  Path_options() : Output_options("obj") {}

  // points as `surface_point()` reads them
  std::string from;             // empty for a homology basis
  std::string to;               // empty for a loop or a straightest path, too
  std::vector<std::string> via; // vertices where the path goes along edges before it is shortened
  bool is_loop = false;
  bool is_flipped = false;        // a geodesic near the path along edges, not the shortest
  bool is_homology_basis = false; // geodesic loops around all handles and holes
  std::optional<std::pair<double, double>> straightest; // degrees and length
};

// Finds a shortest path, a geodesic or a loop, a straightest path, or the loops of a homology
// basis, and writes them as lines. Returns the exit code.
int path(const Common_options& common, const Path_options& options);

struct Transfer_options
{
  std::string output;
  std::string points;           // a file; empty if functions are transferred
  std::string data;             // a file; empty if points are
  bool is_back = false;         // from the intrinsic triangulation to the mesh
  Refinement_bounds refinement; // none without an angle
};

// Takes points or a function from the mesh to its intrinsic Delaunay triangulation, refined if that
// is wanted, or back. Returns the exit code.
int transfer(const Common_options& common, const Transfer_options& options);

struct Operators_options
{
  std::string prefix;
  Refinement_bounds refinement; // none without an angle
};

// Writes the matrices of the intrinsic Delaunay triangulation, refined if that is wanted.
// Returns the exit code.
int operators(const Common_options& common, const Operators_options& options);

// Of the commands whose output has a texture.
struct Texture_options : Output_options
{
  Texture_options() : Output_options("obj") {}

  bool is_homogeneous = false;
};

struct Flatten_options : Texture_options
{
  std::string cones; // "greedy", "none" or a file; empty for what suits the boundary
  std::optional<double> maximum_log_scale; // for greedy cones
  std::string boundary = "free";
  std::string boundary_values;   // the file of "scale" and "curvature"
  std::string solver = "newton"; // or "ceres" or "cetm"
  std::string matrix;            // a file for the interpolation matrix
  bool has_no_overlap = false;   // charts are cut where they overlap
  bool is_in_unit_square = false;
};

// Maps the surface to the plane, discretely conformally, and writes the common subdivision of its
// three triangulations with texture coordinates. Returns the exit code.
int flatten(const Common_options& common, const Flatten_options& options);

struct Hyperbolic_options : Texture_options
{
  std::string cones;        // a file; empty for none
  std::string picture;      // an SVG file
  std::optional<int> depth; // of the tiling in the picture; three if not given
};

// Gives the surface curvature -1, maps it to the hyperbolic plane, and writes the common
// subdivision with texture coordinates in the disk, and a picture of the tiling. Returns the exit
// code.
int hyperbolic(const Common_options& common, const Hyperbolic_options& options);

// Gives the surface the constant curvature of its topology, and writes it as `sphere()`,
// `flatten()` or `hyperbolic()` does, of whose options the last serve for all. Returns the exit
// code.
int uniformize(const Common_options& common, const Hyperbolic_options& options);

struct Sphere_options : Output_options
{
  Sphere_options() : Output_options("ply") {}

  std::string precise; // positions in all digits; empty if not wanted
};

// Maps the surface to the sphere or a hemisphere, discretely conformally, and writes the common
// subdivision of its three triangulations there. Returns the exit code.
int sphere(const Common_options& common, const Sphere_options& options);

struct Simplify_options : Output_options
{
  Simplify_options() : Output_options("ply") {}

  std::string coarse_mesh; // a file for the coarse triangulation in space
  std::string prolongation;
  // one of these is given
  std::optional<std::size_t> number_of_vertices;
  std::optional<double> ratio; // of the number of vertices
  std::optional<double> maximum_cost;
  std::vector<std::string> weights; // as "name=value"
  std::size_t number_of_levels = 1;
  Refinement_bounds refinement;    // of the fine triangulation; none without an angle
  double coarse_minimum_angle = 0; // of the coarse triangulation; 0 for no refinement
  double closed_length = 0;        // of boundary loops that are closed before
  double pinched_length = 0;       // of edge loops along which handles are cut before
};

// Removes vertices from the intrinsic Delaunay triangulation, refined if that is wanted, refines
// what is left if that is wanted, and writes its common subdivision with the input, itself as an
// ordinary mesh, and the matrices that take functions from coarse vertices to those of the level
// before. Returns the exit code.
int simplify(const Common_options& common, const Simplify_options& options);

#endif // INTRINSIC_COMMANDS_H
