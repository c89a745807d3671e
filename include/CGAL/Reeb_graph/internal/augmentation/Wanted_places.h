// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_WANTED_PLACES_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_WANTED_PLACES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Flat_graph.h>
#include <CGAL/Reeb_graph/internal/augmentation/Vertex_lists.h>
#include <CGAL/Reeb_graph/internal/augmentation/Vertex_places.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Vertex_queries.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <boost/property_map/property_map.hpp>

#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What the pipeline finds besides the graph if no places of vertices are wanted: nothing.
struct No_vertex_places
{
  static constexpr bool are_wanted = false;

  template <class ConcurrencyTag, class... Arguments>
  void find(const Arguments&...) const
  {}

  template <class VertexList>
  void write(const VertexList&) const
  {}
};

// The places of all vertices, for a property map: their arcs are found with those of the graph.
template <class PlaceMap>
class Vertex_places_for_map
{
public:
  static constexpr bool are_wanted = true;

  explicit Vertex_places_for_map(const PlaceMap& map) : map_(map) {}

  template <class ConcurrencyTag, class Complex, class Order, class ChosenMethod, class ChosenNumberOfSlabs>
  Slab_arcs find_arcs(const Complex& complex,
                      const Order& order,
                      const Swept_vertices& critical_vertices,
                      ChosenMethod method,
                      ChosenNumberOfSlabs number_of_slabs,
                      const Stage_progress& progress)
  {
    return find_arcs_with_vertices<ConcurrencyTag>(complex, order, critical_vertices, method, number_of_slabs,
                                                   arc_of_vertex_, progress);
  }

  template <class ConcurrencyTag, class Complex, class Order>
  void find(const Complex& complex,
            const Order& order,
            const Swept_vertices& critical_vertices,
            const Slab_arcs& critical_arcs,
            const Flat_graph& graph,
            Ties ties)
  {
    places_ = Vertex_place_finder(complex, order, critical_vertices, critical_arcs, arc_of_vertex_, graph, ties)
                .template find<ConcurrencyTag>();
    arc_of_vertex_ = Arc_of_vertex();
  }

  template <class VertexList>
  void write(const VertexList& vertices) const
  {
    using boost::put; // for a pointer, whatever has been included before
    typedef typename boost::property_traits<PlaceMap>::value_type Place;
    for(const Vertex_index v : places_.keys())
    {
      if(places_[v] != no_index)
        put(map_, vertices[v], static_cast<Place>(places_[v]));
    }
  }

private:
  const PlaceMap map_;
  Arc_of_vertex arc_of_vertex_;
  Vertex_places places_;
};

template <class NamedParameters>
auto choose_places(const NamedParameters& np)
{
  const auto map = parameters::get_parameter(np, vertex_place_map);
  if constexpr(is_given<decltype(map)>)
    return Vertex_places_for_map(map);
  else
    return No_vertex_places();
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_WANTED_PLACES_H
