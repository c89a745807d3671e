// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_H
#define CGAL_REEB_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

// All that is about graphs. The headers of the folders fields/, curves/ and handles/, which are about meshes, and those
// of distributed/, which need MPI, are included one by one.
#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/Flat_field.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/csv.h>
#include <CGAL/Reeb_graph/IO/graphml.h>
#include <CGAL/Reeb_graph/IO/graphviz.h>
#include <CGAL/Reeb_graph/IO/json.h>
#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/IO/vtp.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph/plane_layout.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>
#include <CGAL/Reeb_graph/tetrahedra.h>
#include <CGAL/Reeb_graph_soup_traits.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#endif // CGAL_REEB_GRAPH_H
