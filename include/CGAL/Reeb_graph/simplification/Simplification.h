// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief the way from a Reeb graph to its simplified graph: for each node and each arc the node or arc of the
/// simplified graph that has taken it up.
///
/// It is made by `simplify()`. As a property map, it has the nodes of the graph that has been simplified as keys:
/// `get(simplification, node)`. Copies share their memory. It holds copies of the arc descriptors of the simplified
/// graph, which must not lose arcs as long as it is used. Given to `Augmentation` as named parameter `simplification`,
/// it leads from the vertices of the mesh to the simplified graph.
///
/// \tparam ReebGraph the type of both graphs
///
/// \cgalModels{ReadablePropertyMap}
template <class ReebGraph>
class Simplification
{
public:
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor; ///< a node
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor; ///< an arc of the simplified graph

  /// a node or an arc: `std::holds_alternative<arc_descriptor>(place)`, `std::get<arc_descriptor>(place)`
  typedef std::variant<node_descriptor, arc_descriptor> Place;

  typedef node_descriptor key_type;                  ///< the key type
  typedef Place value_type;                          ///< the value type
  typedef Place reference;                           ///< the same
  typedef boost::readable_property_map_tag category; ///< the category

  /// returns what has taken up the node `node` of the graph that has been simplified: itself, if it is still there.
  ///
  /// \exception Graph_mismatch_error if there was no such node
  Place operator[](node_descriptor node) const { return place(index_of_node(node)); }

  /// returns what has taken up the arc number `i` of the graph that has been simplified, in the order of its `edges()`.
  ///
  /// \exception Graph_mismatch_error if there was no such arc
  Place place_of_arc(std::size_t i) const { return place(index_of_arc(i)); }

  /// returns the number of what has taken up a node: nodes of the simplified graph are numbered from 0 by their
  /// descriptors, arcs behind the last node, in the order of `edges()`. These are the numbers of `Vertex_places`.
  ///
  /// \exception Graph_mismatch_error if there was no such node
  std::size_t index_of_node(node_descriptor node) const
  {
    if(!(node < places_->number_of_old_nodes))
      throw Graph_mismatch_error("the node is not one of the graph");
    return places_->new_places[node];
  }

  /// returns the number of what has taken up the arc number `i`, in the order of `edges()`.
  ///
  /// \exception Graph_mismatch_error if there was no such arc
  std::size_t index_of_arc(std::size_t i) const
  {
    if(i >= places_->new_places.size() - places_->number_of_old_nodes)
      throw Graph_mismatch_error("the arc is not one of the graph");
    return places_->new_places[places_->number_of_old_nodes + i];
  }

  /// returns the number of nodes of the graph that has been simplified.
  std::size_t number_of_old_nodes() const { return places_->number_of_old_nodes; }

  /// returns the number of arcs of the graph that has been simplified.
  std::size_t number_of_old_arcs() const { return places_->new_places.size() - places_->number_of_old_nodes; }

  /// returns what has taken up a node.
  friend Place get(const Simplification& simplification, node_descriptor node) { return simplification[node]; }

#ifndef DOXYGEN_RUNNING
  // By place in the old graph, the place in the new one.
  Simplification(std::size_t number_of_old_nodes,
                 std::size_t number_of_new_nodes,
                 std::vector<internal::Index> new_places,
                 std::vector<arc_descriptor> new_arcs)
    : places_(std::make_shared<const Places>(
      Places{number_of_old_nodes, number_of_new_nodes, std::move(new_places), std::move(new_arcs)}))
  {}
#endif

private:
  struct Places
  {
    std::size_t number_of_old_nodes, number_of_new_nodes;
    std::vector<internal::Index> new_places;
    std::vector<arc_descriptor> new_arcs;
  };

  Place place(std::size_t place) const
  {
    if(place < places_->number_of_new_nodes)
      return node_descriptor(place);
    return places_->new_arcs[place - places_->number_of_new_nodes];
  }

  std::shared_ptr<const Places> places_;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_H
