// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_VERTEX_LOCATIONS_H
#define CGAL_REEB_GRAPH_VERTEX_LOCATIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/way_back/Vertex_places.h>

#include <CGAL/Iterator_range.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the place of each vertex of the mesh in the Reeb graph, and the vertices of each arc and node.
///
/// It is made by `Augmentation::locate_vertices()`. The vertices of arcs and nodes are sorted when they are asked for
/// the first time, in \f$ O(n \log n) \f$ for \f$ n \f$ vertices of the mesh; several threads may ask at a time. It can
/// outlive the `Augmentation` and the mesh, but holds copies of the arc descriptors and of a `vertex_index_map`: as
/// long as it is used, the graph must not lose arcs, and the map must stay valid. `get(vertex_locations, v)` is the
/// same as `vertex_locations[v]`.
///
/// \tparam VertexDescriptor a vertex descriptor of the mesh
/// \tparam ReebGraph the type of the Reeb graph
///
/// \cgalModels{ReadablePropertyMap}
template <class VertexDescriptor, class ReebGraph>
class Vertex_locations
{
public:
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor; ///< a node of the graph
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;    ///< an arc of the graph

  /// a node or an arc: `std::holds_alternative<arc_descriptor>(location)`, `std::get<arc_descriptor>(location)`
  typedef std::variant<node_descriptor, arc_descriptor> Location;

  typedef VertexDescriptor key_type;                            ///< the key type
  typedef Location value_type;                                  ///< the value type
  typedef Location reference;                                   ///< the same
  typedef boost::readable_property_map_tag category;            ///< the category
  typedef Iterator_range<const VertexDescriptor*> Vertex_range; ///< the type of a range of vertices

  /// returns the place of the vertex `v`: the node that it belongs to, or the arc that passes it.
  ///
  /// \exception Unknown_vertex_error if the mesh had no such vertex
  Location operator[](VertexDescriptor v) const
  {
    const std::size_t place = index(v);
    if(place < number_of_nodes_)
      return node_descriptor(place);
    return arcs_[place - number_of_nodes_];
  }

  /// returns the number of the place of the vertex `v`: nodes are numbered from 0 by their descriptors, arcs after the
  /// last node, in the order of `edges(graph)`.
  ///
  /// \exception Unknown_vertex_error if the mesh had no such vertex
  std::size_t index(VertexDescriptor v) const
  {
    const internal::Vertex_index position = position_(v);
    if(!places_->contains(position) || (*places_)[position] == internal::no_index)
      throw Unknown_vertex_error();
    return (*places_)[position];
  }

  /// returns the vertices of a node in ascending order. It has more than one if ties are contracted.
  Vertex_range vertices_of_node(node_descriptor node) const { return (*lists_)(node); }

  /// returns the vertices of the arc number `i`, in the order of `edges(graph)`, in ascending order. That is the arc of
  /// the vertices whose `index()` is the number of nodes plus `i`.
  Vertex_range vertices_of_arc(std::size_t i) const { return (*lists_)(number_of_nodes_ + i); }

  /// returns the place of `v`.
  friend Location get(const Vertex_locations& locations, VertexDescriptor v) { return locations[v]; }

#ifndef DOXYGEN_RUNNING
  Vertex_locations(std::function<internal::Vertex_index(VertexDescriptor)> position,
                   std::size_t number_of_nodes,
                   std::vector<arc_descriptor> arcs,
                   std::shared_ptr<const internal::Vertex_places> places,
                   std::shared_ptr<const internal::Vertex_lists<VertexDescriptor>> lists)
    : position_(std::move(position)),
      number_of_nodes_(number_of_nodes),
      arcs_(std::move(arcs)),
      places_(std::move(places)),
      lists_(std::move(lists))
  {}
#endif

private:
  std::function<internal::Vertex_index(VertexDescriptor)> position_;
  std::size_t number_of_nodes_;
  std::vector<arc_descriptor> arcs_;
  std::shared_ptr<const internal::Vertex_places> places_; // nodes come first, then arcs
  std::shared_ptr<const internal::Vertex_lists<VertexDescriptor>> lists_;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_VERTEX_LOCATIONS_H
