// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_PIECE_WEIGHTS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_PIECE_WEIGHTS_H

#include <CGAL/license/Reeb_graph.h>

// The weights of pieces are measures of them.
#include <CGAL/Reeb_graph/piece_measures.h>

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_PIECE_WEIGHTS_H
