// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_ARC_TABLE_H
#define CGAL_REEB_GRAPH_SRC_ARC_TABLE_H

#include "base/surface.h"

#include <CGAL/Reeb_graph/options.h>

#include <cstddef>
#include <cstdint>
#include <variant>
#include <vector>

namespace reeb_graph_program {
// What is known of the arcs of a graph, by their numbers. Files, reports, the page and Python show columns by what is
// said here: none of them knows one by its name.

// How the number of an arc of a simplified graph comes from those of the given graph.
enum class Arc_joining
{
  ALONG_CHAIN,   // the sum over the arcs that its chain passes
  WITH_ABSORBED, // the sum over all arcs that it has taken up
  WITH_NODES,    // the sum over all arcs and nodes that it has taken up
  MEAN_BY_AREA,  // the mean over all arcs that it has taken up, weighted by their areas or volumes
  RECOMPUTED     // by a function of the simplified graph
};

enum class Arc_unit
{
  VALUE,      // of the field
  DIFFERENCE, // of two values
  PLAIN,      // that of the points, or none
  COUNT
};

struct Arc_column
{
  CGAL::Reeb_graph::Attribute attribute;
  Arc_joining joining;
  Arc_unit unit;
  bool is_in_text = true;                                              // of the report; all others show all columns
  std::vector<std::int64_t> of_nodes = {};                             // for WITH_NODES: what belongs to each node
  std::vector<double> (*recompute)(const Graph& simplified) = nullptr; // for RECOMPUTED
};

struct Arc_ends
{
  std::size_t lower_node = 0, upper_node = 0;
  double lower_value = 0, upper_value = 0;
};

struct Arc_table
{
  std::vector<Arc_ends> ends;
  std::vector<Arc_column> columns;

  // What files write, with `base` added to values.
  std::vector<CGAL::Reeb_graph::Attribute> attributes(double base = 0) const
  {
    std::vector<CGAL::Reeb_graph::Attribute> attributes;
    for(const Arc_column& column : columns)
    {
      attributes.push_back(column.attribute);
      if(column.unit == Arc_unit::VALUE)
        for(double& value : std::get<std::vector<double>>(attributes.back().numbers))
          value += base;
    }
    return attributes;
  }
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_ARC_TABLE_H
