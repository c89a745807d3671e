// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_H
#define CGAL_REEB_GRAPH_IO_H

#include <CGAL/license/Reeb_graph.h>

// Reading and writing, by formats.
#include <CGAL/Reeb_graph/IO/csv.h>
#include <CGAL/Reeb_graph/IO/graphml.h>
#include <CGAL/Reeb_graph/IO/graphviz.h>
#include <CGAL/Reeb_graph/IO/json.h>
#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph_traits.h>

#endif // CGAL_REEB_GRAPH_IO_H
