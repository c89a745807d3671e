// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_VTP_H
#define CGAL_REEB_GRAPH_IO_VTP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/IO/attributes.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/io/Vtp_document.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {
/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in space as an XML file of VTK, `.vtp`, which ParaView, PyVista and other programs open.
///
/// Points and cells have numbers, to color them by. Where a number makes no sense it is -1, or NaN in floating point.
///
/// - The points are first the nodes, then the inner points of the polylines of the arcs, arc by arc. Their arrays are
///   `value`, and `node`, `kind` and `vertex` of nodes, and `arc` of inner points.
/// - The cells are first a vertex for each node, then a polyline for each arc, from its lower to its upper node. Their
///   arrays are `node`, `kind` and `vertex` of nodes, `arc` of arcs, and `lower_value` and `upper_value`; and with
///   names of their own, the `arc_attributes`.
///
/// The numbers of `kind` are those of `Node_kind`: 0 isolated, 1 minimum, 2 saddle, 3 maximum, 4 degree two.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam Embedding an instance of `Reeb_graph::Embedding`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param out the stream; whether writing succeeded is seen by its state
/// \param graph the Reeb graph
/// \param embedding what `embed()` has returned for it
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{arc_attributes}
///     \cgalParamDescription{numbers of the arcs that are written, too, such as what `arc_persistences()`,
///                           `arc_lengths()` and `arc_areas()` return}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::arc_attributes()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class Graph,
          class Embedding,
          class VertexIndexMap,
          class NamedParameters = parameters::Default_named_parameters>
void write_vtp(std::ostream& out,
               const Graph& graph,
               const Embedding& embedding,
               VertexIndexMap vertex_index_map,
               const NamedParameters& np = parameters::default_values())
{
  const internal::Classic_locale classic_locale(out);
  if constexpr(internal::Graph_and_vertex_map<Graph, VertexIndexMap>::value)
  {
    using internal::padded;
    const std::size_t number_of_nodes = num_vertices(graph), number_of_arcs = num_edges(graph);
    const std::vector<Attribute> attributes =
      internal::checked_attributes(parameters::get_parameter(np, internal::arc_attributes), number_of_arcs);
    const internal::Vtp_graph<Graph, Embedding> points(graph, embedding);
    const std::size_t number_of_inner_points = points.arc_of_point.size();
    std::vector<std::int64_t> node_numbers, arc_numbers, kinds, vertex_numbers;
    std::vector<double> lower_values = embedding.node_values, upper_values = lower_values;
    for(const auto node : CGAL::make_range(vertices(graph)))
    {
      node_numbers.push_back(static_cast<std::int64_t>(node));
      kinds.push_back(static_cast<std::int64_t>(graph[node].kind));
      vertex_numbers.push_back(static_cast<std::int64_t>(get(vertex_index_map, graph[node].vertex)));
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      arc_numbers.push_back(static_cast<std::int64_t>(arc_numbers.size()));
      lower_values.push_back(embedding.node_values[source(arc, graph)]);
      upper_values.push_back(embedding.node_values[target(arc, graph)]);
    }

    internal::Vtp_document document(out, points.values.size(), points.nodes, points.arcs, {});
    document.write_section("Points", "", [&] { document.write_array("Points", points.coordinates, 3); });
    document.write_section("PointData", "value", [&] {
      document.write_array("value", points.values);
      document.write_array("node", padded(0, node_numbers, number_of_inner_points));
      document.write_array("kind", padded(0, kinds, number_of_inner_points));
      document.write_array("vertex", padded(0, vertex_numbers, number_of_inner_points));
      document.write_array("arc", padded(number_of_nodes, points.arc_of_point, 0));
    });
    document.write_section("CellData", "arc", [&] {
      document.write_array("node", padded(0, node_numbers, number_of_arcs));
      document.write_array("kind", padded(0, kinds, number_of_arcs));
      document.write_array("vertex", padded(0, vertex_numbers, number_of_arcs));
      document.write_array("arc", padded(number_of_nodes, arc_numbers, 0));
      document.write_array("lower_value", lower_values);
      document.write_array("upper_value", upper_values);
      for(const Attribute& attribute : attributes)
        std::visit(
          [&](const auto& numbers) { document.write_array(attribute.name, padded(number_of_nodes, numbers, 0)); },
          attribute.numbers);
    });
    document.finish();
  }
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in space to a file `.vtp`. The stream is as above.
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class Graph,
          class Embedding,
          class VertexIndexMap,
          class NamedParameters = parameters::Default_named_parameters>
void write_vtp(const std::string& filename,
               const Graph& graph,
               const Embedding& embedding,
               VertexIndexMap vertex_index_map,
               const NamedParameters& np = parameters::default_values())
{
  // before the file is opened, which empties it
  internal::checked_attributes(parameters::get_parameter(np, internal::arc_attributes), num_edges(graph));
  internal::write_file(filename,
                       [&](std::ostream& out) { Reeb_graph::write_vtp(out, graph, embedding, vertex_index_map, np); });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_VTP_H
