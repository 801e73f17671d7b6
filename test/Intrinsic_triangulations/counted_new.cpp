// Copyright (c) 2026 The Intrinsic_triangulations authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Replaces operator new of the test program by one that counts. It is in a separate file, because
// compilers that see new and delete together warn of free().

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

std::size_t number_of_allocations();
std::size_t bytes_in_use();

namespace {

std::atomic<std::size_t> count = 0, bytes = 0; // threads allocate, too

// The size of each block precedes it, in so many bytes that the block is aligned for all types.
constexpr std::size_t header = alignof(std::max_align_t);
static_assert(header >= sizeof(std::size_t));

} // namespace

std::size_t number_of_allocations() { return count; }
std::size_t bytes_in_use() { return bytes; }

void* operator new(std::size_t size)
{
  ++count;
  void* const p = std::malloc(header + size);
  if(!p)
    throw std::bad_alloc();
  bytes += size;
  *static_cast<std::size_t*>(p) = size;
  return static_cast<char*>(p) + header;
}

// std::stable_sort() calls it. That of the address sanitizer does not fit to the delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  try {
    return operator new(size);
  } catch(const std::bad_alloc&) {
    return nullptr;
  }
}

void operator delete(void* p) noexcept
{
  if(!p)
    return;
  void* const whole = static_cast<char*>(p) - header;
  bytes -= *static_cast<std::size_t*>(whole);
  std::free(whole);
}

void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { operator delete(p); }
