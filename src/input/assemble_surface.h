// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_ASSEMBLE_SURFACE_H
#define CGAL_REEB_GRAPH_SRC_ASSEMBLE_SURFACE_H

#include "input/Polygon_soup.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// Makes the surface of oriented faces. Returns false, and leaves the surface in any state, unless each edge is that of
// at most one face on each side, and the faces at each vertex are one fan. The surface is the same, numbers of
// halfedges included, as that of CGAL::Euler::add_face() for one face after the other, which takes two to three times
// as long. Vertices of faces have to exist, and no face may have one of them twice.
bool assemble_surface(const Polygon_soup& soup, Surface& surface);

// The points and faces of a surface.
Polygon_soup soup_of(const Surface& surface);

// Makes the border of the tetrahedra the polygons: the faces of only one of them, as they are seen from outside. What
// polygons there were, and are no faces of tetrahedra, is left out. Notes say so. Tetrahedra of volume 0 are taken as
// positively oriented.
void take_border_of_tetrahedra(Polygon_soup& soup);

// Cuts each polygon of n corners into n - 2 triangles, in its place, whose corners are all of its own. A new edge joins no
// two vertices that another edge joins, where that can be avoided: the surface stays what it is. Returns the number of
// the first polygon that cannot be cut: one without area.
std::optional<std::size_t> triangulate_faces(Polygon_soup& soup);

// Cuts some of the polygons in the same way, whose area does not matter.
void cut_into_triangles(Polygon_soup& soup, const std::vector<char>& is_meant);

// Fills borders of at most so many edges with triangles, flat where the border is, unless they would need an edge that is
// there: then they meet in the center of the border, a vertex that is added, with two vertices of the border as origins.
// Returns the number of borders.
std::size_t fill_borders(Polygon_soup& soup, std::size_t most_edges, std::vector<std::array<Corner, 2>>& origins);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_ASSEMBLE_SURFACE_H
