// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_CSV_H
#define CGAL_REEB_GRAPH_IO_CSV_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

// A field of a CSV file, in quotes if it needs them.
inline std::string csv_of(const std::string& text)
{
  if(text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for(const char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief writes the nodes of a Reeb graph in space as a table of comma-separated values, with a header line.
///
/// The columns are `node`, the numbers of the nodes, `vertex`, the indices of their mesh vertices, `value`, `kind`, the
/// coordinates `x`, `y`, `z`, and how many arcs there are below and above, `arcs_below` and `arcs_above`.
///
/// Numbers have all digits; they can be `inf` and `nan`.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam Embedding an instance of `Reeb_graph::Embedding`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
template <class Graph, class Embedding, class VertexIndexMap>
void write_nodes_csv(const internal::Output& output,
                     const Graph& graph,
                     const Embedding& embedding,
                     VertexIndexMap vertex_index_map)
{
  static_assert(internal::are_met<internal::Graph_and_vertex_map<Graph, VertexIndexMap>>);
  output([&](std::ostream& out) {
    internal::Text_output text(out);
    text << "node,vertex,value,kind,x,y,z,arcs_below,arcs_above\n";
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      text << node << ',' << get(vertex_index_map, graph[node].vertex) << ',' << embedding.node_values[node] << ','
           << to_string(graph[node].kind);
      for(const double coordinate : internal::coordinates_of(embedding.node_points[node]))
        text << ',' << coordinate;
      text << ',' << in_degree(node, graph) << ',' << out_degree(node, graph) << '\n';
    }
    text.flush();
  });
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes the arcs of a Reeb graph in space as a table of comma-separated values, with a header line.
///
/// The columns are `arc`, the numbers of the arcs, `source` and `target`, those of their lower and upper nodes,
/// `lower_value` and `upper_value`, the values of these, and the `arc_attributes` by their names.
///
/// Numbers have all digits; they can be `inf` and `nan`.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam Embedding an instance of `Reeb_graph::Embedding`
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `arc_attributes`, as for
///        `write_vtp()`
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class Graph, class Embedding, class NamedParameters = parameters::Default_named_parameters>
void write_arcs_csv(const internal::Output& output,
                    const Graph& graph,
                    const Embedding& embedding,
                    const NamedParameters& np = parameters::default_values())
{
  const std::vector<Attribute> attributes =
    internal::checked_attributes(parameters::get_parameter(np, internal::arc_attributes), num_edges(graph));
  output([&](std::ostream& out) {
    internal::Text_output text(out);
    text << "arc,source,target,lower_value,upper_value";
    for(const Attribute& attribute : attributes)
      text << ',' << internal::csv_of(attribute.name);
    text << '\n';
    std::size_t i = 0;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const auto lower = source(arc, graph), upper = target(arc, graph);
      text << i << ',' << lower << ',' << upper << ',' << embedding.node_values[lower] << ','
           << embedding.node_values[upper];
      for(const Attribute& attribute : attributes)
        std::visit([&](const auto& numbers) { text << ',' << numbers[i]; }, attribute.numbers);
      text << '\n';
      ++i;
    }
    text.flush();
  });
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes the two tables of a Reeb graph in space to files.
///
/// \param nodes_filename the file of `write_nodes_csv()`
/// \param arcs_filename the file of `write_arcs_csv()`
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `arc_attributes`, as for
///        `write_vtp()`
///
/// \reebGraphComplexity
///
/// \exception File_error if a file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class Graph,
          class Embedding,
          class VertexIndexMap,
          class NamedParameters = parameters::Default_named_parameters>
void write_csv(const std::string& nodes_filename,
               const std::string& arcs_filename,
               const Graph& graph,
               const Embedding& embedding,
               VertexIndexMap vertex_index_map,
               const NamedParameters& np = parameters::default_values())
{
  // before the files are opened, which empties them
  internal::checked_attributes(parameters::get_parameter(np, internal::arc_attributes), num_edges(graph));
  Reeb_graph::write_nodes_csv(nodes_filename, graph, embedding, vertex_index_map);
  Reeb_graph::write_arcs_csv(arcs_filename, graph, embedding, np);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_CSV_H
