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

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_tree/detail/xml_parser_utils.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstddef>
#include <fstream>
#include <istream>
#include <locale>
#include <map>
#include <memory>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
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
  static_assert(are_met<Graph_and_vertex_map<Graph, VertexIndexMap>,
                        Scalars_can_be_written<Traits_of_nodes<Graph, NamedParameters>>>);
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

namespace internal {

// Reads all of a text as a number, or whatever the type reads by its operator>>.
template <class Value>
Value parse_value(const std::string& text)
{
  Value value{};
  bool is_read = false;
  if constexpr(std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>)
  {
    const char* const end = text.data() + text.size();
    const auto result = read_number(text.data(), end, value);
    is_read = result.ec == std::errc() && result.ptr == end;
  }
  else
  {
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    is_read = static_cast<bool>(stream >> value) && (stream >> std::ws).eof();
  }
  if(!is_read)
    throw File_error("'" + text + "' is not a value of a Reeb graph");
  return value;
}

// The scalar value that written_scalar() has written.
template <class Traits>
typename Traits::Scalar parse_scalar(const std::string& text, const Scalar_conversion<Traits>& conversion)
{
  typedef typename Traits::Scalar Scalar;
  if constexpr(!Scalars_can_be_read<Traits>::value)
    return Scalar();
  else if constexpr(Has<Read_scalar, Scalar>::value)
    return parse_value<Scalar>(text);
  else
    return *conversion.from_double(parse_value<double>(text), false);
}

inline Node_kind parse_node_kind(const std::string& text)
{
  for(const Node_kind kind :
      {Node_kind::ISOLATED, Node_kind::MINIMUM, Node_kind::SADDLE, Node_kind::MAXIMUM, Node_kind::DEGREE_TWO})
  {
    if(text == to_string(kind))
      return kind;
  }
  throw File_error("'" + text + "' is not a kind of node");
}

template <class Descriptor>
Descriptor element_at(const std::vector<Descriptor>& elements, const std::string& position)
{
  const auto i = parse_value<std::size_t>(position);
  if(i >= elements.size())
    throw File_error("the mesh has no vertex or halfedge " + position);
  return elements[i];
}

// The parts of a GraphML file by their names.
class Graphml_document
{
  typedef boost::property_tree::ptree Tree;

public:
  explicit Graphml_document(std::istream& in)
  {
    try
    {
      boost::property_tree::read_xml(in, tree_);
      for(const auto& [tag, child] : tree_.get_child("graphml"))
      {
        if(tag == "key")
          names_[attribute(child, "id")] = attribute(child, "attr.name");
      }
    }
    catch(const boost::property_tree::file_parser_error& error)
    {
      throw File_error("this is not GraphML: line " + std::to_string(error.line()) + ": " + error.message());
    }
    catch(const boost::property_tree::ptree_error& error)
    {
      throw File_error(std::string("this is not GraphML: ") + error.what());
    }
  }

  // Calls visit(element, data by name) for each element of the graph of that tag.
  template <class Visit>
  void for_each(const std::string& tag_of_elements, const Visit& visit) const
  {
    const auto graph = tree_.get_child_optional("graphml.graph");
    if(!graph)
      throw File_error("the GraphML has no graph");
    for(const auto& [tag, element] : *graph)
    {
      if(tag != tag_of_elements)
        continue;
      std::map<std::string, std::string> data;
      for(const auto& [child_tag, child] : element)
      {
        const auto name = child_tag == "data" ? names_.find(attribute(child, "key")) : names_.end();
        if(name != names_.end())
          data[name->second] = child.data();
      }
      visit(element, data);
    }
  }

  static std::string attribute(const Tree& element, const std::string& name)
  {
    const auto value = element.get_optional<std::string>(Tree::path_type("<xmlattr>|" + name, '|'));
    if(!value)
      throw File_error("an element of the GraphML has no " + name);
    return *value;
  }

private:
  Tree tree_;
  std::map<std::string, std::string> names_; // of data, by key
};

inline const std::string& data_of(const std::map<std::string, std::string>& data, const std::string& name)
{
  const auto found = data.find(name);
  if(found == data.end())
    throw File_error(
      "a node or edge of the GraphML has no data " + name
      + (name == "chain" ? ": write_graphml() writes chains if it is given an index map of the halfedges" : ""));
  return found->second;
}

} // namespace internal

/// \ingroup PkgReebGraphIO
///
/// \brief reads a Reeb graph that `write_graphml()` has written with the chains of its arcs.
///
/// The result is the same graph: nodes, values to the last digit, kinds, arcs with their numbers and chains, all in the
/// same order. The mesh has to be the one that the graph has been computed of, or one with the same order of vertices
/// and of halfedges. The file must have their positions, as the maps of `make_vertex_index_map()` and
/// `make_halfedge_index_map()` give them. `Augmentation` throws an exception if the graph is not one of the mesh.
///
/// \param in the stream
/// \param mesh the mesh
/// \param graph the result. Values that are not built-in numbers are read by their `operator>>`, or if they have none,
///        as numbers, of which the traits class makes values. They have to be the same values as before.
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, a model of
///        `ReebGraphInverseNumberTraits`, whose `scalar_from_double_object()` does so
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::File_error if the stream has no such graph; then `graph` is as it was before
template <class FaceListGraph, class Graph, class NamedParameters = parameters::Default_named_parameters>
void read_graphml(std::istream& in,
                  const FaceListGraph& mesh,
                  Graph& graph,
                  const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::vertex_bundle_type<Graph>::type Node;
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  struct Arc
  {
    std::size_t lower, upper, begin, end;
  };
  const std::vector<vertex_descriptor> mesh_vertices(vertices(mesh).begin(), vertices(mesh).end());
  const std::vector<halfedge_descriptor> mesh_halfedges(halfedges(mesh).begin(), halfedges(mesh).end());
  const auto conversion = internal::choose_conversion_of_nodes<Graph>(np);
  const internal::Graphml_document document(in);
  std::map<std::string, std::size_t> numbers;
  std::vector<Node> nodes;
  document.for_each("node", [&](const auto& element, const auto& data) {
    Node node;
    node.vertex = internal::element_at(mesh_vertices, internal::data_of(data, "vertex"));
    node.value = internal::parse_scalar(internal::data_of(data, "value"), conversion);
    node.kind = internal::parse_node_kind(internal::data_of(data, "kind"));
    numbers.emplace(document.attribute(element, "id"), nodes.size());
    nodes.push_back(std::move(node));
  });
  std::vector<Arc> arcs;
  std::vector<halfedge_descriptor> chains;
  document.for_each("edge", [&](const auto& element, const auto& data) {
    const auto lower = numbers.find(document.attribute(element, "source"));
    const auto upper = numbers.find(document.attribute(element, "target"));
    if(lower == numbers.end() || upper == numbers.end())
      throw File_error("an edge of the GraphML has no node at its end");
    const std::size_t begin = chains.size();
    std::istringstream positions(internal::data_of(data, "chain"));
    for(std::string position; positions >> position;)
      chains.push_back(internal::element_at(mesh_halfedges, position));
    arcs.push_back({lower->second, upper->second, begin, chains.size()});
  });

  graph.clear();
  for(Node& node : nodes)
    add_vertex(std::move(node), graph);
  for(const Arc& arc : arcs)
    add_edge(arc.lower, arc.upper, graph);
  const auto storage = std::make_shared<const std::vector<halfedge_descriptor>>(std::move(chains));
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    graph[arc].chain = {storage, arcs[number].begin, arcs[number].end - arcs[number].begin};
    internal::set_arc_index(graph, arc, number++);
  }
}

/// \ingroup PkgReebGraphIO
///
/// \brief reads a Reeb graph from a file, as from a stream.
///
/// \param filename the name of the file
/// \param mesh the mesh
/// \param graph the result
/// \param np the named parameters of reading from a stream
///
/// \reebGraphComplexity
///
/// \exception Reeb_graph::File_error if the file cannot be read, or has no such graph
template <class FaceListGraph, class Graph, class NamedParameters = parameters::Default_named_parameters>
void read_graphml(const std::string& filename,
                  const FaceListGraph& mesh,
                  Graph& graph,
                  const NamedParameters& np = parameters::default_values())
{
  std::ifstream in(filename);
  if(!in)
    throw File_error(filename + " cannot be read");
  try
  {
    Reeb_graph::read_graphml(in, mesh, graph, np);
  }
  catch(const File_error& error)
  {
    throw File_error(filename + ": " + error.what());
  }
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_IO_GRAPHML_H
