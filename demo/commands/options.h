// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_OPTIONS_H
#define INTRINSIC_OPTIONS_H

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Names a file that a command reads, and the option that gives it.
struct Read_file
{
  std::string option;
  std::string path;
};

// Stores the options of all commands on intrinsic triangulations. Empty paths are outputs that are
// not requested.
struct Common_options
{
  std::string input;
  std::vector<Read_file> read_files; // the input, and the files of options
  std::string save;
  std::string statistics;
  std::string view;                            // a page
  std::string picture;                         // SVG or PNG
  std::pair<std::string, std::string> section; // of the picture: a point, empty for all; a radius
  double mollification = 0;
  bool is_repair_wanted = false;
  double weld_distance = 0;             // at which a repair merges points; zero for none
  bool is_strict = false;               // faces must be triangles, and keep their lengths
  bool is_direct = false;               // pages are drawn without a common subdivision
  std::size_t number_of_neighbors = 0;  // in a cloud of points; zero if there must be faces
  std::optional<std::size_t> component; // the one that is mapped; all if not given
  bool is_largest_chosen = false;       // the component with the greatest area
  bool is_exact = false;                // decisions about Delaunay edges, with a certificate
  bool is_failure_kept = false;         // a map that is no success is written
  bool is_quiet = false;
  std::size_t threads = 0;        // 0 for as many as there are processors
  bool are_soups_allowed = false; // by the command: edges and vertices that are not manifold
  bool are_positions_used = true; // by the command

  bool is_repaired() const { return is_repair_wanted || weld_distance > 0; }
  bool is_shown() const { return !view.empty() || !picture.empty(); } // on a page or in a picture
};

// Stores the options of a command whose output is a mesh.
struct Output_options
{
  explicit Output_options(const char* default_format) : format(default_format) {}

  std::string output;
  std::string format; // on standard output
  bool is_binary = false;
};

// Stores the options of commands whose output is the common subdivision.
struct Subdivision_options : Output_options
{
  Subdivision_options() : Output_options("off") {}

  double constrained_angle = 0; // in degrees; 0 for none
};

struct Delaunay_options : Subdivision_options
{
  std::string weights; // a property of vertices or a file; empty for none
};

// Stores the options of commands whose output has a texture.
struct Texture_options : Output_options
{
  Texture_options() : Output_options("obj") {}

  bool is_homogeneous = false;
};

// Stores the bounds for the faces of a refined triangulation, and for the number of insertions.
struct Refinement_bounds
{
  double minimum_angle = 0; // in degrees; 0 for none
  double maximum_circumradius = std::numeric_limits<double>::infinity();
  std::optional<std::size_t>
    maximum_number_of_insertions; // the default of the library if not given
  bool is_simplicial = false;
};

#endif // INTRINSIC_OPTIONS_H
