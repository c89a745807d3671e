// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_GRAPHML_H
#define CGAL_REEB_GRAPH_IO_GRAPHML_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/IO/attributes.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/io/Graphml_writer.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

template <class Graph, class VertexIndexMap, class NamedParameters, class TextOfChain>
void write_graphml_with(std::ostream& out,
                        const Graph& graph,
                        VertexIndexMap vertex_index_map,
                        const NamedParameters& np,
                        const TextOfChain& text_of_chain)
{
  if constexpr(Graph_to_write<Graph, VertexIndexMap, NamedParameters>::value)
  {
    const std::vector<Attribute> attributes =
      checked_attributes(parameters::get_parameter(np, arc_attributes), num_edges(graph));
    Graphml_writer(out, graph, vertex_index_map, choose_conversion_of_nodes<Graph>(np), text_of_chain, attributes)
      .write();
  }
}

// The attributes of named parameters, which stand behind index maps.
template <class IndexMap>
void check_arc_attributes(const IndexMap& map, std::size_t number_of_arcs)
{
  if constexpr(are_named_parameters<IndexMap>)
    checked_attributes(parameters::get_parameter(map, arc_attributes), number_of_arcs);
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in the <A HREF="http://graphml.graphdrawing.org/">GraphML</A> format.
///
/// Each node has the data `vertex`, the index of its mesh vertex, `value`, the scalar value, and `kind`, see
/// `to_string()`. Each edge runs from the lower to the upper node, and has the data `index`, the number of the arc, if
/// the graph has the property `boost::edge_index`, and the `arc_attributes` by their names. Nodes and edges are written
/// in the order that they have in the graph, by which they are numbered from 0 as their ids, so that equal graphs give
/// equal files. A floating-point value is written with as many digits as
/// it takes to read back the same value, and an integer as a number, even if it is a character. Any other value is
/// written by its `operator<<`, or if it has none, as the number that the traits class makes of it.
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
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class whose `scalar_to_double_object()` makes numbers of values
///                           that have no `operator<<`}
///     \cgalParamType{a model of `ReebGraphTraits`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{arc_attributes}
///     \cgalParamDescription{numbers of the arcs that are written as data of the edges}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::arc_attributes()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Attribute_count_error if an attribute has not one number for each arc
///
/// \note Boost has a function of this name; qualify the call.
#ifdef DOXYGEN_RUNNING
template <class Graph, class VertexIndexMap, class NamedParameters = parameters::Default_named_parameters>
void write_graphml(std::ostream& out,
                   const Graph& graph,
                   VertexIndexMap vertex_index_map,
                   const NamedParameters& np = parameters::default_values());
#else
template <class Graph, class VertexIndexMap>
void write_graphml(std::ostream& out, const Graph& graph, VertexIndexMap vertex_index_map)
{
  internal::write_graphml_with(out, graph, vertex_index_map, parameters::default_values(), nullptr);
}
#endif

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph with the chains of its arcs in the GraphML format, so that `read_graphml()` can read it
///            back.
///
/// It is as without chains, but each edge has the data `chain`, the indices of the halfedges.
///
/// \tparam HalfedgeIndexMap a model of `ReadablePropertyMap` with the halfedge descriptors of the mesh as key type and
///         an integer type as value type
///
/// \param out the stream; whether writing succeeded is seen by its state
/// \param graph the Reeb graph
/// \param vertex_index_map the index of each vertex of the mesh; for `read_graphml()` its position, as
///        `make_vertex_index_map()` gives it
/// \param halfedge_index_map the index of each halfedge of the mesh, likewise
/// \param np named parameters, as without chains
template <class Graph,
          class VertexIndexMap,
          class HalfedgeIndexMap,
          class NamedParameters = parameters::Default_named_parameters>
void write_graphml(std::ostream& out,
                   const Graph& graph,
                   VertexIndexMap vertex_index_map,
                   HalfedgeIndexMap halfedge_index_map,
                   const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::are_named_parameters<HalfedgeIndexMap>) // no map
    internal::write_graphml_with(out, graph, vertex_index_map, halfedge_index_map, nullptr);
  else
    internal::write_graphml_with(out, graph, vertex_index_map, np, [&](const auto& arc) {
      std::string text;
      for(const auto h : graph[arc].chain)
        text += (text.empty() ? "" : " ") + std::to_string(get(halfedge_index_map, h));
      return text;
    });
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph to a file, as to a stream: with the chains of its arcs if there is a map for halfedges.
///
/// \param filename the name of the file
/// \param graph the Reeb graph
/// \param index_maps the index maps that are passed on, and named parameters behind them
///
/// \exception Reeb_graph::File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
template <class Graph, class... IndexMaps>
void write_graphml(const std::string& filename, const Graph& graph, IndexMaps... index_maps)
{
  (internal::check_arc_attributes(index_maps, num_edges(graph)), ...); // before the file is opened, which empties it
  internal::write_file(filename, [&](std::ostream& out) { Reeb_graph::write_graphml(out, graph, index_maps...); });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_GRAPHML_H
