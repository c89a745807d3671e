// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/find_duplicates.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace reeb_graph_program {
namespace {
// The polygons from their smallest vertices on; if their orientation does not matter, towards the smaller neighbour.
Polygons normalize(const Polygons& polygons, bool have_same_orientation)
{
  Polygons result;
  result.reserve(polygons.size());
  std::vector<Corner> corners;
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    corners.assign(polygons[i].begin(), polygons[i].end());
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    if(!have_same_orientation && corners.back() < corners[1])
      std::reverse(corners.begin() + 1, corners.end());
    for(const Corner v : corners)
      result.add_corner(v);
    result.end_polygon();
  }
  return result;
}
} // namespace

Duplicates find_duplicates(const Polygons& polygons, bool have_same_orientation)
{
  const Polygons normalized = normalize(polygons, have_same_orientation);
  const auto is_less = [&](std::size_t i, std::size_t j) {
    return std::lexicographical_compare(normalized[i].begin(), normalized[i].end(), normalized[j].begin(),
                                        normalized[j].end());
  };
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), is_less);
  Duplicates duplicates;
  duplicates.firsts.resize(polygons.size());
  for(std::size_t k = 0; k < order.size(); ++k)
  {
    const bool is_repeated = k > 0 && !is_less(order[k - 1], order[k]);
    duplicates.firsts[order[k]] = is_repeated ? duplicates.firsts[order[k - 1]] : order[k];
    if(is_repeated)
      duplicates.numbers.push_back(order[k]);
  }
  std::sort(duplicates.numbers.begin(), duplicates.numbers.end());
  duplicates.number = duplicates.numbers.size();
  if(duplicates.number > 0)
    duplicates.first = duplicates.numbers.front();
  return duplicates;
}

} // namespace reeb_graph_program
