// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// The named parameters of the package's own, as CGAL's parameters_interface.h lists its own: each as a name and the type of
// the value. None of these names is among those of CGAL, whatever its version: the test `names_of_parameters_are_free` looks.
// It is read several times, and is not guarded therefore.

CGAL_REEB_GRAPH_NAMED_PARAMETER(keep_degree_two_nodes, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(ties, Reeb_graph::Ties)
CGAL_REEB_GRAPH_NAMED_PARAMETER(method, Reeb_graph::Method)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_slabs, std::size_t)
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
CGAL_REEB_GRAPH_NAMED_PARAMETER(field_name, std::string)
CGAL_REEB_GRAPH_NAMED_PARAMETER(field_unit, std::string)
CGAL_REEB_GRAPH_NAMED_PARAMETER(gather_chains, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_candidates, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(borders, Reeb_graph::Borders)
CGAL_REEB_GRAPH_NAMED_PARAMETER(persistence_threshold, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(vertex_count_threshold, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(measure_threshold, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(cut_open, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(arc_attributes, std::vector<Reeb_graph::Attribute>)
CGAL_REEB_GRAPH_NAMED_PARAMETER(vertex_attributes, std::vector<Reeb_graph::Attribute>)
CGAL_REEB_GRAPH_NAMED_PARAMETER(face_attributes, std::vector<Reeb_graph::Attribute>)
CGAL_REEB_GRAPH_NAMED_PARAMETER(shorten_loops, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(number_of_handles, std::size_t)
CGAL_REEB_GRAPH_NAMED_PARAMETER(check_self_intersections, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(ignore_self_intersections, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(pruning_ratio, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(sampling_ratio, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(spacing, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(smooth, double)
CGAL_REEB_GRAPH_NAMED_PARAMETER(ends_at_borders, bool)
CGAL_REEB_GRAPH_NAMED_PARAMETER(price_alone, double)

// These have values of any type, and a tag, which has another name where there are functions called as the parameter is.
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(vertex_place_map, vertex_place_map)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(parametrization_map, parametrization_map)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(branch_measure, branch_measure)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(place_weights, place_weights)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(simplification, simplification)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(edges, edges_of_soup)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(slab, slab_of_rank)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(curve_cost, curve_cost)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(arc_weight, arc_weight)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(edge_curve_map, edge_curve_map)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(face_band_map, face_band_map)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(face_count_callback, face_count_callback)
CGAL_REEB_GRAPH_NAMED_PARAMETER_OF_ANY_TYPE(original_vertex_map, original_vertex_map)
