// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_SKELETON_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_SKELETON_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>
#include <CGAL/Reeb_graph/skeleton/internal/Skeleton_options.h>

#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// The skeleton of a component by numbers: first the nodes, then the other points of one arc after the other.
struct Component_skeleton
{
  struct Vertex
  {
    Point point;
    double radius, inscribed_radius;
    Index arc; // no_index for a node
    double place;
  };

  std::vector<Vertex> vertices;
  std::vector<std::vector<Index>> arcs; // from node to node
  std::vector<Index> vertex_map;        // of the given vertices of the component
  std::size_t number_of_ends = 0, number_of_border_ends = 0, number_of_junctions = 0;
  std::size_t number_outside = 0, number_of_crossings = 0, number_of_contractible_loops = 0;
  std::size_t genus = 0, number_of_loops = 0, loop_index = 1; // loops of the Reeb graph
  bool is_self_intersecting = false;
};

// A template so that the library can have it, and defined in make_component_skeleton.h.
template <class Component>
Component_skeleton make_component_skeleton(Component component,
                                           const Skeleton_options& options,
                                           const Stage_progress& progress);

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_SKELETON_H
