// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Replaces operator new of the test program by one that counts. In a file of its own, since
// compilers that see new and delete together warn of free().

#include <cstddef>
#include <cstdlib>
#include <new>

std::size_t number_of_allocations();

namespace {
std::size_t count = 0;
}

std::size_t number_of_allocations() { return count; }

void* operator new(std::size_t size)
{
  ++count;
  if(void* p = std::malloc(size == 0 ? 1 : size))
    return p;
  throw std::bad_alloc();
}

void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
