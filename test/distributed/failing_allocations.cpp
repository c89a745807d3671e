// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "failing_allocations.h"

#include <cstdlib>
#include <new>

std::size_t failing_allocations::allocations_left = failing_allocations::never;

void* operator new(std::size_t size)
{
  using namespace failing_allocations;
  if(size >= smallest_size && allocations_left != never && allocations_left-- == 0)
    throw std::bad_alloc();
  if(void* const memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
