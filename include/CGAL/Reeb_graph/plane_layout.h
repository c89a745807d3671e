// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PLANE_LAYOUT_H
#define CGAL_REEB_GRAPH_PLANE_LAYOUT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/drawing/Plane_drawing.h>
#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphDrawing
///
/// \brief where the nodes and the arcs of a Reeb graph lie in a drawing in the plane whose vertical axis is the scalar
/// value; see `lay_out_in_plane()`.
struct Plane_layout
{
  /// by number of node, its horizontal position. Neighboring columns are 1 apart, those of short branches half of that,
  /// and those with many nodes of nearly one value more. Such nodes, whose signs would lie on each other in the drawing
  /// of `write_svg()`, are 0.25 apart, or less if they are more than 24. The position is greater than -0.5. The
  /// vertical position of a node is its value, or in an order that is not that of numbers up or down its number.
  std::vector<double> node_positions;

  /// by arc, in the order of `edges(graph)`, the points of a curve from its lower node to its upper one, horizontal and
  /// vertical position. The vertical ones do not descend, or do not ascend if larger numbers come first in the order.
  /// Instead of an infinite value there is a finite one, a tenth of the range beyond the finite values.
  std::vector<std::vector<std::array<double, 2>>> arc_polylines;
};

/// \ingroup PkgReebGraphDrawing
///
/// \brief lays out a Reeb graph in the plane: the height of a node is its value, arcs ascend.
///
/// In another order than that of `operator<`, larger numbers may come first. Then draw the axis with the largest number
/// at the bottom, and arcs ascend again. If the numbers neither ascend nor fall from node to node, the height of a node
/// is its number, its place in the order.
///
/// The graph consists of branches, from the least persistent one to the trunk of each component, as for `simplify()`.
/// Of the sides of a loop, all but one are branches that end where the loop closes. A branch is drawn in a column of
/// its own, and is led in a curve to the branch at which it is attached. Branches share a column where they are at
/// different heights. Their sides and their order are chosen so that few arcs cross: none in a graph whose branches all
/// go up, as in a merge tree, or all go down. Components lie side by side, the tallest first. Nodes of nearly one value
/// lie beside each other.
///
/// With \f$ n \f$ nodes and arcs it takes \f$ O(n \log^2 n) \f$ time. Equal graphs have equal layouts.
///
/// \tparam ReebGraph the type `Graph` of the traits class, or another bidirectional graph with `std::size_t` as vertex
///         descriptor
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for `simplify()`
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
Plane_layout lay_out_in_plane(const ReebGraph& graph, const NamedParameters& np = parameters::default_values())
{
  Plane_layout layout;
  if constexpr(internal::Plain_graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    const std::vector<internal::Ascending_arc> arcs = internal::read_arcs(graph);
    const std::vector<double> values = internal::drawn_values(internal::numbers_of_nodes(graph, np));
    const internal::Value_scale scale(values);
    std::vector<double> heights;
    heights.reserve(values.size());
    for(const double value : values)
      heights.push_back(scale.height(value));
    const internal::Plane_drawing drawing(arcs, heights);
    layout.node_positions = drawing.positions();
    layout.arc_polylines = drawing.curves();
    for(std::size_t i = 0; i != arcs.size(); ++i)
    {
      double last = scale.finite_value(values[arcs[i].lower]);
      const double end = scale.finite_value(values[arcs[i].upper]);
      layout.arc_polylines[i].front()[1] = last;
      for(std::size_t k = 1; k != layout.arc_polylines[i].size(); ++k)
      {
        double& value = layout.arc_polylines[i][k][1];
        const auto [low, high] = std::minmax(last, end);
        value = last = (std::clamp)(scale.value(value), low, high); // rounded values could go back
      }
      layout.arc_polylines[i].back()[1] = end;
    }
  }
  return layout;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_PLANE_LAYOUT_H
