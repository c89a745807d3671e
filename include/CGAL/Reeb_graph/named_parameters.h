// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
#define CGAL_REEB_GRAPH_NAMED_PARAMETERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <string>

// The named parameters of graphs, fields and simplification; their documentation is in the list
// `PkgReebGraphNamedParameters`.
CGAL_REEB_GRAPH_NAMED_PARAMETER(keep_degree_two_nodes, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(ties, Reeb_graph::Ties)
CGAL_REEB_GRAPH_NAMED_PARAMETER(method, Reeb_graph::Method)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_slabs, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(vertex_place_map)
CGAL_REEB_GRAPH_NAMED_PARAMETER(laplacian_weights, Reeb_graph::Laplacian_weights)
CGAL_REEB_GRAPH_NAMED_PARAMETER(solver_tolerance, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(border_extremum, Reeb_graph::Border_extremum)
CGAL_REEB_GRAPH_NAMED_PARAMETER(collar_width, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_leaves, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(cancel_loops, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(embedding_manner, Reeb_graph::Embedding_manner)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_contours, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_contours_at_nodes, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_smoothing_steps, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(parametrization_map)
CGAL_REEB_GRAPH_NAMED_PARAMETER(field_name, std::string)
CGAL_REEB_GRAPH_NAMED_PARAMETER(field_unit, std::string)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(branch_measure)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(piece_weights)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(simplification)
CGAL_REEB_GRAPH_NAMED_PARAMETER_AND_TAG(edges, edges_of_soup)
CGAL_REEB_GRAPH_NAMED_PARAMETER(gather_chains, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER_AND_TAG(slab, slab_of_rank)

#endif // CGAL_REEB_GRAPH_NAMED_PARAMETERS_H
