// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Prints how many seconds std::sort takes for the numbers of a file, the median of nine times: the unit of other times.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

int main(int argc, char* argv[])
{
  std::ifstream file(argc > 1 ? argv[1] : "");
  const std::vector<double> numbers(std::istream_iterator<double>(file), std::istream_iterator<double>{});
  if(numbers.empty())
    return EXIT_FAILURE;
  std::array<double, 9> seconds;
  for(double& time : seconds)
  {
    std::vector<double> copy = numbers;
    const std::clock_t begin = std::clock();
    std::sort(copy.begin(), copy.end());
    time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
  std::sort(seconds.begin(), seconds.end());
  std::cout << seconds[seconds.size() / 2] << '\n';
  return EXIT_SUCCESS;
}
