// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_HARMONIC_CONSTRAINTS_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_HARMONIC_CONSTRAINTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/internal/base/point_map.h>
#include <CGAL/Reeb_graph/internal/mesh/border_cycles.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The vertices with given values of a harmonic field whose extrema are all borders: 0 on the first border of each
// component, 1 on the other ones. A component with one border has a vertex far from it as other end; a component
// without border has two vertices that are far apart.
template <class Mesh>
class Harmonic_constraints
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

public:
  typedef std::vector<std::pair<vertex_descriptor, double>> Range;

  template <class NamedParameters>
  Harmonic_constraints(const Mesh& mesh, const NamedParameters& np)
    : mesh_(mesh),
      is_reached_(get(dynamic_vertex_property_t<bool>(), mesh))
  {
    for(const vertex_descriptor v : vertices(mesh))
      put(is_reached_, v, false);
    fix_borders();
    std::vector<std::pair<vertex_descriptor, vertex_descriptor>> ends;
    // The callback is that of the field, whose progress begins later.
    find_far_apart_vertices(mesh, std::back_inserter(ends), parameters::vertex_point_map(choose_point_map(mesh, np)));
    for(const auto& pair : ends)
    {
      if(get(is_reached_, pair.first))
        continue;
      range_.emplace_back(pair.first, 0.);
      if(pair.second != pair.first)
        range_.emplace_back(pair.second, 1.);
    }
  }

  const Range& range() const { return range_; }

private:
  void fix_borders()
  {
    for(const auto& cycle : find_border_cycles(mesh_))
      fix_border(cycle.halfedge);
  }

  // Fixes a border; the first one of a component reaches all of its vertices.
  void fix_border(halfedge_descriptor border)
  {
    const bool is_first = !get(is_reached_, target(border, mesh_));
    fix_border_cycle(border, mesh_, is_first ? 0. : 1., std::back_inserter(range_));
    if(!is_first)
      return;
    std::vector<vertex_descriptor> reached;
    const auto reach = [&](vertex_descriptor v) {
      if(get(is_reached_, v))
        return;
      put(is_reached_, v, true);
      reached.push_back(v);
    };
    for(const vertex_descriptor v : vertices_around_face(border, mesh_))
      reach(v);
    const std::size_t size_of_border = reached.size();
    bool has_other_border = false;
    for(std::size_t i = 0; i != reached.size(); ++i)
      for(const halfedge_descriptor h : halfedges_around_target(reached[i], mesh_))
      {
        has_other_border = has_other_border || (i >= size_of_border && is_border(h, mesh_));
        reach(source(h, mesh_));
      }
    if(!has_other_border && reached.size() > size_of_border)
      range_.emplace_back(reached.back(), 1.);
  }

  const Mesh& mesh_;
  typename boost::property_map<Mesh, dynamic_vertex_property_t<bool>>::const_type is_reached_;
  Range range_;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_HARMONIC_CONSTRAINTS_H
