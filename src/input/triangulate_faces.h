// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_TRIANGULATE_FACES_H
#define CGAL_REEB_GRAPH_SRC_TRIANGULATE_FACES_H

#include "base/surface.h"

namespace reeb_graph_program {
// Cuts faces into triangles, as far as CGAL can.
void triangulate_faces(Surface& surface);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_TRIANGULATE_FACES_H
