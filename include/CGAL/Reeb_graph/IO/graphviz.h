// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_GRAPHVIZ_H
#define CGAL_REEB_GRAPH_IO_GRAPHVIZ_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Node_kind.h>
#include <CGAL/Reeb_graph/internal/base/arc_index.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/output/files.h>
#include <CGAL/Reeb_graph/internal/output/number_text.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/graphviz.hpp>

#include <ostream>
#include <string>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

inline const char* fill_color(Node_kind kind)
{
  switch(kind)
  {
  case Node_kind::MINIMUM: return "#a6cbf0";
  case Node_kind::SADDLE: return "#f7e3a1";
  case Node_kind::MAXIMUM: return "#f2b0a5";
  case Node_kind::ISOLATED:
  case Node_kind::DEGREE_TWO: break;
  }
  return "#e6e6e6";
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in the <A HREF="https://graphviz.org/">Graphviz</A> format, to be drawn by its
/// program `dot` with lower nodes below upper ones.
///
/// The label of a node is its number, the index of its mesh vertex and its scalar value to six digits, its colour tells
/// the kind. The label of an arc is its number, if the graph has the property `boost::edge_index`. The attributes
/// `vertex`, `value`, and `kind` are those of `write_graphml()`, with all digits. Equal graphs give equal files.
/// Values that have no `operator<<` are written as the numbers that the traits class makes of them.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param out the stream; whether writing succeeded is seen by its state
/// \param graph the Reeb graph
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for
///        `write_graphml()`
///
/// \note Boost has a function of this name; qualify the call.
template <class Graph, class VertexIndexMap, class NamedParameters = parameters::Default_named_parameters>
void write_graphviz(std::ostream& out,
                    const Graph& graph,
                    VertexIndexMap vertex_index_map,
                    const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Graph_to_write<Graph, VertexIndexMap, NamedParameters>::value)
  {
    const auto conversion = internal::choose_conversion_of_nodes<Graph>(np);
    typedef typename boost::graph_traits<Graph>::vertex_descriptor node_descriptor;
    typedef typename boost::graph_traits<Graph>::edge_descriptor arc_descriptor;

    const auto write_graph_attributes = [](std::ostream& stream) {
      stream
        << "rankdir=BT;\nnodesep=0.8;\n"
           "node [shape=box, style=\"rounded,filled\", fontname=\"Helvetica\", fontsize=11, margin=\"0.08,0.04\"];\n"
           "edge [arrowhead=none, fontname=\"Helvetica\", fontsize=11];\n";
    };
    const auto write_node_attributes = [&](std::ostream& stream, node_descriptor node) {
      const auto& properties = graph[node];
      const auto value = internal::written_scalar(conversion, properties.value);
      const std::string index = std::to_string(get(vertex_index_map, properties.vertex));
      const std::string label = "n" + std::to_string(node) + ", v" + index + "\n" + internal::to_short_string(value);
      stream << " [label=" << boost::escape_dot_string(label) << ", fillcolor=\""
             << internal::fill_color(properties.kind) << "\", vertex=" << index
             << ", value=" << boost::escape_dot_string(internal::to_round_trip_string(value)) << ", kind=\""
             << to_string(properties.kind) << "\"]";
    };
    const auto write_arc_attributes = [&](std::ostream& stream, const arc_descriptor& arc) {
      if constexpr(internal::Has_arc_index<Graph>::value)
      {
        const std::string index = std::to_string(get(boost::edge_index, graph, arc));
        stream << " [label=" << index << ", index=" << index << "]";
      }
    };
    boost::write_graphviz(out, graph, write_node_attributes, write_arc_attributes, write_graph_attributes);
  }
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph to a file in the Graphviz format, as to a stream.
///
/// \exception Reeb_graph::File_error if the file cannot be written
template <class Graph, class VertexIndexMap, class NamedParameters = parameters::Default_named_parameters>
void write_graphviz(const std::string& filename,
                    const Graph& graph,
                    VertexIndexMap vertex_index_map,
                    const NamedParameters& np = parameters::default_values())
{
  internal::write_file(filename,
                       [&](std::ostream& out) { Reeb_graph::write_graphviz(out, graph, vertex_index_map, np); });
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_IO_GRAPHVIZ_H
