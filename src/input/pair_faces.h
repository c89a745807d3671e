// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAIR_FACES_H
#define CGAL_REEB_GRAPH_SRC_PAIR_FACES_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"
#include "input/soup_counts.h"

#include <array>
#include <cstddef>
#include <vector>

namespace reeb_graph_program {
// Which faces go on in each other at the edges.
struct Face_pairs
{
  std::vector<Polygon_side> sides;
  std::vector<std::size_t> mates; // of the sides, by their numbers; a side without another one is its own
  std::vector<char> is_turned;    // of the faces: which ones are to be reversed so that pairs agree, if that can be
};

// Pairs both faces of an edge of two, unless no orientation agrees there with the other ones.
Face_pairs pair_two_faces(const Polygons& polygons);

// Pairs those, and where there are more, each
// face that runs along the edge goes on in one that runs against it: in the order of their angles, across gaps outside,
// so that what two solids share does not part them. Each decision is exact.
Face_pairs pair_faces(const Polygon_soup& soup);

// Cuts the mesh open where faces are not paired: each fan of pairs gets a vertex of its own, the first one the given one.
// Where edges at one place then have both ends in common, each gets a midpoint. Returns two given vertices for each vertex
// that is added behind the others: a copy has the same one twice, a midpoint the ends of its edge.
std::vector<std::array<Corner, 2>> split_at_pairs(Polygon_soup& soup, const Face_pairs& pairs, Repair_counts& counts);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAIR_FACES_H
