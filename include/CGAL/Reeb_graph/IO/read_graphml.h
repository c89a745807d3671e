// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_IO_READ_GRAPHML_H
#define CGAL_REEB_GRAPH_IO_READ_GRAPHML_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/io/read_number.h>
#include <CGAL/Reeb_graph/internal/io/requirements.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <cstddef>
#include <fstream>
#include <istream>
#include <locale>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {
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

#endif // CGAL_REEB_GRAPH_IO_READ_GRAPHML_H
