// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program.h"

int main(int argc, char** argv) { return run_program(argc, argv); }
