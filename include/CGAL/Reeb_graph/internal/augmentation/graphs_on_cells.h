// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPHS_ON_CELLS_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPHS_ON_CELLS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/internal/augmentation/Cell_list.h>
#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_soup.h>
#include <CGAL/Reeb_graph/internal/augmentation/Level_set_component.h>
#include <CGAL/Reeb_graph/internal/augmentation/Oriented_tetrahedra.h>
#include <CGAL/Reeb_graph/internal/augmentation/Polyline_search.h>
#include <CGAL/Reeb_graph/internal/augmentation/Triangle_orientation.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <boost/unordered_map.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A graph on triangles, in which contours are polylines.
template <class ReebGraph, class Traits>
class Graph_on_triangles : public Graph_on_soup<ReebGraph, Traits, Cell_list, Soup_contour>
{
  typedef Graph_on_soup<ReebGraph, Traits, Cell_list, Soup_contour> Base;

public:
  using Base::Base;
  using typename Base::arc_descriptor;
  using typename Base::Contour;

  template <class Level>
  Contour trace(arc_descriptor arc, Edge_index start, const Level& level) const
  {
    const Level_set_component component = find_level_set_component(this->complex(), start, level.is_below);
    Contour contour = this->make_points(arc, component, level);
    Polyline_search search(component);
    contour.polylines = search.find_polylines();
    contour.branch_points = search.branch_points();
    return contour;
  }
};

// A graph on tetrahedra, in which contours are patches of triangles.
template <class ReebGraph, class Traits>
class Graph_on_tetrahedra : public Graph_on_soup<ReebGraph, Traits, Oriented_tetrahedra, Isosurface_patch>
{
  typedef Graph_on_soup<ReebGraph, Traits, Oriented_tetrahedra, Isosurface_patch> Base;
  typedef Oriented_tetrahedra::Tetrahedron Tetrahedron;

public:
  using Base::Base;
  using typename Base::arc_descriptor;
  using typename Base::Contour;

  template <class Level>
  Contour trace(arc_descriptor arc, Edge_index start, const Level& level) const
  {
    Contour contour = this->make_points(arc, find_level_set_component(this->complex(), start, level.is_below), level);
    Point_of_edge point_of_edge;
    boost::unordered_set<std::size_t> lower_vertices;
    std::vector<Vertex_index> lower_vertices_in_order;
    for(std::size_t point = 0; point != contour.edges.size(); ++point)
    {
      point_of_edge.emplace(contour.edges[point], point);
      if(lower_vertices.insert(contour.edges[point].first).second)
        lower_vertices_in_order.push_back(Vertex_index(contour.edges[point].first));
    }
    for(const Vertex_index vertex : lower_vertices_in_order)
    {
      this->cells().for_each_at(vertex, [&](Number number) {
        Tetrahedron tetrahedron = this->cells()[number];
        const std::size_t number_of_lower = move_lower_to_front(tetrahedron, level.is_below);
        // so that the tetrahedron comes once
        const bool is_first = vertex == *std::min_element(tetrahedron.begin(), tetrahedron.begin() + number_of_lower);
        if(number_of_lower != 4 && is_first && point_of_edge.count(edge(tetrahedron[0], tetrahedron[3])) != 0)
          add_triangles(tetrahedron, number_of_lower, point_of_edge, contour);
      });
    }
    Triangle_orientation::orient(contour.triangles);
    return contour;
  }

private:
  typedef std::pair<std::size_t, std::size_t> Edge;
  typedef boost::unordered_map<Edge, std::size_t> Point_of_edge;

  static Edge edge(Vertex_index lower, Vertex_index higher) { return {lower.number(), higher.number()}; }

  // Moves the vertices below the level to the front by an even permutation, which keeps the orientation, and returns
  // their number.
  template <class IsBelow>
  static std::size_t move_lower_to_front(Tetrahedron& t, const IsBelow& is_below)
  {
    std::size_t number_of_lower = 0;
    bool is_odd = false;
    for(std::size_t i = 0; i != 4; ++i)
    {
      if(!is_below(t[i]))
        continue;
      is_odd ^= i != number_of_lower;
      std::swap(t[i], t[number_of_lower++]);
    }
    if(is_odd && number_of_lower >= 2)
      std::swap(t[0], t[1]);
    else if(is_odd)
      std::swap(t[2], t[3]);
    return number_of_lower;
  }

  // In a positive tetrahedron, the first three vertices appear counterclockwise from the last one.
  static void add_triangles(const Tetrahedron& t,
                            std::size_t number_of_lower,
                            const Point_of_edge& point_of_edge,
                            Contour& contour)
  {
    const auto point = [&](std::size_t lower, std::size_t higher) {
      return point_of_edge.at(edge(t[lower], t[higher]));
    };
    switch(number_of_lower)
    {
    case 1: contour.triangles.push_back({point(0, 1), point(0, 2), point(0, 3)}); break;
    case 2:
      contour.triangles.push_back({point(0, 2), point(0, 3), point(1, 3)});
      contour.triangles.push_back({point(0, 2), point(1, 3), point(1, 2)});
      break;
    default: contour.triangles.push_back({point(0, 3), point(1, 3), point(2, 3)});
    }
  }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPHS_ON_CELLS_H
