// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PROGRAM_H
#define INTRINSIC_PROGRAM_H

// Runs the program with the arguments of `main()` and returns its exit code. It is 0 for success,
// and 1 if a result is impossible. It is 2 if the arguments or the input are wrong, and 3 if a
// failed map is written on request. Errors are written to the standard error.
int run_program(int argc, const char* const* argv);

#endif // INTRINSIC_PROGRAM_H
