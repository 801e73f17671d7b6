// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program.h"

#include <cstdlib> // for __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

// Keeps freed memory for its next use. If large arrays are allocated and freed, the system would
// spend up to a quarter of the time on new pages and their initialization.
void keep_memory()
{
#ifdef __GLIBC__
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
#endif
}

} // namespace

int main(int argc, char** argv)
{
  keep_memory();
  return run_program(argc, argv);
}
