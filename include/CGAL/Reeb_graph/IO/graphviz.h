// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_GRAPHVIZ_H
#define CGAL_REEB_GRAPH_IO_GRAPHVIZ_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL::Reeb_graph {
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

// A number that DOT reads without quotation marks: with digits and a point, but without an exponent.
inline bool is_dot_number(const std::string& text)
{
  const char* digits = "0123456789";
  const std::size_t begin = text.compare(0, 1, "-") == 0 ? 1 : 0, point = text.find_first_not_of(digits, begin);
  if(point == std::string::npos)
    return begin != text.size();
  return text[point] == '.' && text.find_first_not_of(digits, point + 1) == std::string::npos;
}

inline bool is_dot_name(const std::string& text)
{
  const std::string letters = "_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  return letters.find(text[0]) != std::string::npos
      && text.find_first_not_of(letters + "0123456789") == std::string::npos;
}

// The text as DOT reads it, in quotation marks where it needs them. Boost has such a function, in a header whose names
// break its own algorithms where they are included later.
inline std::string dot_text(const std::string& text)
{
  if(is_dot_number(text) || is_dot_name(text))
    return text;
  std::string quoted = "\"";
  for(const char c : text)
    quoted += c == '"' ? std::string("\\\"") : std::string(1, c);
  return quoted + "\"";
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in the <A HREF="https://graphviz.org/">Graphviz</A> format, to be drawn by its
/// program `dot` with lower nodes below upper ones.
///
/// The label of a node is its number, the index of its mesh vertex and its scalar value to six digits. Its color shows
/// the kind. The label of an arc is its number, if the graph has the property `boost::edge_index`. The attributes
/// `vertex`, `value`, and `kind` are those of `write_graphml()`, with all digits. Equal graphs give equal files.
/// Values that have no `operator<<` are written as the numbers that the traits class makes of them.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph the Reeb graph
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for
///        `write_graphml()`
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
///
/// \note Boost has a function of this name; qualify the call.
template <class Graph, class VertexIndexMap, class NamedParameters = parameters::Default_named_parameters>
void write_graphviz(const internal::Output& output,
                    const Graph& graph,
                    VertexIndexMap vertex_index_map,
                    const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Graph_and_vertex_map<Graph, VertexIndexMap>,
                                  internal::Scalars_can_be_written<internal::Traits_of_nodes<Graph, NamedParameters>>>);
  const auto conversion = internal::choose_conversion_of_nodes<Graph>(np);
  output([&](std::ostream& out) {
    internal::Text_output text(out);
    text << "digraph G {\nrankdir=BT;\nnodesep=0.8;\n"
            "node [shape=box, style=\"rounded,filled\", fontname=\"Helvetica\", fontsize=11, margin=\"0.08,0.04\"];\n"
            "edge [arrowhead=none, fontname=\"Helvetica\", fontsize=11];\n";
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      const auto& properties = graph[node];
      const auto value = internal::written_scalar(conversion, properties.value);
      const std::string index = std::to_string(get(vertex_index_map, properties.vertex));
      const std::string label = "n" + std::to_string(node) + ", v" + index + "\n" + internal::to_short_string(value);
      text << std::size_t(node) << " [label=" << internal::dot_text(label) << ", fillcolor=\""
           << internal::fill_color(properties.kind) << "\", vertex=" << index
           << ", value=" << internal::dot_text(internal::to_round_trip_string(value)) << ", kind=\""
           << to_string(properties.kind) << "\"];\n";
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      text << std::size_t(source(arc, graph)) << "->" << std::size_t(target(arc, graph)) << ' ';
      if constexpr(internal::Has_arc_index<Graph>::value)
      {
        const std::string index = std::to_string(get(boost::edge_index, graph, arc));
        text << " [label=" << index << ", index=" << index << "]";
      }
      text << ";\n";
    }
    text << "}\n";
    text.flush();
  });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_GRAPHVIZ_H
