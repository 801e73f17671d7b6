// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMANDS_H
#define INTRINSIC_COMMANDS_H

#include <string>

struct Info_options
{
  std::string input;
  bool is_json = false;
};

// Prints what is wrong with a mesh, what is worth noting and a few numbers.
// Returns the exit code: 2 if the mesh cannot be worked on.
int info(const Info_options& options);

struct Delaunay_options
{
  std::string input;
  std::string output;
  std::string format = "off"; // on standard output
  std::string save;
  std::string statistics;
  double mollification = 0;
  double constrained_angle = 0; // in degrees; 0 for none
  bool is_repair_wanted = false;
  bool is_quiet = false;
};

// Flips to the intrinsic Delaunay triangulation and writes its common subdivision with the input.
// Returns the exit code.
int delaunay(const Delaunay_options& options);

#endif // INTRINSIC_COMMANDS_H
