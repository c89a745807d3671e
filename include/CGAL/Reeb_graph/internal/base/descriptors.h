// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_DESCRIPTORS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_DESCRIPTORS_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/graph/properties.hpp>
#include <boost/pending/property.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <unordered_map>

namespace CGAL::Reeb_graph::internal {

// The descriptors of a mesh, numbered in the order in which they are added: a property map whose copies share the
// numbers. Several threads may read it, also with descriptors of other meshes, which a dynamic property map of CGAL
// inserts when it is read.
template <class Descriptor, class Number>
class Descriptor_numbers
{
public:
  typedef Descriptor key_type;
  typedef Number value_type;
  typedef Number reference;
  typedef boost::readable_property_map_tag category;

  explicit Descriptor_numbers(std::size_t size) : numbers_(std::make_shared<std::unordered_map<Descriptor, Number>>())
  {
    numbers_->reserve(size);
  }

  void add(const Descriptor& d) { numbers_->emplace(d, static_cast<Number>(numbers_->size())); }

  // The number of a descriptor, the greatest of its type if it has none.
  friend Number get(const Descriptor_numbers& map, const Descriptor& d)
  {
    const auto found = map.numbers_->find(d);
    return found == map.numbers_->end() ? (std::numeric_limits<Number>::max)() : found->second;
  }

private:
  std::shared_ptr<std::unordered_map<Descriptor, Number>> numbers_;
};

// Whether the arcs of a graph have the property boost::edge_index.
template <class Graph, class = void>
struct Has_arc_index : std::false_type
{
};
template <class Graph>
struct Has_arc_index<Graph, std::void_t<typename Graph::edge_property_type>>
  : std::bool_constant<boost::lookup_one_property<typename Graph::edge_property_type, boost::edge_index_t>::found>
{
};

// Numbers an arc if its graph has a place for the number.
template <class Graph>
void set_arc_index(Graph& graph, const typename Graph::edge_descriptor& arc, std::size_t number)
{
  if constexpr(Has_arc_index<Graph>::value)
    put(boost::edge_index, graph, arc, number);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_DESCRIPTORS_H
