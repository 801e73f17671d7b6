// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PROGRAM_ERROR_H
#define INTRINSIC_PROGRAM_ERROR_H

#include <CGAL/Intrinsic_triangulations/exceptions.h>

#include <exception>
#include <stdexcept>

// Reports a wrong input or call: exit code 2. Any other exception is a failed computation: exit
// code 1.
class Program_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Reports a map without a property that it must have.
class Map_failure : public CGAL::Intrinsic_triangulations::Numerical_error
{
public:
  using Numerical_error::Numerical_error;
};

#endif // INTRINSIC_PROGRAM_ERROR_H
