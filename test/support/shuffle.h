// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_SHUFFLE_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_SHUFFLE_H

#include "generated_surfaces/Triangle_soup.h"
#include "random_meshes.h"

#include <cstddef>
#include <numeric>
#include <vector>

namespace generated_surfaces {

// Gives each vertex the new number that stands at its old one.
inline void renumber(Triangle_soup& soup, const std::vector<std::size_t>& new_numbers)
{
  const auto points = soup.points;
  for(std::size_t v = 0; v < points.size(); ++v)
    soup.points[new_numbers[v]] = points[v];
  for(auto& triangle : soup.triangles)
    for(std::size_t& v : triangle)
      v = new_numbers[v];
}

// Puts the vertices and the triangles in a random order.
inline void shuffle(Triangle_soup& soup, random_meshes::Random& random)
{
  std::vector<std::size_t> new_numbers(soup.points.size());
  std::iota(new_numbers.begin(), new_numbers.end(), std::size_t(0));
  random.shuffle(new_numbers);
  renumber(soup, new_numbers);
  random.shuffle(soup.triangles);
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_SHUFFLE_H
