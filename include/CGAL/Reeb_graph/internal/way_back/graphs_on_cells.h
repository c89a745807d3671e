// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPHS_ON_CELLS_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPHS_ON_CELLS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/complex/flatten_soup.h>
#include <CGAL/Reeb_graph/internal/engine/stages_of_complexes.h>
#include <CGAL/Reeb_graph/internal/way_back/Graph_on_mesh.h>
#include <CGAL/Reeb_graph/internal/way_back/cells.h>

#include <boost/unordered_map.hpp>
#include <boost/unordered_set.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A component of a level set of a complex as a graph: a point on each crossed edge, and a line in each crossed
// triangle.
struct Level_set_component
{
  typedef std::array<Index, 2> Line; // the numbers of two points

  std::vector<Edge_index> edges; // by the numbers of their points
  std::vector<Line> lines;
};

// The component on the edge `start`. Points are numbered in the order in which a search finds them, breadth first.
template <class IsBelow>
Level_set_component find_level_set_component(const Simplicial_complex& complex,
                                             Edge_index start,
                                             const IsBelow& is_below)
{
  Level_set_component component;
  boost::unordered_map<Index, Index> point_of_edge;
  const auto find_point = [&](Edge_index edge) {
    const auto inserted = point_of_edge.emplace(edge.number(), static_cast<Index>(component.edges.size()));
    if(inserted.second)
      component.edges.push_back(edge);
    return inserted.first->second;
  };
  find_point(start);
  for(Index point = 0; point != component.edges.size(); ++point)
  {
    const Edge_index edge = component.edges[point];
    for_each_crossed_edge_beside(complex, edge, is_below, [&](Edge_index beside, Triangle_index) {
      const Index other_point = find_point(beside);
      if(point < other_point) // so that each line comes once
        component.lines.push_back({point, other_point});
    });
  }
  return component;
}

struct Point_tag;
typedef Index_of<Point_tag> Point_index;

// Splits the lines of a component of a level set into polylines, which end where not exactly two lines meet: those from
// branch points and points of the border, in the order of their first points, or the only one, if the component is a
// closed curve. Branch points are those of more than two lines.
inline void find_polylines(const Level_set_component& component,
                           std::vector<std::vector<std::size_t>>& polylines,
                           std::vector<std::size_t>& branch_points)
{
  const std::vector<Level_set_component::Line>& lines = component.lines;
  const Buckets<Point_index, std::size_t> lines_of_points(component.edges.size(), [&](const auto& visit) {
    for(std::size_t line = 0; line != lines.size(); ++line)
      for(const Index point : lines[line])
        visit(Point_index(point), line);
  });
  const auto lines_at = [&](std::size_t point) { return lines_of_points[Point_index(point)]; };
  std::vector<bool> is_used(lines.size(), false);
  const auto follow = [&](std::size_t first_point, std::size_t line) {
    polylines.push_back({first_point});
    std::vector<std::size_t>& polyline = polylines.back();
    for(;;)
    {
      is_used[line] = true;
      const std::size_t point = lines[line][lines[line][0] == polyline.back() ? 1 : 0];
      polyline.push_back(point);
      const auto lines_on = lines_at(point);
      if(point == first_point || lines_on.size() != 2)
        return;
      line = lines_on.begin()[*lines_on.begin() == line ? 1 : 0];
    }
  };
  for(std::size_t point = 0; point != component.edges.size(); ++point)
  {
    if(lines_at(point).size() > 2)
      branch_points.push_back(point);
    for(const std::size_t line : lines_at(point))
    {
      if(lines_at(point).size() != 2 && !is_used[line])
        follow(point, line);
    }
  }
  if(polylines.empty() && !lines.empty())
    follow(0, *lines_at(0).begin());
}

// A graph and the complex that its nodes and chains are on, whose vertices are numbers for the user, too. `CellList`
// holds the triangles or tetrahedra as the user lists them. A derived class traces the contours.
template <class ReebGraph, class Traits, class CellList, template <class> class ContourOfArc>
class Graph_on_soup : public Graph_on_complex<ReebGraph, Traits, Simplicial_complex>
{
  typedef Graph_on_complex<ReebGraph, Traits, Simplicial_complex> Base;

public:
  typedef Simplicial_complex Mesh;
  typedef typename Base::node_descriptor node_descriptor;
  typedef typename Base::arc_descriptor arc_descriptor;
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor;
  typedef ContourOfArc<arc_descriptor> Contour;
  typedef Soup_critical_set<Contour> Critical_set;
  using Base::complex;

  template <class PointsOrNumber, class Cells, class Scalars, class NamedParameters>
  Graph_on_soup(const PointsOrNumber& points,
                const Cells& cells,
                const Scalars& scalars,
                const ReebGraph& graph,
                const Traits& traits,
                const NamedParameters& np,
                const Progress& progress)
    : Base(graph,
           traits,
           progress,
           [&] {
             return std::make_shared<const Flat_values<Simplicial_complex, typename Traits::Scalar>>(
               keep_flat<Simplicial_complex, typename Traits::Scalar>(
                 flatten_cells<Sequential_tag, CellList::vertices_per_cell>(
                   points, cells, parameters::get_parameter(np, edges_of_soup), scalars, traits)));
           }),
      cells_(this->end_of_vertices(), points, cells)
  {}

  // The edges of the complex are a mesh as far as chains need one.
  const Mesh& mesh() const { return complex(); }
  bool has_vertices() const { return this->end_of_vertices() != 0; }

  Vertex_index source_of(const halfedge_descriptor& h) const { return this->number(h.first); }
  Vertex_index target_of(const halfedge_descriptor& h) const { return this->number(h.second); }

  // The ends of an edge that may be one of another complex.
  Vertex_index checked_source(const halfedge_descriptor& h) const { return checked(source_of(h)); }
  Vertex_index checked_target(const halfedge_descriptor& h) const { return checked(target_of(h)); }

  Edge_index find_start(const halfedge_descriptor& h) const
  {
    const Halfedge_index halfedge = complex().find_halfedge(checked_source(h), checked_target(h));
    if(halfedge == no_index)
      throw Graph_mismatch_error();
    return edge_of(halfedge);
  }

  Critical_set critical_set(node_descriptor node, std::vector<Contour> lower, std::vector<Contour> upper) const
  {
    const auto star = cells_.at_vertex(this->node_vertex(node));
    return {std::move(lower), std::move(upper), {star.begin(), star.end()}};
  }

  const CellList& cells() const { return cells_; }

protected:
  // A contour that has the points on the crossed edges, and nothing between them.
  template <class Level>
  Contour make_points(arc_descriptor arc, const Level_set_component& component, const Level& level) const
  {
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    contour.edges.reserve(component.edges.size());
    contour.fractions.reserve(component.edges.size());
    for(const Edge_index edge : component.edges)
    {
      Vertex_index lower = complex().lower_end(edge), higher = complex().higher_end(edge);
      if(!level.is_below(lower))
        std::swap(lower, higher);
      contour.edges.emplace_back(lower.number(), higher.number());
      contour.fractions.push_back(crossing_fraction(this->value(lower), this->value(higher), level.value));
    }
    return contour;
  }

private:
  static Vertex_index checked(Vertex_index vertex)
  {
    if(vertex == no_index)
      throw Graph_mismatch_error();
    return vertex;
  }

  const CellList cells_;
};

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
    find_polylines(component, contour.polylines, contour.branch_points);
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
      for(const Index number : this->cells().at_vertex(vertex))
      {
        Tetrahedron tetrahedron = this->cells()[number];
        const std::size_t number_of_lower = move_lower_to_front(tetrahedron, level.is_below);
        // so that the tetrahedron comes once
        const bool is_first = vertex == *std::min_element(tetrahedron.begin(), tetrahedron.begin() + number_of_lower);
        if(number_of_lower != 4 && is_first && point_of_edge.count(edge(tetrahedron[0], tetrahedron[3])) != 0)
          add_triangles(tetrahedron, number_of_lower, point_of_edge, contour);
      }
    orient_alike(contour.triangles);
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPHS_ON_CELLS_H
