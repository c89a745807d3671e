// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_IO_GRAPHML_DOCUMENT_H
#define CGAL_REEB_GRAPH_INTERNAL_IO_GRAPHML_DOCUMENT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Node_kind.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <charconv>
#include <cstddef>
#include <istream>
#include <locale>
#include <map>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Reads all of a text as a number, or whatever the type reads by its operator>>.
template <class Value>
Value parse_value(const std::string& text)
{
  Value value{};
  bool is_read = false;
  if constexpr(std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>)
  {
    const char* const end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_IO_GRAPHML_DOCUMENT_H
