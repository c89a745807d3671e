// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_JSON_H
#define CGAL_REEB_GRAPH_IO_JSON_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

// `vertex_index_map` and `ends_of` give the indices of the vertices of nodes, and of both ends of a halfedge.
template <class Graph, class Embedding, class VertexIndexMap, class EndsOf, class NamedParameters>
void write_json_of_graph(const Output& output,
                         const Graph& graph,
                         const Embedding& embedding,
                         VertexIndexMap vertex_index_map,
                         const EndsOf& ends_of,
                         const NamedParameters& np)
{
  const std::vector<Attribute> attributes =
    checked_attributes(parameters::get_parameter(np, arc_attributes), num_edges(graph));
  output([&](std::ostream& out) {
    const Classic_locale classic_locale(out);
    out << "{\n\"directed\": true,\n\"multigraph\": true,\n\"nodes\": [";
    for(const auto node : CGAL::make_range(vertices(graph)))
      out << (node == 0 ? "\n" : ",\n") << "{\"id\": " << node
          << ", \"vertex\": " << std::to_string(get(vertex_index_map, graph[node].vertex))
          << ", \"value\": " << json_of(embedding.node_values[node])
          << ", \"kind\": " << json_of(to_string(graph[node].kind))
          << ", \"point\": " << json_of_point(embedding.node_points[node]) << '}';
    out << "\n],\n\"edges\": [";
    std::size_t i = 0;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      out << (i == 0 ? "\n" : ",\n") << "{\"index\": " << i << ", \"source\": " << source(arc, graph)
          << ", \"target\": " << target(arc, graph);
      for(const Attribute& attribute : attributes)
        std::visit([&](const auto& numbers) { out << ", " << json_of(attribute.name) << ": " << json_of(numbers[i]); },
                   attribute.numbers);
      out << ", \"chain\": " << json_of_chain(graph[arc].chain, ends_of)
          << ", \"polyline\": " << json_list(embedding.arc_polylines[i], [](const auto& p) { return json_of_point(p); })
          << ", \"values\": " << json_list(embedding.arc_values[i], [](double value) { return json_of(value); }) << '}';
      ++i;
    }
    out << "\n]\n}\n";
  });
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in space with its chains as one JSON object.
///
/// The object has the members `directed` and `multigraph`, which are `true`, `nodes`, and `edges`, the arcs, in their
/// order, so that NetworkX makes a graph of it by `node_link_graph(json.load(file))` from its version 3.6 on. In the
/// versions 3.4 and 3.5, `edges="edges"` is needed, in older ones `link="edges"`.
///
/// - Nodes have `id`, their number, `vertex`, the index of their mesh vertex, `value`, `kind`, and `point`.
/// - Arcs have `index`, their number, `source` and `target`, the numbers of the lower and the upper node, `polyline`,
///   the list of their points, `values`, those of these points, `chain`, and the `arc_attributes` by their names. A
///   chain is a list of ascending edge paths, each a list of vertices. There is more than one where nodes have been
///   removed. The last edge of each path passes by the place where the next one, or the upper node, is.
///
/// Values and attributes that are infinite or NaN are `null`; other numbers have all digits.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam Embedding an instance of `Reeb_graph::Embedding`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param mesh the mesh that the graph is of
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param vertex_index_map the index of each vertex of the mesh
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `arc_attributes`, as for
///        `write_vtp()`
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class FaceListGraph,
          class Graph,
          class Embedding,
          class VertexIndexMap,
          class NamedParameters = parameters::Default_named_parameters>
void write_json(const internal::Output& output,
                const FaceListGraph& mesh,
                const Graph& graph,
                const Embedding& embedding,
                VertexIndexMap vertex_index_map,
                const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Graph_and_vertex_map<Graph, VertexIndexMap>>);
  const auto ends_of = [&](const auto h) {
    return std::make_pair(get(vertex_index_map, source(h, mesh)), get(vertex_index_map, target(h, mesh)));
  };
  internal::write_json_of_graph(output, graph, embedding, vertex_index_map, ends_of, np);
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes the Reeb graph of a triangle soup or of tetrahedra, as `compute_reeb_graph_of_soup()` makes it, in
/// space with its chains as one JSON object. The object and the exceptions are as above.
///
/// \param output a stream, or the name of a file
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param np an optional sequence of named parameters: `arc_attributes`
///
/// \reebGraphComplexity
template <class Graph, class Embedding, class NamedParameters = parameters::Default_named_parameters>
void write_json(const internal::Output& output,
                const Graph& graph,
                const Embedding& embedding,
                const NamedParameters& np = parameters::default_values())
{
  typedef boost::typed_identity_property_map<std::size_t> Index_map;
  static_assert(internal::are_met<internal::Graph_and_vertex_map<Graph, Index_map>>);
  internal::write_json_of_graph(
    output, graph, embedding, Index_map(), [](const auto& edge) { return edge; }, np);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_JSON_H
