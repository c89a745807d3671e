// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_H
#define CGAL_REEB_GRAPH_IO_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph_traits.h>

#include <boost/graph/graphml.hpp>
#include <boost/graph/graphviz.hpp>
#include <boost/make_shared.hpp>
#include <boost/property_map/dynamic_property_map.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/throw_exception.hpp>

#include <cstddef>
#include <limits>
#include <locale>
#include <ostream>
#include <sstream>
#include <string>
#include <type_traits>
#include <typeinfo>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class Value>
std::string to_string_with_precision(const Value& value, int precision)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(precision);
  if constexpr(std::is_integral_v<Value>)
    text << +value; // those of 8 bits are no characters
  else
    text << value;
  return text.str();
}

// Six digits: what a person reads.
template <class Value>
std::string to_short_string(const Value& value)
{
  return to_string_with_precision(value, 6);
}

// As many digits as it takes to read back the same floating-point number.
template <class Value>
std::string to_round_trip_string(const Value& value)
{
  if constexpr(std::is_floating_point_v<Value>)
    return to_string_with_precision(value, std::numeric_limits<Value>::max_digits10);
  else
    return to_short_string(value);
}

// What Boost writes as it stands has six digits only.
template <class PropertyMap>
class Round_trip_property_map : public boost::dynamic_property_map
{
  typedef typename boost::property_traits<PropertyMap>::key_type key_type;
  typedef std::decay_t<typename boost::property_traits<PropertyMap>::value_type> value_type;

public:
  explicit Round_trip_property_map(const PropertyMap& map) : map_(map) {}

  boost::any get(const boost::any& key) override { return value_of(key); }
  std::string get_string(const boost::any& key) override { return to_round_trip_string(value_of(key)); }
  void put(const boost::any&, const boost::any&) override { boost::throw_exception(boost::dynamic_const_put_error()); }
  const std::type_info& key() const override { return typeid(key_type); }
  const std::type_info& value() const override { return typeid(value_type); }

private:
  value_type value_of(const boost::any& key) const { return map_[boost::any_cast<key_type>(key)]; }

  PropertyMap map_;
};

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
/// \brief returns the name under which a kind of node is written:
/// `"isolated"`, `"minimum"`, `"saddle"`, `"maximum"`, or `"degree-two"`.
inline std::string to_string(Node_kind kind)
{
  switch(kind)
  {
  case Node_kind::ISOLATED: return "isolated";
  case Node_kind::MINIMUM: return "minimum";
  case Node_kind::SADDLE: return "saddle";
  case Node_kind::MAXIMUM: return "maximum";
  case Node_kind::DEGREE_TWO: return "degree-two";
  }
  return "unknown";
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in the <A HREF="http://graphml.graphdrawing.org/">GraphML</A> format.
///
/// Each node has the data `vertex`, the index of its mesh vertex, `value`, the scalar value, and `kind`, see
/// `to_string()`. Each edge runs from the lower to the upper node. Nodes and edges are written in the order that they
/// have in the graph, so that equal graphs give equal files. A floating-point value is written with as many digits as
/// it takes to read back the same value; an integer as a number, even if it is a character;
/// any other value by its `operator<<`.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param out the stream; whether writing succeeded is seen by its state
/// \param graph the Reeb graph
/// \param vertex_index_map the index of each vertex of the mesh
///
/// \note Boost has a function of this name; qualify the call.
template <class Graph, class VertexIndexMap>
void write_graphml(std::ostream& out, const Graph& graph, VertexIndexMap vertex_index_map)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor node_descriptor;

  const auto index_of_node = [&](node_descriptor node) -> std::size_t {
    return get(vertex_index_map, graph[node].vertex);
  };
  const auto value_of_node = [&](node_descriptor node) { return graph[node].value; };
  const auto kind_of_node = [&](node_descriptor node) { return to_string(graph[node].kind); };

  boost::dynamic_properties properties;
  properties.property("vertex", boost::make_function_property_map<node_descriptor>(index_of_node));
  properties.property("kind", boost::make_function_property_map<node_descriptor>(kind_of_node));
  const auto value_map = boost::make_function_property_map<node_descriptor>(value_of_node);
  properties.insert("value", boost::make_shared<internal::Round_trip_property_map<decltype(value_map)>>(value_map));
  const bool are_nodes_numbered_in_order = true;
  boost::write_graphml(out, graph, properties, are_nodes_numbered_in_order);
}

/// \ingroup PkgReebGraphIO
///
/// \brief writes a Reeb graph in the <A HREF="https://graphviz.org/">Graphviz</A> format, to be drawn by its
/// program `dot` with lower nodes below upper ones.
///
/// The label of a node is the index of its mesh vertex and its scalar value to six digits, its colour tells the
/// kind. The attributes `vertex`, `value`, and `kind` are those of `write_graphml()`, with all digits.
/// Equal graphs give equal files.
///
/// \tparam Graph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam VertexIndexMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type and an
///         integer type as value type
///
/// \param out the stream; whether writing succeeded is seen by its state
/// \param graph the Reeb graph
/// \param vertex_index_map the index of each vertex of the mesh
///
/// \note Boost has a function of this name; qualify the call.
template <class Graph, class VertexIndexMap>
void write_graphviz(std::ostream& out, const Graph& graph, VertexIndexMap vertex_index_map)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor node_descriptor;
  typedef typename boost::graph_traits<Graph>::edge_descriptor arc_descriptor;

  const auto write_graph_attributes = [](std::ostream& stream) {
    stream << "rankdir=BT;\nnodesep=0.8;\n"
              "node [shape=box, style=\"rounded,filled\", fontname=\"Helvetica\", fontsize=11, margin=\"0.08,0.04\"];\n"
              "edge [arrowhead=none];\n";
  };
  const auto write_node_attributes = [&](std::ostream& stream, node_descriptor node) {
    const auto& properties = graph[node];
    const std::string index = std::to_string(get(vertex_index_map, properties.vertex));
    const std::string label = "v" + index + "\n" + internal::to_short_string(properties.value);
    stream << " [label=" << boost::escape_dot_string(label) << ", fillcolor=\"" << internal::fill_color(properties.kind)
           << "\", vertex=" << index
           << ", value=" << boost::escape_dot_string(internal::to_round_trip_string(properties.value)) << ", kind=\""
           << to_string(properties.kind) << "\"]";
  };
  const auto write_no_arc_attributes = [](std::ostream&, const arc_descriptor&) {};
  boost::write_graphviz(out, graph, write_node_attributes, write_no_arc_attributes, write_graph_attributes);
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_IO_H
