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

namespace reeb_graph_program {
// Makes the surface of oriented faces. Returns false, and leaves the surface in any state, unless each edge is that of
// at most one face on each side, and the faces at each vertex are one fan. The surface is the same, numbers of
// halfedges included, as that of CGAL::Euler::add_face() for one face after the other, which takes two to three times
// as long. Vertices of faces have to exist, and no face may have one of them twice.
bool assemble_surface(const Polygon_soup& soup, Surface& surface);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_ASSEMBLE_SURFACE_H
