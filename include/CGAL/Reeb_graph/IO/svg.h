// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_SVG_H
#define CGAL_REEB_GRAPH_IO_SVG_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/drawing/Svg_drawing.h>
#include <CGAL/Reeb_graph/internal/drawing/Value_scale.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/plane_layout.h>

#include <cstddef>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

// A number and what it counts.
inline std::string counted(std::size_t number, const std::string& name)
{
  return std::to_string(number) + ' ' + name + (number == 1 ? "" : "s");
}

} // namespace internal

/// \ingroup PkgReebGraphDrawing
///
/// \brief draws a Reeb graph as a picture in the format SVG, which web browsers show and vector graphics programs edit.
///
/// The height of a node is its value, as the axis shows. The axis falls if larger numbers come first in the order, and
/// counts the nodes in any order but that of numbers. `lay_out_in_plane()` puts nodes and arcs in their places. Colors
/// and shapes of nodes show their kinds; people with color blindness can distinguish the colors. The label of a node
/// is `n` and its number, and in a small graph its value, too. The label of an arc is its number in the order of
/// `edges(graph)`. Labels are where there is room: none lies on another one, on a node, or on an arc. A graph of more
/// than 5,000 nodes has no labels. Point at a node or an arc to read all about it. There is no script in the file.
/// Equal graphs give equal files. Bytes of names that are not UTF-8 become U+FFFD.
///
/// \tparam ReebGraph the type `Graph` of a model of `ReebGraphTraits`
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph a Reeb graph, computed with any named parameters
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{field_name}
///     \cgalParamDescription{what the values are, in UTF-8, for the axis}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{`"value"`}
///   \cgalParamNEnd
///   \cgalParamNBegin{field_unit}
///     \cgalParamDescription{the unit of the values, in UTF-8, for the axis}
///     \cgalParamType{`std::string`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_index_map}
///     \cgalParamDescription{a property map that associates an index with each vertex of the mesh: that of a node is
///                           told where the pointer rests on it}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///                    integer type as value type}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class whose `scalar_to_double_object()` makes numbers of the
///                           values}
///     \cgalParamType{a model of `ReebGraphNumberTraits`}
///     \cgalParamDefault{none: `CGAL::to_double()` of the values}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
/// \exception Reeb_graph::File_error if the file cannot be written
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
void write_svg(const internal::Output& output,
               const ReebGraph& graph,
               const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    using parameters::choose_parameter;
    using parameters::get_parameter;
    const std::string name = choose_parameter(get_parameter(np, internal::field_name), std::string("value"));
    const std::string unit = choose_parameter(get_parameter(np, internal::field_unit), std::string());
    const auto vertex_index_map = get_parameter(np, internal_np::vertex_index);
    const std::string unit_text = unit.empty() ? "" : ' ' + unit;
    const std::vector<double> values = internal::numbers_of_nodes(graph, np), heights = internal::drawn_values(values);
    const auto value_text = [&](std::size_t node, int digits = 6) {
      return internal::to_string_with_precision(values[node], digits);
    };
    constexpr std::size_t few_nodes = 40;

    Plane_layout layout = lay_out_in_plane(graph, np);
    std::vector<internal::Drawn_node> nodes;
    for(std::size_t node = 0; node != num_vertices(graph); ++node)
    {
      std::ostringstream title;
      title.imbue(std::locale::classic());
      title << "node " << node << ": " << graph[node].kind << '\n' << name << ' ' << value_text(node) << unit_text;
      if constexpr(internal::is_given<decltype(vertex_index_map)>)
        title << "\nvertex " << get(vertex_index_map, graph[node].vertex);
      nodes.push_back({layout.node_positions[node], heights[node], graph[node].kind,
                       'n' + std::to_string(node) + (num_vertices(graph) > few_nodes ? "" : ": " + value_text(node, 4)),
                       title.str()});
    }
    std::vector<internal::Drawn_arc> arcs;
    for(auto range = edges(graph); range.first != range.second; ++range.first)
    {
      const std::size_t lower = source(*range.first, graph), upper = target(*range.first, graph), number = arcs.size();
      std::ostringstream title;
      title.imbue(std::locale::classic());
      title << "arc " << number << ": from node " << lower << " to node " << upper << '\n'
            << name << " from " << value_text(lower) << " to " << value_text(upper) << unit_text;
      arcs.push_back({std::move(layout.arc_polylines[number]), std::to_string(number), title.str()});
    }
    std::string description = internal::counted(num_vertices(graph), "node");
    description.append(", ").append(internal::counted(num_edges(graph), "arc"));
    description.append(", ").append(internal::counted(number_of_loops(graph), "loop"));
    description.append(", ").append(internal::counted(number_of_components(graph), "component"));
    const std::string axis_title = heights != values ? "order of " + name
                                 : unit.empty()      ? name
                                                     : name + " [" + unit + "]";
    const internal::Svg_drawing drawing(std::move(nodes), std::move(arcs), axis_title);
    output([&](std::ostream& out) { drawing.write(out, "Reeb graph", description); });
  }
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_SVG_H
