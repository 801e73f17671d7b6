// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_COMMAND_LINE_H
#define INTRINSIC_COMMAND_LINE_H

#include "commands/commands.h"

#include <CLI/CLI.hpp>

// The options of all commands, of which one is called.
struct Options
{
  Info_options info;
  View_options view;
  Common_options common;
  Delaunay_options delaunay;
  Refine_options refine;
  Distance_options distance;
  Path_options path;
  Transfer_options transfer;
  Operators_options operators;
  Flatten_options flatten;
  Hyperbolic_options hyperbolic;
  Sphere_options sphere;
  Simplify_options simplify;
};

// Declares to `app` what can stand on the command line; parsing sets `options`, which must live as
// long.
void define_command_line(CLI::App& app, Options& options);

#endif // INTRINSIC_COMMAND_LINE_H
