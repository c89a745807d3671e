// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_GRAPHML_H
#define CGAL_REEB_GRAPH_IO_GRAPHML_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/io/requirements.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_tree/detail/xml_parser_utils.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

// The type of the values of a key, as GraphML calls it.
template <class Value>
constexpr const char* graphml_type()
{
  if constexpr(std::is_same_v<Value, bool>)
    return "boolean";
  else if constexpr(std::is_floating_point_v<Value>)
    return std::is_same_v<Value, float> ? "float" : "double";
  else if constexpr(std::is_integral_v<Value> && sizeof(Value) > 1)
    return std::is_same_v<Value, long> || std::is_same_v<Value, unsigned long> || (sizeof(Value) > sizeof(int)) ? "long"
                                                                                                                : "int";
  else
    return "string";
}

// The text of the value of a key.
template <class Value>
auto graphml_text(const Value& value)
{
  if constexpr(std::is_floating_point_v<Value>)
    return value;
  else if constexpr(std::is_integral_v<Value>)
    return to_round_trip_string(value);
  else
    return boost::property_tree::xml_parser::encode_char_entities(xml_characters(to_round_trip_string(value)));
}

// The numbers of the keys of a file.
template <class Graph, bool has_chains_>
struct Graphml_keys
{
  static constexpr bool has_chains = has_chains_, has_index = Has_arc_index<Graph>::value;
  static constexpr std::size_t chain = 0, index = has_chains ? 1 : 0, kind = index + (has_index ? 1 : 0),
                               value = kind + 1, vertex = kind + 2, first_attribute = kind + 3;
};

template <class Keys, class Value>
void write_graphml_keys(Text_output& text, const std::vector<Attribute>& attributes)
{
  const auto write_key = [&](std::size_t key, std::string_view things, std::string_view name, std::string_view type) {
    text << "  <key id=\"key" << key << "\" for=\"" << things << "\" attr.name=\"" << name << "\" attr.type=\"" << type
         << "\" />\n";
  };
  if constexpr(Keys::has_chains)
    write_key(Keys::chain, "edge", "chain", "string");
  if constexpr(Keys::has_index)
    write_key(Keys::index, "edge", "index", "long");
  write_key(Keys::kind, "node", "kind", "string");
  write_key(Keys::value, "node", "value", graphml_type<Value>());
  write_key(Keys::vertex, "node", "vertex", "long");
  for(std::size_t i = 0; i != attributes.size(); ++i)
    write_key(Keys::first_attribute + i, "edge", graphml_text(attributes[i].name),
              std::holds_alternative<std::vector<double>>(attributes[i].numbers) ? "double" : "long");
}

// Writes a graph as Boost's function of this name does, in a fifth of its time: that one asks each property of each
// node for a text by its type at run time. The chains are what `text_of_chain` makes of arcs, if it is no null pointer.
// Nodes and arcs are named by their numbers, which the format allows.
template <class Graph, class VertexIndexMap, class NamedParameters, class TextOfChain>
void write_graphml_with(const Output& output,
                        const Graph& graph,
                        VertexIndexMap vertex_index_map,
                        const NamedParameters& np,
                        const TextOfChain& text_of_chain)
{
  if constexpr(Graph_to_write<Graph, VertexIndexMap, NamedParameters>::value)
  {
    typedef Graphml_keys<Graph, !std::is_same_v<TextOfChain, std::nullptr_t>> Keys;
    const std::vector<Attribute> attributes =
      checked_attributes(parameters::get_parameter(np, arc_attributes), num_edges(graph));
    const auto conversion = choose_conversion_of_nodes<Graph>(np);
    const auto value_of = [&](const auto node) { return written_scalar(conversion, graph[node].value); };
    output([&](std::ostream& out) {
      Text_output text(out);
      const auto write_data = [&](std::size_t key, const auto& value) {
        text << "      <data key=\"key" << key << "\">" << value << "</data>\n";
      };
      text << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
              "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\" "
              "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
              "xsi:schemaLocation=\"http://graphml.graphdrawing.org/xmlns "
              "http://graphml.graphdrawing.org/xmlns/1.0/graphml.xsd\">\n";
      write_graphml_keys<Keys, decltype(value_of(*vertices(graph).first))>(text, attributes);
      text << "  <graph id=\"G\" edgedefault=\"directed\" parse.nodeids=\"free\" parse.edgeids=\"free\" "
              "parse.order=\"nodesfirst\">\n";
      for(const auto node : CGAL::make_range(vertices(graph)))
      {
        text << "    <node id=\"" << std::size_t(node) << "\">\n";
        write_data(Keys::kind, to_string(graph[node].kind));
        write_data(Keys::value, graphml_text(value_of(node)));
        write_data(Keys::vertex, static_cast<std::size_t>(get(vertex_index_map, graph[node].vertex)));
        text << "    </node>\n";
      }
      std::size_t number = 0;
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        text << "    <edge id=\"" << number << "\" source=\"" << std::size_t(source(arc, graph)) << "\" target=\""
             << std::size_t(target(arc, graph)) << "\">\n";
        if constexpr(Keys::has_chains)
          write_data(Keys::chain, text_of_chain(arc));
        if constexpr(Keys::has_index)
          write_data(Keys::index, static_cast<std::size_t>(get(boost::edge_index, graph, arc)));
        for(std::size_t i = 0; i != attributes.size(); ++i)
          std::visit([&](const auto& numbers) { write_data(Keys::first_attribute + i, graphml_text(numbers[number])); },
                     attributes[i].numbers);
        text << "    </edge>\n";
        ++number;
      }
      text << "  </graph>\n</graphml>\n";
      text.flush();
    });
  }
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
/// With an index map of the halfedges, each edge also has the data `chain`, the indices of the halfedges of its chain, so
/// that `read_graphml()` can read the graph back.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
/// \tparam HalfedgeIndexMap likewise for the halfedge descriptors
///
/// \param output a stream, whose state tells whether writing succeeded, or the name of a file
/// \param graph the Reeb graph
/// \param vertex_index_map the index of each vertex of the mesh; in soups and tetrahedra vertices are indices, so that
///        it is `boost::typed_identity_property_map<std::size_t>`. For `read_graphml()` it is the position, as
///        `make_vertex_index_map()` gives it.
/// \param halfedge_index_map the index of each halfedge of the mesh, likewise; may be left out, so that `np` stands in
///        its place
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class whose `scalar_to_double_object()` makes numbers of values
///                           that have no `operator<<`}
///     \cgalParamType{a model of `ReebGraphNumberTraits`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{arc_attributes}
///     \cgalParamDescription{numbers of the arcs that are written as data of the edges}
///     \cgalParamType{`std::vector<Reeb_graph::Attribute>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \exception File_error if the file cannot be written
/// \exception Attribute_count_error if an attribute has not one number for each arc
///
/// \note Boost has a function of this name; qualify the call.
template <class Graph,
          class VertexIndexMap,
          class HalfedgeIndexMap = parameters::Default_named_parameters,
          class NamedParameters = parameters::Default_named_parameters>
void write_graphml(const internal::Output& output,
                   const Graph& graph,
                   VertexIndexMap vertex_index_map,
                   const HalfedgeIndexMap& halfedge_index_map = parameters::default_values(),
                   const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::are_named_parameters<HalfedgeIndexMap>) // no map
    internal::write_graphml_with(output, graph, vertex_index_map, halfedge_index_map, nullptr);
  else
    internal::write_graphml_with(output, graph, vertex_index_map, np, [&](const auto& arc) {
      std::string text;
      for(const auto h : graph[arc].chain)
        text += (text.empty() ? "" : " ") + std::to_string(get(halfedge_index_map, h));
      return text;
    });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_GRAPHML_H
