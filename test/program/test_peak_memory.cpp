// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/costs.h"

#include <cstdlib>
#include <iostream>
#include <vector>

// The peak of memory is told in bytes on each system, although systems count it in different units.
int main()
{
  const std::size_t size = 100'000'000, tolerance = 50'000'000;
  const std::size_t before = reeb_graph_program::peak_memory_bytes();
  const std::vector<char> memory(size, 'x');
  const char* volatile const seen = memory.data(); // Otherwise, a compiler may leave out the vector.
  const std::size_t difference = reeb_graph_program::peak_memory_bytes() - before;
  if(difference + tolerance > size && difference < size + tolerance && seen[size - 1] == 'x')
    return EXIT_SUCCESS;
  std::cerr << "the peak grew by " << difference << " bytes with a vector of " << size << '\n';
  return EXIT_FAILURE;
}
