// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_ATTRIBUTE_H
#define CGAL_REEB_GRAPH_ATTRIBUTE_H

#include <CGAL/Reeb_graph/options.h> // has what was here

#endif // CGAL_REEB_GRAPH_ATTRIBUTE_H
