// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMANDS_H
#define INTRINSIC_COMMANDS_H

#include <cstdint>
#include <string>
#include <vector>

struct Info_options
{
  std::string input;
  bool is_json = false;
};

// Prints what is wrong with a mesh, what is worth noting and a few numbers.
// Returns the exit code: 2 if the mesh cannot be worked on.
int info(const Info_options& options);

// What all commands on intrinsic triangulations have; empty paths are outputs that are not wanted.
struct Common_options
{
  std::string input;
  std::string save;
  std::string statistics;
  double mollification = 0;
  bool is_repair_wanted = false;
  bool is_quiet = false;
};

struct Delaunay_options
{
  std::string output;
  std::string format = "off";   // on standard output
  double constrained_angle = 0; // in degrees; 0 for none
};

// Flips to the intrinsic Delaunay triangulation and writes its common subdivision with the input.
// Returns the exit code.
int delaunay(const Common_options& common, const Delaunay_options& options);

struct Distance_options
{
  std::string output;
  std::string subdivision;
  std::string format = "ply"; // on standard output
  std::vector<std::int64_t> sources;
  double time_step_factor = 1;
};

// Computes distances on the intrinsic Delaunay triangulation and writes the input with them.
// Returns the exit code.
int distance(const Common_options& common, const Distance_options& options);

struct Operators_options
{
  std::string prefix;
};

// Writes the matrices of the intrinsic Delaunay triangulation.
// Returns the exit code.
int operators(const Common_options& common, const Operators_options& options);

#endif // INTRINSIC_COMMANDS_H
